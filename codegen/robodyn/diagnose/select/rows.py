"""Logs as rows: filtered torques less the model's, the weight of each, and the blocks that are held out.

At rest dry friction is a set and not a value: of a speed that is not resolved the sign is +1 or -1 with the
mean s = v / v0 (at most 1), so that friction of the level F has the mean F s and the variance F^2 (1 - s^2).
A row at rest so says that its torque lies within the level, by its first two moments (Karnopp 1985).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.diagnose.select.library.candidate import Context
from robodyn.diagnose.select.library.context import context_of
from robodyn.diagnose.select.limits import BLOCKS, GUARD, LEAST_NOISE_SHARE, SHORTEST_PIECE
from robodyn.gate.gate import Gate
from robodyn.identify.prior import number_of
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.limits import MOTION_WIDER
from robodyn.logs.log import Log
from robodyn.logs.signals import Signals, signals_of
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True, eq=False)
class Rows:
    """The rows of logs along ``contexts``: ``blocks`` [B, m] of them are held out in turn.

    ``speeds`` [n]: below which directions of motion are not resolved, and those ``expected`` by filter,
    accelerations and encoders; ``unresolved`` [N, n]: 1 - s^2 of each row, filtered like the torque;
    ``sigma`` [n]: noise, ``correlation`` [n]: how many rows say what one says; ``level`` [n]: dry friction,
    of which the rows at rest say a set; ``floor`` [n]: noise that the sensors alone leave."""

    robot: Robot
    contexts: tuple[Context, ...]
    blocks: NDArray[np.intp]
    speeds: Floats
    unresolved: Floats
    floor: Floats
    sigma: Floats
    correlation: Floats
    level: Floats
    expected: Floats

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.speeds)

    @property
    def rate(self) -> float:
        """Rows a second [Hz]."""
        s = self.contexts[0].signals
        return 1 / (s.period * s.every)

    @property
    def weight(self) -> Floats:
        """What rows count [N, n]: one over their variance."""
        return np.asarray(
            1 / (self.correlation * self.sigma**2 + self.level**2 * np.clip(self.unresolved, 0.0, 1.0))
        )

    def seen(self, part: str) -> Floats:
        """A table of the motion (``q``, ``qd``, ``qdd``, ``tau``), filtered, by rows [N, n]."""
        tables = [c.signals.thinned(c.signals.filtered(getattr(c.signals, part))) for c in self.contexts]
        return np.concatenate(tables)


def rows_of(robot: Robot, gates: Sequence[Gate], speeds: Floats | None = None) -> Rows:
    """The rows of logs that have passed their ``gates``; the ``speeds`` [n] below which directions are not
    resolved (None: as the logs let expect). Parts too short to be filtered are left out."""
    pieces = sorted(
        (_piece(gate.log, part) for gate in gates for part in gate.segments), key=lambda log: -log.samples
    )
    longest = signals_of(pieces[0], wider=MOTION_WIDER)
    signals = [longest]
    for piece in pieces[1:]:
        if piece.samples * longest.period > SHORTEST_PIECE / longest.cutoff:
            signals.append(signals_of(piece, cutoff=longest.cutoff, wider=MOTION_WIDER))
    expected = np.maximum(unresolved_speeds(signals), 1e-9)
    speeds = expected if speeds is None else speeds
    model = Model(robot, sticking=speeds)
    first = context_of(model, signals[0])
    contexts = (first, *(context_of(model, s, first.hints) for s in signals[1:]))
    unresolved = np.concatenate([s.thinned(s.filtered(1 - model.direction(s.qd) ** 2)) for s in signals])
    none = np.zeros(robot.n)
    floor = np.hypot(passed_noise(longest), encoder_torque_noise(first))
    level = np.array([abs(number_of(link.joint.coulomb)) for link in robot.links])
    blocks = _blocks(len(unresolved), longest)
    return Rows(robot, contexts, blocks, speeds, unresolved, floor, floor, none + 1, level, expected)


def _piece(log: Log, part: slice) -> Log:
    if part == slice(0, log.samples):
        return log
    cut = [None if x is None else x[part] for x in (log.t, log.q, log.qd, log.qdd, log.tau)]
    return Log(*cut, ql=None if log.ql is None else log.ql[part])  # type: ignore[arg-type, misc]


def _blocks(count: int, s: Signals) -> NDArray[np.intp]:
    """Rows [B, m] of contiguous blocks, without those at their edges that the filter has from others."""
    ends = np.linspace(0, count, min(BLOCKS, count) + 1).astype(int)
    shortest = int(np.diff(ends).min())
    guard = int(np.ceil(GUARD / (2 * np.pi * s.cutoff) / (s.period * s.every)))
    guard = min(guard, (shortest - 1) // 2)
    return np.stack([np.arange(start + guard, start + shortest - guard) for start in ends[:-1]])


def unresolved_speeds(signals: Sequence[Signals]) -> Floats:
    """Speeds [n] below which the direction of motion is not known: by what a speed changes within the time
    of the torque's filter, and by the encoders' noise that is left in it."""
    s = signals[0]
    rates = np.sqrt(np.mean(np.concatenate([each.qdd for each in signals]) ** 2, axis=0))
    return np.asarray(np.hypot(rates / (2 * np.pi * s.cutoff), s.speed_noise))


def passed_noise(s: Signals) -> Floats:
    """Standard deviations [n] of the torque channel's noise, as far as the filter lets it pass."""
    noise = np.zeros(s.n) if s.torque_noise is None else s.torque_noise
    size = np.sqrt(np.mean(s.tau**2, axis=0))
    return np.asarray(
        np.maximum(noise * np.sqrt(min(1.0, 2 * s.cutoff * s.period)), LEAST_NOISE_SHARE * size)
    )


def encoder_torque_noise(c: Context, poses: int = 100) -> Floats:
    """Standard deviations [n] of the encoders' noise, carried into the model's torques by the
    accelerations."""
    s = c.signals
    if s.acceleration_noise is None:
        return np.zeros(c.n)
    q = s.q[:: max(1, len(s.q) // poses)]
    inertia = c.model.mass_matrix(q)
    return np.asarray(np.sqrt(np.mean((inertia * s.acceleration_noise) ** 2, axis=0).sum(axis=1)))


def with_noise(rows: Rows, sigma: Floats, correlation: Floats, level: Floats) -> Rows:
    """The same rows with their noise."""
    return replace(rows, sigma=sigma, correlation=correlation, level=level)


def with_speeds(rows: Rows, speeds: Floats) -> Rows:
    """The same rows with other speeds below which directions are not resolved; candidates along them are
    still of those before."""
    model = Model(rows.robot, sticking=speeds)
    signals = [c.signals for c in rows.contexts]
    unresolved = np.concatenate([s.thinned(s.filtered(1 - model.direction(s.qd) ** 2)) for s in signals])
    return replace(rows, speeds=speeds, unresolved=unresolved)
