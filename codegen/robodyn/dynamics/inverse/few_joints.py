"""One or two joints and a point that they move: where they bring it nearest to a place, and whether there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from robodyn.dynamics.inverse.branch import Branch, Setting
from robodyn.dynamics.inverse.screws import Axis, minus
from robodyn.dynamics.inverse.subproblems import both
from robodyn.dynamics.vectors import Vector, dot, plus, scaled
from robodyn.effects.scalars import choose


def placed(axes: Sequence[Axis], tip: Vector, place: Vector, at: Setting) -> Iterator[Branch]:
    """Branches in which ``axes``, one or two, bring ``tip`` to ``place`` [m]. They reach a line or a surface:
    a branch exists where ``place`` is on it, to within the edge of reach."""
    slack = (at.scale(1).edge * at.size) ** 2
    for branch in _nearest(axes, tip, place, at):
        moved = tip
        for axis in reversed(axes):
            position = branch.positions[axis.joint]
            if axis.revolute:
                moved = plus(axis.point, branch.outward(axis, minus(moved, axis.point)))
            else:
                moved = plus(moved, scaled(position, axis.direction))
        missing = minus(place, moved)
        there = choose(slack - dot(missing, missing), 1, 0)
        yield replace(branch, exists=both(branch.exists, there))


def _nearest(axes: Sequence[Axis], tip: Vector, place: Vector, at: Setting) -> Iterator[Branch]:
    one = axes[0]
    if len(axes) == 1:
        yield _one(one, tip, place, Branch(), at)
        return
    two = axes[1]
    if one.revolute:
        yield from _turned(one, two, tip, place, at)
    elif two.revolute:  # from the tip to the base it is a turn, and then a slide
        yield from _turned(two.reversed(), one.reversed(), place, tip, at)
    else:
        w, cosine = minus(place, tip), dot(one.direction, two.direction)
        x, y = dot(w, one.direction), dot(w, two.direction)
        share = 1 / (1 - cosine * cosine)
        first = Branch().known(one.joint, share * (x - cosine * y))
        yield first.known(two.joint, share * (y - cosine * x))


def _one(axis: Axis, tip: Vector, place: Vector, branch: Branch, at: Setting) -> Branch:
    """``branch`` with the position of ``axis`` that brings ``tip`` nearest to ``place``."""
    if not axis.revolute:
        return branch.known(axis.joint, dot(axis.direction, minus(place, tip)))
    return branch.one(axis.joint, at.onto(axis, minus(tip, axis.point), minus(place, axis.point), 2))


def _turned(one: Axis, two: Axis, tip: Vector, place: Vector, at: Setting) -> Iterator[Branch]:
    """A revolute axis, and another joint behind it that brings the tip as far from a point of that axis as
    the place is."""
    p = minus(place, one.point)
    if two.revolute:
        b, c = minus(two.point, one.point), minus(tip, two.point)
        for folded in Branch().each(two.joint, at.fold(two, b, c, dot(p, p))):
            v = plus(b, folded.outward(two, c))
            yield folded.one(one.joint, at.onto(one, v, p, 2))
        return
    b, h = minus(tip, one.point), two.direction
    for out in Branch().each(two.joint, at.slide(dot(b, h), dot(b, b) - dot(p, p))):
        v = plus(b, scaled(out.positions[two.joint], h))
        yield out.one(one.joint, at.onto(one, v, p, 2))
