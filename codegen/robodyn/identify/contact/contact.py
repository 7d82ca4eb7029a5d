"""Contacts in a log, and the log without them.

A contact is a stretch of time in which a force on one link explains what a robust fit leaves (the arm's
numbers and friction are uncertain) far better than chance: De Luca and Mattone 2005 (residuals of
collisions), found by a likelihood ratio scan (:mod:`robodyn.identify.contact.scan`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.gate.gate import Gate
from robodyn.identify.contact.force import Push, push_in
from robodyn.identify.contact.limits import ALPHA, MARGIN, MOST, PRACTICAL
from robodyn.identify.contact.loose import Loose, left_of, loose
from robodyn.identify.contact.scan import Scan, Window, quiet
from robodyn.kernels.array_dynamics import Model
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]


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
    one = loose(model, gate, left)
    if one is None:
        return ()
    rests, out = quiet(robot, one), np.zeros(len(one.t), dtype=bool)
    rest, friction, numbers = left_of(one, out)
    scan = Scan(one, rest, rests, friction, out)
    # The best of all windows on any link is better by as much by chance; those that overlap are one.
    chance = float(np.log(np.sum(one.rest.size / scan.lengths) / ALPHA))
    out = _rows(one, [each for each in _apart(scan, one) if each.nats > chance])
    rest, friction, _ = left_of(one, out, numbers)
    windows = _apart(Scan(one, rest, rests, friction, out), one)
    found: list[tuple[Window, Push]] = []
    for kind in (False, True):
        own = [each for each in windows if bool(rests[each.rows[0]]) == kind]
        found += _standing_out(_explained(model, one, own, friction, is_rest=kind), chance, is_rest=kind)
    return tuple(
        Contact(
            float(one.t[window.rows[0]]), float(one.t[window.rows[-1]]), push.link, push.force, push.stderr,
            push.cone, push.explained, bool(rests[window.rows[0]]),
        )
        for window, push in sorted(found, key=lambda each: int(each[0].rows[0]))
        if _counts(one, window, friction)
    )  # fmt: skip


def _rows(one: Loose, windows: Sequence[Window]) -> Mask:
    """The rows [N] of ``windows``, and those beside them."""
    out = np.zeros(len(one.t), dtype=bool)
    for each in windows:
        start, end = one.t[each.rows[[0, -1]]]
        out |= (one.t >= start - MARGIN) & (one.t <= end + MARGIN)
    return out


def _apart(scan: Scan, one: Loose) -> list[Window]:
    """Windows that stand out, none of which has rows of another, the one that stands out most first."""
    windows: list[Window] = []
    while len(windows) < MOST and (best := scan.best(_rows(one, windows))) is not None and best.nats > 1:
        windows.append(best)
    return windows


def _explained(
    model: Model, one: Loose, windows: Sequence[Window], friction: Floats, *, is_rest: bool
) -> list[tuple[float, Window, Push]]:
    """By how many nats a force explains each of ``windows``, the most first. In motion a joint may do by
    itself what it likes; and what no force explains is noise."""
    result = []
    for window in windows:
        # At rest friction holds anything within its level: a uniform distribution.
        held = np.hypot(friction, window.shift) / np.sqrt(3) * is_rest
        push = push_in(model, one.q[window.rows], window.torque, window.spread, held)
        if push is not None:
            share = push.explained - (0.0 if is_rest and model.n > 1 else push.alone)
            noise = max(1.0, 2 * window.nats * (1 - push.explained) / model.n)
            result.append((window.nats * share / noise, window, push))
    return sorted(result, key=lambda each: -each[0])


def _standing_out(
    scored: Sequence[tuple[float, Window, Push]], chance: float, *, is_rest: bool
) -> list[tuple[Window, Push]]:
    """The windows better than by ``chance`` and, in motion, than what else the log leaves: of as many as may
    be, the last that stands out of all that are less (Rosner 1983). What else is left is as large by an
    exponential chance, of the mean by what stands out of it, and as much like a force, beside one joint
    alone, by that of a random direction."""
    count = 0
    for k, (nats, window, push) in enumerate(scored):
        others = np.array([1.0, *(each.nats for _, each, _ in scored[k + 1 :])])
        usual = float((others**2).sum() / others.sum())
        like = np.log(max(1 - push.alone, 1e-9) / max(1 - push.explained, 1e-9))
        own = window.nats / usual + 0.5 * max(len(window.spread) - 3, 0) * like
        if nats > chance and (is_rest or own > np.log(len(scored) * len(window.spread) / ALPHA)):
            count = k + 1
    return [(window, push) for _, window, push in scored[:count]]


def _counts(one: Loose, window: Window, friction: Floats) -> bool:
    """Whether a window is worth a name, and not of a drive at its limit."""
    squares = window.torque**2
    size = np.sqrt(squares.mean(axis=0)) / (one.size + friction)
    return bool(size.max() > PRACTICAL and squares[one.saturated[window.rows]].sum() < 0.5 * squares.sum())


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
    segments, rows, start = [], [], 0
    for part in gate.segments:
        kept = part.start + np.flatnonzero(~out[part])
        for run in np.split(kept, np.flatnonzero(np.diff(kept) > 1) + 1) if len(kept) else []:
            segments.append(slice(start, start + len(run)))
            start += len(run)
            rows.append(run)
    some = np.concatenate(rows) if rows else np.zeros(0, dtype=np.intp)
    log = gate.log
    groups = {name: getattr(log, name) for name in ("t", "q", "qd", "qdd", "tau", "ql")}
    cut: dict[str, Any] = {name: None if x is None else x[some] for name, x in groups.items()}
    return replace(
        gate, log=replace(log, **cut), segments=tuple(segments), rows=gate.rows[some],
        saturated=gate.saturated[some], resting=gate.resting[some],
    )  # fmt: skip
