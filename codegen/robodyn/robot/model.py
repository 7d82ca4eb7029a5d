"""A serial arm as data: frozen, SI units, modified (Craig) Denavit-Hartenberg frames.

Frame i is reached from frame i-1 by ``Rot(x, alpha) Trans(x, a) Rot(z, theta + q) Trans(z, d)``
(revolute) or ``Rot(x, alpha) Trans(x, a) Rot(z, theta) Trans(z, d + q)`` (prismatic). Numbers are
:data:`~robodyn.robot.values.Value`: an exact rational, or an affine form in run-time parameters.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from robodyn.robot.values import ZERO, Affine, Angle, Value, parameters_of

if TYPE_CHECKING:
    from robodyn.effects.effect import Effect

JointKind = Literal["revolute", "prismatic"]
Vector = tuple[Value, Value, Value]
#: Entries of an inertia tensor, in the order of :class:`Inertia`.
AXES = ("xx", "yy", "zz", "xy", "xz", "yz")


@dataclass(frozen=True, slots=True)
class Inertia:
    """Inertia tensor about the centre of mass, along the link's axes [kg m^2].

    ``xy`` and its like are the entries of the tensor (minus the products of inertia).
    """

    xx: Value = ZERO
    yy: Value = ZERO
    zz: Value = ZERO
    xy: Value = ZERO
    xz: Value = ZERO
    yz: Value = ZERO


@dataclass(frozen=True, slots=True)
class Limits:
    """Limits of a joint; rad or m, per second, per second squared; N m or N. None: not stated."""

    position: tuple[Fraction, Fraction] | None = None
    velocity: Fraction | None = None
    acceleration: Fraction | None = None
    torque: Fraction | None = None


@dataclass(frozen=True, slots=True)
class Joint:
    """The joint before a link: its kind, its four DH numbers, and what sits in it.

    ``motor_inertia`` is reflected to the joint [kg m^2, prismatic kg]; ``viscous`` [N m s/rad or
    N s/m] and ``coulomb`` [N m or N] are the friction shorthand.
    """

    kind: JointKind
    alpha: Angle
    a: Value
    d: Value
    theta: Angle
    motor_inertia: Value = ZERO
    viscous: Value = ZERO
    coulomb: Value = ZERO
    limits: Limits = field(default_factory=Limits)


@dataclass(frozen=True, slots=True)
class Link:
    """A link with the joint that carries it: mass [kg], centre of mass [m] in its own frame.

    ``acknowledged`` says why implausible numbers of it stand as they are ("": nobody says so).
    """

    name: str
    joint: Joint
    mass: Value = ZERO
    com: Vector = (ZERO, ZERO, ZERO)
    inertia: Inertia = field(default_factory=Inertia)
    confidence: Fraction = Fraction(1, 10)
    acknowledged: str = ""


#: What an effect's parameter may be: a number, three, a tensor, knots (load fraction, efficiency), a word,
#: the number of a joint.
Setting = Value | Vector | Inertia | tuple[tuple[Fraction, Fraction], ...] | str | int


@dataclass(frozen=True, slots=True)
class EffectEntry:
    """An effect that a robot has: its id in the catalogue (:mod:`robodyn.effects.catalogue`), the joint (from
    1; None: the whole robot), and its parameters, those left out at their defaults."""

    effect: str
    joint: int | None
    settings: tuple[tuple[str, Setting], ...]

    @property
    def definition(self) -> Effect:
        """The effect itself."""
        from robodyn.effects.catalogue import CATALOGUE  # a rigid arm does without it

        return CATALOGUE[self.effect]

    def __getitem__(self, name: str) -> Any:
        for known, value in self.settings:
            if known == name:
                return value
        raise KeyError(name)

    def __contains__(self, name: str) -> bool:
        return any(known == name for known, _ in self.settings)

    def number(self, name: str, parameters: Mapping[str, float] | None = None) -> float:
        """The parameter ``name`` as a float; run-time names take their values from ``parameters``."""
        value = self[name]
        if isinstance(value, Affine):
            known = parameters or {}
            return float(value.constant) + sum(float(k) * known[term] for term, k in value.terms)
        return float(value)

    def text(self, name: str) -> str:
        """The parameter ``name``, a word."""
        return str(self[name])

    def values(self) -> Iterator[Value]:
        """Every number of it that may be a run-time parameter."""
        for _, setting in self.settings:
            if isinstance(setting, (Fraction, Affine)):
                yield setting
            elif isinstance(setting, Inertia):
                yield from (setting.xx, setting.yy, setting.zz, setting.xy, setting.xz, setting.yz)
            elif isinstance(setting, tuple):
                yield from (x for x in setting if isinstance(x, (Fraction, Affine)))


@dataclass(frozen=True, slots=True)
class Comparison:
    """The row of a table of the thesis that a robot is set beside."""

    table: str
    row: str


@dataclass(frozen=True, slots=True)
class Robot:
    """A serial arm, base to tip.

    ``rest_velocity`` is None where friction at rest is exact (sgn 0 = 0), else the velocity [rad/s or
    m/s] over which ``tanh(qd / rest_velocity)`` replaces the sign. ``torque_side`` says whether the
    joint torque is the motor's (rotor and friction are in it) or the link's (they are not).
    ``dead_band``: the sign is 0 below that velocity. ``effects``: base to tip, then those of the whole robot.
    ``file`` is where the description was read, None if it came from no file; records may lie beside it.
    """

    name: str
    links: tuple[Link, ...]
    title: str = ""
    source: str = ""
    gravity: tuple[Fraction, Fraction, Fraction] = (ZERO, ZERO, Fraction(-981, 100))
    compare: Comparison | None = None
    torque_side: Literal["motor", "link"] = "motor"
    rest_velocity: Fraction | None = None
    dead_band: Fraction | None = None
    effects: tuple[EffectEntry, ...] = ()
    file: Path | None = field(default=None, compare=False, repr=False)

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.links)

    def values(self) -> Iterator[Value]:
        """Every number that may be a run-time parameter, base to tip."""
        for link in self.links:
            i, j = link.inertia, link.joint
            yield from (j.a, j.d, link.mass, *link.com)
            yield from (i.xx, i.yy, i.zz, i.xy, i.xz, i.yz)
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

        return filled(self, parameters)
