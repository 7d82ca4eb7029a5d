"""Masses and inertias that nobody knows: which joints carry them, and taking them as 0 on purpose. Rotors
folded into the links, as the thesis has them."""

from __future__ import annotations

from dataclasses import replace

from robodyn.errors import InputError
from robodyn.robot.model import Link, Robot
from robodyn.robot.origins import Origin
from robodyn.robot.values import ZERO


def unknown_masses(robot: Robot) -> tuple[int, ...]:
    """The joints (from 1) that carry a mass or an inertia that nobody knows; none where all are known.

    A description defines what it leaves out as 0, so that a link without mass is known to have none. Not so
    where it says that this is absent (``origin: {inertial: absent}``), as of other formats' links without
    inertia.
    """
    return tuple(
        i
        for i, link in enumerate(robot.links, 1)
        if link.origins.unknown and "absent" in (link.origins.mass, link.origins.inertia)
    )


def require_masses(robot: Robot) -> None:
    """Refuse torques and inertias that would rest on masses that nobody knows.

    Raises
    ------
    InputError: with the place of the first link whose mass or inertia is unknown.
    """
    unknown = unknown_masses(robot)
    if not unknown:
        return
    links = [robot.links[joint - 1] for joint in unknown]
    lacking = ("mass", "inertia") if any(link.origins.mass == "absent" for link in links) else ("inertia",)
    raise InputError(
        f"{robot.name}: torques and inertias would rest on numbers that nobody states",
        where=links[0].origins.where,
        found="no " + " and no ".join(lacking) + " behind " + ", ".join(_named(i, robot) for i in unknown),
        expected=f"the {' and '.join(lacking)} of all that moves; poses and Jacobians need none",
        remedy="state them, take them as 0 on purpose (--massless, massless=True), "
        "or ask for functions of poses alone (--functions forward_kinematics,jacobian)",
    )


def massless(robot: Robot) -> Robot:
    """``robot``, what is unknown of its masses and inertias assumed to be 0."""
    assumed: Origin = "assumed"
    links = list(robot.links)
    for joint in unknown_masses(robot):
        link = links[joint - 1]
        origins = replace(link.origins, mass=assumed, com=assumed, inertia=assumed, unknown=False)
        links[joint - 1] = replace(link, origins=origins)
    return replace(robot, links=tuple(links))


def _named(joint: int, robot: Robot) -> str:
    name = robot.links[joint - 1].name
    return f"joint {joint}" + ("" if name == f"link{joint}" else f" ({name})")


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
