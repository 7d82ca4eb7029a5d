"""What is pruned, that its errors stay within what is proven and asked for, and what is refused."""

from __future__ import annotations

import dataclasses
import json
import re
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import robodyn.optimize.prune.pruning
from prune.limited import limited, random_limited
from records.made import bundled
from robodyn.counts import count
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.errors import InputError
from robodyn.kernels.generate import Generated, Options, generate, program
from robodyn.optimize.prune import PRUNED, PruneError, parse_tolerance, peaks_of, prune
from robodyn.optimize.prune.bounds import proven_errors
from robodyn.optimize.prune.box import box_of, draw, values
from robodyn.robot import Robot
from robodyn.robot.model import Limits
from robodyn_cli.main import main

PERCENT = Fraction(1, 100)
FAST = Options(optimize="fast")
Capture = pytest.CaptureFixture[str]

ARM = """
name: arm
gravity: [0, 0, -9.8]
links:
  - {joint: revolute, mass: 3, com: [0.1, 0, 0.2], inertia: {xx: 0.1, yy: 0.2, zz: 0.25},
     friction: {viscous: 0.5, coulomb: 0.01},
     limits: {position: [-pi, pi], velocity: 3, acceleration: 10}}
  - {joint: revolute, alpha: pi/2, a: 0.4, mass: 2, com: [0.2, 0.0001, 0.1],
     inertia: {xx: 0.1, yy: 0.2, zz: 0.2, xy: 0.0001, yz: 0.0002}, motor_inertia: 0.3,
     limits: {position: [-2, 2], velocity: 2, acceleration: 10}}
  - {joint: prismatic, alpha: pi/2, mass: 1, com: [0, 0.001, 0.1],
     inertia: {xx: 0.001, yy: 0.001, zz: 0.0002},
     limits: {position: [0.1, 0.4], velocity: 0.5, acceleration: 4}}
"""


@pytest.fixture(scope="module")
def arm(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The file of a small arm with limits and with terms that hardly matter."""
    path = tmp_path_factory.mktemp("prune") / "arm.yaml"
    path.write_text(ARM, encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def puma() -> Generated:
    """The PUMA 560's inverse dynamics, pruned to 1 %."""
    return generate(bundled("puma560"), Options(("inverse_dynamics",), prune=PERCENT))


def worst(robot: Robot, function: str, one: Any, other: Any, states: int, seed: int) -> Any:
    """The largest differences at random states, in chunks."""
    box = box_of(robot, FUNCTIONS[function].input_names)
    found = np.zeros(robot.n)
    for k in range(0, states, 20_000):
        at = draw(box, min(20_000, states - k), seed + k)
        found = np.maximum(found, np.abs(values(one, box, at) - values(other, box, at)).max(axis=1))
    return found


# --- the PUMA 560 -------------------------------------------------------------------------------------------


def test_the_pumas_errors_stay_within_what_is_proven_and_asked_for(puma: Generated) -> None:
    pruning = puma.prunings["inverse_dynamics"]
    without = count(program(bundled("puma560"), "inverse_dynamics")).total
    assert (pruning.before, pruning.after) == (without, puma.counts["inverse_dynamics"].total)
    assert pruning.after < min(without, 305)  # 305: Armstrong's
    for peak, proven, sampled in zip(pruning.peaks, pruning.proven, pruning.sampled, strict=True):
        assert sampled <= proven <= peak / 100
        assert proven <= 3 * sampled
    robot = bundled("puma560")
    original = program(robot, "inverse_dynamics")
    ((_, pruned),) = puma.unit.functions
    found = worst(robot, "inverse_dynamics", original, pruned, 50_000, 11)
    assert (found <= np.array(pruning.proven)).all()
    assert (found >= 0.3 * np.array(pruning.sampled)).all()  # and something was looked at


def test_header_and_fortran_say_what_was_done(puma: Generated) -> None:
    files = puma.files()
    pruning = puma.prunings["inverse_dynamics"]
    for name, mark in (("puma560.h", r"\n \*"), ("puma560.f90", "\n!")):
        text = re.sub(r"\s+", " ", re.sub(mark, " ", files[name]))
        assert "Pruned to 1 % of each joint's peak torque" in text
        assert "joints 1, 2, 3, 4, 5, 6: q -3.14159 .. 3.14159 rad, |qd| <= 3 rad/s, |qdd| <= 10" in text
        assert all(re.sub(r"\s+", " ", line).strip() in text for line in pruning.notes())


def test_limits_alone_change_nothing() -> None:
    robot = bundled("puma560")
    bare = dataclasses.replace(
        robot,
        links=tuple(
            dataclasses.replace(link, joint=dataclasses.replace(link.joint, limits=Limits()))
            for link in robot.links
        ),
    )
    assert all(link.joint.limits.acceleration == 10 for link in robot.links)
    assert programs(robot) == programs(bare)


def programs(robot: Robot) -> dict[str, str]:
    """What the files compute, without their heads, which state the limits."""
    return {
        name: text.split("*/", 1)[-1] if name.endswith((".c", ".h")) else text[text.index("\nmodule ") :]
        for name, text in generate(robot).files().items()
    }


# --- any arm ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(1, 5))
def test_random_arms_keep_to_their_bounds(seed: int) -> None:
    robot = random_limited(seed, 2 + seed % 2)
    peaks = peaks_of(robot)
    for function in PRUNED:
        original = program(robot, function, FAST)
        smaller, pruning = prune(robot, function, original, Fraction(1, 20))
        assert pruning.after == count(smaller).total <= pruning.before == count(original).total
        found = worst(robot, function, original, smaller, 20_000, seed)
        allowed = np.array(peaks) / 20
        assert (found <= np.array(pruning.proven) + 1e-11 * np.array(peaks)).all()
        assert (np.array(pruning.proven) <= allowed).all()


def test_more_is_dropped_where_more_may_be_wrong() -> None:
    robot = limited(bundled("puma560_3dof"))
    original = program(robot, "inverse_dynamics", FAST)
    totals = [
        prune(robot, "inverse_dynamics", original, Fraction(share))[1].after
        for share in ("0.000001", "0.01", "0.2")
    ]
    assert totals == sorted(totals, reverse=True)
    assert 0 <= count(original).total - totals[0] <= 1  # nothing is dropped, and the passes run once more
    assert totals[0] > totals[1] > totals[2]


@pytest.mark.parametrize(("factor", "words"), [(0.0, "above the proven"), (2.0, "above the tolerance")])
def test_a_bound_that_does_not_hold_is_noticed(
    factor: float, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot = limited(bundled("puma560_3dof"))
    original = program(robot, "inverse_dynamics", FAST)
    honest = proven_errors
    monkeypatch.setattr(
        robodyn.optimize.prune.pruning,
        "proven_errors",
        lambda *given: [factor * bound for bound in honest(*given)],
    )
    with pytest.raises(PruneError, match=words):
        prune(robot, "inverse_dynamics", original, PERCENT)


def test_an_arm_without_torques_stays_as_it_is() -> None:
    robot = dataclasses.replace(random_limited(1, 1), gravity=(Fraction(0),) * 3)
    link = robot.links[0]
    nothing = dataclasses.replace(
        link,
        mass=Fraction(0),
        com=(Fraction(0),) * 3,
        inertia=type(link.inertia)(),
        joint=dataclasses.replace(
            link.joint, motor_inertia=Fraction(0), viscous=Fraction(0), coulomb=Fraction(0)
        ),
    )
    robot = dataclasses.replace(robot, links=(nothing,))
    _, pruning = prune(robot, "inverse_dynamics", program(robot, "inverse_dynamics"), PERCENT)
    assert (pruning.peaks, pruning.proven, pruning.before, pruning.after) == ((0.0,), (0.0,), 0, 0)
    assert pruning.to_dict()["joints"][0]["share"] == 0.0


def test_the_mass_matrix_stays_exact() -> None:
    robot = limited(bundled("puma560_3dof"))
    pruned, plain = (generate(robot, Options(optimize="fast", prune=share)) for share in (PERCENT, None))
    assert set(pruned.prunings) == set(PRUNED)
    for (interface, one), (_, other) in zip(pruned.unit.functions, plain.unit.functions, strict=True):
        assert (one == other) == (interface.function in ("mass_matrix", "forward_dynamics"))
    assert pruned.files() == generate(robot, Options(optimize="fast", prune=PERCENT)).files()


# --- refusals -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("text", ["1%", "0.01", " 1 % ", "1e-2", "1e0%"])
def test_a_share_may_be_written_in_two_ways(text: str) -> None:
    assert parse_tolerance(text) == PERCENT


@pytest.mark.parametrize(
    "text", ["", "%", "0", "-1%", "100%", "1", "nan", "inf", "one", "1e-999999999", "1%%"]
)
def test_what_is_no_share_is_refused(text: str) -> None:
    with pytest.raises(InputError, match="1%"):
        parse_tolerance(text)
    with pytest.raises(InputError, match="not a share"):
        Options(prune=Fraction(1))


def run(capsys: Capture, *arguments: str, code: int = 0) -> tuple[str, str]:
    assert main(list(arguments)) == code
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return out, err


def test_what_cannot_be_pruned_is_refused(capsys: Capture, arm: Path, tmp_path: Path) -> None:
    out, err = run(capsys, "gen", "puma560_d2", "--prune", "1%", "-o", str(tmp_path / "out"), code=2)
    assert not out
    assert "no position, velocity, acceleration of joints 1, 2, 3, 4, 5, 6" in err
    assert "limits: {position: [-pi, pi], velocity: 3, acceleration: 10}" in err
    assert not (tmp_path / "out").exists()
    lacking = tmp_path / "lacking.yaml"
    lacking.write_text(ARM.replace("velocity: 2, ", ""), encoding="utf-8")
    _, err = run(capsys, "flops", str(lacking), "--prune", "1%", code=2)
    assert "found no velocity of joint 2;" in err
    lacking.write_text(ARM.replace("mass: 1,", "mass: m_tool,"), encoding="utf-8")
    _, err = run(capsys, "flops", str(lacking), "--prune", "1%", code=2)
    assert "m_tool" in err
    assert "cannot be pruned" in err
    _, err = run(capsys, "flops", str(arm), "--functions", "mass_matrix", "--prune", "1%", code=2)
    assert "mass_matrix cannot be pruned" in err


# --- the command line ---------------------------------------------------------------------------------------


def test_flops_tells_the_errors(capsys: Capture, arm: Path) -> None:
    out, _ = run(capsys, "flops", str(arm), "--prune", "1%")
    assert "Pruned to 1 % of each joint's peak torque" in out
    assert re.search(r"joint 3: peak [\d.]+, error proven below [\d.e-]+ \([\d.]+ %\), sampled up to", out)
    found = json.loads(run(capsys, "flops", str(arm), "--prune", "0.01", "--json")[0])
    plain = json.loads(run(capsys, "flops", str(arm), "--json")[0])
    assert "prune" not in plain
    told = found["prune"]
    assert (told["tolerance"], told["before"], told["after"]) == (0.01, plain["total"], found["total"])
    assert found["total"] < plain["total"]
    assert [row["joint"] for row in told["joints"]] == [1, 2, 3]
    for row in told["joints"]:
        assert row["sampled"] <= row["proven"] <= 0.01 * row["peak"]
        assert row["share"] <= 0.01


def test_gen_writes_what_it_tells(capsys: Capture, arm: Path, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    out, _ = run(capsys, "gen", str(arm), "--prune", "1%", "-o", str(folder), "--json")
    records = {record["function"]: record for record in json.loads(out)["functions"]}
    assert {name for name, record in records.items() if "prune" in record} == set(PRUNED)
    header = (folder / "arm.h").read_text(encoding="utf-8")
    assert "Pruned to 1 %" in header
    assert "joint 3: q 0.1 .. 0.4 m, |qd| <= 0.5 m/s, |qdd| <= 4 m/s^2" in header
    for name in PRUNED:
        told = records[name]["prune"]
        assert f"{name}: {told['before']} operations without, {told['after']} with" in header
    run(capsys, "gen", str(arm), "--prune", "1%", "-o", str(folder), "--check")
    run(capsys, "gen", str(arm), "-o", str(folder), "--check", code=1)
