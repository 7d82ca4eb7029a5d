"""Elastic joints by their second encoders: what a motor leads its link by, against the torque.

The twist ``q - ql`` is the torque behind the gear by the joint's stiffness. What is measured is the motor's
torque, which contains its rotor and its friction, and two encoders are hardly read at one time: a skew of
3 ms at 1 rad/s is 3 mrad, ten times the twist of a stiff gear. So the twist of each joint is fitted, between
reversals, as

    q - ql = tau / k + s sgn(qd) + T qd + r qdd + an offset for each log

where ``T`` takes skew and viscous friction, ``r`` the rotor, ``s`` backlash less Coulomb friction. What is
left to tell ``k`` is gravity, and what the other joints do. Errors are by leaving out parts of the logs
(jackknife: Efron 1982), for the residuals are correlated.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.diagnose.result import Estimate, Finding
from robodyn.diagnose.select.limits import (
    BLOCKS,
    ENCODER_CONFIDENCE,
    ENCODER_MOVING,
    ENCODER_SAMPLES,
    ENCODER_SURE,
)
from robodyn.effects.catalogue import CATALOGUE
from robodyn.gate.gate import Gate
from robodyn.logs.signals import low_pass, signals_of
from robodyn.robot.model import Robot

#: The columns of a fit.
_TORQUE, _WAY, _SPEED, _RATE = range(4)


@dataclass(frozen=True, slots=True)
class Elasticity:
    """What two encoders of a ``joint`` (from 1) say of the spring between them.

    ``compliance`` [rad/(N m) or m/N] and the standard error ``stderr`` of it; ``skew`` [s] by which the
    link's encoder is late, with ``skew_stderr``; viscous friction by the stiffness is in it. ``reversal``
    [rad or m]: full width of what follows the direction of motion, the description's Coulomb friction
    accounted for.
    ``explained``: the share of the twist's mean square beyond its offset. ``without_skew`` [N m/rad or N/m]:
    the stiffness if both encoders are taken to be read at one time.
    """

    joint: int
    compliance: float
    stderr: float
    skew: float
    skew_stderr: float
    reversal: float
    explained: float
    without_skew: float

    @property
    def stiffness(self) -> float:
        """[N m/rad or N/m]; infinite where the joint is not softer than the encoders can tell."""
        return 1 / self.compliance if self.compliance > 0 else math.inf

    @property
    def stiffness_stderr(self) -> float:
        """Standard error of :attr:`stiffness`."""
        return self.stderr / self.compliance**2 if self.compliance > 0 else math.inf

    @property
    def least_stiffness(self) -> float:
        """The joint is at least as stiff, with 97.5 %."""
        most = self.compliance + 1.96 * self.stderr
        return 1 / most if most > 0 else math.inf

    @property
    def is_identifiable(self) -> bool:
        """Whether the logs show the stiffness at all."""
        return self.compliance > ENCODER_SURE * self.stderr


def elasticity(robot: Robot, gates: Sequence[Gate]) -> tuple[Elasticity, ...]:
    """The elasticity of each joint that has a second encoder in some of the logs; of a joint that hardly
    moves there, or of logs without such columns, nothing."""
    linked = sorted({j for gate in gates for j in gate.log.linked})
    return tuple(one for j in linked if (one := _of_joint(robot, gates, j)) is not None)


def elastic_findings(robot: Robot, seen: Sequence[Elasticity]) -> tuple[Finding, ...]:
    """The joints of ``robot`` whose second encoders show their elasticity, as findings; a joint that is
    described as elastic already is none."""
    effect = next(each for each in CATALOGUE.values() if each.traits.twist)
    findings = []
    for one in seen:
        entries = robot.effects_at(one.joint)
        if not one.is_identifiable or any(entry.definition.coupler is not None for entry in entries):
            continue
        revolute = robot.links[one.joint - 1].joint.kind == "revolute"
        (parameter,) = (p for p in effect.parameters if p.name == effect.traits.twist)
        unit = parameter.unit_at(revolute=revolute)
        where = (
            f"joint {one.joint}: the two encoders differ in step with the torque; the link's is read "
            f"about {abs(1e3 * one.skew):.2g} ms {'late' if one.skew > 0 else 'early'}"
        )
        sure = one.compliance / one.stderr
        stiffness = Estimate(one.stiffness, one.stiffness_stderr, unit)
        findings.append(
            Finding(
                effect.id, one.joint, {parameter.name: stiffness}, ENCODER_CONFIDENCE, (), where, None,
                gain=sure**2 / 2, t=sure,
            )
        )  # fmt: skip
    return tuple(findings)


def stiff_words(robot: Robot, seen: Sequence[Elasticity]) -> tuple[str, ...]:
    """Of each joint whose second encoder shows no spring: how stiff it is at least, and which spring there
    would be, were the encoders read at one time."""
    words = []
    for one in seen:
        if one.is_identifiable or not math.isfinite(one.least_stiffness):
            continue
        unit = "N m/rad" if robot.links[one.joint - 1].joint.kind == "revolute" else "N/m"
        late = f"about {abs(1e3 * one.skew):.2g} ms {'late' if one.skew > 0 else 'early'}"
        plain = f"; {one.without_skew:.2g} if it were not" if math.isfinite(one.without_skew) else ""
        words.append(
            f"joint {one.joint}: its second encoder is read {late}, and beside that no spring is seen: at "
            f"least {one.least_stiffness:.2g} {unit}{plain}"
        )
    return tuple(words)


def _of_joint(robot: Robot, gates: Sequence[Gate], j: int) -> Elasticity | None:
    parts = list(_parts(gates, j))
    if len(parts) < 2:
        return None
    columns = [_TORQUE, _WAY, _SPEED]
    if robot.torque_side == "motor":
        columns.append(_RATE)
    A = np.concatenate([rows for _, rows, _ in parts])[:, columns]
    if np.any(np.ptp(A, axis=0) == 0):
        return None
    # Offsets: what is left after the mean of each log.
    logs = np.concatenate([np.full(len(y), log, dtype=np.intp) for log, _, y in parts])
    blocks = np.concatenate([np.full(len(y), k) for k, (_, _, y) in enumerate(parts)])
    y = np.concatenate([twist for _, _, twist in parts])
    scale = np.abs(A).max(axis=0)
    A = A / scale
    whole = _solved(A, y, logs)
    each = np.stack([_solved(A[blocks != k], y[blocks != k], logs[blocks != k]) for k in range(len(parts))])
    errors = np.sqrt((len(parts) - 1) * np.mean((each - each.mean(axis=0)) ** 2, axis=0)) / scale
    plain = float(_solved(A[:, :2], y, logs)[0] / scale[0])
    left = _centred(y, logs) - _centred(A, logs) @ whole
    x = whole / scale
    level = float(robot.links[j].joint.coulomb) if robot.torque_side == "motor" else 0.0  # type: ignore[arg-type]  # constants
    return Elasticity(
        j + 1, float(x[0]), float(errors[0]), float(x[2]), float(errors[2]),
        2 * (float(x[1]) + level * float(x[0])),
        1 - float(left @ left) / max(float(np.sum(_centred(y, logs) ** 2)), 1e-300),
        1 / plain if plain > 0 else math.inf,
    )  # fmt: skip


def _parts(gates: Sequence[Gate], j: int) -> Iterator[tuple[int, Floats, Floats]]:
    """Number of the log, columns [K, 4] and twist [K] of each part in which the joint moves."""
    for log_index, gate in enumerate(gates):
        ql = gate.log.ql
        if ql is None or j not in gate.log.linked:
            continue
        for segment in gate.segments:
            if segment.stop - segment.start < ENCODER_SAMPLES:
                continue
            rows, twist, moves = _filtered(gate, segment, ql[segment, j], j)
            for block in np.array_split(np.arange(len(twist)), BLOCKS):
                kept = block[moves[block]]
                if len(kept) >= ENCODER_SAMPLES // BLOCKS:
                    yield log_index, rows[kept], twist[kept]


def _filtered(gate: Gate, segment: slice, ql: Floats, j: int) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    """All columns and the twist through one filter, and where the joint moves."""
    log = gate.log
    arrays = {name: getattr(log, name)[segment] for name in ("t", "q", "tau")}
    s = signals_of(replace(log, **arrays, qd=None, qdd=None, ql=None))
    known = np.isfinite(ql[: len(s.t)])
    times = s.t[known]
    filled = np.interp(s.t, times, ql[: len(s.t)][known]) if len(times) else np.zeros_like(s.t)
    qd = s.qd[:, j]
    columns = np.stack([s.tau[:, j], np.sign(qd), qd, s.qdd[:, j]], axis=1)
    twist = log.q[segment, j][: len(s.t)] - filled
    both = low_pass(np.column_stack([columns, twist]), 1 / s.period, s.cutoff)
    moves = known & (np.abs(qd) > ENCODER_MOVING * np.abs(qd).max())
    moves[: s.edge] = moves[len(moves) - s.edge :] = False
    return both[:, :4], both[:, 4], moves


def _centred(x: Floats, logs: NDArray[np.intp]) -> Floats:
    """``x`` [K, ...] less its mean in each log."""
    centred = np.array(x, dtype=np.float64)
    for log in np.unique(logs):
        centred[logs == log] -= centred[logs == log].mean(axis=0)
    return centred


def _solved(A: Floats, y: Floats, logs: NDArray[np.intp]) -> Floats:
    solution = np.linalg.lstsq(_centred(A, logs), _centred(y, logs), rcond=1e-10)[0]
    return np.asarray(solution, dtype=np.float64)
