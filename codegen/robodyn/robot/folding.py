"""Effects that only change numbers which a rigid arm has anyway.

They go into those numbers and leave no entry: friction that is also written as ``friction``, rotor inertia,
errors of a link's inertial parameters, the tilt of the base. So equal arms are equal, however written. The
thesis has rotors folded into the links, too.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from robodyn.effects.catalogue import CATALOGUE
from robodyn.robot import numbers
from robodyn.robot.effects import Written
from robodyn.robot.fields import Section
from robodyn.robot.model import AXES, EffectEntry, Inertia, Link, Robot
from robodyn.robot.values import ZERO, angle

# What lies between the link and the motor's torque: not in a torque behind the gear.
_BEFORE_THE_GEAR = frozenset({"gear", "motor", "pair", "coupler"})
_INTO_LINKS = ("joint", "link")


def into_link(
    link: Link, friction: Section | None, entries: Iterable[Written]
) -> tuple[Link, tuple[Written, ...]]:
    """The link with those effects that are numbers of it, and the others; ``friction`` is its shorthand.

    Raises
    ------
    InputError: friction is stated twice, or the mass would be negative or a number beyond double.
    """
    kept = []
    for written in entries:
        part = written.section
        fold = written.entry.definition.traits.fold
        if fold is None or fold.into not in _INTO_LINKS:
            kept.append(written)
            if written.entry.definition.dissipative:
                link = replace(link, origins=link.origins.with_stated(["friction"]))
            continue
        if friction and fold.group and fold.key in friction.values:
            what = f"{part.label} stands beside '{fold.group}: {{{fold.key}: ...}}', which is the same"
            part.source.fail(part.node, what, remedy="delete one of the two")
        link = folded_link(link, [written.entry])
        if isinstance(link.mass, Fraction) and link.mass < 0:
            what, found = "makes the link's mass negative", f"{numbers.brief(link.mass)} kg"
            what, node = f"{part.path('delta_mass')} {what}", part.values["delta_mass"]
            part.source.fail(node, what, found=found, expected="0 kg or more in all")
        try:
            for value in (link.mass, *link.com, *link.inertia.entries, link.joint.motor_inertia):
                numbers.rounded(value)
        except OverflowError:
            part.source.fail(
                part.node, f"{part.label}: a sum is beyond double", expected="numbers well below 1e308"
            )
    return link, tuple(kept)


def into_robot(robot: Robot, entries: Iterable[Written]) -> Robot:
    """``robot`` with the effects ``entries``, base to tip, then those of the whole robot.

    Raises
    ------
    InputError: an effect of all joints stands at one of them too, or gravity would be beyond double.
    """
    entries = tuple(entries)
    at_joints = {written.effect for written in entries if written.entry.joint is not None}
    for written in entries:
        part = written.section
        if written.entry.joint is None and written.effect in at_joints:
            what, expected = f"{part.label} stands at a joint too", "one for all joints, or one at each"
            part.source.fail(part.node, what, expected=expected, remedy="delete it here or there")
    behind = next((one for one in entries if CATALOGUE[one.effect].place in _BEFORE_THE_GEAR), None)
    if behind and robot.torque_side == "link":
        behind.section.source.note(
            behind.section.node,
            f"{behind.section.label} acts before the gear, and is not in a torque behind it (torque_side)",
            "delete it, or take torque_side: motor",
        )
    try:
        return folded(replace(robot, effects=tuple(written.entry for written in entries)))
    except OverflowError:
        part = next(written.section for written in entries if _turns_gravity(written.entry))
        part.source.fail(
            part.node, "the tilted gravity is beyond double", expected="numbers well below 1e308"
        )


def folded(robot: Robot) -> Robot:
    """``robot`` without those entries that only change numbers which it has anyway: they are in its links and
    in gravity. A tilt by other than right angles leaves gravity rounded to double.

    Raises
    ------
    OverflowError: gravity grows beyond double.
    """
    links = tuple(folded_link(link, robot.effects_at(i)) for i, link in enumerate(robot.links, 1))
    gravity = robot.gravity
    for entry in robot.effects:
        if _turns_gravity(entry):
            gravity = _tilted(gravity, entry)
    kept = tuple(one for one in robot.effects if one.definition.traits.fold is None)
    return replace(robot, links=links, gravity=gravity, effects=kept)


def folded_link(link: Link, entries: Iterable[EffectEntry]) -> Link:
    """``link`` with those of the ``entries`` at its joint that are numbers of it."""
    for entry in entries:
        joint, inertia, fold = link.joint, link.inertia, entry.definition.traits.fold
        if fold is None:
            continue
        if fold.into == "joint":
            value = getattr(joint, fold.key) + entry[fold.parameter]
            link = replace(link, joint=replace(joint, **{fold.key: value}))
        elif fold.into == "link":
            x, y, z = (c + entry[f"delta_com_{axis}"] for c, axis in zip(link.com, "xyz", strict=True))
            sums = (c + entry[f"delta_{axes}"] for c, axes in zip(inertia.entries, AXES, strict=True))
            link = replace(link, mass=link.mass + entry["delta_mass"], com=(x, y, z), inertia=Inertia(*sums))
    return link


def _turns_gravity(entry: EffectEntry) -> bool:
    fold = entry.definition.traits.fold
    return fold is not None and fold.into == "gravity"


def _tilted(
    gravity: tuple[Fraction, Fraction, Fraction], entry: EffectEntry
) -> tuple[Fraction, Fraction, Fraction]:
    """``R_y(tilt_y) R_x(tilt_x) gravity``."""
    x, y, z = gravity
    one, other = angle(entry["tilt_x"]), angle(entry["tilt_y"])
    y, z = one.cos * y - one.sin * z, one.sin * y + one.cos * z
    x, z = other.cos * x + other.sin * z, other.cos * z - other.sin * x
    if None not in (one.quarter, other.quarter):
        return x, y, z
    # Elsewhere cosines are good to 1e-30 only, and their digits are of no use.
    return tuple(map(numbers.shortest, map(float, (x, y, z))))  # type: ignore[return-value]


def fold_rotor(robot: Robot) -> Robot:
    """``robot`` with every ``motor_inertia`` moved into its link, as the thesis's programs do it.

    Revolute: added to the link's Izz. The rotor then takes part in the whole rotation of the link, not
    only in the joint's own: not the right physics (it is off by several N m on a moving PUMA 560), but what
    the printed figures were computed with.

    Prismatic: added to the link's mass [kg] at its centre, the nearest thing that a rigid body allows.
    The joint's own acceleration meets the same inertia as before; in addition the lump weighs, and is
    swung about by the other joints. The thesis never does this: its listings drop the number (0.782 kg of
    the Stanford arm), and so do the bundled ``stanford_d3`` and ``stanford_3dof_d3``.
    """
    return replace(robot, links=tuple(_with_rotor(link) for link in robot.links))


def _with_rotor(link: Link) -> Link:
    rotor = link.joint.motor_inertia
    joint = replace(link.joint, motor_inertia=ZERO)
    if link.joint.kind == "revolute":
        return replace(link, joint=joint, inertia=replace(link.inertia, zz=link.inertia.zz + rotor))
    return replace(link, joint=joint, mass=link.mass + rotor)
