"""``robodyn simulate``: motions known in closed form, what is written, what is said."""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from cli.command import Capture, run, run_json
from robodyn.logs.log import read_log
from robodyn.robot import load, to_yaml
from robodyn.simulate.kinematics import Kinematics
from robodyn_cli import progress
from robodyn_testing import covering, require_module

Floats = NDArray[np.float64]

pytestmark = pytest.mark.usefixtures("robots")

SLIDE = """\
name: slide
links:
  - joint: prismatic
    alpha: pi/2
    mass: m
    limits: {position: [-1, 1], velocity: 2, acceleration: 20}
"""
# A pendulum in the plane of x and y of a base whose gravity is along -y.
PENDULUM = """\
name: pendulum
gravity: [0, -9.81, 0]
links:
  - {joint: revolute, theta: -pi/2, mass: 2, com: [0.5, 0, 0], inertia: {zz: 0.1}}
"""
ROBOTS = {
    "slide": SLIDE,
    "pendulum": PENDULUM,
    "sticky": PENDULUM.replace("zz: 0.1}", "zz: 0.1}, friction: {coulomb: 10}"),
    "weak": SLIDE.replace("mass: m", "mass: 2") + "    effects: [{effect: torque_saturation, limit: 1}]\n",
    "heavy": SLIDE.replace("mass: m", "mass: 4"),
    "elastic": """\
name: elastic
gravity: [0, 0, 0]
links:
  - {joint: revolute, inertia: {zz: 1}, motor_inertia: 0.01,
     effects: [{effect: joint_elasticity, stiffness: 1e4, damping: 2}]}
""",
}


@pytest.fixture
def robots(elsewhere: Path) -> None:
    for name, text in ROBOTS.items():
        _, _, links = text.partition("\n")
        (elsewhere / f"{name}.yaml").write_text(f"name: {name}\n{links}")


def simulate(capsys: Capture, command: str, code: int = 0) -> tuple[str, str]:
    return run(capsys, f"simulate {command}", code=code)


def figures(capsys: Capture, command: str) -> Any:
    return run_json(capsys, f"simulate {command}")


def made() -> set[str]:
    """What there is in the folder besides the robots."""
    return {path.name for path in Path().iterdir() if path.suffix != ".yaml"}


def table(path: str, header: str, rows: Floats) -> None:
    Path(path).write_text(header + "\n" + "\n".join(",".join(map(repr, row)) for row in rows.tolist()) + "\n")


# --- motions known in closed form -------------------------------------------------------------------------


@pytest.mark.parametrize("solver", ["adaptive", "rk4"])
def test_a_constant_force_gives_a_parabola(solver: str, capsys: Capture) -> None:
    table("f.csv", "t,tau1,what", np.array([[5.0, 3.0, 0], [5.5, 3.0, 0], [6.0, 3.0, 0]]))
    simulate(capsys, f"slide.yaml --torque f.csv --param m=2 --speed 0.1 --rate 100 --solver {solver}")
    log = read_log("slide.csv")
    assert log.t.tolist() == pytest.approx(np.arange(101) / 100)
    np.testing.assert_allclose(log.q[:, 0], 0.1 * log.t + 3 * log.t**2 / 4, atol=1e-12)
    np.testing.assert_allclose(log.qd[:, 0] if log.qd is not None else 0, 0.1 + 1.5 * log.t, atol=1e-12)
    assert set(np.ravel(log.qdd if log.qdd is not None else 0)) == {1.5}
    assert (log.tau == 3).all()


def test_rows_of_torques_are_joined_and_the_last_one_is_held(capsys: Capture) -> None:
    t = np.arange(11) / 10
    table("ramp.csv", "tau1,t", np.column_stack([6 * t, t]))
    _, err = simulate(capsys, "slide.yaml --torque ramp.csv --linear --param m=2 --duration 2 --rate 10")
    assert "the torques end at 1 s; the last row is held" in err
    assert read_log("slide.csv").q[[10, -1], 0] == pytest.approx([0.5, 0.5 + 1.5 + 3 / 2])


def test_a_joint_that_friction_holds_is_stuck(capsys: Capture) -> None:
    """Gravity asks for at most 9.81 N m, the bearing gives 10."""
    (joint,) = figures(capsys, "sticky.yaml --from 1.5 --duration 0.5")["joints"]
    assert (joint["stuck"], joint["lowest"], joint["highest"]) == (1.0, 1.5, 1.5)
    out, err = simulate(capsys, "sticky.yaml --from 1.5 --duration 0.5")
    assert "100 %" in out.splitlines()[-1]
    assert err == ""  # no energy at all moved: nothing is off
    (joint,) = figures(capsys, "sticky.yaml --speed 3 --duration 1")["joints"]
    assert 0.3 < joint["stuck"] < 1


# --- motions to follow ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("controller", "profile"),
    covering(["feedforward", "pd", "computed-torque"], ["quintic", "trapezoid"], rest="slow"),
)
def test_a_controller_leads_the_joint_where_it_should_go(
    controller: str, profile: str, capsys: Capture
) -> None:
    motion = f"--to 1/2 --from 0.1 --profile {profile}"
    found = figures(capsys, f"slide.yaml {motion} --controller {controller} --param m=2")
    log = read_log("slide.csv")
    assert (log.t[-1], log.q[0, 0]) == (2, 0.1)
    assert log.q[-1, 0] == pytest.approx(0.5, abs=1e-3)
    assert found["joints"][0]["peak_error"] < 1e-3
    fastest = {"quintic": 1.875, "trapezoid": 4 / 3}[profile] * 0.4 / 2
    assert found["joints"][0]["peak_speed"] == pytest.approx(fastest, rel=1e-2)
    assert ("kp" in found["drive"]) is (controller != "feedforward")


def test_a_controller_that_takes_the_robot_for_another(capsys: Capture) -> None:
    """Twice the mass in the model, twice the way in the open loop."""
    common = "slide.yaml --to 0.2 --param m=2 --controller-model heavy.yaml"
    for controller, end in (("feedforward", 0.4), ("pd", 0.2), ("computed-torque", 0.2)):
        simulate(capsys, f"{common} --controller {controller}")
        assert read_log("slide.csv").q[-1, 0] == pytest.approx(end, abs=5e-3)
    told = json.loads(Path("slide.csv.json").read_text())["options"]["drive"]
    assert (told["controller"], told["model"]) == ("computed_torque", "heavy")


@pytest.mark.parametrize(
    ("options", "robot", "kp", "kd"),
    [
        ("--param m=2", "slide", 900 * 2, 60 * 2),
        ("--param m=2 --control-rate 20", "slide", 10**2 * 2, 2 * 10 * 2),
        ("--param m=2 --controller computed-torque", "slide", 900, 60),
        ("--param m=2 --kp 7 --kd 5", "slide", 7, 5),
        # The motor alone is 101 times as quick as the controller, which moves both, believes.
        ("", "elastic", (500 / 101) ** 2 * 1.01, 2 * 500 / 101 * 1.01),
        ("--controller computed-torque", "elastic", (500 / 101) ** 2, 2 * 500 / 101),
    ],
)
def test_gains_are_made_for_the_inertia_and_the_rate(
    options: str, robot: str, kp: float, kd: float, capsys: Capture
) -> None:
    drive = figures(capsys, f"{robot}.yaml --to 0.1 {options}")["drive"]
    assert (drive["kp"], drive["kd"]) == (pytest.approx([kp]), pytest.approx([kd]))


def test_excitation_goes_by_the_limits_or_says_which_are_assumed(capsys: Capture) -> None:
    assert simulate(capsys, "slide.yaml --excite --duration 4 --param m=2 --harmonics 3 --seed 3")[1] == ""
    assert 0.1 < np.abs(read_log("slide.csv").q).max() < 1
    _, err = simulate(capsys, "pendulum.yaml --excite --duration 1 --base-frequency 2")
    assert "pendulum has no limits for joint 1; assumed: -3.14 to 3.14 rad, 2 rad/s, 10 rad/s^2" in err


def test_a_motion_from_a_file_beyond_its_limits_is_told(capsys: Capture) -> None:
    t = np.arange(101) / 50
    table("motion.csv", "t,q1", np.column_stack([t, 1.5 * np.sin(t)]))
    _, err = simulate(capsys, "slide.yaml --trajectory motion.csv --param m=2")
    assert "warning: joint 1 is at 1.5 m at 1.58 s, outside its limits -1 to 1" in err
    assert read_log("slide.csv").q[-1, 0] == pytest.approx(1.5 * math.sin(2), abs=1e-3)
    told = json.loads(Path("slide.csv.json").read_text())["options"]["drive"]
    assert told["trajectory"]["file"] == "motion.csv"


def test_a_line_is_the_same_in_the_world_of_an_arm_that_stands_elsewhere(capsys: Capture) -> None:
    common = "--from 0,-0.5,0.3 --duration 1 --rate 50"
    simulate(capsys, f"puma560_3dof --line 0.5,0.3,0.3:0.4,-0.1,0.4 --point 0,-0.43,0 {common}")
    robot, log = load("puma560_3dof"), read_log("puma560_3dof.csv")
    way = Kinematics(robot, {}, (0, -0.43, 0), 3).position(log.q)
    np.testing.assert_allclose(way[[0, -1]], [[0.5, 0.3, 0.3], [0.4, -0.1, 0.4]], atol=1e-4)
    arm = to_yaml(robot).replace("links:", "base: {xyz: [1, 2, 0], rpy: [0, 0, pi/2]}\nlinks:")
    Path("there.yaml").write_text(arm + "tool: {xyz: [0, -0.43, 0]}\n")
    simulate(capsys, f"there.yaml --line 0.7,2.5,0.3:1.1,2.4,0.4 {common} -o there.csv")
    np.testing.assert_allclose(read_log("there.csv").q, log.q, atol=1e-9)


def test_positions_in_degrees_are_doubted(capsys: Capture) -> None:
    links = "{joint: revolute, inertia: {zz: 1}}, {joint: prismatic, mass: 1}"
    Path("arm.yaml").write_text(f"name: arm\ngravity: [0, 0, 0]\nlinks: [{links}]")
    _, err = simulate(capsys, "arm.yaml --to 90,10 --duration 0.1")
    assert (
        "warning: --to: more than one turn; found joint 1: 90 rad; positions are in rad: --to 90*pi/180,10"
        in err
    )
    assert "--from: more than one turn" in simulate(capsys, "arm.yaml --from -90,0 --duration 0.1")[1]
    assert "turn" not in simulate(capsys, "arm.yaml --to 6.28,10 --duration 0.1 --strict")[1]
    text = Path("arm.yaml").read_text().replace("zz: 1}", "zz: 1}, limits: {position: [-99, 99]}")
    Path("arm.yaml").write_text(text)
    assert "turn" not in simulate(capsys, "arm.yaml --to 90,10 --duration 0.1")[1]


# --- what is written and said -----------------------------------------------------------------------------


def test_log_provenance_and_table(capsys: Capture) -> None:
    out, err = simulate(capsys, "weak.yaml --to 0.5 --duration 0.5")
    assert made() == {".robodyn.sha256", "weak.csv", "weak.csv.json"}
    assert Path("weak.csv").read_text().startswith("t,q1,qd1,qdd1,tau1\n0.0,0.0,")
    lines = out.splitlines()
    assert lines[0] == "weak: wrote weak.csv, weak.csv.json"
    assert lines[1].startswith("0.5 s, 501 samples at 1000 Hz; adaptive: ")
    assert lines[2] == "pd at 1000 Hz: kp 1800; kd 120"
    assert "warning: the drive of joint 1 is at its limit" in err
    found = json.loads(Path("weak.csv.json").read_text())
    assert found["effects"] == [{"effect": "torque_saturation", "joint": 1, "limit": 1.0, "clips": "drive"}]
    assert found["options"]["drive"]["trajectory"]["kind"] == "quintic"
    assert found["energy"]["error"] < 1e-9
    assert (found["solver"], found["step"], found["seed"]) == ("adaptive", 0.01, 0)
    assert len(found["sha256"]) == 64


def test_text_on_stdout_in_a_file_and_as_parquet_are_alike(capsys: Capture) -> None:
    command = "slide.yaml --speed 1 --duration 0.01 --param m=2 -o"
    out, err = simulate(capsys, f"{command} -")
    assert made() == set()
    assert [line.count(",") for line in out.splitlines()] == [4] * 12
    assert "energy: stored 0 J" in err
    simulate(capsys, f"{command} a.csv")
    assert Path("a.csv").read_text() == out
    require_module("pyarrow")
    simulate(capsys, f"{command} new/a.parquet")
    for mine, its in zip(read_log("a.csv").arrays(), read_log("new/a.parquet").arrays(), strict=True):
        assert np.array_equal(mine, its)
    assert Path("new/a.parquet.json").read_text() == Path("a.csv.json").read_text()


def test_the_same_command_gives_the_same_bytes(capsys: Capture) -> None:
    command = (
        "slide.yaml --to 0.5 --duration 0.5 --param m=2 --position-noise 1e-4 --torque-noise 0.1 "
        "--velocity filtered --acceleration none --cutoff 50 --torque-resolution 0.01"
    )
    found = []
    for seed, name in ((5, "a"), (5, "b"), (6, "c")):
        simulate(capsys, f"{command} --seed {seed} -o {name}.csv")
        found.append([Path(name + end).read_bytes() for end in (".csv", ".csv.json")])
    assert found[0] == found[1]
    assert all(a != b for a, b in zip(found[0], found[2], strict=True))
    log, again = read_log("a.csv"), read_log("c.csv")
    assert log.qdd is None
    assert np.std(log.q - again.q) == pytest.approx(1e-4 * math.sqrt(2), rel=0.1)
    assert np.std(log.tau - again.tau) == pytest.approx(0.1 * math.sqrt(2), rel=0.1)
    steps = log.tau / 0.01
    np.testing.assert_allclose(steps, np.rint(steps), atol=1e-9)


def test_an_encoder_has_steps(capsys: Capture) -> None:
    simulate(capsys, "pendulum.yaml --from 1 --duration 0.3 --encoder-bits 10 --velocity difference")
    steps = read_log("pendulum.csv").q / (math.tau / 1024)
    np.testing.assert_allclose(steps, np.rint(steps), atol=1e-9)
    _, err = simulate(capsys, "slide.yaml --speed 1 --duration 0.1 --encoder-bits 10 --param m=2")
    assert "--encoder-bits does not apply to prismatic joints (1)" in err


def test_pictures(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    command = "pendulum.yaml --to 1 --duration 0.1 -o - --picture"
    with monkeypatch.context() as patch:
        patch.setitem(sys.modules, "matplotlib.figure", None)
        _, err = simulate(capsys, f"{command} p.svg", code=3)
    assert "pictures need matplotlib, which is not installed; pip install" in err
    assert made() == set()
    for name, head in (("p.svg", b"<?xml"), ("p.png", b"\x89PNG")):
        assert simulate(capsys, f"{command} {name}")[0].startswith("t,q1")
        assert Path(name).read_bytes().startswith(head)
    assert made() == {"p.svg", "p.png"}


def test_energies_that_do_not_balance_are_told(capsys: Capture) -> None:
    _, err = simulate(capsys, "pendulum.yaml --from 2 --solver rk4 --step 0.1 --rate 10")
    assert "warning: the energies do not balance: off by " in err
    assert "--step, or --solver adaptive" in err
    assert simulate(capsys, "pendulum.yaml --from 2 --solver rk4 --step 0.001 --rate 10")[1] == ""


def test_a_run_that_ends_early_leaves_nothing(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    _, err = simulate(capsys, "slide.yaml --to 0.1 --param m=2 --kp 1e300 --kd 1e300 --solver rk4", code=2)
    assert "the simulation ended at t = " in err

    def stop(line: progress.Line, text: str) -> None:
        assert "of 10 s" in text
        raise KeyboardInterrupt

    monkeypatch.setattr("robodyn_cli.simulate._LONG", -1.0)
    monkeypatch.setattr(progress.Line, "tell", stop)
    assert simulate(capsys, "pendulum.yaml --from 2 -o new/a.csv", code=130) == ("", "robodyn: interrupted\n")
    assert made() == set()
