"""Names, limits, springs and what else sits in a joint, from a tree's terms to those of a description."""

from __future__ import annotations

import re
from collections.abc import Iterable
from fractions import Fraction
from pathlib import PurePath

from robodyn.errors import InputError, Place
from robodyn.formats.chain import ChainJoint, Spring
from robodyn.formats.limits import GREATEST
from robodyn.formats.tree import TURNING, JointLimits, Tree, TreeJoint
from robodyn.robot.account import Origins
from robodyn.robot.model import EffectEntry
from robodyn.robot.names import ROBOT_NAME_LENGTH, robot_name_fault, shown
from robodyn.robot.numbers import shortest
from robodyn.robot.parts import Gear, JointKind, Limits
from robodyn.robot.rotations import limits_doubt


def robot_name(tree: Tree, preferred: str = "") -> str:
    """A C identifier out of the name that the file has for the robot, else out of the file's own name.

    Raises
    ------
    InputError: it is a keyword, or the ``preferred`` name is no identifier.
    """
    stem = PurePath(tree.file).name.partition(".")[0]
    name = preferred or _identifier(tree.name) or _identifier(stem) or "arm"
    if fault := robot_name_fault(name):
        raise InputError(
            f"the robot's name {fault}",
            where=Place(tree.file),
            found=shown(name),
            expected="a C identifier that no language reserves",
            remedy="choose another: robodyn import FILE --name NAME -o NAME.yaml",
        )
    return name


def _identifier(text: str) -> str:
    """``text`` with underscores for what cannot stand in an identifier; "" where nothing is left."""
    words = re.sub(r"[^A-Za-z0-9]+", "_", text).strip("_")
    return (words if words[:1].isalpha() or not words else f"arm_{words}")[:ROBOT_NAME_LENGTH].rstrip("_")


def printable(text: str) -> str:
    """``text`` with blanks for what does not print."""
    return "".join(c if c.isprintable() else " " for c in text)


def joint_of(joint: TreeJoint) -> tuple[ChainJoint, list[str]]:
    """The joint of a chain without its pose and body; and what of its limits was not taken as it stands."""
    kind: JointKind = "revolute" if joint.kind in TURNING else "prismatic"
    limits, remarks = _limits_of(joint.limits, kind)
    stated = {"friction": (joint.damping, joint.friction), "motor_inertia": (joint.armature,)}
    converted = ChainJoint(
        joint.name,
        joint.child,
        kind,
        axis=joint.axis,
        limits=limits,
        viscous=joint.damping or 0.0,
        coulomb=joint.friction or 0.0,
        motor_inertia=joint.armature or 0.0,
        gear=None if joint.ratio is None else Gear(shortest(joint.ratio)),
        spring=joint.spring,
        origins=Origins().with_stated(
            name for name, values in stated.items() if any(x is not None for x in values)
        ),
    )
    return converted, remarks


def _limits_of(limits: JointLimits, kind: JointKind) -> tuple[Limits, list[str]]:
    """Limits that say something, and what was left out."""
    remarks = []
    lower, upper = limits.lower, limits.upper
    position = None
    if lower is not None and upper is not None and lower < upper:
        position = (shortest(lower), shortest(upper))
        if doubt := limits_doubt(Limits(position), kind):
            remarks.append(f"limits of {doubt}: were degrees meant?")
    elif (lower, upper) not in ((None, None), (0.0, 0.0)):
        ends = ["none" if end is None else f"{end:g}" for end in (lower, upper)]
        remarks.append(f"no limits of position: lower {ends[0]}, upper {ends[1]}")
    stated = {"velocity": limits.velocity, "acceleration": limits.acceleration, "torque": limits.effort}
    taken = {name: shortest(x) for name, x in stated.items() if x is not None and 0 < x < GREATEST}
    left_out = {name: x for name, x in stated.items() if x is not None and name not in taken}
    remarks += [f"no limit of {name}: {x:g}" for name, x in left_out.items()]
    return Limits(position, **taken), remarks


def effects_of_springs(springs: Iterable[Spring | None]) -> tuple[EffectEntry, ...]:
    """The effects that say as much as the ``springs`` of joints, base to tip; None: the joint has none."""
    hung = [(joint, spring) for joint, spring in enumerate(springs, 1) if spring is not None]
    if not hung:
        return ()
    from robodyn.effects.catalogue import CATALOGUE  # an arm without springs does without it

    (effect,) = (effect for effect in CATALOGUE.values() if effect.traits.in_files)
    stiffness, rest = effect.traits.in_files
    entries = []
    for joint, spring in hung:
        stated = {stiffness: shortest(spring.stiffness), rest: shortest(spring.rest)}
        settings = [(each.name, stated.get(each.name, each.default)) for each in effect.parameters]
        entries.append(
            EffectEntry(effect.id, joint, tuple((name, x) for name, x in settings if x is not None))
        )
    return tuple(entries)


def spring_of(entry: EffectEntry) -> Spring | None:
    """The spring of a file that ``entry`` is; None where files have no words for it."""
    stated = entry.definition.traits.in_files
    more = [value for name, value in entry.settings if name not in stated]
    if not stated or entry.joint is None or any(more):
        return None
    stiffness, rest = (entry[name] if name in entry else Fraction(0) for name in stated)
    return Spring(float(stiffness), float(rest))
