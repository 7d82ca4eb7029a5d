"""The parts of a serial arm: frozen, SI units, modified (Craig) Denavit-Hartenberg frames.

Frame i is reached from frame i-1 by ``Rot(x, alpha) Trans(a, b, 0) Rot(z, theta + q) Trans(z, d)``
(revolute) or ``Rot(x, alpha) Trans(a, b, 0) Rot(z, theta) Trans(z, d + q)`` (prismatic). ``b`` is 0 in
Denavit-Hartenberg rows; where two axes are nearly parallel, it keeps the origins near the arm. Numbers are
:data:`~robodyn.robot.values.Value`: an exact rational, or an affine form in run-time parameters.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Literal

from robodyn.robot.account import Origins
from robodyn.robot.values import ZERO, Affine, Angle, Value

if TYPE_CHECKING:
    from robodyn.arrays import Floats
    from robodyn.effects.effect import Effect

JointKind = Literal["revolute", "prismatic"]
#: What a description says of its inertial numbers: right to about this share of their size; a guess; nothing.
Confidence = Fraction | Literal["unknown"] | None
#: In place of a share: the inertial numbers are a guess.
UNKNOWN: Literal["unknown"] = "unknown"
#: The share by which inertial numbers may be wrong where nothing is stated, and where they are a guess.
SHARE_NOT_STATED, SHARE_UNKNOWN = Fraction(1, 10), Fraction(1)
Vector = tuple[Value, Value, Value]
#: Three exact numbers, and three of them.
Exact = tuple[Fraction, Fraction, Fraction]
Rows = tuple[Exact, Exact, Exact]
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

    @property
    def entries(self) -> tuple[Value, Value, Value, Value, Value, Value]:
        """In the order of :data:`AXES`."""
        return self.xx, self.yy, self.zz, self.xy, self.xz, self.yz


@dataclass(frozen=True, slots=True)
class Limits:
    """Limits of a joint; rad or m, per second, per second squared; N m or N. None: not stated."""

    position: tuple[Fraction, Fraction] | None = None
    velocity: Fraction | None = None
    acceleration: Fraction | None = None
    torque: Fraction | None = None


@dataclass(frozen=True, slots=True)
class Placement:
    """A frame in its parent frame: origin ``xyz`` [m], and URDF's ``rpy`` (roll, pitch, yaw), which is
    ``Rot(z, yaw) Rot(y, pitch) Rot(x, roll)``."""

    xyz: Exact
    rpy: tuple[Angle, Angle, Angle]

    @property
    def rotation(self) -> Rows:
        """The rotation by rows: it takes vectors of the frame into the parent's."""
        roll, pitch, yaw = self.rpy
        (cr, sr), (cp, sp), (cy, sy) = ((angle.cos, angle.sin) for angle in (roll, pitch, yaw))
        return (
            (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
            (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
            (-sp, cp * sr, cp * cr),
        )

    def back(self, u: Exact) -> Exact:
        """A vector of the parent frame along the axes of this one."""
        x, y, z = (sum((row[k] * e for row, e in zip(self.rotation, u, strict=True)), ZERO) for k in range(3))
        return x, y, z


@dataclass(frozen=True, slots=True)
class Gear:
    """Between motor and joint: ``ratio``, turns of the motor for one of the joint (prismatic: rad/m), and
    ``torque_constant`` [N m/A] of the motor, in front of the gear; None: not stated."""

    ratio: Fraction
    torque_constant: Fraction | None = None

    @property
    def torque_per_ampere(self) -> Fraction | None:
        """Joint torque for one ampere [N m/A, prismatic N/A]; None where no torque constant is stated."""
        return None if self.torque_constant is None else self.ratio * self.torque_constant


@dataclass(frozen=True, slots=True)
class Joint:
    """The joint before a link: its kind, its DH numbers, and what sits in it.

    ``b`` [m]: offset along y behind the twist, 0 in a DH row. ``motor_inertia`` is reflected to the joint
    [kg m^2, prismatic kg]; ``viscous`` [N m s/rad or N s/m] and ``coulomb`` [N m or N] are the friction
    shorthand. ``gear``: None where it is not stated.
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
    gear: Gear | None = None
    b: Value = ZERO


@dataclass(frozen=True, slots=True)
class Link:
    """A link with the joint that carries it: mass [kg], centre of mass [m] in its own frame.

    ``confidence``: the share by which its inertial numbers may be wrong, "unknown" where they are a guess,
    None where nothing is stated; who needs a number takes :attr:`inertial_share`.
    ``acknowledged`` says why implausible numbers of it stand as they are ("": nobody says so). ``origins``:
    where the numbers come from; a link made in Python states its geometry and inertial numbers.
    """

    name: str
    joint: Joint
    mass: Value = ZERO
    com: Vector = (ZERO, ZERO, ZERO)
    inertia: Inertia = field(default_factory=Inertia)
    confidence: Confidence = None
    acknowledged: str = ""
    origins: Origins = field(default=Origins(), compare=False, repr=False)

    def __post_init__(self) -> None:
        """A number that is not 0 is there, whoever put it there."""
        joint = self.joint
        values = {
            "geometry": any((joint.alpha.radians, joint.theta.radians, joint.a, joint.b, joint.d)),
            "mass": self.mass != ZERO,
            "com": any(x != ZERO for x in self.com),
            "inertia": self.inertia != Inertia(),
            "motor_inertia": joint.motor_inertia != ZERO,
            "friction": (joint.viscous, joint.coulomb) != (ZERO, ZERO),
            "limits": joint.limits != Limits(),
        }
        stated = self.origins.with_stated(name for name, there in values.items() if there)
        object.__setattr__(self, "origins", stated)

    @property
    def inertial_share(self) -> Fraction:
        """The share by which the inertial numbers may be wrong: the stated one, 1 if they are a guess, 0.1
        where nothing is stated."""
        if self.confidence is None:
            return SHARE_NOT_STATED
        return self.confidence if isinstance(self.confidence, Fraction) else SHARE_UNKNOWN


@dataclass(frozen=True, slots=True)
class Covariance:
    """How sure the numbers of an arm are that were identified together. ``file``: the name of the file beside
    the description that says it. Where it was read or made, ``values`` [11 n]: ten standard parameters of
    each link, then the rotors; ``root`` [r, 11 n]: their covariance is ``root.T @ root``."""

    file: str
    values: Floats | None = field(default=None, compare=False, repr=False)
    root: Floats | None = field(default=None, compare=False, repr=False)


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
                yield from setting.entries
            elif isinstance(setting, tuple):
                yield from (x for x in setting if isinstance(x, (Fraction, Affine)))


@dataclass(frozen=True, slots=True)
class Coupling:
    """The joint number ``joint`` follows the joint ``of``, both from 1: ``q = ratio q_of + offset`` [rad or
    m]. What one joint follows in several couplings adds up."""

    joint: int
    of: int
    ratio: Fraction = Fraction(1)
    offset: Fraction = ZERO


@dataclass(frozen=True, slots=True)
class Comparison:
    """The row of a table of the thesis that a robot is set beside."""

    table: str
    row: str
