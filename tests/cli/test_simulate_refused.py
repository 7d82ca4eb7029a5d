"""What robodyn simulate refuses."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from cli.simulated import Capture, made, simulate
from robodyn.logs.log import read_log

pytestmark = pytest.mark.usefixtures("among_robots")

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
        ("pendulum.yaml --encoder-bits 99", "the resolution of an encoder is out of range"),
        (f"slide.yaml {MOTION} --duration 0", "0 is not more than 0"),
        (f"slide.yaml {MOTION} --duration inf", "'--duration'"),
        (f"slide.yaml {MOTION} --duration 1e-4", "the log would have only one sample"),
        (f"slide.yaml {MOTION} --duration 1e6 --rate 1e6 --control-rate 1", "a log of 1e+12 samples"),
        (f"slide.yaml {MOTION} --duration 1e9", "a trajectory of too many samples"),
        (
            f"slide.yaml {MOTION} --duration 1e6 --rate 1 --control-rate 1 --solver rk4 --step 1e-9",
            "too long",
        ),
        (
            f"slide.yaml {MOTION} --controller-model stanford_3dof",
            "--controller-model does not fit slide; found 3 joints",
        ),
        (
            "weak.yaml --to 0.1 --controller-model slide.yaml",
            "run-time parameters m; expected 1 joints, run-time",
        ),
        (
            "soft.yaml --param k=0 --param d=1",
            "stiffness is not positive; found 0 N m/rad with k = 0",
        ),
        (
            "soft.yaml --param k=1 --param d=-1",
            "damping is negative; found -1 N m s/rad with d = -1",
        ),
        (f"slide.yaml {MOTION} --model slide.yaml", "(the controller's model is --controller-model ROBOT)"),
        (f"slide.yaml {MOTION} --controller-model nobody", "nobody: there is neither"),
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
    assert list(json.loads(out)) == ["error"] if "--json" in command else out == ""
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
