"""The parts of a serial arm: frozen, SI units, modified (Craig) Denavit-Hartenberg frames.

Frame i is reached from frame i-1 by ``Rot(x, alpha) Trans(x, a) Rot(z, theta + q) Trans(z, d)``
(revolute) or ``Rot(x, alpha) Trans(x, a) Rot(z, theta) Trans(z, d + q)`` (prismatic). Numbers are
:data:`~robodyn.robot.values.Value`: an exact rational, or an affine form in run-time parameters.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Literal

from robodyn.robot.values import ZERO, Affine, Angle, Value

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
