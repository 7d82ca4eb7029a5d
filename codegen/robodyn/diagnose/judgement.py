"""What the findings come to: what models leave of logs, whether a name may stand, and the verdict."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.limits import (
    COMMON_EXPLAINED,
    CONFIRMED_SHARE,
    END_SHARE,
    LEAST_EXPLAINED,
    STANDS_OUT_LEFT,
    UNSEEN,
)
from robodyn.diagnose.result import Finding, Gap, Verdict
from robodyn.diagnose.select.library.candidate import rubs
from robodyn.diagnose.select.limits import COMMON_JOINTS
from robodyn.diagnose.select.search import Detected
from robodyn.diagnose.select.selection import Selection, what_matters
from robodyn.gate.gate import Gate
from robodyn.identify.predict import lacking
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]

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


def may_stand(one: Detected, first: Selection, last: Selection) -> bool:
    """Whether what is left at the joints of a finding lets its name stand."""
    rows = list(one.named.trial.candidate.rows)
    after = (last.last.held_out.mean(axis=0) * last.start.sigma**2)[rows]
    if _is_without_drives(first):
        before = (np.mean(first.start.rest**2, axis=0) * first.start.sigma**2)[rows]
        return bool(np.max(1 - after / np.maximum(before, 1e-300)) > COMMON_EXPLAINED)
    before = (first.first.held_out.mean(axis=0) * first.start.sigma**2)[rows]
    most = int(np.argmax((before - after) / last.start.sigma[rows] ** 2))
    share = 1 - float(after[most] / max(before[most], 1e-300))
    stands_out = float(last.residue[rows[most]]) > STANDS_OUT_LEFT
    return not (share < LEAST_EXPLAINED and stands_out and left_over(last)[rows].max() > 1)


def _is_without_drives(first: Selection) -> bool:
    """Whether the whole arm was described without its drives: most joints that are seen to move lack friction
    and none was said to have any."""
    if any(each.is_common for each in first.findings):
        return True
    n = first.start.n
    lacking_friction = {
        each.trial.candidate.joint for each in first.findings if each.trial.candidate.definition.dissipative
    }
    return not any(rubs(first.context, j) for j in range(n)) and len(lacking_friction) >= COMMON_JOINTS * n


def left_over(last: Selection) -> Floats:
    """The median of what is left [n], in units of what would matter."""
    rms = np.sqrt(np.maximum(last.residue**2 - 1, 0)) * last.start.sigma
    return np.asarray(rms / what_matters(last.context))


def holds(lacks: Lacking, robot: Robot, model: Robot, gates: Sequence[Gate], seen: Sequence[Gate]) -> bool:
    """Whether the model is nearer to logs than the ``robot`` without what was named; or no farther from such
    in which that does not show."""
    gap = gap_of(lacks, robot, model, gates, seen)
    floor = np.maximum(gap.noise_floor, 1e-3 * gap.validate_before.max())
    before, after = (float(np.sum((x / floor) ** 2)) for x in (gap.validate_before, gap.validate_after))
    change = np.concatenate([_inner(lacks(robot, gate) - lacks(model, gate), gate) for gate in seen])
    shown = float(np.mean((change / floor) ** 2))
    return bool(shown < UNSEEN or before - after > CONFIRMED_SHARE * shown * robot.n)


def verdict_of(findings: Sequence[Finding], last: Selection, left: Floats) -> Verdict:
    """The verdict; ``left`` [n]: what nothing explains, in units of what would matter."""
    if any(f.confidence >= 0.5 for f in findings):
        return "missing_effect"
    stands_out = last.residue > STANDS_OUT_LEFT
    return "unexplained" if findings or bool(np.any(stands_out & (left > 1.5))) else "consistent"


def words_of(verdict: Verdict, left: Floats) -> tuple[str, ...]:
    """Remarks for people; ``left`` [n] as for :func:`verdict_of`."""
    words = []
    if verdict == "unexplained":
        worst = int(np.argmax(left))
        words.append(f"something moves joint {worst + 1} that no effect of the catalogue explains")
    if verdict == "consistent":
        words.append("no effect needs to be added to this model")
    return tuple(words)
