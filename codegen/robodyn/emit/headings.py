"""Headings of groups of intermediate results: what each quantity of the recursion is."""

from __future__ import annotations

import re

from robodyn.ir.program import Label

#: What a quantity is, and its unit, for headings.
QUANTITIES: dict[str, str] = {
    "sc": "sines and cosines of the joint angles",
    "w": "angular velocity [rad/s]",
    "alpha": "angular acceleration [rad/s^2]",
    "ww": "products of the angular velocity [1/s^2]",
    "lam": "lambda matrix: takes a position to its acceleration [1/s^2]",
    "a": "acceleration of the frame's origin, gravity taken off [m/s^2]",
    "ac": "acceleration of the centre of mass, gravity taken off [m/s^2]",
    "ao": "acceleration of the frame's origin [m/s^2]",
    "vo": "velocity of the frame's origin [m/s]",
    "pl": "momentum of all that the joint carries, along the axes that its turn starts from [kg m/s]",
    "pa": "its moment about the frame's origin [kg m^2/s]",
    "ke": "kinetic energy of the links up to this one [J]",
    "pe": "potential energy of the links up to this one [J]",
    "hc": "first moment of all that the joint carries, along the axes that its turn starts from [kg m]",
    "hw": "first moment of all that the joint carries, before its turn, times gravity [N m]",
    "g": "gravity along the link's axes [m/s^2]",
    "E": "rotation to the base",
    "pb": "origin of the frame from that of the frame before, along the base's axes [m]",
    "wb": "angular velocity, along the base's axes [rad/s]",
    "alphab": "angular acceleration, along the base's axes [rad/s^2]",
    "ab": "acceleration of the frame's origin, gravity taken off, along the base's axes [m/s^2]",
    "rb": "centre of mass from the frame's origin, along the base's axes [m]",
    "fcb": "force that moves the link, along the base's axes [N]",
    "ncb": "moment that turns the link, along the base's axes [N m]",
    "fb": "force through the joint, along the base's axes [N]",
    "nb": "moment through the joint, about the frame's origin, along the base's axes [N m]",
    "A": "transform to the parent's frame",
    "R": "rotation to the parent's frame",
    "dA": "its derivative by the joint variable",
    "dR": "its derivative by the joint variable",
    "W": "transform to the base",
    "dW": "its derivatives by joint variables",
    "ddW": "its second derivatives by joint variables",
    "Wd": "its first time derivative [1/s]",
    "Wdd": "its second time derivative [1/s^2]",
    "dp": "derivative of the origin by the joint variable",
    "pdd": "acceleration of the frame's origin, along the base's axes [m/s^2]",
    "D": "second moment of position and acceleration of all that the joint carries [N m]",
    "e": "inertia force of all that the joint carries, along the base's axes [N]",
    "v": "coefficients of products of velocities",
    "tg": "gravity torque",
    "r": "centre of mass",
    "pw": "partial angular velocities of the link, joint by joint",
    "pv": "partial velocities of the centre of mass, joint by joint [m, at a prismatic joint 1]",
    "fw": "force through the joint less what the whole mass beyond it takes at the origin [N]",
    "fc": "force that moves the link [N]",
    "nc": "moment that turns the link [N m]",
    "f": "force through the joint [N]",
    "n": "moment through the joint, about the frame's origin [N m]",
    "f0": "force through the joint, along the axes that its turn starts from [N]",
    "n0": "moment through the joint, along the axes that its turn starts from [N m]",
    "tau": "joint torque [N m], at a prismatic joint force [N]",
    "h": "first moment of the composite body, about the frame's origin [kg m]",
    "k": "second moment of the composite body [kg m^2]",
    "fu": "force for a unit acceleration of a joint further out",
    "nu": "moment for a unit acceleration of a joint further out",
    "m": "mass matrix, its row of this joint",
    "ia": "inertia of all that the joint carries, the joints beyond free to move, about the frame's origin",
    "ea": "acceleration of the frame for a push at its origin, all joints free to move",
    "pivot": "factorisation M = U D U^T",
    "y": "forward substitution",
    "qdd": "joint acceleration [rad/s^2], at a prismatic joint [m/s^2]",
}


#: Quantities that stand under the heading of another.
_UNDER: dict[str, str] = {
    **dict.fromkeys(("ipivot", "u", "ud"), "pivot"),
    **dict.fromkeys(("ibx", "iby", "ibz", "im"), "ia"),
    **dict.fromkeys(("ebx", "eby", "ebz", "em"), "ea"),
}

#: Where the explanation of a quantity begins, behind its name.
_EXPLANATION = re.compile(r": |, | \[")


def heading_of(label: Label | None) -> str | None:
    """What stands above a value with ``label``; None where nothing is to be said."""
    if label is None:
        return None
    if label.quantity.removesuffix("to").rstrip("0123456789") in ("c", "s", "angle"):
        return QUANTITIES["sc"]
    family = _UNDER.get(label.quantity, label.quantity)
    meaning = QUANTITIES.get(family)
    return meaning if meaning is None or family == "pivot" else f"link {label.link}: {meaning}"


def explained_once(heading: str, explained: set[str]) -> str:
    """``heading`` (``link 3: what it is, of which, in which unit``) in full where the quantity is not among
    those ``explained`` yet, else by its name."""
    place, colon, meaning = heading.partition(": ")
    if not place.startswith("link ") or not colon:
        place, colon, meaning = "", "", heading
    if meaning not in explained:
        explained.add(meaning)
        return heading
    return f"{place}{colon}{_EXPLANATION.split(meaning)[0]}"
