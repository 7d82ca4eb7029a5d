"""An arm in scalars of one kind, and where it is: what every recursion starts from."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from robodyn.dynamics.vectors import BASE, ZERO, Frame, Mark, Vector
from robodyn.effects.scalars import cosine, is_zero, sine
from robodyn.ir.program import Label
from robodyn.robot.coupling import no_couplings
from robodyn.robot.model import Inertia, Placement, Robot
from robodyn.robot.values import Affine, Angle, Value


@dataclass(frozen=True, slots=True)
class Symmetric:
    """A symmetric 3x3 tensor by its six entries."""

    xx: Any
    yy: Any
    zz: Any
    xy: Any
    xz: Any
    yz: Any

    def times(self, u: Vector) -> Vector:
        """The tensor times ``u``."""
        return (
            self.xx * u[0] + self.xy * u[1] + self.xz * u[2],
            self.xy * u[0] + self.yy * u[1] + self.yz * u[2],
            self.xz * u[0] + self.yz * u[1] + self.zz * u[2],
        )

    def entries(self) -> tuple[Any, ...]:
        """``xx yy zz xy xz yz``."""
        return (self.xx, self.yy, self.zz, self.xy, self.xz, self.yz)

    def plus(self, other: Symmetric) -> Symmetric:
        """The sum of both."""
        return Symmetric(*(u + v for u, v in zip(self.entries(), other.entries(), strict=True)))

    def about_x(self, c: Any, s: Any) -> Symmetric:
        """The same turned about x by the angle of cosine ``c`` and sine ``s``."""
        turned = c * c * (self.yy - self.zz) - 2 * (c * s) * self.yz
        return Symmetric(
            self.xx,
            self.zz + turned,
            self.yy - turned,
            c * self.xy - s * self.xz,
            s * self.xy + c * self.xz,
            c * s * (self.yy - self.zz) + (2 * (c * c) - 1) * self.yz,
        )

    def about_z(self, c: Any, s: Any) -> Symmetric:
        """The same turned about z by the angle of cosine ``c`` and sine ``s``."""
        # The part of xx that comes and goes with the angle.
        turned = c * c * (self.xx - self.yy) - 2 * (c * s) * self.xy
        return Symmetric(
            self.yy + turned,
            self.xx - turned,
            self.zz,
            c * s * (self.xx - self.yy) + (2 * (c * c) - 1) * self.xy,
            c * self.xz - s * self.yz,
            s * self.xz + c * self.yz,
        )

    def named(self, mark: Mark, link: int, quantity: str) -> Symmetric:
        """The same with each entry marked as ``quantity`` of ``link``."""
        entries = zip(self.entries(), ("xx", "yy", "zz", "xy", "xz", "yz"), strict=True)
        return Symmetric(*(mark(value, Label(link, quantity, axes)) for value, axes in entries))


@dataclass(frozen=True, slots=True)
class Body:
    """A link and its joint: DH numbers (cosine and sine of alpha), inertial numbers, what sits in the joint.

    ``b`` [m] is the offset along y behind the twist, which Denavit-Hartenberg rows do not have. ``ratio`` and
    ``torque_constant`` [N m/A] are the gear's and the motor's, ``limits`` the lowest and highest position of
    the joint [rad or m]; None where they are not stated.
    ``com`` [m] and ``inertia`` [kg m^2] (about the centre of mass) are along the link's own axes.
    """

    revolute: bool
    cos_alpha: Any
    sin_alpha: Any
    a: Any
    d: Any
    theta: Angle
    mass: Any
    com: Vector
    inertia: Symmetric
    motor_inertia: Any
    viscous: Any
    coulomb: Any
    b: Any = 0
    ratio: Any = None
    torque_constant: Any = None
    limits: tuple[Any, Any] | None = None


@dataclass(frozen=True, slots=True)
class Arm:
    """Bodies from base to tip and gravity [m/s^2] in the base frame; the base frame in the world, and the
    tool in the last link's frame. ``motors``: whether torques are the motors', with rotors and friction in
    them. ``stated_frames``: where the description has the links' frames elsewhere, as standard DH has: ``a``
    along x [m], and turned about x by an angle of this cosine and sine; one a body, or none."""

    bodies: tuple[Body, ...]
    gravity: Vector
    rest_velocity: Any | None
    dead_band: Any | None = None
    base: Frame = BASE
    tool: Frame = BASE
    motors: bool = True
    stated_frames: tuple[Vector, ...] = ()


@dataclass(frozen=True, slots=True)
class JointAngle:
    """An angle that cosine and sine are taken of: a sum of joint variables, ``(joint, +1 or -1)`` with
    joints from 0, and a constant."""

    terms: tuple[tuple[int, int], ...]
    offset: Angle

    def label(self, quantity: str) -> Label:
        """The label of a quantity of the angle: ``c3``, ``c23`` of joints 2 and 3, ``c2to5``."""
        first, last = self.terms[0][0] + 1, self.terms[-1][0] + 1
        if len(self.terms) == 1:
            return Label(last, quantity, "")
        joined = str(first) if last == first + 1 and last < 10 else f"{first}to"
        return Label(last, quantity + joined, "")


#: Cosine and sine of an angle, over the scalars in use.
Trigonometry = Callable[[JointAngle], tuple[Any, Any]]


def trigonometry_at(q: Sequence[Any]) -> Trigonometry:
    """Cosines and sines at the joint variables ``q`` [n], floats or arrays of many states."""

    def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
        total = sum(sign * q[joint] for joint, sign in angle.terms)
        c, s = cosine(total), sine(total)
        c0, s0 = float(angle.offset.cos), float(angle.offset.sin)
        return c0 * c - s0 * s, c0 * s + s0 * c

    return trigonometry


@dataclass(frozen=True, slots=True)
class Motion:
    """A state of the arm, joint by joint: ``c, s`` [n] of the rotation about z (offsets included),
    ``d`` [n] the displacement along z (a prismatic joint's variable included), rates ``qd`` [n] and
    ``qdd`` [n]."""

    c: tuple[Any, ...]
    s: tuple[Any, ...]
    d: tuple[Any, ...]
    qd: tuple[Any, ...]
    qdd: tuple[Any, ...]


def scalar_of(value: Value, constant: Callable[[Fraction], Any], parameter: Callable[[str], Any]) -> Any:
    """A number of a description with ``constant`` applied to constants and ``parameter`` to names."""
    if not isinstance(value, Affine):
        return constant(value)
    total = constant(value.constant) if value.constant else 0
    for name, factor in value.terms:
        total = total + (parameter(name) if factor == 1 else constant(factor) * parameter(name))
    return total


def build_arm(robot: Robot, constant: Callable[[Fraction], Any], parameter: Callable[[str], Any]) -> Arm:
    """``robot`` with ``constant`` applied to its constants and ``parameter`` to its run-time names.

    With ``torque_side: link`` rotor and friction are not in the torque and are left out. A payload is part of
    the last body. Where joints follow others, who knows of that asks for the arm of :attr:`Robot.free`.

    Raises
    ------
    InputError: joints follow others.
    """
    no_couplings(robot, "this")

    def scalar(value: Value) -> Any:
        return scalar_of(value, constant, parameter)

    def vector(values: Sequence[Value]) -> Vector:
        x, y, z = map(scalar, values)
        return x, y, z

    def tensor(i: Inertia) -> Symmetric:
        return Symmetric(*map(scalar, (i.xx, i.yy, i.zz, i.xy, i.xz, i.yz)))

    def frame(place: Placement | None) -> Frame:
        if place is None:
            return BASE
        x, y, z = map(vector, zip(*place.rotation, strict=True))
        return Frame(vector(place.xyz), x, y, z)

    def optional(value: Fraction | None) -> Any:
        return None if value is None else constant(value)

    motor = robot.torque_side == "motor"
    bodies = []
    for link in robot.links:
        joint, gear, span = link.joint, link.joint.gear if motor else None, link.joint.limits.position
        drive = (joint.motor_inertia, joint.viscous, joint.coulomb)
        rotor, viscous, coulomb = (scalar(x if motor else Fraction(0)) for x in drive)
        bodies.append(
            Body(
                revolute=joint.kind == "revolute",
                cos_alpha=constant(joint.alpha.cos),
                sin_alpha=constant(joint.alpha.sin),
                a=scalar(joint.a),
                d=scalar(joint.d),
                theta=joint.theta,
                mass=scalar(link.mass),
                com=vector(link.com),
                inertia=tensor(link.inertia),
                motor_inertia=rotor,
                viscous=viscous,
                coulomb=coulomb,
                b=scalar(joint.b) if joint.b else 0,
                ratio=optional(gear.ratio if gear else None),
                torque_constant=optional(gear.torque_constant if gear else None),
                limits=span and (constant(span[0]), constant(span[1])),
            )
        )
    loads = [
        (scalar(x["mass"]), vector(x["com"]), tensor(x["inertia"] if "inertia" in x else Inertia()))
        for x in robot.effects
        if x.definition.traits.body
    ]
    if loads:
        bodies[-1] = _loaded(bodies[-1], loads)
    stated: list[Vector] = []
    if robot.standard_end is not None:  # each row moves up by one, see robodyn.robot.frames
        end, roll = robot.standard_end.xyz[0], robot.standard_end.rpy[0]
        stated = [(body.a, body.cos_alpha, body.sin_alpha) for body in bodies[1:]]
        stated.append((constant(end), constant(roll.cos), constant(roll.sin)))
    return Arm(
        tuple(bodies),
        vector(robot.base_gravity),
        optional(robot.rest_velocity),
        optional(robot.dead_band),
        frame(robot.base),
        frame(robot.tool),
        motor,
        tuple(stated),
    )


def inertial(arm: Arm) -> Arm:
    """``arm`` without gravity and friction."""
    bodies = tuple(replace(body, viscous=0, coulomb=0) for body in arm.bodies)
    return replace(arm, bodies=bodies, gravity=ZERO)


def in_stated_frame(arm: Arm, link: int, x: Vector, y: Vector, z: Vector) -> tuple[Vector, Vector, Vector]:
    """The axes of the frame that the description has for ``link`` (from 0), from those of its frame here."""
    if not arm.stated_frames:
        return x, y, z
    _, c, s = arm.stated_frames[link]
    return x, _sum_of(c, y, s, z), _sum_of(-s, y, c, z)


def _sum_of(p: Any, u: Vector, q: Any, v: Vector) -> Vector:
    return (p * u[0] + q * v[0], p * u[1] + q * v[1], p * u[2] + q * v[2])


def _loaded(body: Body, loads: Sequence[tuple[Any, Vector, Symmetric]]) -> Body:
    """``body`` with others fixed to it: masses, centres of mass and inertias about them, in its frame."""
    parts = [(body.mass, body.com, body.inertia), *loads]
    heavy = [(m, c) for m, c, _ in parts if not is_zero(m)]
    mass = sum(m for m, _ in heavy)
    if len(heavy) < 2:  # nothing to divide by, not even a run-time mass that may be 0
        x, y, z = heavy[0][1] if heavy else body.com
    else:
        # Integers divide to floats, and floats are not exact.
        share = 1 / (Fraction(mass) if isinstance(mass, int) else mass)
        x, y, z = (sum(m * c[k] for m, c in heavy) * share for k in range(3))
    entries = [0, 0, 0, 0, 0, 0]
    for m, c, inertia in parts:
        r = (c[0] - x, c[1] - y, c[2] - z)
        shift = (
            r[1] * r[1] + r[2] * r[2], r[0] * r[0] + r[2] * r[2], r[0] * r[0] + r[1] * r[1],
            -(r[0] * r[1]), -(r[0] * r[2]), -(r[1] * r[2]),
        )  # fmt: skip
        entries = [e + own + m * s for e, own, s in zip(entries, inertia.entries(), shift, strict=True)]
    return replace(body, mass=mass, com=(x, y, z), inertia=Symmetric(*entries))


def build_motion(
    arm: Arm,
    q: Sequence[Any],
    qd: Sequence[Any],
    qdd: Sequence[Any],
    trigonometry: Trigonometry,
    constant: Callable[[Fraction], Any],
) -> Motion:
    """The motion at ``q, qd, qdd``; constants pass through ``constant``."""
    c, s, d = [], [], []
    for i, (body, x) in enumerate(zip(arm.bodies, q, strict=True)):
        if body.revolute:
            cosine, sine = trigonometry(JointAngle(((i, 1),), body.theta))
            d.append(body.d)
        else:
            cosine, sine = constant(body.theta.cos), constant(body.theta.sin)
            d.append(body.d + x)
        c.append(cosine)
        s.append(sine)
    return Motion(tuple(c), tuple(s), tuple(d), tuple(qd), tuple(qdd))


def into_child(body: Body, c: Any, s: Any, u: Vector) -> Vector:
    """``R^T u``: a vector of the parent's frame along the axes of the link's frame."""
    return about_z(c, -s, about_x(body.cos_alpha, -body.sin_alpha, u))


def into_parent(body: Body, c: Any, s: Any, u: Vector) -> Vector:
    """``R u``: a vector of the link's frame along the axes of the parent's frame."""
    return about_x(body.cos_alpha, body.sin_alpha, about_z(c, s, u))


def about_x(c: Any, s: Any, u: Vector) -> Vector:
    """``u`` turned about x by the angle of cosine ``c`` and sine ``s``."""
    return (u[0], c * u[1] - s * u[2], s * u[1] + c * u[2])


def about_z(c: Any, s: Any, u: Vector) -> Vector:
    """``u`` turned about z by the angle of cosine ``c`` and sine ``s``."""
    return (c * u[0] - s * u[1], s * u[0] + c * u[1], u[2])


def origin(body: Body, d: Any) -> Vector:
    """``p``: the origin of the link's frame in the parent's frame [m]."""
    if is_zero(body.b):
        return (body.a, -(body.sin_alpha * d), body.cos_alpha * d)
    return (body.a, *behind_twist(body, body.b, d))


def behind_twist(body: Body, b: Any, d: Any) -> tuple[Any, Any]:
    """What lies ``b`` along y and ``d`` along z behind the twist, along y and z of the parent's frame."""
    c, s = body.cos_alpha, body.sin_alpha
    return c * b - s * d, s * b + c * d
