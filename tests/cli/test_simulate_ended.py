"""Runs that end early, and what help loads."""

from __future__ import annotations

import subprocess
import sys

import pytest

from cli.simulated import Capture, made, simulate
from robodyn_cli import progress
from robodyn_cli import simulate as the_command

pytestmark = pytest.mark.usefixtures("among_robots")


def test_energies_that_do_not_balance_are_told(capsys: Capture) -> None:
    _, err = simulate(capsys, "pendulum.yaml --from 2 --solver rk4 --step 0.1 --rate 10")
    assert "warning: the energies do not balance: off by " in err
    assert "--step, or --solver adaptive" in err
    _, err = simulate(capsys, "pendulum.yaml --from 2 --solver rk4 --step 0.001 --rate 10")
    assert err == ""


def test_a_robot_that_runs_away_is_told(capsys: Capture) -> None:
    _, err = simulate(capsys, "slide.yaml --to 0.1 --param m=2 --kp 1e300 --kd 1e300 --solver rk4", code=2)
    assert "the simulation ended at t = " in err
    assert made() == set()


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
