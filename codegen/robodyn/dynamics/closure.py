"""A program of inverse kinematics against plain forward kinematics, at 60 digits.

Its roots and angles have no place in a finite field, where other programs are compared. So joint positions
are drawn from a hash of robot and program, the tool is brought there by multiplying up the frames of the
description, and the program is asked where the joints are: every branch that exists must bring the tool back
to where it is, one of them being the positions that were drawn. Beyond the arm's reach no branch may exist,
and at no pose may a result be no number.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from robodyn.dynamics.arm import Arm, JointAngle, build_arm, build_motion
from robodyn.dynamics.functions import function_named
from robodyn.dynamics.functions.record import Answers
from robodyn.dynamics.inverse.limits import EDGE
from robodyn.dynamics.kinematics import frames
from robodyn.dynamics.limits import (
    DRAWN_POSES,
    EDGE_SHARE,
    NEGLECTED_SHARE,
    PROVEN_DIGITS,
    PROVEN_SHARE,
    ROUNDING,
    SAME_POSITION,
)
from robodyn.ir.digits import evaluate_to_digits, to_digits
from robodyn.ir.fingerprint import digest
from robodyn.ir.program import Input, Program
from robodyn.ir.signature import ScalarType
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot

#: Positions are drawn from so many numbers.
_RANGE = 1 << 32
#: How far from them the reference of a program is that repeats a step [rad or m]: a few steps.
BESIDE = Fraction(1, 64)
#: What :func:`flaw` says of a program that is right wherever it says that it reaches a pose, and never does.
UNREACHED = "no pose is reached"


class Drawn(NamedTuple):
    """A pose [12] and the reference [n] (rad or m) that go with it, and ``words`` for them. ``q`` [n]: the
    positions that the pose is of; None: any pose, ``far`` beyond reach."""

    words: str
    T: Sequence[Any]
    near: Sequence[Any]
    q: Sequence[Any] | None = None
    far: bool = False


def flaw(
    robot: Robot,
    function: str,
    program: Program,
    scalar: ScalarType,
    *,
    place_only: bool,
    beside: Fraction = BESIDE,
) -> str | None:
    """What is wrong with ``program`` as ``function`` of ``robot``, in words; None where nothing is.

    ``place_only``: whether only the place of the tool counts. Poses may be missed by some squares of what
    ``scalar``, the type that the program is for, rounds, as a share of the arm's size; or by what is taken
    for rounding of the description where that is not of :func:`simple numbers <is_simple>`. A program that
    repeats a step stops near what ``scalar`` rounds; it begins ``beside`` the positions that were drawn
    [rad or m], and is not sure to reach each pose.
    """
    import mpmath

    chance = random.Random(f"{digest(program).hex()} {identity(robot)} {function}")
    with mpmath.workdps(PROVEN_DIGITS):
        arm = build_arm(robot, to_digits, lambda name: mpmath.mpf(1))
        size = mpmath.mpf(1) + sum(abs(x) for body in arm.bodies for x in (body.a, body.b, body.d))
        steps = program.iteration is not None
        share = EDGE * ROUNDING[scalar] if steps else PROVEN_SHARE * ROUNDING[scalar] ** 2
        if not steps and not is_simple(robot):
            share = max(share, NEGLECTED_SHARE)
        same = SAME_POSITION * mpmath.sqrt(to_digits(ROUNDING[scalar]))
        goal = _Goal(arm, size, to_digits(share), same, place_only, sure=not steps)
        reached = False
        for drawn in _draws(arm, size, chance, beside if steps else Fraction(0)):
            inputs = {Input("T", k): x for k, x in enumerate(drawn.T)}
            inputs |= {Input("q_near", k): x for k, x in enumerate(drawn.near)}
            try:
                results = evaluate_to_digits(program, inputs)
            except ZeroDivisionError:
                return f"at {drawn.words}: a divisor is 0"
            for part in function_named(function).fuses or (function_named(function),):
                assert part.answers is not None
                wrong = goal.flaw(part.answers, results, drawn)
                if wrong is not None:
                    return f"at {drawn.words}: {wrong}"
                reached |= 1 in results[part.answers.exists]
    return None if reached else UNREACHED


def is_simple(robot: Robot) -> bool:
    """Whether no two axes are almost parallel, or almost meet: between them are quarter turns and whole
    nanometres."""
    joints, place = [link.joint for link in robot.links], robot.tool
    lengths = [x for joint in joints for x in (joint.a, joint.b, joint.d)]
    lengths += [] if place is None else list(place.xyz)
    turns = [] if place is None else [x for row in place.rotation for x in row]
    return (
        all(angle.quarter is not None for joint in joints for angle in (joint.alpha, joint.theta))
        and all(x in (-1, 0, 1) for x in turns)
        and all(isinstance(x, Fraction) and (x * 10**9).denominator == 1 for x in lengths)
    )


def _draws(arm: Arm, size: Any, chance: random.Random, beside: Fraction) -> Iterator[Drawn]:
    """Positions within the limits (of a revolute joint half a turn about their middle at most, which is as
    far as its answers go), the reference so much ``beside`` them [rad or m]; poses that the arm may reach or
    not, nearer and nearer to its base; and where all joints are revolute one beyond reach."""
    import mpmath

    def between(low: Any, high: Any) -> Any:
        return low + (high - low) * chance.randint(0, _RANGE) / _RANGE

    def position(limits: tuple[Any, Any] | None, revolute: bool) -> Any:
        reach = mpmath.pi if revolute else mpmath.mpf(1) / 2
        low, high = limits or (-reach, reach)
        if limits and revolute:
            middle = (low + high) / 2
            low, high = max(low, middle - reach), min(high, middle + reach)
        return between(low, high)

    def positions() -> list[Any]:
        return [position(body.limits, body.revolute) for body in arm.bodies]

    for _ in range(DRAWN_POSES):
        q = positions()
        yield Drawn(f"q = {_words(q)}", pose(arm, q), [x + to_digits(beside) for x in q], q)
    scales = [(size / 4**k, False) for k in range(DRAWN_POSES)]
    far = [(3 * size, True)] if all(body.revolute for body in arm.bodies) else []
    for scale, beyond in scales + far:
        q = positions()
        T = pose(arm, q)
        for k, base in zip((3, 7, 11), arm.base.origin, strict=True):
            T[k] = base + scale * between(1, 2) * chance.choice((-1, 1))
        yield Drawn(f"p = {_words(T[3::4])}", T, q, far=beyond)


def pose(arm: Arm, q: Sequence[Any]) -> list[Any]:
    """The tool's frame [12] in the world, ``[R p]`` row by row, of joint positions [n], by the frames of the
    description one after another."""
    import mpmath

    def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
        ((joint, sign),) = angle.terms
        x, offset = sign * q[joint], angle.offset
        if offset.quarter is None:
            return mpmath.cos(x + offset.radians), mpmath.sin(x + offset.radians)
        c, s = mpmath.cos(x), mpmath.sin(x)
        ct, st = int(offset.cos), int(offset.sin)
        return ct * c - st * s, ct * s + st * c

    rest = [0] * len(q)
    motion = build_motion(arm, q, rest, rest, trigonometry, to_digits)
    tool = arm.tool.within(frames(arm, motion, arm.base)[-1])
    rows = zip(tool.rotation(), tool.origin, strict=True)
    return [x for row, place in rows for x in (*row, place)]


@dataclass(frozen=True, slots=True)
class _Goal:
    """An arm of this ``size`` [m], by what ``share`` of that poses may be missed, within what distance
    positions are the ``same`` [rad or m], and whether the place alone counts; ``sure``: whether all are
    reached that can be, in every branch."""

    arm: Arm
    size: Any
    share: Any
    same: Any
    place_only: bool
    sure: bool

    def flaw(self, names: Answers, results: Mapping[str, Sequence[Any]], drawn: Drawn) -> str | None:
        """What is wrong with results at one pose."""
        import mpmath

        n = len(self.arm.bodies)
        flat = results[names.solutions]
        if not all(mpmath.isfinite(x) for row in results.values() for x in row):
            return "a result is no number"
        solutions = [flat[k : k + n] for k in range(0, len(flat), n)]
        flags = list(zip(results[names.exists], results[names.within], results[names.singular], strict=True))
        if any(x not in (0, 1) for row in flags for x in row):
            return "a flag is neither 0 nor 1"
        existing = [k for k, (exists, _, _) in enumerate(flags) if exists]
        if drawn.far:
            return f"branch {existing[0]} is said to reach it" if existing else None
        counted = (3, 7, 11) if self.place_only else range(12)
        for k in existing:
            reached = pose(self.arm, solutions[k])
            missed = max(abs(reached[j] - drawn.T[j]) for j in counted)
            if missed > self.size * (to_digits(EDGE_SHARE) if flags[k][2] == 1 else self.share):
                return f"branch {k} misses the pose by {mpmath.nstr(missed, 3)}"
        if drawn.q is None or not self.sure:
            return None
        within = [solutions[k] for k in existing if flags[k][1]]
        if any(self._apart(q, drawn.q) < self.same for q in within):
            return None
        return "no branch within the limits is the positions that were drawn"

    def _apart(self, one: Sequence[Any], other: Sequence[Any]) -> Any:
        """How far positions are apart [rad, m], whole turns aside."""
        import mpmath

        gaps = zip(self.arm.bodies, one, other, strict=True)
        return max(2 * abs(mpmath.sin((x - y) / 2)) if b.revolute else abs(x - y) for b, x, y in gaps)


def _words(numbers: Sequence[Any]) -> str:
    import mpmath

    return "[" + ", ".join(mpmath.nstr(x, 6) for x in numbers) + "]"
