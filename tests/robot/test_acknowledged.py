"""``acknowledged: why`` at a link: its implausible numbers stand, and nobody is warned of them again."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest

from robodyn.diagnose.amend.amend import Amendment, amended, amended_text
from robodyn.errors import InputError
from robodyn.robot import Robot, bundled_text, fold_rotor, read_text, to_yaml
from robodyn.robot.identity import identity
from robodyn.robot.rewriting import rewritten

WHY = "the rotor: it is in Izz, as in the table"
HEAD = "name: arm\nlinks:\n  - joint: revolute\n  - joint: revolute\n    mass: 1\n"
BAD = HEAD + "    inertia: {xx: 0.1, yy: 0.1, zz: 0.5}  # the table\n"
GOOD = HEAD + "    inertia: {xx: 0.1, yy: 0.1, zz: 0.15}\n"
LINE = f'    acknowledged: "{WHY}"\n'


def told(text: str) -> tuple[Robot, list[str]]:
    warnings: list[str] = []
    return read_text(text, "arm.yaml", warn=warnings.append), warnings


def test_an_acknowledged_link_is_not_warned_of_and_strict_still_refuses_it() -> None:
    before, warnings = told(BAD)
    assert len(warnings) == 1
    assert warnings[0].endswith("or say why it stands (acknowledged: ...)")
    robot, warnings = told(BAD + LINE)
    assert warnings == []
    assert robot.links[1].acknowledged == WHY
    assert identity(robot) == identity(before)
    with pytest.raises(InputError, match=r"arm\.yaml:6:14: link 2: inertia is not physical") as caught:
        read_text(BAD + LINE, "arm.yaml", strict=True)
    assert "acknowledged" not in str(caught.value)


def test_it_holds_for_its_own_link_only() -> None:
    text = (BAD + LINE).replace("- joint: revolute\n  -", "- {joint: revolute, alpha: 90}\n  -")
    assert [warning.partition(";")[0] for warning in told(text)[1]] == [
        "arm.yaml:3:30: link 1: alpha = 90 rad is more than one turn"
    ]
    assert told(text.replace("alpha: 90", "alpha: 90, acknowledged: many turns"))[1] == []


def test_where_nothing_is_implausible_it_is_reported() -> None:
    wanted = ["arm.yaml:7:19: link 2: acknowledged: nothing about this link is implausible; delete the key"]
    assert told(GOOD + LINE)[1] == wanted
    # A run-time parameter is not known now, and may be implausible.
    assert told(GOOD.replace("0.15", "i_z") + LINE)[1] == []
    with pytest.raises(InputError, match="link 2: acknowledged is empty"):
        read_text(BAD + '    acknowledged: ""\n')


def test_what_is_written_reads_back_and_derived_robots_keep_it() -> None:
    robot, _ = told(BAD + LINE)
    assert f'acknowledged: "{WHY}"' in to_yaml(robot)
    assert told(to_yaml(robot)) == (robot, [])
    assert fold_rotor(robot).links[1].acknowledged == WHY
    named, _ = told(BAD.replace("mass: 1", "mass: m") + LINE)
    assert named.at({"m": 1}) == robot


def test_a_file_that_is_edited_keeps_it_or_loses_it_alone() -> None:
    text = BAD + LINE + "    d: 0.1  # m\n"
    robot, _ = told(text)
    link = robot.links[1]
    heavier = replace(robot, links=(robot.links[0], replace(link, mass=Fraction(2))))
    assert rewritten(text, robot, heavier, ()) == text.replace("mass: 1", "mass: 2")
    silent = replace(robot, links=(robot.links[0], replace(link, acknowledged="")))
    assert rewritten(text, robot, silent, ()) == text.replace(LINE, "")
    assert told(rewritten(text.replace(LINE, ""), silent, robot, ()))[0] == robot
    other = replace(robot, links=(robot.links[0], replace(link, acknowledged='a "new" word')))
    assert told(rewritten(text, robot, other, ()))[0] == other


@pytest.mark.parametrize(
    ("amendment", "stays"),
    [
        (Amendment("coulomb_friction", 3, {"level": 1.5}), True),
        (Amendment("inertial_error", 3, {"delta_mass": 0.1}), True),
        (Amendment("inertial_error", 2, {"delta_xx": 0.1}), True),
        (Amendment("inertial_error", 3, {"delta_xx": 0.01}), False),
        (Amendment("inertial_error", 3, {"delta_xx": 0.0}), True),
    ],
)
def test_an_amended_model_keeps_it_unless_the_tensor_changed(amendment: Amendment, stays: bool) -> None:
    text = bundled_text("puma560_3dof")
    robot, _ = told(text)
    assert robot.links[2].acknowledged
    new = amended_text(text, robot, [amendment], {})
    after, warnings = told(new)
    assert after == amended(robot, [amendment])
    assert warnings == []
    assert bool(after.links[2].acknowledged) is stays
