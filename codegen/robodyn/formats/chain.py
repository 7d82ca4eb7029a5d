"""A serial chain as other formats state it: joint axes in any direction, frames where their author put them;
and how its poses and rigid bodies are put together.

Numbers are floats, SI units. What a file wrote as decimal text comes out as the same text again:
:func:`~robodyn.robot.numbers.shortest` makes the rational of a float's shortest text, and rotations by
multiples of pi/2 have entries 0 and +-1 only, so that nothing they touch is rounded. Sums are exact before
they are rounded, so decimals stay short.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction

from robodyn.formats.limits import ROUNDING
from robodyn.robot.account import Origins
from robodyn.robot.numbers import shortest
from robodyn.robot.parts import Coupling, Gear, JointKind, Limits
from robodyn.robot.rotations import QUARTER_TURN
from robodyn.robot.values import ZERO

Vector = tuple[float, float, float]
Rotation = tuple[Vector, Vector, Vector]
#: The entries ``xx yy zz xy xz yz`` of an inertia tensor [kg m^2].
Tensor = tuple[float, float, float, float, float, float]
#: A pseudo-inertia [4, 4] by rows: the integral of ``[r; 1] [r; 1]^T`` over the mass of a body.
Moments = Sequence[Sequence[Fraction]]

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
    inertia: Tensor = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


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
    the frame of the last joint. ``couplings``: which joints follow others.
    """

    name: str
    joints: tuple[ChainJoint, ...]
    title: str = ""
    source: str = ""
    gravity: Vector = (0.0, 0.0, -9.81)
    base: Pose = field(default_factory=Pose)
    tool: Pose = field(default_factory=Pose)
    couplings: tuple[Coupling, ...] = ()


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


def onto(axis: Vector) -> Rotation:
    """A rotation that takes z to the unit vector ``axis``, as few axes turned as can be."""
    largest = max(range(3), key=lambda k: abs(axis[k]))
    way = math.copysign(1.0, axis[largest])
    z: Vector = (way * (largest == 0), way * (largest == 1), way * (largest == 2))
    x: Vector = (1.0, 0.0, 0.0) if largest else (0.0, 0.0, -way)
    if math.hypot(*(axis[k] for k in range(3) if k != largest)) > QUARTER_TURN:
        z = scaled(1 / math.hypot(*axis), axis)
        least = min(range(3), key=lambda k: abs(axis[k]))
        beside: Vector = (float(least == 0), float(least == 1), float(least == 2))
        a, b, c = (u - dot(beside, z) * v for u, v in zip(beside, z, strict=True))
        x = scaled(1 / math.hypot(a, b, c), (a, b, c))
    return transposed((x, cross(z, x), z))


def unit(numbers: Vector) -> Vector:
    """``numbers`` at length 1. One along x, y or z has its exact entries."""
    x, y, z = numbers
    length = math.hypot(x, y, z)
    return numbers if length == 1.0 else (x / length, y / length, z / length)


def composed(pose: Pose, child: Pose) -> Pose:
    """``child``, stated in the frame of ``pose``, as a pose in its parent."""
    if child == Pose():
        return pose
    return Pose(_position(pose, child.xyz), product(pose.rotation, child.rotation))


def tidy(pose: Pose) -> Pose:
    """``pose`` with 0 and +-1 in the rotation where rounding left something else."""
    whole = {x: float(round(x)) for row in pose.rotation for x in row if abs(x - round(x)) <= ROUNDING}
    a, b, c = ((whole.get(x, x), whole.get(y, y), whole.get(z, z)) for x, y, z in pose.rotation)
    return Pose(pose.xyz, (a, b, c))


def body_of(mass: float, pose: Pose, inertia: Tensor) -> Body:
    """The body whose centre of mass is the origin of ``pose`` and whose tensor is along the axes of it;
    turned by quarters, entries change their places and signs only."""
    xx, yy, zz, xy, xz, yz = inertia
    tensor: Rotation = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    a, b, c = product(product(pose.rotation, tensor), transposed(pose.rotation))
    return Body(mass, pose.xyz, (a[0], b[1], c[2], a[1], a[2], b[2]))


def moved(pose: Pose, body: Body) -> Body:
    """``body``, stated in the frame of ``pose``, in its parent."""
    if pose == Pose():
        return body
    return body_of(body.mass, replace(pose, xyz=_position(pose, body.com)), body.inertia)


def lumped(bodies: Iterable[Body]) -> Body:
    """One body out of several in the same frame."""
    bodies = [body for body in bodies if body != Body()]
    if len(bodies) < 2:
        return bodies[0] if bodies else Body()
    rows = zip(*map(moments_of, bodies), strict=True)
    return body_with([[sum(entries, ZERO) for entries in zip(*row, strict=True)] for row in rows])


def moments_of(body: Body) -> Moments:
    """The pseudo-inertia of ``body`` about its frame's origin: second and first moments, and mass."""
    mass, com = shortest(body.mass), [*map(shortest, body.com), Fraction(1)]
    xx, yy, zz, xy, xz, yz = map(shortest, body.inertia)
    half = (xx + yy + zz) / 2
    second = [[half - xx, -xy, -xz], [-xy, half - yy, -yz], [-xz, -yz, half - zz]]
    central = [[*row, ZERO] for row in second] + [[ZERO] * 4]
    return [
        [x + mass * r * c for x, c in zip(row, com, strict=True)] for row, r in zip(central, com, strict=True)
    ]


def body_with(moments: Moments) -> Body:
    """The body that has this pseudo-inertia, rounded; one without mass has its centre at the origin."""
    mass = moments[3][3]
    com = [moments[k][3] / mass if mass else ZERO for k in range(3)]
    (a, d, e), (_, b, f), (_, _, c) = (
        [moments[i][k] - mass * com[i] * com[k] for k in range(3)] for i in range(3)
    )
    x, y, z = map(float, com)
    xx, yy, zz, xy, xz, yz = map(float, (b + c, a + c, a + b, -d, -e, -f))
    return Body(float(mass), (x, y, z), (xx, yy, zz, xy, xz, yz))


def _position(pose: Pose, point: Vector) -> Vector:
    """``R point + xyz``, rounded once an entry."""
    inner = [*map(shortest, point)]
    x, y, z = (
        float(shortest(origin) + sum((shortest(r) * c for r, c in zip(row, inner, strict=True)), ZERO))
        for origin, row in zip(pose.xyz, pose.rotation, strict=True)
    )
    return (x, y, z)
