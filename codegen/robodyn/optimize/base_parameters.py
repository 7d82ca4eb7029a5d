"""Modified Newton-Euler on base parameters: lambda with first and second moments.

With ``F = m a + lambda h`` and the moment about the frame's origin straight from moments of mass, the
masses may be zero or negative and the arm's parameters regrouped (:mod:`robodyn.optimize.gauge`). How each
link is written is said by a :class:`~robodyn.optimize.variant.Variant`; quantities are worked out on demand.

A link has two sets of axes: its own, and those in which its joint, or the chain of parallel joints that it
follows, begins to turn (``start``): these differ by the turn about z, whose cosine and sine are ``c, s``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from robodyn.dynamics.arm import Arm, Body, Motion, behind_twist
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.lump import Lump
from robodyn.dynamics.parallel import Turns
from robodyn.dynamics.regroup import about_axis_z
from robodyn.dynamics.vectors import Mark, unmarked
from robodyn.effects.scalars import is_zero
from robodyn.optimize.gauge import Regrouped, Unsuited
from robodyn.optimize.lazy import NOTHING, Components, Lazy, added, lever, named, turned_x, turned_z
from robodyn.optimize.moments import (
    Rates,
    Wrench,
    angular_acceleration,
    lumped,
    rates_along,
    row_times,
    spin,
    spin_about,
    with_point,
    wrist,
)
from robodyn.optimize.variant import LinkVariant, Variant


@dataclass(frozen=True, slots=True)
class Moving:
    """A link of the forward pass: its motion along its own axes and along those in which it begins to turn;
    ``w0, alpha0`` of what carries it and the third column of its lambda, ``above``, along the latter;
    ``p``, its origin in the parent's frame."""

    own: Rates
    start: Rates
    w0: Components
    alpha0: Components
    above: Components
    p: Components


@dataclass(slots=True)
class BaseNewtonEuler:
    """Forward and backward pass from moments of mass about the frames' origins, each quantity on demand.

    Lengths of ``links`` are multiples of a unit, ``per_unit`` [1/m] is its inverse; the displacements ``d``
    of ``arm`` and ``motion`` [m] are those of the origins that ``links`` have.
    """

    arm: Arm
    motion: Motion
    turns: Turns
    links: Sequence[Regrouped]
    variant: Variant
    per_unit: Any = 1
    mark: Mark = unmarked
    moving: list[Moving] = field(default_factory=list)

    @property
    def mark_lengths(self) -> Mark:
        """Accelerations and forces in another unit of length are not what their names say."""
        return self.mark if self.variant.unit == "metre" else unmarked

    # -- forward ----------------------------------------------------------------------------------
    def _moving(self, i: int) -> Moving:
        body, turns, how = self.arm.bodies[i], self.turns, self.variant.links[i]
        c, s, rate, acceleration = turns.c[i], turns.s[i], turns.rate[i], turns.acceleration[i]
        p = self._origin(i)
        before = self.moving[i - 1] if i else None
        carrier: tuple[Components, Components, Components]
        if before is None:
            u, (gx, gy, gz) = self.per_unit, self.arm.gravity
            carrier = NOTHING, NOTHING, (-gx * u, -gy * u, -gz * u)
        elif turns.follows[i]:
            carrier = before.w0, before.alpha0, self._next_origin(i, before, p)
        else:
            carrier = before.own.w, before.own.alpha, self._next_origin(i, before, p)
        w0, alpha0, a0 = (turned_x(body.cos_alpha, -body.sin_alpha, u) for u in carrier)
        turned_w, carried = turned_z(c, -s, w0), turned_z(c, -s, alpha0)
        if not body.revolute:
            rate = acceleration = 0

        def velocity(k: int) -> Any:
            return turned_w[2] + rate if k == 2 else turned_w[k]

        own_w = named(Lazy(velocity), self.mark, i + 1, "w")
        start_w = Lazy(lambda k: own_w[2] if k == 2 else w0[k])
        own_alpha = Lazy(angular_acceleration(carried, own_w, rate, acceleration))
        from_start = angular_acceleration(alpha0, w0, rate, acceleration)
        start_alpha = Lazy(lambda k: own_alpha[2] if k == 2 else from_start(k))
        own_a = named(self._sliding(i, turned_z(c, -s, a0), own_w), self.mark_lengths, i + 1, "a")
        start_a = self._sliding(i, a0, start_w)
        above = self._above(i, before)
        beside = turned_z(c, -s, above)
        own = rates_along(i, how, own_w, own_alpha, own_a, w0, carried, beside, rate, self.mark)
        start = rates_along(i, how, start_w, start_alpha, start_a, w0, alpha0, above, rate, unmarked)
        return Moving(own, start, w0, alpha0, above, p)

    def _origin(self, i: int) -> Components:
        """``p`` of link ``i``."""
        body, link = self.arm.bodies[i], self.links[i]
        d = link.d if body.revolute else self.per_unit * self.motion.d[i]
        if is_zero(link.side):
            return (link.x, -(body.sin_alpha * d), body.cos_alpha * d + link.lift)
        y, z = behind_twist(body, link.side, d)
        return (link.x, y, z + link.lift)

    def _next_origin(self, i: int, before: Moving, p: Components) -> Components:
        """The acceleration of link i's origin: along the axes in which the parent begins to turn where the
        link follows it in a chain, else along the parent's own."""
        c, s = self.turns.c[i - 1], self.turns.s[i - 1]
        if self.variant.links[i].carry == "own":
            step = Lazy(lambda k: row_times(before.own.lam, k, p))
            if self.turns.follows[i]:
                return added(before.start.a, turned_z(c, s, step))
            return added(before.own.a, step)
        turned = turned_z(c, s, p)
        there = added(before.start.a, Lazy(lambda k: row_times(before.start.lam, k, turned)))
        return there if self.turns.follows[i] else turned_z(c, -s, there)

    def _sliding(self, i: int, turned: Components, w: Components) -> Components:
        """The acceleration of the origin: where the joint slides, Coriolis's and its own besides."""
        if self.arm.bodies[i].revolute:
            return turned
        rate, acceleration = self.turns.rate[i], self.turns.acceleration[i]

        def sliding(k: int) -> Any:
            if k == 2:
                return turned[2] + self.per_unit * acceleration
            twice = 2 * self.per_unit * rate
            return turned[0] + twice * w[1] if k == 0 else turned[1] - twice * w[0]

        return Lazy(sliding)

    def _above(self, i: int, before: Moving | None) -> Components:
        """The third column of the carrier's lambda, its last entry left out, along the axes in which link
        ``i`` begins to turn. The turn about z does not change it but turns it along."""
        if before is None:
            return NOTHING
        body = self.arm.bodies[i]
        ca, sa = body.cos_alpha, body.sin_alpha
        if self.turns.follows[i]:
            above = before.above
            return Lazy(lambda k: ca * above[0] if k == 0 else above[1])
        column = Lazy(lambda j: row_times(before.own.lam, j, (0, -sa, ca)))
        return turned_x(ca, -sa, column)

    # -- links ------------------------------------------------------------------------------------
    def _wrenches(self) -> tuple[list[Wrench | None], list[Wrench | None], dict[int, Components]]:
        """For each link its force and moment along its own axes, and what is evaluated along those in which
        it begins to turn; and moments whose index 3 is a joint's torque."""
        own: list[Wrench | None] = [None] * len(self.links)
        start: list[Wrench | None] = [None] * len(self.links)
        torques: dict[int, Components] = {}
        for i, (link, how) in enumerate(zip(self.links, self.variant.links, strict=True)):
            if how.form == "wrist":
                wrench = self._wrist(i)
                torques[i + 1] = wrench[1]
                start[i] = wrench
                break
            if how.frame == "before":
                wrench = self._spin_before(i)
                torques[i] = wrench[1]
                there = start[i - 1]
                start[i - 1] = wrench if there is None else _both(there, wrench)
            elif how.frame == "start" and self.arm.bodies[i].revolute:
                c, s = self.turns.c[i], self.turns.s[i]
                start[i] = self._wrench(link, how, self.moving[i].start, c, s)
            elif _any(link.lump):
                force, moment = self._wrench(link, how, self.moving[i].own, 1, 0)
                own[i] = (named(force, self.mark_lengths, i + 1, "fc"), named(moment, self.mark, i + 1, "nc"))
        return own, start, torques

    def _wrench(self, link: Regrouped, how: LinkVariant, at: Rates, c: Any, s: Any) -> Wrench:
        """Force and moment of a link along axes from which its own are turned about z by ``c, s``."""
        if how.form == "spin":
            return spin(2 * link.lump.second.xx, at)
        turned = not (c == 1 and s == 0)
        if link.point is not None:
            axis = "xyz".index(how.form[-1])
            r: Components = tuple(link.point.distance if j == axis else 0 for j in range(3))
            return with_point(link.point, turned_z(c, s, r) if turned else r, at)
        lump = about_axis_z(link.lump, c, s) if turned else link.lump
        return lumped(lump, at, how.form)

    def _spin_before(self, i: int) -> Wrench:
        """A last link that is a spin, along the axes in which the joint before begins to turn."""
        body, carrier = self.arm.bodies[i], self.arm.bodies[i - 1]
        legal = i and i == len(self.links) - 1 and body.revolute and carrier.revolute
        legal = legal and not self.turns.follows[i]
        if not legal or self.variant.links[i].form != "spin":
            raise Unsuited(i + 1, "no spin at the tip to be written along the axes of the joint before")
        at = self.moving[i - 1].start
        axis = turned_z(self.turns.c[i - 1], self.turns.s[i - 1], (0, -body.sin_alpha, body.cos_alpha))
        inertia = 2 * self.links[i].lump.second.xx
        return spin_about(inertia, axis, at.w, at.alpha, self.turns.rate[i], self.turns.acceleration[i])

    def _wrist(self, i: int) -> Wrench:
        """The last two links, along the axes in which the last joint but one begins to turn."""
        how, link = self.variant.links[i], self.links[i]
        legal = i == len(self.links) - 2 and how.frame == "start" and self.variant.links[i + 1].form == "spin"
        body = self.arm.bodies[i + 1]
        legal = legal and body.revolute and self.arm.bodies[i].revolute and not self.turns.follows[i + 1]
        if not legal or link.point is None or body.sin_alpha not in (1, -1):
            raise Unsuited(i + 1, "no wrist")
        turned = turned_z(self.turns.c[i], self.turns.s[i], (0, 1, 0))
        inertia = 2 * self.links[i + 1].lump.second.xx
        rate, acceleration = self.turns.rate[i + 1], self.turns.acceleration[i + 1]
        at = self.moving[i].start
        return wrist(link.point, inertia, -body.sin_alpha, turned, at, rate, acceleration)

    # -- backward ---------------------------------------------------------------------------------
    def torques(self) -> list[Any]:
        """Joint torques [n] (N m; N at prismatic joints): motion from base to tip, forces and moments back.

        ``f0, n0`` act through the joint, along the axes in which its chain begins to turn.
        """
        n = len(self.arm.bodies)
        for i in range(n):
            self.moving.append(self._moving(i))
        own, start, known = self._wrenches()
        torques: list[Any] = [None] * n
        f0: Components | None = None
        n0: Components | None = None
        for i in reversed(range(n)):
            c, s = self.turns.c[i], self.turns.s[i]
            mine, turned = own[i], start[i]
            inside: list[Wrench] = [mine] if mine is not None else []
            outside: list[Wrench] = [turned] if turned is not None else []
            if f0 is not None and n0 is not None:
                child: Body = self.arm.bodies[i + 1]
                f, moment = (turned_x(child.cos_alpha, child.sin_alpha, u) for u in (f0, n0))
                p = self.moving[i + 1].p
                if self.turns.follows[i + 1]:
                    outside += [(f, lever(turned_z(c, s, p), f)), (NOTHING, moment)]
                elif self.variant.links[i + 1].lever == "start":
                    through = turned_z(c, s, f)
                    outside += [(through, added(lever(turned_z(c, s, p), through), turned_z(c, s, moment)))]
                else:
                    inside += [(f, added(lever(p, f), moment))]
            f0 = n0 = None
            if inside:
                f, moment = (added(*(wrench[k] for wrench in inside)) for k in (0, 1))
                if not outside:  # else it is not all that acts on the link
                    f = named(f, self.mark_lengths, i + 1, "f")
                    moment = named(moment, self.mark, i + 1, "n")
                outside.insert(0, (turned_z(c, s, f), turned_z(c, s, moment)))
            if outside:
                f, moment = (added(*(wrench[k] for wrench in outside)) for k in (0, 1))
                f0 = named(f, self.mark_lengths, i + 1, "f0")
                n0 = named(moment, self.mark, i + 1, "n0")
            if i in known:
                torque = known[i][3]
            elif f0 is None or n0 is None:
                torque = 0
            else:
                torque = n0[2] if self.arm.bodies[i].revolute else f0[2] * self.per_unit
            torques[i] = joint_torque(self.arm, i, self.motion, torque, self.mark)
        return torques


def _any(lump: Lump) -> bool:
    return bool(lump.mass) or any(map(bool, lump.first)) or any(map(bool, lump.second.entries()))


def _both(one: Wrench, other: Wrench) -> Wrench:
    return added(one[0], other[0]), added(one[1], other[1])
