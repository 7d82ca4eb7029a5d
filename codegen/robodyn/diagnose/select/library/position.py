"""What depends on the position alone: lines and waves over it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from robodyn.diagnose.select.library.candidate import Candidate, Context, single
from robodyn.effects.effect import Effect
from robodyn.effects.traits import Line, Wave


def lines(c: Context, effect: Effect, line: Line, j: int) -> Iterator[Candidate]:
    """A straight line over the position."""
    q = c.signals.q[:, j]
    middle = float(np.mean(q))
    columns = [q - middle, np.ones_like(q)]
    yield single(effect.id, j, columns, (0, 0), lambda x: line.read(x, {"middle": middle}), line.order)


def waves(c: Context, effect: Effect, wave: Wave, j: int) -> Iterator[Candidate]:
    """Waves over the position, of the lengths that stand out."""
    for cycles in c.hints.cycles[j]:
        yield _wave(c, effect, wave, j, {"cycles": cycles})


def _wave(c: Context, effect: Effect, wave: Wave, j: int, settings: Mapping[str, float]) -> Candidate:
    angle = settings["cycles"] * c.signals.q[:, j]
    return single(
        effect.id, j, [np.sin(angle), np.cos(angle)], (0, 0), lambda x: wave.read(x, settings), wave.order,
        values=settings, spread=wave.spread, again=lambda c, values: _wave(c, effect, wave, j, values),
    )  # fmt: skip


def cycles_in(c: Context, j: int, count: int = 4) -> list[float]:
    """The numbers of waves a radian that stand out of what the model leaves, over the joint's position."""
    q, s = c.signals.q[:, j], c.signals
    rest = s.tau[:, j] - c.at.total[:, j]
    span = float(np.ptp(q))
    if span < 0.2:
        return []
    # Against slow changes over position and over velocity, which are other effects.
    basis = np.stack([np.ones_like(q), q, q**2, q**3, s.qd[:, j], np.sign(s.qd[:, j]), s.qdd[:, j]], axis=1)
    rest = rest - basis @ np.linalg.lstsq(basis, rest, rcond=None)[0]
    lowest = 2.5 * 2 * np.pi / span
    highest = min(400.0, 0.2 * np.pi / s.period / max(float(np.abs(s.qd[:, j]).max()), 1e-9))
    if highest <= lowest:
        return []
    # Sums over small steps of position, and their spectrum.
    step = np.pi / 4 / highest
    bins = ((q - q.min()) / step).astype(int)
    sums = np.bincount(bins, rest)
    size = 1 << int(np.ceil(np.log2(8 * len(sums))))
    power = np.abs(np.fft.rfft(sums, size)) ** 2
    tried = 2 * np.pi * np.arange(len(power)) / (size * step)
    power[(tried < lowest) | (tried > highest)] = 0.0
    cycles: list[float] = []
    for k in np.argsort(power)[::-1]:
        if all(abs(tried[k] - other) > 4 / span for other in cycles):
            cycles.append(float(tried[k]))
        if len(cycles) == count:
            break
    return cycles
