"""Masses and inertias that nobody knows: which joints carry them, and taking them as 0 on purpose."""

from __future__ import annotations

from dataclasses import replace

from robodyn.errors import InputError
from robodyn.robot.model import Robot
from robodyn.robot.origins import Origin


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
