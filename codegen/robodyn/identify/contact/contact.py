"""Contacts in a log, and the log without them.

A contact is a burst of the residual that a quick robust fit leaves (the arm's numbers and friction are
uncertain), as long as a force on one link explains it: De Luca and Mattone 2005 (residuals of
collisions), with the friction fitted beside it. The start of a motion, a joint that sticks at a
reversal, a drive at its limit, or a load that stays are none.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats, Mask
from robodyn.gate.gate import Gate
from robodyn.identify.contact.bursts import Burst, Seen, bursts, seen, widened
from robodyn.identify.contact.force import Push, Window, push_in
from robodyn.identify.contact.limits import (
    ABOVE_OTHERS,
    ALONE_SHARE,
    END_TIME,
    EXCESS_SHARE,
    EXPLAINED,
    HELD,
    LEAST_EVIDENCE,
    LEAST_OF_LARGEST,
    LEAST_PUSH,
    LONGEST_SHARE,
    MARGIN,
    MOST_LOAD,
    REST_EDGE,
    SHORT_REST,
    SHORT_TIME,
    SLACK,
    WHOLE,
)
from robodyn.identify.contact.rough import Rough, fitted_rest, rough_signals
from robodyn.kernels.array_dynamics import Model
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True, eq=False)
class Contact:
    """Somebody touched the arm from ``start`` to ``end`` [s] on ``link`` (from 1): ``force`` [3], the
    mean over the window, acts on the arm, along the base's axes (N), ``stderr`` [3] its standard
    errors; within ``cone`` [degrees] of its direction the true one is in 95 %; ``explained``: share of the
    window's squares that it explains; ``at_rest``: the arm stood."""

    start: float
    end: float
    link: int
    force: Floats
    stderr: Floats
    cone: float
    explained: float
    at_rest: bool


def contacts(robot: Robot, gate: Gate, left: Floats | None = None) -> tuple[Contact, ...]:
    """The contacts in a log of ``robot`` that has passed its ``gate``, in the order of time; ``left`` [K, n]:
    what the robot leaves of its torques (None: all but those of its equations, which have no sensors and no
    springs)."""
    model = Model(robot)
    rough = rough_signals(model, gate, left)
    if rough is None:
        return ()
    pushed: list[tuple[NDArray[np.intp], Push]] = []
    out = np.zeros(len(rough.t), dtype=bool)
    view: Seen | None = None
    for last in (False, False, True):
        left, sigma, stiction = fitted_rest(rough, out)
        view = seen(robot, rough, left, sigma, stiction)
        pushed = _pushed(model, rough, view, stiction, last=last)
        now = np.zeros_like(out)
        for rows, _ in pushed:
            now |= (rough.t >= rough.t[rows[0]] - MARGIN) & (rough.t <= rough.t[rows[-1]] + MARGIN)
        out = now
    return tuple(
        Contact(
            float(rough.t[rows[0]]), float(rough.t[rows[-1]]), push.link, push.force, push.stderr,
            push.cone, push.explained, bool(view is not None and view.quiet[rows].mean() > 0.5),
        )
        for rows, push in pushed
    )  # fmt: skip


def _pushed(
    model: Model, rough: Rough, view: Seen, stiction: Floats, *, last: bool
) -> list[tuple[NDArray[np.intp], Push]]:
    """The bursts that are contacts; all that may be, until the ``last`` round."""
    usual = rough.size + stiction
    accepted: list[tuple[float, Burst]] = []
    taken = np.zeros(len(rough.t), dtype=bool)
    for candidates in bursts(rough, view):
        best: tuple[float, Burst, Push] | None = None
        for burst in candidates:
            rows = burst.rows
            if taken[rows].any() or _starts(rough, view, rows) or _limited(rough, burst):
                continue
            push = _push(model, rough, view, burst, stiction)
            if burst.ended and (push.explained < WHOLE or view.quiet[rows].any()):
                continue
            if push.explained < EXPLAINED or not _sure(rough, view, burst, push):
                continue
            energy = push.explained * float((burst.z**2).sum())
            if best is None or energy > best[0]:
                best = energy, burst, push
        if best is None:
            continue
        wide = widened(rough, view, best[1])
        if taken[wide.rows].any():
            wide = best[1]
        torque = best[1].z * view.spread[best[1].rows]
        size = float((np.sqrt((torque**2).mean(axis=0)) / usual).max())
        accepted.append((size, wide))
        taken[wide.rows] = True
    least = max(LEAST_PUSH, LEAST_OF_LARGEST * max((size for size, _ in accepted), default=0.0))
    kept = sorted((wide for size, wide in accepted if size > least), key=lambda one: int(one.rows[0]))
    # What stays after a push stiction holds: it may hold as much during the others.
    shifts = [np.abs(one.shift * view.spread[one.rows[-1]]) for one in kept if view.quiet[one.rows].all()]
    level = np.max([stiction, *shifts], axis=0)
    pushed = [(one.rows, _push(model, rough, view, one, level)) for one in kept]
    if not last:
        return pushed
    # In motion: if much else stands out, the model lacks something, and this may be that.
    excess: Floats = np.where(view.hot & ~view.quiet & ~_at_ends(rough), (view.z**2).sum(axis=1), 0.0)
    inside: Mask = np.zeros(len(excess), dtype=bool)
    for rows, _ in pushed:
        inside[max(rows[0] - 6, 0) : rows[-1] + 7] = True
    if excess[inside].sum() < EXCESS_SHARE * excess.sum():
        pushed = [(rows, push) for rows, push in pushed if view.quiet[rows].all()]
    outside = _largest(rough, view, inside)
    pushed = [
        (rows, push)
        for rows, push in pushed
        if view.quiet[rows].all() or _size(view, rows) * _odds(push) > ABOVE_OTHERS * outside
    ]
    length = sum(len(rows) for rows, _ in pushed)
    return pushed if length <= LONGEST_SHARE * len(rough.t) or view.quiet.all() else []


def _push(model: Model, rough: Rough, view: Seen, burst: Burst, stiction: Floats) -> Push:
    """The force behind a ``burst``; at rest a joint may keep as much as ``stiction`` [n] of it."""
    rows, wide = burst.rows, view.spread[burst.rows]
    torque = burst.z * wide
    held = HELD * stiction * view.quiet[rows].mean()
    return push_in(model, Window(rough.q[rows], torque, wide, burst.shift * wide[-1], held, rough.step))


def _size(view: Seen, rows: NDArray[np.intp]) -> float:
    """RMS of all joints' residuals in ``rows``."""
    return float(np.sqrt((view.z[rows] ** 2).sum(axis=1).mean()))


def _at_ends(rough: Rough) -> Mask:
    """Which rows [N] are near either end of the log, where joints set out or come to rest."""
    return np.asarray((rough.t < rough.t[0] + END_TIME) | (rough.t > rough.t[-1] - END_TIME))


def _odds(push: Push) -> float:
    """What a force explains of a burst, by what it does not."""
    return push.explained / max(1 - push.explained, 1e-9)


def _largest(rough: Rough, view: Seen, inside: Mask) -> float:
    """The largest RMS over a short time of what stands out in motion, but for what is ``inside`` [N], and for
    the ends of the log, where no contact is looked for either."""
    wide = max(1, round(SHORT_TIME / rough.step))
    squares = np.where(inside | view.quiet | _at_ends(rough), 0.0, (view.z**2).sum(axis=1))
    return float(np.sqrt(np.convolve(squares, np.ones(wide) / wide, mode="same").max()))


def _sure(rough: Rough, view: Seen, burst: Burst, push: Push) -> bool:
    """Whether it is a force, and not what a joint does by itself."""
    if push.evidence > LEAST_EVIDENCE or view.quiet[burst.rows].all():
        return True
    # A joint alone, in motion: if it does so once, and not where its torque is largest, at a drive's limit.
    j = push.alone - 1
    load = np.abs(rough.tau[:, j])
    others = np.delete(load, burst.rows)
    if not len(others) or float(np.median(load[burst.rows])) > MOST_LOAD * float(others.max()):
        return False
    squares = view.z[:, j] ** 2
    outside = squares * (view.hot & ~view.quiet)
    share = squares[burst.rows].sum() / max(float(outside.sum()), 1e-300)
    return bool(view.z.shape[1] > 1 and share > ALONE_SHARE)


def _starts(rough: Rough, view: Seen, rows: NDArray[np.intp]) -> bool:
    """Whether a burst is of joints that set out or come to rest, or of brakes that open and close."""
    if view.quiet.all():
        return False
    first, last = int(rows[0]), int(rows[-1])
    if not view.quiet[rows].all():
        if view.quiet[rows].any():
            return True
        return bool(_at_ends(rough)[[first, last]].any())
    if _slack(rough, rows):
        return True
    same = view.quiet & (rough.part == rough.part[first])
    begin, end = first, last
    while begin > 0 and same[begin - 1]:
        begin -= 1
    while end < len(same) - 1 and same[end + 1]:
        end += 1
    at_begin = begin == 0 or rough.part[begin - 1] != rough.part[first]
    at_end = end == len(same) - 1 or rough.part[end + 1] != rough.part[first]
    if (at_begin or at_end) and rough.t[end] - rough.t[begin] < SHORT_REST:
        return True
    near_begin = not at_begin and rough.t[first] < rough.t[begin] + REST_EDGE
    near_end = not at_end and rough.t[last] > rough.t[end] - REST_EDGE
    return bool(near_begin or near_end)


def _slack(rough: Rough, rows: NDArray[np.intp]) -> bool:
    """Whether the joints carry next to nothing in a burst: brakes hold them."""
    wide = round(REST_EDGE / rough.step)
    beside = np.r_[max(rows[0] - 2 * wide, 0) : max(rows[0] - wide, 0), rows[-1] + wide : rows[-1] + 2 * wide]
    beside = beside[beside < len(rough.tau)]
    if not len(beside):
        return False
    inside, usual = (np.median(np.abs(rough.tau[k]), axis=0) for k in (rows, beside))
    loaded = usual > SLACK * usual.max()
    return bool(loaded.sum() > 1 and (inside[loaded] < SLACK * usual[loaded]).all())


def _limited(rough: Rough, burst: Burst) -> bool:
    """Whether the burst is of torques that are cut off."""
    squares = burst.z**2
    return bool(squares[rough.saturated[burst.rows]].sum() > 0.5 * squares.sum())


def without(gate: Gate, outside: Sequence[Contact]) -> Gate:
    """The ``gate`` without the windows of contacts, cut there as at gaps."""
    return without_windows(gate, [(one.start, one.end) for one in outside])


def without_windows(gate: Gate, windows: Sequence[tuple[float, float]]) -> Gate:
    """The ``gate`` without ``windows`` of time [s], and a margin before and after each."""
    t = gate.log.t
    out = np.zeros(len(t), dtype=bool)
    for start, end in windows:
        out |= (t >= start - MARGIN) & (t <= end + MARGIN)
    return without_rows(gate, out) if out.any() else gate


def without_rows(gate: Gate, out: Mask) -> Gate:
    """The ``gate`` without the samples of the mask ``out`` [K], cut there as at gaps."""
    segments, start = [], 0
    for part in gate.segments:
        kept = np.flatnonzero(~out[part])
        for run in np.split(kept, np.flatnonzero(np.diff(kept) > 1) + 1) if len(kept) else []:
            segments.append(slice(start, start + len(run)))
            start += len(run)
    inside = np.zeros(len(out), dtype=bool)
    for part in gate.segments:
        inside[part] = True
    kept = np.flatnonzero(inside & ~out)
    log = gate.log
    groups = {name: getattr(log, name) for name in ("t", "q", "qd", "qdd", "tau", "ql")}
    cut: dict[str, Any] = {name: None if x is None else x[kept] for name, x in groups.items()}
    return replace(
        gate, log=replace(log, **cut), segments=tuple(segments), rows=gate.rows[kept],
        saturated=gate.saturated[kept], resting=gate.resting[kept],
    )  # fmt: skip
