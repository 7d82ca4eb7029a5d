"""What makes two robots the same: every number that a kernel depends on, and nothing else."""

from __future__ import annotations

from dataclasses import fields, replace
from fractions import Fraction
from typing import Any

import pytest

from records.made import TOOL, arm, bundled
from robodyn.optimize.records import bundled_records, identity, parse_record
from robodyn.optimize.records.record import function_key, header
from robodyn.robot import Robot
from robodyn.robot.model import (
    Comparison,
    Coupling,
    Covariance,
    EffectEntry,
    Gear,
    Inertia,
    Joint,
    Limits,
    Link,
    Placement,
)
from robodyn.robot.values import Affine, angle, parameter, quarter_turns

BASE = arm(TOOL)
LINK, JOINT = BASE.links[1], BASE.links[1].joint
SMALL = Fraction(1, 10**40)
ORIGIN, RPY = (Fraction(0), Fraction(0), Fraction(0)), (quarter_turns(0), quarter_turns(0), quarter_turns(0))


def with_link(link: Link) -> Robot:
    return replace(BASE, links=(BASE.links[0], link, BASE.links[2]))


def with_joint(**changes: Any) -> Robot:
    return with_link(replace(LINK, joint=replace(JOINT, **changes)))


def with_inertia(**changes: Any) -> Robot:
    return with_link(replace(LINK, inertia=replace(LINK.inertia, **changes)))


#: For every field of the model a robot that differs in it alone, and whether a kernel differs.
CHANGED: dict[tuple[type, str], tuple[Robot, bool]] = {
    (Robot, "name"): (replace(BASE, name="other"), False),
    (Robot, "title"): (replace(BASE, title="other"), False),
    (Robot, "source"): (replace(BASE, source="other"), False),
    (Robot, "couplings"): (replace(BASE, couplings=(Coupling(2, 1),)), True),
    (Robot, "covariance"): (replace(BASE, covariance=Covariance("identify.json")), False),
    (Robot, "compare"): (replace(BASE, compare=Comparison("2.10", "puma_6")), False),
    (Robot, "links"): (replace(BASE, links=BASE.links[:2]), True),
    (Robot, "gravity"): (replace(BASE, gravity=(SMALL, BASE.gravity[1], BASE.gravity[2])), True),
    (Robot, "torque_side"): (replace(BASE, torque_side="link"), True),
    (Robot, "rest_velocity"): (replace(BASE, rest_velocity=Fraction(1, 1000)), True),
    (Robot, "dead_band"): (replace(BASE, dead_band=Fraction(1, 1000)), True),
    (Robot, "base"): (replace(BASE, base=Placement(ORIGIN, (quarter_turns(1), *RPY[1:]))), True),
    (Robot, "tool"): (replace(BASE, tool=Placement((SMALL, *ORIGIN[1:]), RPY)), False),
    (Robot, "standard_end"): (replace(BASE, standard_end=Placement(ORIGIN, RPY)), False),
    (Robot, "effects"): (
        replace(BASE, effects=(EffectEntry("torque_ripple", 1, (("amplitude", Fraction(1)),)),)),
        True,
    ),
    (Link, "name"): (with_link(replace(LINK, name="other")), False),
    (Link, "confidence"): (with_link(replace(LINK, confidence=Fraction(1, 50))), False),
    (Link, "acknowledged"): (with_link(replace(LINK, acknowledged="why")), False),
    (Link, "joint"): (with_joint(kind="prismatic"), True),
    (Link, "mass"): (with_link(replace(LINK, mass=LINK.mass + SMALL)), True),
    (Link, "com"): (with_link(replace(LINK, com=(LINK.com[0], LINK.com[1], Fraction(0)))), True),
    (Link, "inertia"): (with_inertia(xx=SMALL), True),
    (Joint, "limits"): (with_joint(limits=Limits(velocity=Fraction(3))), False),
    (Joint, "gear"): (with_joint(gear=Gear(Fraction(100))), False),
    (Joint, "kind"): (with_joint(kind="prismatic"), True),
    (Joint, "alpha"): (with_joint(alpha=quarter_turns(-1)), True),
    (Joint, "theta"): (with_joint(theta=angle(Fraction(1, 10**11))), True),
    **{
        (Joint, name): (with_joint(**{name: getattr(JOINT, name) + SMALL}), True)
        for name in ("a", "b", "d", "motor_inertia", "viscous", "coulomb")
    },
    **{
        (Inertia, name): (with_inertia(**{name: getattr(LINK.inertia, name) + SMALL}), True)
        for name in ("xx", "yy", "zz", "xy", "xz", "yz")
    },
}
MODELS = (Robot, Link, Joint, Inertia)
FIELDS = [(model, field.name) for model in MODELS for field in fields(model) if field.compare]


@pytest.mark.parametrize(("model", "name"), FIELDS, ids=lambda x: x if isinstance(x, str) else x.__name__)
def test_every_field_counts_if_a_kernel_depends_on_it(model: type, name: str) -> None:
    assert (model, name) in CHANGED, f"{model.__name__}.{name} is new: does identity() look at it?"
    changed, differs = CHANGED[model, name]
    assert changed != BASE
    assert (identity(changed) != identity(BASE)) is differs


def test_a_run_time_parameter_counts_by_its_name() -> None:
    found = [with_link(replace(LINK, mass=x)) for x in (parameter("m"), parameter("n"), Fraction(1))]
    found.append(with_link(replace(LINK, mass=Affine(Fraction(1), (("m", Fraction(1)),)))))
    found.append(with_link(replace(LINK, mass=Affine(Fraction(0), (("m", Fraction(2)),)))))
    found.append(with_link(replace(LINK, mass=Affine(Fraction(0), (("m", Fraction(1)), ("n", Fraction(1)))))))
    assert len({identity(robot) for robot in found}) == len(found)


def test_identities_of_committed_records_are_those_of_their_robots() -> None:
    for path in sorted(bundled_records().glob("*.record")):
        text = path.read_text(encoding="utf-8")
        fields = header(text)
        assert fields["identity"] == identity(bundled(fields["robot"])), path.name
        assert fields["computes"] == function_key(parse_record(text, path.name).program), path.name
        assert path.name.startswith(f"{fields['robot']}.{fields['function']}.")
