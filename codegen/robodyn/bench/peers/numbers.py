"""A rigid arm in plain doubles, which is what the peers take; and whether one gives our torques: only then is
it timed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.errors import CheckError, InputError
from robodyn.robot.model import AXES, Link, Robot


class NumbersLacking(InputError):
    """The robot is not one that the peers can be given."""


@dataclass(frozen=True, slots=True)
class LinkNumbers:
    """A link and the joint that carries it: modified DH and the offset ``b`` [m] along y behind the twist,
    mass [kg], centre of mass [3] (m), inertia about it [3, 3] (kg m^2), rotor at the joint (kg m^2, prismatic
    kg). ``rotation`` [3, 3] and ``position`` [3] place the joint's frame at q = 0 in the frame before it."""

    revolute: bool
    alpha: tuple[float, float, float]
    a: float
    d: float
    theta: tuple[float, float, float]
    mass: float
    com: Floats
    inertia: Floats
    rotor: float
    b: float = 0.0

    @property
    def rotation(self) -> Floats:
        """Rot(x, alpha) Rot(z, theta)."""
        _, ca, sa = self.alpha
        _, ct, st = self.theta
        about_x = np.array([[1, 0, 0], [0, ca, -sa], [0, sa, ca]])
        return np.asarray(about_x @ np.array([[ct, -st, 0], [st, ct, 0], [0, 0, 1]]), dtype=np.float64)

    @property
    def position(self) -> Floats:
        """Where the frame's origin is [3]."""
        _, ca, sa = self.alpha
        return np.array([self.a, ca * self.b - sa * self.d, sa * self.b + ca * self.d])


@dataclass(frozen=True, slots=True)
class Numbers:
    """The arm: gravity [3] (m/s^2) in the base frame, and its links."""

    name: str
    gravity: Floats
    links: tuple[LinkNumbers, ...]

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.links)


def numbers_of(robot: Robot) -> Numbers:
    """``robot`` in plain numbers.

    Raises
    ------
    NumbersLacking: run-time parameters, effects, friction: peers know none of them.
    """
    if robot.parameters:
        raise NumbersLacking(f"{robot.name} has run-time parameters", found=", ".join(robot.parameters))
    if robot.effects:
        effects = ", ".join(sorted({entry.effect for entry in robot.effects}))
        raise NumbersLacking(f"{robot.name} has effects that peers do not know", found=effects)
    motor = robot.torque_side == "motor"
    if motor and any(link.joint.viscous or link.joint.coulomb for link in robot.links):
        raise NumbersLacking(f"{robot.name} has friction, which the peers' inverse dynamics leave out")
    links = tuple(_link(link, motor) for link in robot.links)
    return Numbers(robot.name, np.array([float(g) for g in robot.base_gravity]), links)


def _link(link: Link, motor: bool) -> LinkNumbers:
    joint = link.joint
    xx, yy, zz, xy, xz, yz = (_plain(getattr(link.inertia, axes)) for axes in AXES)
    return LinkNumbers(
        revolute=joint.kind == "revolute",
        alpha=(joint.alpha.radians, float(joint.alpha.cos), float(joint.alpha.sin)),
        theta=(joint.theta.radians, float(joint.theta.cos), float(joint.theta.sin)),
        mass=_plain(link.mass),
        com=np.array([_plain(x) for x in link.com]),
        inertia=np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]),
        rotor=_plain(joint.motor_inertia) if motor else 0.0,
        **{name: _plain(getattr(joint, name)) for name in ("a", "d", "b")},
    )


def _plain(value: Any) -> float:
    return float(value)  # there are no run-time parameters


# --- agreement --------------------------------------------------------------------------------------------

#: What may be between two torques of a state, as a share of the larger of 1 and its largest torque.
TOLERANCE: Final = 1e-9
#: The same for kernels in single precision.
TOLERANCE_FLOAT: Final = 2e-4


class Disagreement(CheckError):
    """A peer gives other torques: whatever it computes, its time says nothing."""


def hold_against(name: str, ours: NDArray[Any], theirs: NDArray[Any], tolerance: float = TOLERANCE) -> float:
    """The largest difference of the torques [N, n] of one and the other, as a share of what it is held to
    (:data:`TOLERANCE`).

    Raises
    ------
    Disagreement: more than ``tolerance``, or a torque that is no number.
    """
    if ours.shape != theirs.shape:
        raise Disagreement(f"{name} gives torques [{theirs.shape}]", expected=f"[{ours.shape}]")
    scale = np.maximum(1.0, np.abs(ours).max(axis=1, keepdims=True))
    error = np.abs(theirs.astype(np.float64) - ours) / scale
    worst = float(np.nan_to_num(error, nan=np.inf).max()) if error.size else 0.0
    if worst > tolerance:
        state, joint = np.unravel_index(int(np.nan_to_num(error, nan=np.inf).argmax()), error.shape)
        raise Disagreement(
            f"{name} gives another torque in state {state}, joint {joint + 1}",
            found=f"{theirs[state, joint]!r}",
            expected=f"{ours[state, joint]!r}, to {tolerance:g} of the largest torque",
            remedy="it is not timed",
        )
    return worst
