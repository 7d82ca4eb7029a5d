"""What the findings come to: what models leave of logs, whether a name may stand, and the verdict."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.limits import CLAIM, END_SHARE, MOSTLY, WITHDRAWN
from robodyn.diagnose.result import Finding, Gap, Verdict
from robodyn.diagnose.select.limits import (
    ABOVE_FLOOR,
    EXCESS,
    PRACTICAL,
    STRUCTURE,
    STRUCTURE_LAGS,
)
from robodyn.diagnose.select.noise import rest_of
from robodyn.diagnose.select.outcome import Outcome
from robodyn.diagnose.select.rows import Rows, rows_of, with_noise
from robodyn.gate.gate import Gate
from robodyn.identify.predict import lacking
from robodyn.robot.model import Robot

#: What is said where no joint moves in the logs that were fitted.
STANDS: Final = "no joint moves in these logs: only contacts were looked for"

# --- what models leave ------------------------------------------------------------------------------------


class Lacking:
    """What models do not explain of logs: each is evaluated along each log once."""

    def __init__(self) -> None:
        self._known: list[tuple[Robot, Gate, Floats]] = []

    def __call__(self, robot: Robot, gate: Gate) -> Floats:
        for model, log, rest in self._known:
            if model is robot and log is gate:
                return rest
        rest = lacking(robot, gate)
        self._known.append((robot, gate, rest))
        return rest


def rms(lacks: Lacking, arm: Robot, gates: Sequence[Gate]) -> Floats:
    """RMS [n] of what ``arm`` leaves of logs."""
    return _rms([_inner(lacks(arm, gate), gate) for gate in gates])


def _rms(tables: Sequence[Floats]) -> Floats:
    """RMS [n] over the rows of tables [K, n]."""
    squares = np.sum([(table**2).sum(axis=0) for table in tables], axis=0)
    return np.asarray(np.sqrt(squares / sum(map(len, tables))))


def gap_of(lacks: Lacking, robot: Robot, model: Robot, gates: Sequence[Gate], seen: Sequence[Gate]) -> Gap:
    """What ``robot`` and ``model`` leave of logs that were fitted and of those that names are ``seen`` in."""
    noise = np.sqrt(np.mean([gate.torque_noise**2 for gate in gates], axis=0))
    train, validate = ([rms(lacks, arm, which) for arm in (robot, model)] for which in (gates, seen))
    torque = tuple(_rms([_inner(gate.log.tau, gate) for gate in which]) for which in (gates, seen))
    return Gap(train[0], train[1], validate[0], validate[1], noise, (torque[0], torque[1]))


def _inner(x: Floats, gate: Gate) -> Floats:
    """``x`` [K, n] along a log without the ends of its unbroken parts: there a motion that is cut off, at a
    gap or at a contact, has no rates to go by."""
    parts = [x[part] for part in gate.segments]
    edges = [int(END_SHARE * len(part)) for part in parts]
    return np.concatenate([part[edge : len(part) - edge] for part, edge in zip(parts, edges, strict=True)])


# --- whether names stand ----------------------------------------------------------------------------------


def excess(rows: Rows, left: Floats) -> Floats:
    """RMS [n] of what is ``left`` [N, n] beyond the sensors' noise, in units of that. Rows at rest count as
    their set says."""
    size = np.mean(_beyond_set(rows, left) ** 2, axis=0) / rows.floor**2 - 1
    return np.asarray(np.sqrt(np.maximum(size, 0.0)))


def structure(rows: Rows, left: Floats) -> Floats:
    """The same of joints where it is more than noise: correlated over longer than the filter makes it, or
    more than the torque itself (a model that says nothing would leave less)."""
    first, last = (max(1, int(rows.rate * lag)) for lag in STRUCTURE_LAGS)
    lags = [lag for lag in range(first, last + 1) if lag < len(left) // 2]
    centred = _beyond_set(rows, left)
    centred = centred - centred.mean(axis=0)
    sizes = np.maximum(np.sum(centred**2, axis=0), 1e-300)
    each = [np.sum(centred[:-lag] * centred[lag:], axis=0) / sizes for lag in lags] or [0 * sizes]
    is_correlated = np.sqrt(np.mean(np.square(each), axis=0)) > STRUCTURE
    torque = _beyond_set(rows, rows.seen("tau"))
    is_worse_than_none = np.sum(_beyond_set(rows, left) ** 2, axis=0) > np.sum(torque**2, axis=0)
    return np.where(is_correlated | is_worse_than_none, excess(rows, left), 0.0)


def _beyond_set(rows: Rows, left: Floats) -> Floats:
    """What is ``left`` [N, n]; of rows at rest by as much less as their set is wider than noise."""
    return np.asarray(left * rows.sigma * np.sqrt(rows.weight * rows.correlation))


def explained(outcome: Outcome) -> Floats:
    """The share [n] of what is beyond the sensors' noise at each joint (RMS) that all names together
    explain."""
    rows = outcome.fit.model.rows
    left, before = (excess(rows, one.rest) for one in (outcome.fit, outcome.begun))
    return np.asarray(1 - left / np.maximum(before, 1e-300))


def standing(findings: Sequence[Finding], outcome: Outcome) -> tuple[Finding, ...]:
    """The ``findings``, no claims those at whose joint most of the torque remains, and not as noise: what
    fits there a little need not be what is missing. None is a claim where more is left of some joint than it
    has torque: that is another arm, or another log."""
    rows = outcome.fit.model.rows
    left = structure(rows, outcome.fit.rest)
    torque, rest = (
        np.sqrt(np.mean(_beyond_set(rows, x) ** 2, axis=0)) for x in (rows.seen("tau"), outcome.fit.rest)
    )
    is_left = (left > EXCESS) & (rest > MOSTLY * torque)
    is_left |= np.any((left > EXCESS) & (rest > torque))
    place = {one.member.key: int(one.trial.at.argmax()) for one in outcome.found}
    return tuple(
        replace(f, confidence=min(f.confidence, WITHDRAWN)) if is_left[place[f.effect, f.joint]] else f
        for f in findings
    )


def verdict_of(findings: Sequence[Finding], outcome: Outcome) -> Verdict:
    """The verdict: what the sensors do not explain and what is correlated is structure; if there is some and
    nothing is claimed, it is unexplained."""
    if any(f.confidence >= CLAIM for f in findings):
        return "missing_effect"
    left = structure(outcome.fit.model.rows, outcome.fit.rest)
    return "unexplained" if findings or left.max(initial=0.0) > EXCESS else "consistent"


def what_matters(outcome: Outcome) -> Floats:
    """RMS [n] that an effect must explain at a joint to be worth a name beside what is left there."""
    rows = outcome.fit.model.rows
    rest = np.sqrt(np.mean(outcome.fit.rest**2, axis=0))
    return np.asarray(np.sqrt(1 - (1 - PRACTICAL) ** 2) * np.maximum(rest, ABOVE_FLOOR * rows.floor))


def structure_left(outcome: Outcome) -> Floats:
    """What has structure beyond the noise [n], in units of what matters."""
    rows = outcome.fit.model.rows
    left = structure(rows, outcome.fit.rest) * rows.floor
    return np.asarray(left / np.maximum(EXCESS * rows.floor, 1e-300))


def confirmed(models: Sequence[Robot], seen: Sequence[Gate], fitted: Rows) -> list[bool]:
    """Of each finding whether it takes the model no farther from logs that were not ``fitted`` (it need not
    show there); the first of ``models`` has all of them, each other lacks one."""
    rows = with_noise(
        rows_of(fitted.robot, seen, fitted.speeds), fitted.sigma, fitted.correlation, fitted.level
    )
    whole = rest_of(models[0], rows)
    return [bool(np.sum((rest_of(one, rows) ** 2 - whole**2) * rows.weight) >= 0) for one in models[1:]]


def words_of(verdict: Verdict, left: Floats, *, stands: bool) -> tuple[str, ...]:
    """Remarks for people; ``left`` [n]: what nothing explains, in units of what would matter; ``stands``:
    whether the arm stands still in all logs that were fitted."""
    words = []
    if stands:
        words.append(STANDS)
    elif verdict == "unexplained":
        worst = int(np.argmax(left))
        words.append(f"something moves joint {worst + 1} that no effect of the catalogue explains")
    if verdict == "consistent":
        words.append("no effect needs to be added to this model")
    return tuple(words)
