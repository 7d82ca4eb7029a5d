"""Maps of columns: as YAML, as one line, and everything that one can have wrong."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from robodyn.errors import InputError
from robodyn.logs.log import Log, read_log
from robodyn.logs.mapping import LogMap, map_of_columns, map_of_text
from robodyn.logs.units import SI, SI_PRISMATIC, UnknownUnit, names_of, scaled, unit_of
from robodyn.robot import load

K = 20


def table(folder: Path, **columns: float) -> Path:
    """A log of constant ``columns``, but for t and q1, which rise."""
    names = ["t", "q1", *columns]
    rows = ([k, k / 10, *columns.values()] for k in range(K))
    path = folder / "log.csv"
    path.write_text("\n".join([",".join(names), *(",".join(map(str, row)) for row in rows)]) + "\n")
    return path


def read(folder: Path, text: str, n: int | None = None, **columns: float) -> Log:
    mapping = map_of_text(text) if ":" in text else map_of_columns(text)
    return read_log(table(folder, **columns), n, mapping=mapping)


# --- units ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "group", "factor"),
    [
        ("deg", "q", math.pi / 180), ("°", "q", math.pi / 180), ("rev", "q", 2 * math.pi),
        ("mrad", "q", 1e-3), ("deg/s", "qd", math.pi / 180), ("°/s", "qd", math.pi / 180),
        ("rpm", "qd", 2 * math.pi / 60),
        ("deg/s²", "qdd", math.pi / 180), ("rad/s^2", "qdd", 1.0), ("ms", "t", 1e-3), ("ns", "t", 1e-9),
        ("µs", "t", 1e-6), ("mNm", "tau", 1e-3), ("N*m", "tau", 1.0), ("N·m", "tau", 1.0),
        ("Nmm", "tau", 1e-3),
        ("0.5*N*m", "tau", 0.5), ("-1*Nm", "tau", -1.0), ("pi/2048*rad", "q", math.pi / 2048),
        ("kgf cm", "tau", 0.0980665), ("lbf ft", "tau", 1.3558179483314004), ("mA", "tau", 1e-3),
        ("%", "tau", 0.01), ("‰", "tau", 1e-3),
    ],
)  # fmt: skip
def test_units_have_their_factors(text: str, group: str, factor: float) -> None:
    assert float(unit_of(text, group).factor) == pytest.approx(factor, rel=1e-15)


def test_every_unit_is_of_the_joints_it_fits() -> None:
    for group in ("q", "qd", "qdd", "tau", "ql"):
        for name in names_of(group):
            kinds = set()
            for prismatic in (False, True):
                try:
                    kinds.add(unit_of(name, group, prismatic=prismatic).kind)
                except UnknownUnit:
                    continue
            assert len(kinds) == 1, (group, name)
        assert unit_of(SI[group], group).factor == 1
        assert unit_of(SI_PRISMATIC[group], group, prismatic=True).factor == 1


@pytest.mark.parametrize(
    ("text", "group", "near"), [("deg", "qd", "deg/s"), ("degs", "q", "deg"), ("Mn", "tau", "mN")]
)
def test_a_unit_that_is_none_names_the_nearest(text: str, group: str, near: str) -> None:
    with pytest.raises(UnknownUnit) as caught:
        unit_of(text, group)
    assert near in caught.value.expected


@given(st.fractions(min_value=Fraction(1, 10**9), max_value=10**9), st.floats(-1e6, 1e6))
def test_scaling_is_right_to_the_last_digits(factor: Fraction, value: float) -> None:
    x = np.array([value])
    scaled(x, factor)
    exact = float(Fraction(value) * factor)
    assert abs(x[0] - exact) <= 4e-16 * abs(exact)


def test_whole_parts_divide_exactly() -> None:
    x = np.array([8.0, 16.0, 24.0, 3.0])
    scaled(x, Fraction(1, 1000))
    assert x.tolist() == [0.008, 0.016, 0.024, 0.003]
    scaled(x, Fraction(1))
    assert x.tolist() == [0.008, 0.016, 0.024, 0.003]


# --- what a map does --------------------------------------------------------------------------------------


def test_one_line_says_columns_units_and_signs(tmp_path: Path) -> None:
    log = read(
        tmp_path, "t=t[ms],q=joint_%d[deg],tau=-load_%d[mN m]", joint_1=180, joint_2=90, load_1=1, load_2=2
    )
    assert log.t[1] == 1e-3
    np.testing.assert_allclose(log.q[0], [math.pi, math.pi / 2], rtol=1e-15)
    assert log.tau[0].tolist() == [-0.001, -0.002]
    assert log.qd is None


@pytest.mark.parametrize(
    ("tau", "value"),
    [
        ("{columns: i, unit: A, torque_constant: 0.1, gear: 100}", 30.0),
        ("{columns: i, unit: mA, torque_constant: 0.1}", 3e-4),
        ("{columns: i, unit: rated, rated: 12}", 36.0),
        ("{columns: i, unit: permille, rated: 12, gear: 50}", 1.8),
        ("{columns: i, factor: 2/3, offset: -1}", 1.0),
        ("{columns: i, unit: mN m, gear: 100, zero: 1, sign: -1}", -0.2),
        ("{columns: i, unit: raw, factor: pi}", 3 * math.pi),
        ("i[4*N m]", 12.0),
    ],
)  # fmt: skip
def test_torques_of_every_kind(tau: str, value: float, tmp_path: Path) -> None:
    log = read(tmp_path, f"q: q1\ntau: {tau}\n", i=3)
    np.testing.assert_allclose(log.tau, value, rtol=1e-15)


@pytest.mark.parametrize(
    ("q", "value"),
    [
        ("{columns: x, unit: ticks, counts_per_turn: 4096}", 2 * math.pi),
        ("{columns: x, counts_per_turn: 4096, gear: 8, zero: 2048}", math.pi / 8),
        ("{columns: x, unit: deg, gear: -2, offset: pi}", math.pi - 2048 * math.pi / 180),
        ("{columns: x, unit: rev, zero: 4095}", 2 * math.pi),
    ],
)  # fmt: skip
def test_positions_of_every_kind(q: str, value: float, tmp_path: Path) -> None:
    log = read(tmp_path, f"q: {q}\ntau: i\n", x=4096, i=0)
    np.testing.assert_allclose(log.q, value, rtol=1e-14)


def test_a_slide_has_lengths_and_forces_or_a_gear(tmp_path: Path) -> None:
    robot = load("stanford_3dof", warn=lambda _: None)
    text = "q: [a, a, d]\ntau: {columns: [b, b, f], unit: %s}\n"
    path = table(tmp_path, a=1, d=500, b=2, f=7)
    with pytest.raises(InputError, match="the unit does not fit a revolute joint; found 'mm'"):
        read_log(
            path, robot=robot, mapping=map_of_text("q: {columns: [a, a, d], unit: mm}\ntau: [b, b, f]\n")
        )
    with pytest.raises(InputError, match="the unit does not fit a prismatic joint; found 'mN m'"):
        read_log(path, robot=robot, mapping=map_of_text(text % "mN m"))
    geared = "q: {columns: [a, a, d], unit: deg, gear: [1, 1, 100*pi/180]}\ntau: [b, b, f]\n"
    log = read_log(path, robot=robot, mapping=map_of_text(geared))
    assert log.q[0, 2] == pytest.approx(5.0, rel=1e-14)
    assert log.tau[0].tolist() == [2.0, 2.0, 7.0]


@pytest.mark.parametrize(
    ("names", "pattern"),
    [
        (["x_0", "x_1", "x_2"], "x_%d"), (["x1", "x2", "x3"], "x%d"), (["x01", "x02", "x03"], "x%02d"),
        (["x4", "x5", "x6"], "x4..x6"), (["x4", "x5", "x6"], "x4..6"), (["x[0]", "x[1]", "x[2]"], "x[%d]"),
        (["lift x", "tilt x", "turn x"], "%s x"), (["b", "a", "c"], "[b, a, c]"),
        (["x.0", "x.1", "x.2"], "x"),
    ],
)  # fmt: skip
def test_columns_by_number_name_range_and_list(names: list[str], pattern: str, tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    path.write_text(",".join(["t", *names, "tau1", "tau2", "tau3"]) + "\n0,1,2,3,4,5,6\n1,1,2,3,4,5,6\n")
    quoted = pattern if pattern.startswith("[") else f'"{pattern}"'
    log = read_log(path, 3, mapping=map_of_text(f"joints: [lift, tilt, turn]\nq: {quoted}\n"))
    assert log.q[0].tolist() == [1, 2, 3]
    assert read_log(path, mapping=map_of_text(f"joints: [lift, tilt, turn]\nq: {quoted}\n")).n == 3


def test_the_file_may_state_its_units(tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    path.write_text("t [ms];q1 [deg];tau1 [mNm]\n0;180;5\n8;180;5\n")
    log = read_log(path)
    assert (log.t.tolist(), log.q[0, 0], log.tau[0, 0]) == ([0, 0.008], pytest.approx(math.pi), 0.005)
    log = read_log(path, mapping=map_of_columns("q=q1[rad]"))  # the map's goes before
    assert log.q[0, 0] == 180
    path.write_text("t [ms];q1 [furlong];tau1 [mNm]\n0;180;5\n8;180;5\n")
    with pytest.raises(InputError, match="that is what the file states"):
        read_log(path)


def test_what_the_description_says_of_a_gear(tmp_path: Path) -> None:
    """A link of a description may have a gear; without one the map has to say."""
    robot = load("puma560_3dof", warn=lambda _: None)
    path = table(tmp_path, x=1, i=2)
    text = "q: [x, x, x]\ntau: {columns: [i, i, i], unit: A}\n"
    with pytest.raises(
        InputError, match=r"tau in A needs a number; found no torque_constant; .* at the motor"
    ):
        read_log(path, robot=robot, mapping=map_of_text(text))
    with pytest.raises(InputError, match="the description has no gear for joint 1"):
        read_log(
            path, robot=robot, mapping=map_of_text("q: {columns: [x, x, x], gear: robot}\ntau: [i, i, i]\n")
        )


# --- what is wrong with one -------------------------------------------------------------------------------


def test_numbers_from_0_with_one_too_many_are_asked_for(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"numbered from 0, and there is one too many.*x0\.\.x1"):
        read(tmp_path, "q=x%d,tau=x%d", 2, x0=1, x1=2, x2=3)
    log = read(tmp_path, "q=x0..x1,tau=x1..x2", 2, x0=1, x1=2, x2=3)
    assert (log.q[0].tolist(), log.tau[0].tolist()) == ([1, 2], [2, 3])


def test_lists_of_another_length_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="q has another number of columns than the arm of joints; found 2"):
        read(tmp_path, "q: [x, y]\ntau: [x, y, x]\n", 3, x=1, y=2)
    with pytest.raises(InputError, match="the map has a joint that the robot has not; found joint 3"):
        read(tmp_path, "q: [x, y]\ntau: [x, y]\nql: {columns: [x], joints: [3]}\n", 2, x=1, y=2)


@given(st.text(max_size=80))
def test_no_text_is_more_than_refused(text: str) -> None:
    for reader in (map_of_columns, map_of_text):
        where: object = None
        try:
            assert isinstance(reader(text), LogMap)
            continue
        except InputError as error:
            where = error.where
        assert where is not None
