"""References: energies and forces of an arm just as it is described, nothing chosen to save operations."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from robodyn.dynamics.arm import Arm, Body, Motion, inertial, into_child, origin
from robodyn.dynamics.joints import rotors_of
from robodyn.dynamics.limits import ROUNDING
from robodyn.dynamics.lump import NO_LUMP, MomentForm
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.parallel import Turns, single_turns
from robodyn.dynamics.regroup import lumps_of
from robodyn.dynamics.state import First, Moving, RigidDrives, Rotor
from robodyn.dynamics.vectors import ZERO, Vector, cross, dot, minus, plus, scaled, unmarked
from robodyn.effects.scalars import quotient

if TYPE_CHECKING:
    from robodyn.robot.coupling import Transmission


def energies(arm: Arm, motion: Motion) -> tuple[Any, Any]:
    """Kinetic (rotors included) and potential energy [J] of ``arm`` at the positions and rates of ``motion``,
    link by link; the potential of the base's origin is 0. Source: Craig, Introduction to Robotics, 6.69 to
    6.74."""
    kinetic: Any = 0
    potential: Any = 0
    w, v, g = ZERO, ZERO, arm.gravity
    height: Any = 0  # of the frame's origin: -g . position
    for i, body in enumerate(arm.bodies):
        c, s, qd = motion.c[i], motion.s[i], motion.qd[i]
        p = origin(body, motion.d[i])
        height = height - dot(g, p)
        v = into_child(body, c, s, plus(v, cross(w, p)))
        w, g = into_child(body, c, s, w), into_child(body, c, s, g)
        if body.revolute:
            w = plus(w, (0, 0, qd))
        else:
            v = plus(v, (0, 0, qd))
        v_com = plus(v, cross(w, body.com))
        spin = dot(w, body.inertia.times(w))
        twice = body.mass * dot(v_com, v_com) + spin + body.motor_inertia * (qd * qd)
        kinetic = kinetic + quotient(twice, 2)
        potential = potential + body.mass * (height - dot(g, body.com))
    return kinetic, potential


def reactions(arm: Arm, motion: Motion, w: Sequence[Any]) -> list[tuple[Vector, Vector]]:
    """Force [N] and moment [N m] of link i-1 on link i for each joint, base to tip, along the axes and about
    the origin of link i's frame, while ``w`` [6], force and moment along the world's axes, acts on the tool
    at its origin.

    By free bodies: all that lies beyond a joint is cut free there, and what the joint passes on is the rate
    of its momentum, and of its angular momentum, less the weight and what else acts on it. Velocities and
    rates are derivatives of poses, so that no recursion of velocities, accelerations or forces is in it:
    recursions are checked by it.
    """
    from robodyn.dynamics.dual import moving_along, slopes, values
    from robodyn.dynamics.transforms import Matrix, applied, axial, poses, product, transposed

    def vector(x: Sequence[Any]) -> Vector:
        return x[0], x[1], x[2]

    def turned(A: Matrix, u: tuple[Any, ...]) -> Vector:
        return vector(applied(A, u))

    def place(T: Matrix) -> Vector:
        """The origin of a frame, without derivatives."""
        return vector(values(values([row[3] for row in T[:3]])))

    in_time = moving_along(arm, motion, motion.qd, motion.qdd, [0] * len(motion.qd))
    moving = moving_along(arm, in_time, in_time.qd, in_time.qdd, [0] * len(motion.qd))
    *links, tool = poses(arm, moving)
    g = turned(arm.base.rotation(), arm.gravity)
    push, twist = (w[0], w[1], w[2]), (w[3], w[4], w[5])
    f = scaled(-1, push)  # about the world's origin from here on
    n = scaled(-1, plus(twist, cross(place(tool), push)))
    joints: list[tuple[Vector, Vector]] = []
    for body, T in zip(reversed(arm.bodies), reversed(links), strict=True):
        now = tuple(tuple(values(row)) for row in T[:3])  # with its derivative in time
        rate = tuple(tuple(slopes(row)) for row in T[:3])
        R, R_rate = (tuple(row[:3] for row in rows) for rows in (now, rate))
        com, velocity = (turned(rows, (*body.com, 1)) for rows in (now, rate))
        spin = vector(axial(product(R_rate, transposed(R))))
        momentum = scaled(body.mass, velocity)
        inner = body.inertia.times(turned(transposed(R), spin))
        angular = plus(turned(R, inner), cross(com, momentum))
        weight = scaled(body.mass, g)
        f = minus(plus(f, vector(slopes(momentum))), weight)
        n = minus(plus(n, vector(slopes(angular))), cross(vector(values(com)), weight))
        back = transposed(tuple(tuple(values(row)) for row in R))
        joints.append((turned(back, f), turned(back, minus(n, cross(place(T), f)))))
    return joints[::-1]


class PlainDynamics(RigidDrives, ABC):
    """The dynamics of ``arm`` at ``inputs``, see :class:`robodyn.dynamics.state.ReferenceDynamics`: turns and
    masses as described, forces of free bodies, torques by conventional Newton-Euler."""

    mark = staticmethod(unmarked)
    cheapest = First()
    rounding = ROUNDING["double"]
    arm: Arm
    inputs: Mapping[str, Sequence[Any]]
    rest: Sequence[Any]
    #: How joints follow others, if they do; ``number`` makes a rational of it a scalar.
    transmission: Transmission | None = None
    number: Callable[[Fraction], Any]

    @property
    def link_count(self) -> int:  # type: ignore[override]
        """How many links there are where joints follow others."""
        return len(self.transmission.rows) if self.transmission else 0

    def driven(self) -> Sequence[Body]:
        """The bodies whose joints follow no other."""
        bodies = self.arm.bodies
        return [bodies[k] for k in self.transmission.commanded] if self.transmission else bodies

    def joint_positions(self) -> Sequence[Any]:
        """The positions of all joints."""
        q = self.inputs["q"]
        return self.transmission.joints(q, self.number) if self.transmission else q

    def spread(self, rates: Sequence[Any]) -> Sequence[Any]:
        """The rates of all joints."""
        return self.transmission.spread(rates, self.number) if self.transmission else rates

    def folded(self, torques: Sequence[Any]) -> list[Any]:
        """Torques of all joints as those of the commanded."""
        return self.transmission.folded(torques, self.number) if self.transmission else list(torques)

    @abstractmethod
    def motion(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Motion:
        """The arm at ``q``, with these rates and accelerations."""

    def turns(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Turns:
        """How its joints turn, each for itself."""
        return single_turns(self.motion(qd, qdd))

    def links(self, qd: Sequence[Any], qdd: Sequence[Any], form: MomentForm = "second_moment") -> Moving:
        """The same, as described."""
        motion = self.motion(qd, qdd)
        return Moving(self.arm, motion, single_turns(motion), lumps_of(self.arm), NO_LUMP)

    def reactions(
        self, qd: Sequence[Any], qdd: Sequence[Any], w: Sequence[Any]
    ) -> Sequence[tuple[Vector, Vector]]:
        """Force and moment in each joint, of free bodies."""
        return reactions(self.arm, self.motion(qd, qdd), w)

    def rotors(self) -> list[Rotor]:
        """The rotors of the joints, by the rates of those that are commanded."""
        return self.rotors_in_coordinates(rotors_of(self.arm))

    def rotors_in_coordinates(self, rotors: Iterable[Rotor]) -> list[Rotor]:
        """``rotors`` of joints, by the rates of those that are commanded."""
        of = self.transmission
        if of is None:
            return list(rotors)
        return [
            Rotor(
                rotor.inertia,
                tuple((k, ratio * self.number(g)) for i, ratio in rotor.rates for k, g in of.rows[i].items()),
            )
            for rotor in rotors
        ]

    def torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Joint torques [n]."""
        return self.folded(newton_euler(self.arm, self.motion(qd, qdd)))

    def inertial_torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Joint torques [n] without gravity and friction."""
        return self.folded(newton_euler(inertial(self.arm), self.motion(qd, qdd)))

    def mass_matrix(self) -> list[list[Any]]:
        """Mass matrix [n][n]: torques of unit accelerations less those of none, of the arm at rest."""
        units = ([int(i == j) for i in range(len(self.rest))] for j in range(len(self.rest)))
        still = self.torques(self.rest, self.rest)
        columns = (
            [x - y for x, y in zip(self.torques(self.rest, unit), still, strict=True)] for unit in units
        )
        return [list(row) for row in zip(*columns, strict=True)]

    def torque_derivatives(self, qdd: Sequence[Any]) -> None:
        """None: the rigid arm's derivatives are written out."""
        return

    def torque_slopes(self, qdd: Sequence[Any], dq: Sequence[Any], dqd: Sequence[Any]) -> list[Any]:
        """The plain recursion of the rigid arm, differentiated along ``dq, dqd`` by dual numbers."""
        from robodyn.dynamics.dual import moving_along, slopes

        motion = self.motion(self.inputs["qd"], qdd)
        along = moving_along(self.arm, motion, *map(self.spread, (dq, dqd, [0] * len(dq))))
        return self.folded(slopes(newton_euler(self.arm, along)))
