"""An arm of unknown masses: its poses are verified and solved for. What is said: golden/massless.txt."""

from __future__ import annotations

from pathlib import Path

from cli.command import Capture, run, run_json

FILE = str(Path(__file__).parent / "golden" / "files" / "massless.urdf")


def test_poses_are_verified_solved_for_and_compared(capsys: Capture) -> None:
    run(capsys, "verify", FILE, "--functions", "forward_kinematics,jacobian")
    run(capsys, "ik", FILE, "--pose", "0.4,0,0,0,0,0")
    compared = run_json(capsys, "diff", FILE, FILE)
    assert (compared["torques"], compared["operations"]) == (None, None)


def test_0_on_purpose(elsewhere: Path, capsys: Capture) -> None:
    run(capsys, "gen", FILE, "--massless", "-o", "out")
    head = " ".join((elsewhere / "out" / "arm.h").read_text().replace("*", " ").split())
    assert "mass, centre of mass, inertia (joint 2): assumed" in head
    run(capsys, "verify", FILE, "--massless")
