"""Masses and inertias that nobody knows, which are refused or taken as 0 on purpose; and inertia tensors that
no body has: a negative principal moment, a broken triangle inequality.

The latter is decided with exact rationals: every principal moment is at most the sum of the two others if and
only if ``trace/2 * 1 - I``, the second moments of the mass, has no negative eigenvalue, which its principal
minors tell (Traversaro et al., IROS 2016; Wensing et al., RA-L 2018).
"""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from typing import Any

from robodyn.errors import InputError
from robodyn.robot.account import Origin
from robodyn.robot.model import Inertia, Joint, Robot
from robodyn.robot.numbers import brief

# Rounding noise of converted tensors, as a share of the trace, is not worth a word.
_NOISE = Fraction(1, 10**9)
_Entries = tuple[Fraction, Fraction, Fraction, Fraction, Fraction, Fraction]


def inertia_doubt(inertia: Inertia) -> str | None:
    """What is unphysical about the tensor [kg m^2], or None.

    A tensor with run-time parameters in it is not judged.
    """
    if not is_judged(inertia):
        return None
    entries: Any = inertia.entries  # all known
    xx, yy, zz, xy, xz, yz = entries
    half = (xx + yy + zz) / 2
    noise = _NOISE * abs(half)
    # Physical second moments are sufficient for positive principal moments too: one test in the usual case.
    if _has_no_negative_eigenvalue((half - xx + noise, half - yy + noise, half - zz + noise, -xy, -xz, -yz)):
        return None
    for axis, moment in zip("xyz", (xx, yy, zz), strict=True):
        if moment < 0:
            return f"I{axis}{axis} = {brief(moment)} kg m^2 is negative"
    for (p, one), (q, two), (r, three) in (
        (("x", xx), ("y", yy), ("z", zz)),
        (("x", xx), ("z", zz), ("y", yy)),
        (("y", yy), ("z", zz), ("x", xx)),
    ):
        if one + two + noise < three:
            left, right = _distinct(one + two, three)
            return f"I{p}{p} + I{q}{q} = {left} < I{r}{r} = {right} kg m^2"
    # The diagonal is fine: the products of inertia are too large for it.
    low, middle, high = _principal_moments(entries)
    if not _has_no_negative_eigenvalue((xx + noise, yy + noise, zz + noise, xy, xz, yz)):
        return f"the principal moment {low:.6g} kg m^2 is negative"
    return f"of the principal moments {low:.6g} + {middle:.6g} < {high:.6g} kg m^2"


def is_judged(inertia: Inertia) -> bool:
    """Whether all entries are known now; a run-time parameter is not."""
    return all(isinstance(entry, Fraction) for entry in inertia.entries)


def only_about_base_axis(joint: Joint, inertia: Inertia) -> bool:
    """Whether nothing but Izz is stated of a link that turns about an axis fixed in the base.

    Then no other entry enters any torque, and tables (the thesis's too) leave them out: no doubt.
    """
    return joint.kind == "revolute" and inertia == Inertia(zz=inertia.zz)


def _has_no_negative_eigenvalue(entries: _Entries) -> bool:
    """Whether all seven principal minors of the symmetric matrix are 0 or more."""
    xx, yy, zz, xy, xz, yz = entries
    if xx < 0 or yy < 0 or zz < 0:
        return False
    if xx * yy < xy * xy or xx * zz < xz * xz or yy * zz < yz * yz:
        return False
    return xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz) >= 0


def _principal_moments(entries: _Entries) -> tuple[float, float, float]:
    """Eigenvalues of the symmetric matrix, ascending, in closed form; for messages."""
    scale = max(abs(entry) for entry in entries)
    xx, yy, zz, xy, xz, yz = (float(entry / scale) for entry in entries)
    mean = (xx + yy + zz) / 3
    a, b, c = xx - mean, yy - mean, zz - mean
    radius = math.sqrt((a * a + b * b + c * c + 2 * (xy * xy + xz * xz + yz * yz)) / 6)
    if radius == 0:
        return (mean * float(scale),) * 3
    determinant = a * (b * c - yz * yz) - xy * (xy * c - yz * xz) + xz * (xy * yz - b * xz)
    third = math.acos(max(-1.0, min(1.0, determinant / (2 * radius**3)))) / 3
    roots = sorted(mean + 2 * radius * math.cos(third + 2 * math.pi * k / 3) for k in range(3))
    low, middle, high = (root * float(scale) for root in roots)
    return low, middle, high


def _distinct(left: Fraction, right: Fraction) -> tuple[str, str]:
    """Both for a message, with as many digits as it takes to see that they differ."""
    if brief(left) != brief(right):
        return brief(left), brief(right)
    return repr(float(left)), repr(float(right))


# --- what nobody knows --------------------------------------------------------------------------------------


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
