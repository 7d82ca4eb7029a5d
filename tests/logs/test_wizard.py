"""What is said of a log, and the maps that are proposed: they must lead back to the arrays."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from logs.files_of_logs import bag, matlab
from robodyn.errors import Place
from robodyn.logs.log import Log, read_log
from robodyn.logs.map_text import map_text
from robodyn.logs.mapping import Channel, LogMap, map_of_text
from robodyn.logs.wizard import examine
from robodyn.report.logs import data, lines, spark
from robodyn.robot import load
from robodyn.robot.parts import Limits
from robodyn.verify.reference import Reference

RATE = 200.0


def arm_log(*, samples: int = 600, amplitude: float = 0.6, speed: float = 1.0) -> Log:
    """A motion of the PUMA's first joints, with the torques that it takes."""
    robot = load("puma560_3dof", warn=lambda _: None)
    t = np.arange(samples) / RATE
    w = speed * np.array([2.1, 2.9, 3.7])
    q = amplitude * np.sin(np.outer(t, w))
    qd, qdd = amplitude * w * np.cos(np.outer(t, w)), -amplitude * w**2 * np.sin(np.outer(t, w))
    return Log(t, q, qd, qdd, Reference(robot, None).inverse_dynamics(q, qd, qdd))


def table(path: Path, columns: dict[str, np.ndarray], mark: str = ",") -> Path:
    rows = np.column_stack(list(columns.values()))
    text = [mark.join(columns), *(mark.join(map(repr, row)) for row in rows.tolist())]
    path.write_text("\n".join(text) + "\n", encoding="utf-8")
    return path


def foreign(path: Path) -> Path:
    """A log as a controller may write it: degrees, amperes of the motor, milliseconds, temperatures."""
    log = arm_log()
    assert log.qd is not None
    columns = {"time_ms": 1e3 * log.t}
    for j in range(3):
        columns[f"axis{j + 1}_act_pos"] = np.degrees(log.q[:, j]) * 20
        columns[f"axis{j + 1}_ref_pos"] = np.degrees(log.q[:, j]) * 20 + 1
        columns[f"axis{j + 1}_act_vel"] = np.degrees(log.qd[:, j]) * 20
        columns[f"axis{j + 1}_current"] = log.tau[:, j] / 50
        columns[f"axis{j + 1}_temp"] = 30 + log.t
    return table(path, columns, ";")


def test_names_steps_and_ranges_say_what_a_column_is(tmp_path: Path) -> None:
    result = examine(foreign(tmp_path / "log.csv"))
    units = {group: (channel.columns, channel.unit) for group, channel in result.mapping.groups.items()}
    assert units == {
        "t": (("time_ms",), "ms"),
        "q": (("axis%d_act_pos",), "deg"),
        "qd": (("axis%d_act_vel",), "deg/s"),
        "tau": (("axis%d_current",), "A"),
    }
    assert "more than" in result.reasons["q"]
    assert "times the rate of the positions" in result.reasons["qd"]
    assert "tau in A needs a number" in result.problem


def test_a_proposed_map_reads_the_log(tmp_path: Path) -> None:
    path = foreign(tmp_path / "log.csv")
    text = map_text(examine(path).mapping, {})
    text = text.replace("unit: A", "unit: A, torque_constant: 2.5, gear: 20").replace(
        "deg}", "deg, gear: 20}"
    )
    text = text.replace("deg/s", "deg/s, gear: 20")
    read, log = read_log(path, mapping=map_of_text(text)), arm_log()
    np.testing.assert_allclose(read.q, log.q, atol=1e-12)
    np.testing.assert_allclose(read.tau, log.tau, atol=1e-9)
    np.testing.assert_allclose(read.qd, log.qd, atol=1e-9)  # type: ignore[arg-type]
    np.testing.assert_allclose(read.t, log.t, atol=1e-12)


@pytest.mark.parametrize(
    ("factor", "unit"),
    [(1.0, "rad/s"), (180 / np.pi, "deg/s"), (30 / np.pi, "rpm"), (7.7, None)],
)  # fmt: skip
def test_a_rate_has_the_unit_that_its_positions_give_it(
    factor: float, unit: str | None, tmp_path: Path
) -> None:
    log = arm_log()
    columns = {"t": log.t}
    for j in range(3):
        columns[f"pos{j}"], columns[f"speed{j}"] = log.q[:, j], factor * log.qd[:, j]  # type: ignore[index]
        columns[f"torque{j}"] = log.tau[:, j]
    result = examine(table(tmp_path / "log.csv", columns))
    channel = result.mapping.groups.get("qd")
    assert (channel.unit if channel else None) == unit
    assert (unit is None) == result.reasons["qd"].startswith("left out")


@pytest.mark.parametrize(
    ("times", "unit"),
    [(1.0, ""), (1e3, "ms"), (1e6, "us"), (1e9, "ns")],
)  # fmt: skip
@pytest.mark.parametrize("start", [0.0, 1.7e9])
def test_times_of_every_unit_and_of_dates(times: float, unit: str, start: float, tmp_path: Path) -> None:
    log = arm_log(samples=200)
    columns = {"stamp": (log.t + start) * times, "q1": log.q[:, 1], "tau1": log.tau[:, 1]}
    result = examine(table(tmp_path / "log.csv", columns))
    assert result.mapping.groups["t"].unit == unit
    assert result.facts is not None
    assert result.facts.rate == pytest.approx(RATE, rel=1e-3)


def test_whole_numbers_are_counts(tmp_path: Path) -> None:
    log = arm_log()
    load_word = np.rint(log.tau[:, 1] * 3) % 65536
    columns = {"t": log.t, "enc_pos": np.rint(log.q[:, 1] * 20000), "load": load_word, "enable": 0 * log.t}
    path = table(tmp_path / "log.csv", columns)
    result = examine(path)
    assert result.mapping.groups["q"].unit == "ticks"
    assert result.mapping.groups["tau"].unit == "raw"
    assert any("write bits: 16" in line for line in lines(result))
    text = "q: {columns: enc_pos, counts_per_turn: 40000*pi}\ntau: {columns: load, bits: 16, factor: 1/3}\n"
    read = read_log(path, mapping=map_of_text(text))
    np.testing.assert_allclose(read.tau[:, 0], log.tau[:, 1], atol=0.17)
    np.testing.assert_allclose(read.q[:, 0], log.q[:, 1], atol=2.6e-5)


def test_a_file_without_times_asks_for_a_rate_and_still_shows_signs(tmp_path: Path) -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    log = arm_log(samples=1500, speed=0.3)
    columns = {
        f"{name}_{j}": array[:, j] for name, array in (("q", log.q), ("tau", -log.tau)) for j in range(3)
    }
    path = table(tmp_path / "log.csv", columns)
    result = examine(path, robot)
    assert result.missing == ("t",)
    assert result.log is None
    assert [float(x) for x in result.mapping.groups["tau"].numbers["sign"]] == [-1, -1, -1]
    text = map_text(result.mapping, result.reasons, result.missing)
    assert "# t: {rate: 100}" in text
    read = read_log(path, mapping=map_of_text(text.replace("# t: {rate: 100}", "t: {rate: 200}")))
    np.testing.assert_array_equal(read.tau, log.tau)
    np.testing.assert_array_equal(read.t, log.t)


def test_one_joint_against_gravity_is_turned_and_said(tmp_path: Path) -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    log = arm_log()
    tau = log.tau * [1, 1, -1]
    path = tmp_path / "log.csv"
    path.write_text(Log(log.t, log.q, None, None, tau).csv(), encoding="utf-8")
    result = examine(path, robot)
    assert [int(x) for x in result.mapping.groups["tau"].numbers["sign"]] == [1, 1, -1]
    assert "against gravity's torque at joint 3" in result.reasons["tau"]
    assert all(check.correlation > 0 or np.isnan(check.correlation) for check in result.checks)


def test_joints_and_limits_are_compared_with_a_robot(tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    path.write_text(arm_log(amplitude=3.5).csv(), encoding="utf-8")
    puma, limits = load("puma560_3dof", warn=lambda _: None), Limits((Fraction(-2), Fraction(2)))
    links = tuple(replace(link, joint=replace(link.joint, limits=limits)) for link in puma.links)
    result = examine(path, replace(puma, links=links))
    assert any("beyond the joint's limits" in line for line in lines(result, puma.name))
    assert "which columns are q, tau" in examine(path, load("ur10", warn=lambda _: None)).problem


def test_a_usual_log_needs_no_map(tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    path.write_text(arm_log().csv(), encoding="utf-8")
    result = examine(path)
    assert result.plain
    assert lines(result)[-1].startswith("  tau3")
    assert data(result)["needs_map"] is False


def test_gaps_repeats_and_standstill_are_counted(tmp_path: Path) -> None:
    log = arm_log(samples=1000)
    q, tau, t = log.q.copy(), log.tau.copy(), log.t.copy()
    q[300:500], tau[300:500] = q[300], tau[300]
    t[700:] += 0.5
    tau[900, 0] = np.nan
    path = tmp_path / "log.csv"
    path.write_text(Log(t, q, None, None, tau).csv(), encoding="utf-8")
    facts = examine(path).facts
    assert facts is not None
    assert facts.repeated == 199
    np.testing.assert_allclose(facts.gaps, [(699 / RATE, 0.505)])
    assert facts.missing == 1
    assert 0.15 < facts.standstill < 0.25
    assert facts.move == (1, 2, 3)
    said = "\n".join(lines(examine(path)))
    for words in (
        "199 rows repeat",
        "a gap of 0.505 s at 3.495 s",
        "1 rows without a number",
        "standstill 18%",
    ):
        assert words in said, words


def test_a_recording_is_listed_by_its_topics(tmp_path: Path) -> None:
    path = bag(arm_log(samples=60), tmp_path / "bag", ".mcap")
    result = examine(path)
    assert result.mapping.joints == ("fore_joint", "base_joint", "upper_joint")
    assert "set them base to tip" in result.reasons["joints"]
    assert not result.plain
    listed = data(result)["streams"][0]
    assert (listed["name"], listed["rows"], listed["rate"]) == ("/joint_states", 60, pytest.approx(RATE))
    text = map_text(result.mapping, result.reasons)
    assert map_of_text(text).joints == result.mapping.joints


def test_second_encoders_of_some_joints_are_proposed(tmp_path: Path) -> None:
    log = arm_log()
    secondary = np.column_stack([log.q[:, 0], log.q[:, 1], np.zeros(log.samples)])
    path = tmp_path / "log.mat"
    data_of = {
        "rec": {
            "t": log.t,
            "pos_mot_deg": np.degrees(log.q),
            "pos_se_deg": np.degrees(secondary),
            "torque_nm": log.tau,
        }
    }
    path.write_bytes(matlab(data_of))
    result = examine(path)
    assert result.mapping.groups["ql"].joints == (1, 2)
    assert result.log is not None
    assert result.log.linked == (0, 1)


def test_sparklines() -> None:
    assert spark(np.arange(8.0), 8) == "▁▂▃▄▅▆▇█"
    assert spark(np.zeros(4), 4) == "▁▁▁▁"
    assert spark(np.array([0.0, np.nan, 1.0]), 3) == "▁ █"
    assert len(spark(np.arange(1000.0), 48)) == 48


@given(
    st.lists(
        st.text(min_size=1, max_size=12).filter(lambda s: s.strip()), min_size=1, max_size=4, unique=True
    )
)
def test_a_map_reads_back_whatever_columns_are_called(names: list[str]) -> None:
    try:
        map_of_text("q: 'a'")
        channel = Channel(tuple(names), Place("x"), "deg", {"sign": (Fraction(1),)})
        text = map_text(LogMap({"q": channel}, tuple(names), "/topic name"), {"q": "why"}, ())
        back = map_of_text(text)
    except UnicodeEncodeError:
        return
    assert back.groups["q"].columns == tuple(names)
    assert (back.joints, back.topic, back.groups["q"].unit) == (tuple(names), "/topic name", "deg")


def test_joints_of_several_publishers_are_all_listed(tmp_path: Path) -> None:
    path = bag(arm_log(samples=60), tmp_path / "bag", ".db3", name_of=lambda k: (0,) if k % 3 else (1, 2))
    columns = data(examine(path))["streams"][0]["columns"]
    effort = {column["name"]: column["share"] for column in columns if column["name"].startswith("effort")}
    assert effort == {"effort.base_joint": 1.0, "effort.upper_joint": 1.0, "effort.fore_joint": 1.0}
