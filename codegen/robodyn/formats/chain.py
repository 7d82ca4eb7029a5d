"""A serial chain as other formats state it: joint axes in any direction, frames where their author put them.

Numbers are floats, SI units. What a file wrote as decimal text comes out as the same text again:
:func:`~robodyn.robot.numbers.shortest` makes the rational of a float's shortest text, and rotations by
multiples of pi/2 have entries 0 and +-1 only, so that nothing they touch is rounded.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

from robodyn.robot.account import Origins
from robodyn.robot.parts import Gear, JointKind, Limits
from robodyn.robot.rotations import QUARTER_TURN

Vector = tuple[float, float, float]
Rotation = tuple[Vector, Vector, Vector]

IDENTITY: Rotation = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
_QUARTERS = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))


@dataclass(frozen=True, slots=True)
class Pose:
    """A rigid transformation: a frame in its parent frame.

    ``xyz`` [m] is the frame's origin; the columns of ``rotation`` (rows first) are its axes, both along the
    axes of the parent.
    """

    xyz: Vector = (0.0, 0.0, 0.0)
    rotation: Rotation = IDENTITY

    @classmethod
    def from_rpy(cls, xyz: Sequence[float], rpy: Sequence[float]) -> Pose:
        """The pose with origin ``xyz`` [m] and URDF's ``rpy`` [rad]: ``Rz(yaw) Ry(pitch) Rx(roll)``."""
        x, y, z = xyz
        (cr, sr), (cp, sp), (cy, sy) = map(cosine_and_sine, rpy)
        rotation = (
            (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
            (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
            (-sp, cp * sr, cp * cr),
        )
        return cls((x, y, z), rotation)

    @classmethod
    def from_quaternion(cls, xyz: Sequence[float], wxyz: Sequence[float]) -> Pose:
        """The pose with origin ``xyz`` [m] and the quaternion ``wxyz`` (scalar first), normalised here.

        Raises
        ------
        ValueError: the quaternion is 0 or not finite.
        """
        x, y, z = xyz
        norm = math.hypot(*wxyz)
        if not 0 < norm < math.inf:
            raise ValueError(f"the quaternion {tuple(wxyz)} has no direction")
        w, i, j, k = (entry / norm for entry in wxyz)
        rotation = (
            (1 - 2 * (j * j + k * k), 2 * (i * j - k * w), 2 * (i * k + j * w)),
            (2 * (i * j + k * w), 1 - 2 * (i * i + k * k), 2 * (j * k - i * w)),
            (2 * (i * k - j * w), 2 * (j * k + i * w), 1 - 2 * (i * i + j * j)),
        )
        return cls((x, y, z), rotation)

    def compose(self, child: Pose) -> Pose:
        """``child``, stated in this frame, as a pose in the parent of this frame."""
        return Pose(added(self.xyz, turned(self.rotation, child.xyz)), product(self.rotation, child.rotation))

    def inverse(self) -> Pose:
        """The parent frame in this frame."""
        back = transposed(self.rotation)
        x, y, z = turned(back, self.xyz)
        return Pose((-x, -y, -z), back)


@dataclass(frozen=True, slots=True)
class Body:
    """A rigid body in the frame of the joint that carries it: mass [kg], centre of mass [m] and inertia about
    it [kg m^2], ``xx yy zz xy xz yz`` (entries of the tensor)."""

    mass: float = 0.0
    com: Vector = (0.0, 0.0, 0.0)
    inertia: tuple[float, float, float, float, float, float] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Spring:
    """A spring in a joint: it pulls towards ``rest`` [rad or m] by ``stiffness`` [N m/rad or N/m]."""

    stiffness: float
    rest: float = 0.0


@dataclass(frozen=True, slots=True)
class ChainJoint:
    """A joint and the link behind it.

    ``pose``: the joint's frame in the frame of the joint before (of the base, for the first) at q = 0;
    ``axis``: unit vector in the joint's frame, along or about which q [m or rad] counts. ``motor_inertia``
    is reflected to the joint [kg m^2, prismatic kg]; ``viscous`` [N m s/rad or N s/m] and ``coulomb`` [N m or
    N] are friction. ``origins``: where the numbers come from.
    """

    name: str
    link: str
    kind: JointKind
    pose: Pose = field(default_factory=Pose)
    axis: Vector = (0.0, 0.0, 1.0)
    body: Body = field(default_factory=Body)
    limits: Limits = field(default_factory=Limits)
    viscous: float = 0.0
    coulomb: float = 0.0
    motor_inertia: float = 0.0
    gear: Gear | None = None
    spring: Spring | None = None
    origins: Origins = field(default_factory=Origins)


@dataclass(frozen=True, slots=True)
class Chain:
    """A serial chain, base to tip.

    ``gravity`` [m/s^2] is in the world; ``base``: the base frame in the world; ``tool``: the tip's frame in
    the frame of the last joint.
    """

    name: str
    joints: tuple[ChainJoint, ...]
    title: str = ""
    source: str = ""
    gravity: Vector = (0.0, 0.0, -9.81)
    base: Pose = field(default_factory=Pose)
    tool: Pose = field(default_factory=Pose)


def cosine_and_sine(angle: float) -> tuple[float, float]:
    """Cosine and sine of ``angle`` [rad], 0 and +-1 exactly at multiples of pi/2 written with 12 digits."""
    quarter = round(angle / (math.pi / 2))
    if abs(angle - quarter * (math.pi / 2)) <= QUARTER_TURN * max(1, abs(quarter)):
        return _QUARTERS[quarter % 4]
    return math.cos(angle), math.sin(angle)


def dot(u: Vector, v: Vector) -> float:
    """Scalar product."""
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u: Vector, v: Vector) -> Vector:
    """Vector product."""
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def added(u: Vector, v: Vector) -> Vector:
    """``u + v``."""
    return (u[0] + v[0], u[1] + v[1], u[2] + v[2])


def scaled(factor: float, u: Vector) -> Vector:
    """``factor u``."""
    return (factor * u[0], factor * u[1], factor * u[2])


def turned(rotation: Rotation, u: Vector) -> Vector:
    """``R u``."""
    return (dot(rotation[0], u), dot(rotation[1], u), dot(rotation[2], u))


def transposed(rotation: Rotation) -> Rotation:
    """``R^T``."""
    (a, b, c), (d, e, f), (g, h, i) = rotation
    return ((a, d, g), (b, e, h), (c, f, i))


def product(left: Rotation, right: Rotation) -> Rotation:
    """``L R``."""
    columns = transposed(right)
    a, b, c = (turned(columns, row) for row in left)
    return (a, b, c)


def about_axis(axis: Vector, angle: float) -> Rotation:
    """The rotation by ``angle`` [rad] about the unit vector ``axis`` (Rodrigues)."""
    c, s = cosine_and_sine(angle)
    x, y, z = axis
    v = 1 - c
    return (
        (c + v * x * x, v * x * y - s * z, v * x * z + s * y),
        (v * x * y + s * z, c + v * y * y, v * y * z - s * x),
        (v * x * z - s * y, v * y * z + s * x, c + v * z * z),
    )
