"""robodyn ik: poses from the command line and from files, as text and as JSON, reached or not."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cli.command import Capture, run


def ik(capsys: Capture, *arguments: str, code: int = 0) -> tuple[str, str]:
    return run(capsys, "ik", *arguments, code=code)


def test_the_same_pose_in_three_ways_and_degrees(capsys: Capture) -> None:
    of = "0.1,-0.5,0.4,0.2,0.9,0.3"
    data = json.loads(ik(capsys, "puma560", "--of", of, "--json")[0])
    (pose,) = data["poses"]
    rows = ",".join(str(x) for row in pose["pose"] for x in row)
    degrees = ",".join(str(np.degrees(float(x))) for x in of.split(","))
    other = json.loads(ik(capsys, "puma560", "--pose", rows, "--of", degrees, "--degrees", "--json")[0])
    q = [[branch["q"] for branch in each["branches"]] for each in (pose, *other["poses"])]
    np.testing.assert_allclose(q[1:], [q[0], q[0]], atol=1e-9)
    assert pose["reached"] == 8
    assert data["method"] == "closed form"
    assert data["free_joint"] is None
    assert all(branch["off"]["place"] < 1e-14 for branch in pose["branches"])


def test_the_nearest_alone(capsys: Capture) -> None:
    near = "0.1,-0.5,0.4,0.2,0.9,0.3"
    data = json.loads(ik(capsys, "puma560", "--of", near, "--near", near, "--nearest", "--json")[0])
    (pose,) = data["poses"]
    assert "branches" not in pose
    np.testing.assert_allclose(pose["nearest"]["q"], [float(x) for x in near.split(",")], atol=1e-12)
    out, _ = ik(capsys, "puma560", "--of", near, "--near", near, "--nearest")
    assert out.splitlines()[-1] == "reached"


def test_by_least_squares_less_is_missing_than_of_any_branch(capsys: Capture) -> None:
    out, _ = ik(capsys, "ur5", "--pose", "1.2,0,0.3,0,1,0", "--json", code=1)
    (pose,) = json.loads(out)["poses"]
    assert pose["reached"] == 0
    assert pose["nearest"]["branch"] == "least squares"

    def missing(solution: dict[str, Any]) -> float:
        off = solution["off"]
        return float((off["place"] / 1.2) ** 2 + off["rotation"] ** 2)  # the arm's size is about 1.2 m

    assert missing(pose["nearest"]) < min(map(missing, pose["branches"])) < 1


@pytest.mark.usefixtures("elsewhere")
def test_what_is_missing_by_least_squares(capsys: Capture) -> None:
    out, err = ik(capsys, "puma560", "--pose", "3,0,0,0,0,0", code=1)
    assert "not reached: 2." in out
    assert err == "robodyn: error: puma560 does not reach the pose; move it into the arm's reach\n"
    out, _ = ik(capsys, "puma560", "--pose", "0.4,0.1,9,10,20,30", "--degrees", "--nearest", code=1)
    assert re.search(r"\nnot reached: 8\.\d+ m and \S+ deg are missing by least squares\n", out)
    poses = "x,y,z,roll,pitch,yaw\n0.4,0.1,0.5,0,3,0\n0.4,0.1,9,0,3,0\n"
    Path("poses.csv").write_text(poses, encoding="utf-8")
    _, err = ik(capsys, "panda", "--poses", "poses.csv", "--nearest", code=1)
    assert "panda does not reach 1 of 2 poses; found pose 2 as the first" in err


def test_a_redundant_arm_reaches_a_pose_with_its_joint_elsewhere(capsys: Capture) -> None:
    of, near = "-1.52,0.16,-0.75,-0.21,0.73,0.23,-2.82", "0,0,0,-0.5,0,1,-1.5"
    out, _ = ik(capsys, "panda", "--of", of, "--near", near)
    assert out.endswith(
        "reached by no branch with joint 7 as --near has it, by least squares with it elsewhere\n"
    )
