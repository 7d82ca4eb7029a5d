"""``robodyn simulate``: motions known in closed form, what is written, what is said, what is refused."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.simulate.log import Log, read_log
from robodyn_cli import progress
from robodyn_cli import simulate as the_command
from robodyn_cli.main import main
from robodyn_testing import require_module

Capture = pytest.CaptureFixture[str]
Floats = NDArray[np.float64]

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
STICKY = PENDULUM.replace("name: pendulum", "name: sticky").replace(
    "inertia: {zz: 0.1}", "inertia: {zz: 0.1}, friction: {coulomb: 10}"
)
WEAK = SLIDE.replace("name: slide", "name: weak").replace("mass: m", "mass: 2") + (
    "    effects: [{effect: torque_saturation, limit: 1}]\n"
)
ELASTIC = """\
name: elastic
gravity: [0, 0, 0]
links:
  - joint: revolute
    inertia: {zz: 1}
    motor_inertia: 0.01
    effects: [{effect: joint_elasticity, stiffness: 1e4, damping: 2}]
"""

SOFT = ELASTIC.replace("name: elastic", "name: soft").replace("1e4, damping: 2", "k, damping: d")


@pytest.fixture(autouse=True)
def elsewhere(
    tmp_path: Path, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> Path:
    """Every test works in a folder of its own with the robots; what is compiled is shared."""
    for text in (SLIDE, PENDULUM, STICKY, WEAK, ELASTIC, SOFT):
        (tmp_path / f"{text.split()[1]}.yaml").write_text(text)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ROBODYN_CACHE", str(tmp_path_factory.getbasetemp() / "robodyn-cache"))
    monkeypatch.delenv("CC", raising=False)
    return tmp_path


def simulate(capsys: Capture, command: str, code: int = 0) -> tuple[str, str]:
    """Standard output and standard error."""
    assert main(["simulate", *command.split()]) == code, capsys.readouterr().err
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return out, err


def figures(capsys: Capture, command: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(simulate(capsys, command + " --json")[0])
    return found


def table(path: str, header: str, rows: Floats) -> None:
    Path(path).write_text(header + "\n" + "\n".join(",".join(map(repr, row)) for row in rows.tolist()) + "\n")


def made() -> set[str]:
    """What there is in the folder besides the robots."""
    return {path.name for path in Path().iterdir() if path.suffix != ".yaml"}


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


def test_rows_of_torques_are_held_or_joined(capsys: Capture) -> None:
    t = np.arange(11) / 10
    table("ramp.csv", "tau1,t", np.column_stack([6 * t, t]))
    simulate(capsys, "slide.yaml --torque ramp.csv --linear --param m=2")
    log = read_log("slide.csv")
    np.testing.assert_allclose(log.q[:, 0], log.t**3 / 2, atol=1e-12)
    simulate(capsys, "slide.yaml --torque ramp.csv --param m=2 --rate 10")
    speed = np.concatenate([[0], np.cumsum(3 * t[:-1] * 0.1)])
    held = read_log("slide.csv")
    np.testing.assert_allclose(held.q[-1, 0], np.sum(speed[:-1] * 0.1 + 3 * t[:-1] * 0.1**2 / 2), atol=1e-12)
    _, err = simulate(capsys, "slide.yaml --torque ramp.csv --linear --param m=2 --duration 2 --rate 10")
    assert "the torques end at 1 s; the last row is held" in err
    assert read_log("slide.csv").q[-1, 0] == pytest.approx(0.5 + 1.5 + 3 / 2)


def test_a_pendulum_swings_back_after_its_period(capsys: Capture) -> None:
    """Through the arithmetic-geometric mean; and by energy, its speed at the bottom."""
    start = 2.0
    inertia = 0.1 + 2 * 0.5**2
    a, b = 1.0, math.cos(start / 2)
    for _ in range(6):
        a, b = (a + b) / 2, math.sqrt(a * b)
    period = math.tau / math.sqrt(2 * 9.81 * 0.5 / inertia) / a
    found = figures(
        capsys, f"pendulum.yaml --from {start} --duration {period!r} --rate {200 / period!r} --rtol 1e-12"
    )
    assert found["drive"] == {"kind": "free"}
    log = read_log("pendulum.csv")
    assert log.samples == 201
    assert log.q[-1, 0] == pytest.approx(start, abs=1e-8)
    assert log.q[100, 0] == pytest.approx(-start, abs=1e-8)
    (joint,) = found["joints"]
    assert (joint["lowest"], joint["highest"]) == pytest.approx((-start, start), abs=1e-8)
    fastest = math.sqrt(2 * 2 * 9.81 * 0.5 * (1 - math.cos(start)) / inertia)
    assert joint["peak_speed"] == pytest.approx(fastest, rel=1e-6)
    assert found["energy"]["error"] < 1e-9
    assert joint["stuck"] is None


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


@pytest.mark.parametrize("controller", ["feedforward", "pd", "computed-torque"])
@pytest.mark.parametrize("profile", ["quintic", "trapezoid"])
def test_a_controller_leads_the_joint_where_it_should_go(
    controller: str, profile: str, capsys: Capture
) -> None:
    found = figures(
        capsys, f"slide.yaml --to 1/2 --from 0.1 --profile {profile} --controller {controller} --param m=2"
    )
    log = read_log("slide.csv")
    assert log.t[-1] == 2
    assert log.q[0, 0] == 0.1
    assert log.q[-1, 0] == pytest.approx(0.5, abs=1e-3)
    assert found["joints"][0]["peak_error"] < 1e-3
    fastest = {"quintic": 1.875, "trapezoid": 4 / 3}[profile] * 0.4 / 2
    assert found["joints"][0]["peak_speed"] == pytest.approx(fastest, rel=1e-2)
    assert ("kp" in found["drive"]) is (controller != "feedforward")


def test_a_controller_that_takes_the_robot_for_another(capsys: Capture) -> None:
    """Twice the mass in the model, twice the way in the open loop."""
    Path("heavy.yaml").write_text(SLIDE.replace("name: slide", "name: heavy").replace("mass: m", "mass: 4"))
    common = "slide.yaml --to 0.2 --param m=2 --model heavy.yaml"
    simulate(capsys, f"{common} --controller feedforward")
    assert read_log("slide.csv").q[-1, 0] == pytest.approx(0.4, abs=2e-3)
    for controller in ("pd", "computed-torque"):
        simulate(capsys, f"{common} --controller {controller}")
        assert read_log("slide.csv").q[-1, 0] == pytest.approx(0.2, abs=5e-3)
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
    assert drive["kp"] == pytest.approx([kp])
    assert drive["kd"] == pytest.approx([kd])


def test_excitation_stays_inside_the_limits(capsys: Capture) -> None:
    _, err = simulate(capsys, "slide.yaml --excite --duration 4 --param m=2 --seed 3 --harmonics 3")
    assert err == ""
    log = read_log("slide.csv")
    assert log.qd is not None
    assert log.qdd is not None
    shares = [np.abs(x).max() / most for x, most in ((log.q, 1), (log.qd, 2), (log.qdd, 20))]
    assert 0.95 < max(shares) < 1
    assert log.q[-1, 0] == pytest.approx(log.q[0, 0], abs=1e-3)
    simulate(capsys, "slide.yaml --excite --duration 4 --param m=2 --seed 4 --harmonics 3 -o other.csv")
    assert abs(read_log("other.csv").q[0, 0] - log.q[0, 0]) > 1e-3
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


def test_a_line_is_straight(capsys: Capture) -> None:
    from robodyn.robot import load
    from robodyn.simulate.kinematics import Kinematics

    simulate(
        capsys,
        "puma560_3dof --line 0.5,0.3,0.3:0.4,-0.1,0.4 --point 0,-0.43,0 --from 0,-0.5,0.3 --duration 1 "
        "--rate 50",
    )
    with pytest.warns(match="not physical"):
        robot = load("puma560_3dof")
    way = Kinematics(robot, {}, (0, -0.43, 0), 3).position(read_log("puma560_3dof.csv").q)
    np.testing.assert_allclose(way[[0, -1]], [[0.5, 0.3, 0.3], [0.4, -0.1, 0.4]], atol=1e-4)
    ahead = way[-1] - way[0]
    beside = np.cross(way - way[0], ahead / np.linalg.norm(ahead))
    assert np.abs(beside).max() < 1e-4


# --- what is written and said -----------------------------------------------------------------------------


def test_log_provenance_and_table(capsys: Capture) -> None:
    out, err = simulate(capsys, "weak.yaml --to 0.5 --duration 0.5")
    assert made() == {"weak.csv", "weak.csv.json"}
    assert Path("weak.csv").read_text().startswith("t,q1,qd1,qdd1,tau1\n0.0,0.0,")
    lines = out.splitlines()
    assert lines[0] == "weak: wrote weak.csv, weak.csv.json"
    assert lines[1].startswith("0.5 s, 501 samples at 1000 Hz; adaptive: ")
    assert lines[2] == "pd at 1000 Hz: kp 1800; kd 120"
    assert lines[3].startswith("energy: stored ")
    assert lines[4].split("  ")[-1] == "peak error"
    assert lines[5].split()[:1] == ["1"]
    assert "warning: the drive of joint 1 is at its limit" in err
    found = json.loads(Path("weak.csv.json").read_text())
    assert found["robot"] == "weak"
    assert found["effects"] == [{"effect": "torque_saturation", "joint": 1, "limit": 1.0, "clips": "drive"}]
    assert found["options"]["drive"]["trajectory"]["kind"] == "quintic"
    assert found["energy"]["error"] < 1e-9
    assert (found["solver"], found["step"], found["seed"]) == ("adaptive", 0.01, 0)
    assert len(found["sha256"]) == 64


def test_text_on_stdout(capsys: Capture) -> None:
    out, err = simulate(capsys, "slide.yaml --speed 1 --duration 0.01 -o - --param m=2")
    assert made() == set()
    assert [line.count(",") for line in out.splitlines()] == [4] * 12
    assert "energy: stored 0 J" in err
    simulate(capsys, "slide.yaml --speed 1 --duration 0.01 -o a.csv --param m=2")
    assert Path("a.csv").read_text() == out


def test_parquet_and_text_are_alike(capsys: Capture) -> None:
    require_module("pyarrow")
    for name in ("a.csv", "new/a.parquet"):
        simulate(capsys, f"slide.yaml --speed 1 --duration 0.1 -o {name} --param m=2")
    one, other = read_log("a.csv"), read_log("new/a.parquet")
    for mine, its in zip(one.arrays(), other.arrays(), strict=True):
        assert np.array_equal(mine, its)
    assert Path("new/a.parquet.json").read_text() == Path("a.csv.json").read_text()


def test_the_same_command_gives_the_same_bytes(capsys: Capture) -> None:
    command = (
        "slide.yaml --to 0.5 --duration 0.5 --param m=2 --position-noise 1e-4 --torque-noise 0.1 "
        "--velocity filtered --acceleration none --cutoff 50 --torque-resolution 0.01"
    )
    found = []
    for seed, name in ((5, "a"), (5, "b"), (6, "c")):
        simulate(capsys, f"{command} --seed {seed} -o {name}.csv --picture {name}.svg")
        found.append([Path(name + end).read_bytes() for end in (".csv", ".csv.json", ".svg")])
    assert found[0] == found[1]
    assert all(a != b for a, b in zip(found[0], found[2], strict=True))
    log = read_log("a.csv")
    assert log.qdd is None
    again = read_log("c.csv")
    assert np.std(log.q - again.q) == pytest.approx(1e-4 * math.sqrt(2), rel=0.1)
    assert np.std(log.tau - again.tau) == pytest.approx(0.1 * math.sqrt(2), rel=0.1)
    steps = log.tau / 0.01
    np.testing.assert_allclose(steps, np.rint(steps), atol=1e-9)


def test_an_encoder_has_steps(capsys: Capture) -> None:
    simulate(capsys, "pendulum.yaml --from 1 --duration 0.3 --encoder-bits 10 --velocity difference")
    log: Log = read_log("pendulum.csv")
    steps = log.q / (math.tau / 1024)
    np.testing.assert_allclose(steps, np.rint(steps), atol=1e-9)
    assert log.qd is not None
    np.testing.assert_allclose(log.qd[1:], np.diff(log.q, axis=0) / 1e-3, atol=1e-9)
    _, err = simulate(capsys, "slide.yaml --speed 1 --duration 0.1 --encoder-bits 10 --param m=2")
    assert "--encoder-bits does not apply to prismatic joints (1)" in err


@pytest.mark.parametrize("kind", ["svg", "png"])
def test_a_picture(kind: str, capsys: Capture) -> None:
    out, _ = simulate(capsys, f"pendulum.yaml --to 1 --duration 0.2 --picture p.{kind} -o -")
    data = Path(f"p.{kind}").read_bytes()
    assert data.startswith({"svg": b"<?xml", "png": b"\x89PNG"}[kind])
    assert made() == {f"p.{kind}"}
    assert out.startswith("t,q1")


def test_a_picture_without_matplotlib(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    _, err = simulate(capsys, "pendulum.yaml --duration 0.1 --picture p.svg", code=3)
    assert "a picture needs matplotlib, which is not installed; pip install" in err
    assert made() == set()


def test_energies_that_do_not_balance_are_told(capsys: Capture) -> None:
    _, err = simulate(capsys, "pendulum.yaml --from 2 --solver rk4 --step 0.1 --rate 10")
    assert "warning: the energies do not balance: off by " in err
    assert "--step, or --solver adaptive" in err
    _, err = simulate(capsys, "pendulum.yaml --from 2 --solver rk4 --step 0.001 --rate 10")
    assert err == ""


def test_an_interrupted_run_leaves_nothing(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    def stop(line: progress.Line, text: str) -> None:
        assert "of 10 s" in text
        raise KeyboardInterrupt

    monkeypatch.setattr(the_command, "_LONG", -1.0)
    monkeypatch.setattr(progress.Line, "tell", stop)
    out, err = simulate(capsys, "pendulum.yaml --from 2 -o new/a.csv", code=130)
    assert (out, err) == ("", "robodyn: interrupted\n")
    assert made() == set()


def test_help_loads_nothing_heavy() -> None:
    script = "import sys\nfrom robodyn_cli.main import main\nassert main(['simulate', '--help']) == 0"
    run = [sys.executable, "-c", f"{script}\nprint(*sys.modules, file=sys.stderr)"]
    found = subprocess.run(run, capture_output=True, text=True, check=True).stderr.split()
    assert not {"numpy", "cffi", "jinja2", "yaml", "matplotlib", "scipy", "sympy"} & set(found)


# --- what is refused --------------------------------------------------------------------------------------

MOTION = "--to 0.1 --param m=2"


@pytest.mark.parametrize(
    ("command", "text"),
    [
        ("nowhere.yaml", "nowhere.yaml: there is neither a file nor a bundled robot"),
        (
            "slide.yaml --to 1",
            "found no m; expected a number for each of m; on the command line --param",
        ),
        ("slide.yaml --param m=2 --param k=1", "found k; expected m; remove it"),
        ("slide.yaml --param m=2 --param m=1", "found --param m=... twice"),
        ("slide.yaml --param m", "'m' is not NAME=VALUE"),
        ("slide.yaml --param m=two", "'--param': "),
        (f"slide.yaml {MOTION} --excite", "only one input can drive the robot; found --to and --excite"),
        ("slide.yaml --kp 3 --param m=2", "--kp requires a motion to follow"),
        (f"slide.yaml {MOTION} --controller feedforward --kp 3", "--kp requires --controller pd"),
        (f"slide.yaml {MOTION} --linear", "--linear requires --torque"),
        (f"slide.yaml {MOTION} --harmonics 3", "--harmonics requires --excite"),
        (f"slide.yaml {MOTION} --point 1,2,3", "--point requires --line"),
        ("slide.yaml --profile quintic --param m=2", "--profile requires --to or --line"),
        (f"slide.yaml {MOTION} --solver rk4 --rtol 1e-3", "--rtol requires --solver adaptive"),
        (f"slide.yaml {MOTION} --cutoff 3", "--cutoff requires --velocity filtered"),
        (
            f"slide.yaml {MOTION} --velocity filtered",
            "the low-pass filter has no cutoff frequency; add --cutoff HZ",
        ),
        (f"slide.yaml {MOTION} --velocity filtered --cutoff 1e6", "cutoff"),
        (f"slide.yaml {MOTION} --velocity best", "'--velocity'"),
        (f"slide.yaml {MOTION} --controller pid", "'--controller'"),
        ("slide.yaml --to 1,2 --param m=2", "--to does not fit slide; found 2 numbers"),
        (f"slide.yaml {MOTION} --from 1,2", "--from does not fit slide; found 2 numbers"),
        (f"slide.yaml {MOTION} --speed 1,2", "--speed does not fit slide"),
        (f"slide.yaml {MOTION} --kd 1,2", "--kd does not fit slide"),
        (f"slide.yaml {MOTION} --kp -1", "-1 is not 0 or more"),
        (f"slide.yaml {MOTION} --position-noise 1,2", "--position-noise does not fit slide"),
        (f"slide.yaml {MOTION} --torque-noise nan", "not a finite number"),
        (f"slide.yaml {MOTION} --encoder-bits 3 --position-resolution 1", "set the same quantity"),
        ("pendulum.yaml --encoder-bits 0.5", "encoder bits must be an integer"),
        ("pendulum.yaml --encoder-bits 99", "an encoder has no so many bits"),
        (f"slide.yaml {MOTION} --duration 0", "0 is not more than 0"),
        (f"slide.yaml {MOTION} --duration inf", "'--duration'"),
        (f"slide.yaml {MOTION} --duration 1e-4", "the log would have only one sample"),
        (f"slide.yaml {MOTION} --duration 1e6 --rate 1e6 --control-rate 1", "a log of 1e+12 samples"),
        (f"slide.yaml {MOTION} --duration 1e9", "a trajectory of too many samples"),
        (
            f"slide.yaml {MOTION} --duration 1e6 --rate 1 --control-rate 1 --solver rk4 --step 1e-9",
            "too long",
        ),
        (f"slide.yaml {MOTION} --model stanford_3dof", "--model does not fit slide; found 3 joints"),
        ("weak.yaml --to 0.1 --model slide.yaml", "run-time parameters m; expected 1 joints, run-time"),
        (
            "soft.yaml --param k=0 --param d=1",
            "stiffness is not positive; found 0 N m/rad with k = 0",
        ),
        (
            "soft.yaml --param k=1 --param d=-1",
            "damping is negative; found -1 N m s/rad with d = -1",
        ),
        (f"slide.yaml {MOTION} --model nobody", "nobody: there is neither"),
        (f"slide.yaml {MOTION} --seed -1", "'--seed'"),
        (f"slide.yaml {MOTION} -o log.txt", "found log.txt; expected one of .csv"),
        (f"slide.yaml {MOTION} -o slide.yaml/a.csv", "cannot write slide.yaml/a.csv"),
        (f"slide.yaml {MOTION} -o - --json", "--json and -o - both write"),
        (f"slide.yaml {MOTION} --picture p.pdf", "pictures are written as SVG or PNG"),
        ("puma560 --line 1,2", "'1,2' is neither x,y,z:x,y,z"),
        ("puma560_3dof --line 1,2,3:9,9,9 --point 0,-0.43,0", "reach"),
        ("puma560_3dof --line 1,2,3 --link 4", "has no such link; found link 4"),
        ("slide.yaml --torque none.csv --param m=2", "none.csv: the file cannot be read"),
        ("slide.yaml --trajectory none.csv --param m=2", "none.csv: the file cannot be read"),
    ],
)
def test_refused(command: str, text: str, capsys: Capture) -> None:
    out, err = simulate(capsys, command, code=2)
    assert out == ""
    assert text in err.splitlines()[-1]
    assert made() == set()


@pytest.mark.parametrize(
    ("rows", "text"),
    [
        ("", "f.csv: there are no torques in the file; found nothing"),
        ("t,tau1\n", "f.csv: there are no torques in the file; found the header only"),
        ("t,tau2\n0,1\n", "f.csv:1: there is no column tau1"),
        ("t;tau1\n0;1\n", "separate the columns by commas"),
        ("t,tau1,tau1\n0,1,1\n", "f.csv:1: there are two columns tau1"),
        ("t,tau1,tau2\n0,1,1\n", "f.csv:1: the torques are of another arm; found tau2; expected 1 joint"),
        ("t,tau1\n0,1\n1\n", "f.csv:3: a line of the wrong length; found 1 cells"),
        ("t,tau1\n0,1\n\n1,x\n", "f.csv:4: tau1 is not a finite number; found 'x'"),
        ("t,tau1\n0,1\n1,\n", "f.csv:3: tau1 is not a finite number; found ''"),
        ("t,tau1\n0,1\n1,inf\n", "f.csv:3: tau1 is not a finite number"),
        ("t,tau1\n0,1\n1,1\n2,1\n4,1\n5,1\n", "the times are not even"),
        ("t,tau1\n1,1\n0,1\n", "rising times"),
        ("t,tau1\n0,1\n", "one row of torques has no duration; add --duration"),
        ("t,tau1\n\xff", "f.csv:2:1: the file is not UTF-8 text"),
    ],
)
def test_torques_that_are_none(rows: str, text: str, capsys: Capture) -> None:
    Path("f.csv").write_bytes(rows.encode("latin-1"))
    _, err = simulate(capsys, "slide.yaml --torque f.csv --param m=2", code=2)
    assert text in err


def test_one_row_of_torques_is_for_all_time(capsys: Capture) -> None:
    Path("f.csv").write_text("t,tau1\n0,4\n")
    simulate(capsys, "slide.yaml --torque f.csv --param m=2 --duration 0.5")
    assert read_log("slide.csv").q[-1, 0] == pytest.approx(0.25)


def test_inputs_are_not_written_over(capsys: Capture) -> None:
    Path("slide.csv").write_text("t,tau1\n0,4\n1,4\n")
    _, err = simulate(capsys, "slide.yaml --torque ./slide.csv --param m=2", code=2)
    assert "slide.csv is an input and would be overwritten; choose another name with -o" in err
    assert Path("slide.csv").read_text() == "t,tau1\n0,4\n1,4\n"


def test_a_robot_that_runs_away_is_told(capsys: Capture) -> None:
    _, err = simulate(capsys, f"slide.yaml {MOTION} --kp 1e300 --kd 1e300 --solver rk4", code=2)
    assert "the simulation ended at t = " in err
    assert made() == set()
