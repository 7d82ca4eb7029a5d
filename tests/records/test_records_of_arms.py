"""Records of arms in public files: whoever imports such a file has them, whatever tool and friction."""

from __future__ import annotations

from pathlib import Path

import pytest

from robodyn import Options, count, load
from robodyn.dynamics.equality import equals_recursion
from robodyn.formats.arm import import_arm
from robodyn.optimize.records import identity, parse_record
from robodyn.optimize.records.find import records_of_arms
from robodyn.optimize.records.record import function_key, header
from robodyn.optimize.records.validation import frictionless
from robodyn_testing.public_arms import arm_file

EXAMPLES = Path(__file__).parents[2] / "examples" / "arms"
RECORDS = sorted(records_of_arms().glob("*.record"))


def test_there_are_some() -> None:
    names = {path.name.partition(".")[0] for path in RECORDS}
    assert names == {"panda_hand", "ur10_cb3", "ur3", "ur5_cb3"}


@pytest.mark.parametrize("path", RECORDS, ids=lambda path: path.name)
def test_a_record_is_of_the_arm_without_friction(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    record, fields = parse_record(text, path.name), header(text)
    arm = frictionless(load(EXAMPLES / f"{record.robot}.yaml"))
    assert record.identity == identity(arm)
    assert fields["computes"] == function_key(record.program)
    assert equals_recursion(arm, record.function, record.program)
    function = record.function
    assert count(arm, function).total < count(arm, function, Options((function,), optimize="fast")).total


@pytest.mark.parametrize(
    ("file", "tip", "torques", "matrix"),
    [
        ("ur_description/urdf/ur3_robot.urdf", "tool0", 185, 66),
        ("ur_description/urdf/ur5_robot.urdf", "ee_link", 185, 66),
        ("ur_description/urdf/ur10_robot.urdf", "tool0", 185, 66),
        ("panda_description/urdf/panda.urdf", "panda_hand_tcp", 530 + 2 * 7, 333),
    ],
)
def test_the_public_file_takes_no_more(file: str, tip: str, torques: int, matrix: int) -> None:
    arm = import_arm(arm_file("example-robot-data", file), tip=tip).robot
    assert count(arm).total == torques
    assert count(arm, "mass_matrix").total == matrix
    assert count(frictionless(arm)).total == (530 if arm.n == 7 else torques)
