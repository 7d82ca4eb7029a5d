"""Link encoders (second encoders, behind the gear): are they usable, and do they follow their joints?"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from robodyn.arrays import Mask
from robodyn.gate import limits
from robodyn.gate.flag import Flag, chunks, count, refuse, spans_of
from robodyn.logs.log import Log


def with_usable_links(log: Log, flags: list[Flag]) -> Log:
    """``log`` without the link encoders whose readings are invalid in too many rows."""
    if log.ql is None:
        return log
    drop = []
    for j in log.linked:
        broken = _broken(log, j)
        share = float(broken.mean())
        if share > limits.BROKEN_SHARE:
            drop.append(j)
            text = f"missing or beyond {limits.BOUNDS['ql']:g} in {share:.0%} of the rows: not used"
            spans = spans_of(np.flatnonzero(broken), log.t)
            flags.append(Flag("link_encoder_unusable", f"ql{j + 1}", spans, text, (j + 1,)))
    if not drop:
        return log
    ql = log.ql.copy()
    ql[:, drop] = np.nan
    return replace(log, ql=None if np.isnan(ql).all() else ql)


def links_garbage(log: Log, flags: list[Flag]) -> Mask:
    """The rows [K] in which a reading of a link encoder is missing or absurdly large."""
    bad = np.zeros(log.samples, dtype=bool)
    for j in log.linked:
        broken = _broken(log, j)
        if broken.any():
            rows = count(int(broken.sum()))
            text = f"missing or beyond {limits.BOUNDS['ql']:g} in {rows}, left out"
            spans = spans_of(np.flatnonzero(broken), log.t)
            flags.append(Flag("garbage", f"ql{j + 1}", spans, text, (j + 1,)))
            bad |= broken
    return bad


def check_links(log: Log) -> None:
    """Refuse link encoders that do not follow their joints.

    Raises
    ------
    InputError: a link encoder does not move one to one with its joint (wrong unit, sign or joint).
    """
    if log.ql is None:
        return
    for j in log.linked:
        q = log.q[:, j] - log.q[:, j].mean()
        ql = log.ql[:, j] - log.ql[:, j].mean()
        if np.ptp(q) < limits.LEVER * limits.LEAST_ANGLE:
            continue
        slope = float(q @ ql / (q @ q))
        if abs(slope - 1) > limits.LINK_SLOPE:
            refuse(
                f"ql{j + 1} does not follow q{j + 1}",
                found=f"it moves {slope:.3g} times as far",
                expected=f"1, within {limits.LINK_SLOPE:.0%}: both measure the same joint",
                remedy="correct its unit or sign, or give the column of the right joint",
            )


def _broken(log: Log, j: int) -> Mask:
    assert log.ql is not None
    broken = np.zeros(log.samples, dtype=bool)
    for rows in chunks(log.samples):
        broken[rows] = ~(np.abs(log.ql[rows, j]) <= limits.BOUNDS["ql"])
    return broken
