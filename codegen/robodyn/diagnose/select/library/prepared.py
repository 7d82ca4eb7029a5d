"""Columns of candidates through the filter of the torque, many at once: a pass of it costs more than its
samples do, where logs come in pieces."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from robodyn.arrays import Floats, Singles
from robodyn.diagnose.select.library.candidate import Candidate, Context
from robodyn.diagnose.select.limits import FILTERED_AT_ONCE
from robodyn.identify.predict import delays


def prepared(context: Context, several: Iterable[Candidate]) -> Iterator[tuple[Candidate, Singles]]:
    """Candidates with their columns [N, rows, c], filtered and thinned like the torque, in single precision:
    they are most of what is kept of a log."""
    late = delays(context.model.robot)
    rest = iter(several)
    while batch := _some(rest):
        columns: dict[int, Floats] = {}
        for coarse in (False, True):
            which = [k for k, one in enumerate(batch) if one.coarse is coarse]
            signals = context.slow if coarse else context.signals
            flat = [_late(context, batch[k], late).reshape(len(signals.t), -1) for k in which]
            if not flat:
                continue
            filtered = signals.thinned(signals.filtered(np.concatenate(flat, axis=1)))
            ends = np.cumsum([each.shape[1] for each in flat])[:-1]
            columns |= dict(zip(which, np.split(filtered, ends, axis=1), strict=True))
        for k, one in enumerate(batch):
            yield one, columns[k].reshape(len(columns[k]), *one.columns.shape[1:]).astype(np.float32)


def _some(rest: Iterator[Candidate]) -> list[Candidate]:
    """As many of the next candidates as are filtered at once."""
    batch, numbers = list[Candidate](), 0
    for one in rest:
        batch.append(one)
        numbers += one.columns.size
        if numbers >= FILTERED_AT_ONCE:
            break
    return batch


def _late(context: Context, candidate: Candidate, late: Floats) -> Floats:
    """The columns [K, rows, c], as late as the torque channels of their joints are known to be."""
    columns, own = candidate.columns, late[list(candidate.rows)]
    if not own.any() or _of_torque_channel(candidate):
        return columns
    signals = context.slow if candidate.coarse else context.signals
    columns = columns.copy()
    for k, delay in enumerate(own):
        for i in range(columns.shape[2]):
            columns[:, k, i] = np.interp(signals.t - delay, signals.t, columns[:, k, i])
    return columns


def _of_torque_channel(candidate: Candidate) -> bool:
    channel = candidate.definition.traits.channel
    return channel is not None and channel.is_torque
