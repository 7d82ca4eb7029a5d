"""A serial arm as data: frozen, SI units, modified (Craig) Denavit-Hartenberg frames; its parts are in
:mod:`robodyn.robot.parts`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from pathlib import Path
from typing import Literal

from robodyn.robot.account import Account
from robodyn.robot.parts import (
    AXES,
    Comparison,
    Confidence,
    Coupling,
    Covariance,
    EffectEntry,
    Exact,
    Gear,
    Inertia,
    Joint,
    JointKind,
    Limits,
    Link,
    Placement,
    Setting,
    Vector,
)
from robodyn.robot.values import ZERO, Affine, Value, parameters_of

__all__ = [
    "AXES",
    "Comparison",
    "Confidence",
    "Coupling",
    "Covariance",
    "EffectEntry",
    "Gear",
    "Inertia",
    "Joint",
    "JointKind",
    "Limits",
    "Link",
    "Placement",
    "Robot",
    "Setting",
    "Vector",
]


#: Joints that the ``repr`` of a robot shows.
_SHOWN = 20


def _short(value: Value) -> str:
    """A number for people; of a run-time one its names."""
    return "+".join(parameters_of(value)) if isinstance(value, Affine) else f"{float(value):g}"


@dataclass(frozen=True, slots=True)
class Robot:
    """A serial arm, base to tip.

    ``rest_velocity`` is None where friction at rest is exact (sgn 0 = 0), else the velocity [rad/s or
    m/s] over which ``tanh(qd / rest_velocity)`` replaces the sign. ``torque_side`` says whether the
    joint torque is the motor's (rotor and friction are in it) or the link's (they are not).
    ``dead_band``: the sign is 0 below that velocity. ``effects``: base to tip, then those of the whole robot.
    ``gravity`` [m/s^2] is in the frame that ``base`` places the base frame in (None: in the base frame);
    ``tool`` is the tool's frame in the last link's. ``standard_end``: of a description in standard DH
    the last link's frame by it, in the last one here. ``file`` is where the description was read, None if it
    came from no file; records may lie beside it. ``account``: what the reading of a file in another format
    came upon, None where there was no such file. ``covariance``: of numbers that were identified together.
    ``couplings``: which joints follow others (:mod:`robodyn.robot.coupling`); what moves by itself is
    commanded.
    """

    name: str
    links: tuple[Link, ...]
    title: str = ""
    source: str = ""
    gravity: Exact = (ZERO, ZERO, Fraction(-981, 100))
    compare: Comparison | None = None
    torque_side: Literal["motor", "link"] = "motor"
    rest_velocity: Fraction | None = None
    dead_band: Fraction | None = None
    effects: tuple[EffectEntry, ...] = ()
    file: Path | None = field(default=None, compare=False, repr=False)
    base: Placement | None = None
    tool: Placement | None = None
    standard_end: Placement | None = None
    account: Account | None = field(default=None, compare=False, repr=False)
    covariance: Covariance | None = None
    couplings: tuple[Coupling, ...] = ()

    def __repr__(self) -> str:
        """A screen's worth: one line a joint, the first twenty. :func:`~robodyn.robot.to_yaml` shows all."""
        lines = [
            f"<Robot {self.name}: {self.n} joints, gravity [{', '.join(map(_short, self.gravity))}] m/s^2"
        ]
        for i, link in enumerate(self.links[:_SHOWN], 1):
            effects = ", ".join(entry.effect for entry in self.effects_at(i)[:3])
            lines.append(
                f"  {i} {link.name[:24]}: {link.joint.kind}, {_short(link.mass)[:24]} kg"
                + (f", {effects}"[:40] if effects else "")
            )
        if self.n > _SHOWN:
            lines.append(f"  and {self.n - _SHOWN} more")
        return "\n".join(lines) + ">"

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.links)

    @property
    def commanded(self) -> tuple[int, ...]:
        """The joints, from 0, that follow no other: the coordinates of kernels, base to tip."""
        following = {coupling.joint - 1 for coupling in self.couplings}
        return tuple(i for i in range(self.n) if i not in following)

    @property
    def free(self) -> Robot:
        """The same arm with every joint moving by itself."""
        return replace(self, couplings=()) if self.couplings else self

    @property
    def base_gravity(self) -> Exact:
        """Gravity [m/s^2] along the axes of the base frame; exact, so with many digits where the base is
        turned by other than right angles."""
        return self.gravity if self.base is None else self.base.back(self.gravity)

    def values(self) -> Iterator[Value]:
        """Every number that may be a run-time parameter, base to tip."""
        for link in self.links:
            j = link.joint
            yield from (j.a, j.d, j.b, link.mass, *link.com, *link.inertia.entries)
            yield from (j.motor_inertia, j.viscous, j.coulomb)
        for entry in self.effects:
            yield from entry.values()

    def effects_at(self, joint: int | None) -> tuple[EffectEntry, ...]:
        """The effects at ``joint`` (from 1), or those of the whole robot (None)."""
        return tuple(entry for entry in self.effects if entry.joint == joint)

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the run-time parameters, in the order of the emitted ``NAME_params``."""
        seen: dict[str, None] = {}
        for value in self.values():
            if isinstance(value, Affine):
                seen.update(dict.fromkeys(parameters_of(value)))
        return tuple(seen)

    def at(self, parameters: Mapping[str, float | Fraction]) -> Robot:
        """This robot with its run-time parameters at the given values, SI units.

        Raises
        ------
        InputError: a parameter is unknown or has no value, or a value is not finite or not allowed.
        """
        from robodyn.robot.filling import filled

        links, effects = filled(self, parameters)
        return replace(self, links=links, effects=effects) if self.parameters else self
