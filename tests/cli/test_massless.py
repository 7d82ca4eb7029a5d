"""An arm of unknown masses through the commands: refused for torques, fine for poses, 0 by ``--massless``."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from robodyn_cli.main import main
from robodyn_testing import covering

ARM = (
    "<robot name='arm'><link name='base'/><link name='upper'><inertial><mass value='2'/>"
    "<inertia ixx='0.1' iyy='0.1' izz='0.1'/></inertial></link>"
    "<link name='lower'><inertial><origin xyz='0.1 0 0'/><mass value='1'/></inertial></link>"
    "<joint name='j1' type='revolute'><parent link='base'/><child link='upper'/><axis xyz='0 1 0'/>"
    "<limit lower='-2' upper='2' effort='9' velocity='3'/><dynamics friction='1'/></joint>"
    "<joint name='j2' type='revolute'><parent link='upper'/><child link='lower'/><axis xyz='0 1 0'/>"
    "<origin xyz='0.4 0 0'/><limit lower='-2' upper='2' effort='9' velocity='3'/></joint></robot>"
)
OF_TORQUES = [
    "gen {} -o out",
    "gen {} --functions gravity,jacobian -o out",
    "flops {}",
    "flops {} --function mass_matrix",
    "verify {}",
    "bench {}",
    "report {} -o out.html",
    "package {} --as cmake -o out",
    "schedule {} -p 2",
    "schedule {} -p 2 --cut 1",
    "plan {} --deadline 1ms",
    "prove {} --ranges q=1,qd=1,qdd=1",
    "excite {} -o out.csv",
    "simulate {} -o out.csv --duration 0.01",
    "diagnose {} log.csv --out out",
    "identify {} log.csv -o out",
]
OF_POSES = [
    "gen {} --functions forward_kinematics,jacobian,link_poses -o out",
    "flops {} --function jacobian",
    "verify {} --functions forward_kinematics,jacobian",
    "ik {} --pose 0.4,0,0,0,0,0",
    "export {} --to urdf -o out.urdf",
    "export {} --to sdf -o out.sdf",
    "diff {} {}",
]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("arm.urdf").write_text(ARM)
    t = np.arange(2000) * 0.002
    q = np.stack([np.sin(3 * t), np.cos(4 * t)], axis=1)
    tau = np.stack([5 * np.cos(2 * t), 3 * np.sin(5 * t)], axis=1)
    rows = np.column_stack([t, q, tau])
    np.savetxt("log.csv", rows, delimiter=",", header="t,q1,q2,tau1,tau2", comments="")
    return tmp_path


@pytest.mark.parametrize(("command", "file"), covering(OF_TORQUES, ["arm.urdf", "arm.yaml"]))
def test_torques_are_refused(command: str, file: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["import", "arm.urdf", "-o", "arm.yaml"]) == 0
    there = set(Path().iterdir())
    capsys.readouterr()
    assert main(command.format(file).split()) == 2
    error = capsys.readouterr().err.splitlines()[-1]
    assert "torques and inertias would rest on numbers that nobody states" in error
    assert f" {file}:" in error
    assert "no inertia behind joint 2 (j2)" in error
    assert "--massless" in error
    assert set(Path().iterdir()) == there, "nothing half-written"


@pytest.mark.parametrize(("command", "file"), covering(OF_POSES, ["arm.urdf", "arm.yaml"]))
def test_poses_are_not(command: str, file: str) -> None:
    assert main(["import", "arm.urdf", "-o", "arm.yaml"]) == 0
    assert main(command.format(file, file).split()) == 0


def test_a_difference_says_that_torques_are_not_compared(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["diff", "arm.urdf", "arm.urdf"]) == 0
    assert "not compared: torques: arm has masses that nobody states" in capsys.readouterr().out
    assert main(["diff", "arm.urdf", "arm.urdf", "--json"]) == 0
    compared = json.loads(capsys.readouterr().out)
    assert (compared["torques"], compared["operations"]) == (None, None)


def test_0_on_purpose(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["gen", "arm.urdf", "--massless", "-o", "out"]) == 0
    err = capsys.readouterr().err
    assert "unknown masses and inertias are taken as 0 on purpose: joint 2" in err
    head = " ".join(Path("out/arm.h").read_text().replace("*", " ").split())
    assert "mass, centre of mass, inertia (joint 2): assumed" in head
    assert main(["import", "arm.urdf", "--massless", "-o", "arm.yaml"]) == 0
    assert main(["gen", "arm.yaml", "-o", "out", "--check"]) == 0, "the description says the same"
    assert main(["verify", "arm.yaml"]) == 0
    capsys.readouterr()
    Path("bare.yaml").write_text("name: bare\norigin: {inertial: absent}\nlinks: [{joint: revolute}]\n")
    assert main(["flops", "bare.yaml"]) == 2
    assert main(["flops", "bare.yaml", "--massless"]) == 0
