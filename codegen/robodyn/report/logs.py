"""What ``robodyn logs`` found, as data and as lines of text."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.logs.log import Log
from robodyn.logs.map_text import map_text
from robodyn.logs.survey import ColumnFacts, LogFacts, StreamFacts
from robodyn.logs.wizard import Examination, JointCheck

#: Streams, columns of a stream, and rows and columns of the mapped log that are shown; cells of a sparkline.
_STREAMS, _COLUMNS, _ROWS, _WIDE, _CELLS = 8, 40, 3, 9, 48
_BARS: Final = "▁▂▃▄▅▆▇█"


def data(result: Examination) -> dict[str, Any]:
    """The examination for JSON."""
    facts, log = result.facts, result.log
    return {
        "file": result.recording.file,
        "format": result.recording.format,
        "notes": [*result.recording.notes, *(log.notes if log is not None else ())],
        "streams": [_stream_data(one) for one in result.streams],
        "map": map_text(result.mapping, {}, ()),
        "proposed": result.proposed,
        "needs_map": not result.plain,
        "reasons": dict(result.reasons),
        "missing": list(result.missing),
        "problem": result.problem or None,
        "log": None if facts is None or log is None else _log_data(log, facts),
        "checks": [_check_data(one) for one in result.checks],
    }


def _stream_data(one: StreamFacts) -> dict[str, Any]:
    columns = [
        {
            "name": column.name, "unit": one.stream.units.get(column.name) or None,
            "low": _number(column.low), "high": _number(column.high), "share": column.share,
            "whole": column.whole,
        }
        for column in one.columns.values()
    ]  # fmt: skip
    head = {"name": one.stream.name, "kind": one.stream.kind, "rows": one.rows, "rate": _rate(one)}
    return {**head, "columns": columns}


def _log_data(log: Log, facts: LogFacts) -> dict[str, Any]:
    ranges = [[_number(array.min()), _number(array.max())] for array in log.arrays()]
    return {
        "samples": facts.samples, "joints": facts.joints,
        **{name: _number(getattr(facts, name)) for name in ("duration", "rate", "jitter")},
        "gaps": [{"at": at, "length": length} for at, length in facts.gaps],
        "backwards": facts.backwards, "repeated": facts.repeated, "missing": facts.missing,
        "standstill": _number(facts.standstill),
        "move": list(facts.move), "ranges": dict(zip(log.columns, ranges, strict=True)),
        "linked": [j + 1 for j in log.linked],
    }  # fmt: skip


def _check_data(check: JointCheck) -> dict[str, Any]:
    numbers = {name: _number(getattr(check, name)) for name in ("low", "high", "correlation", "gain")}
    limits = None if check.limits is None else list(check.limits)
    return {"joint": check.joint, **numbers, "limits": limits, "remarks": list(check.remarks)}


def _number(value: Any) -> float | None:
    return float(value) if math.isfinite(value) else None


def _rate(one: StreamFacts) -> float | None:
    """Rows a second of a stream with stamps."""
    steps = np.diff(one.seconds) if one.seconds is not None else np.empty(0)
    steps = steps[steps > 0]
    return float(1 / np.median(steps)) if len(steps) else None


# --- text -------------------------------------------------------------------------------------------------


def lines(result: Examination, robot: str = "") -> list[str]:
    """The examination for a terminal; ``robot`` is the name of the arm it was compared with."""
    recording = result.recording
    text = [f"{recording.file}: {recording.format}", *(f"  note: {note}" for note in recording.notes)]
    for one in result.streams[:_STREAMS]:
        text += _stream_lines(one)
    if len(result.streams) > _STREAMS:
        text.append(f"  ... and {len(result.streams) - _STREAMS} streams more")
    text.append("")
    if result.plain:
        text.append("No map is needed: names and units are the usual ones.")
    else:
        mapping = map_text(result.mapping, result.reasons, result.missing).splitlines()
        text += ["Proposed map:" if result.proposed else "Map:", *(f"  {line}" for line in mapping)]
    if result.problem:
        text += ["", f"Not read yet: {result.problem}"]
    if result.log is not None and result.facts is not None:
        text += ["", *_log_lines(result.log, result.facts)]
    if result.checks:
        text += ["", *_check_lines(result.checks, robot)]
    return text


def _stream_lines(one: StreamFacts) -> list[str]:
    rate, columns = _rate(one), list(one.columns.items())
    head = [one.stream.name or "table", one.stream.kind, f"{one.rows} rows", f"{len(columns)} columns"]
    head += [f"{rate:.4g} Hz"] if rate else []
    text = ["  " + ", ".join(dict.fromkeys(head))]
    width = min(48, max((len(name) for name, _ in columns[:_COLUMNS]), default=0))
    for name, column in columns[:_COLUMNS]:
        extent = "no numbers" if not column.share else f"{column.low:.6g} to {column.high:.6g}"
        extent = f"{column.low:.6g}" if column.share and column.constant else extent
        unit = one.stream.units.get(name, "")
        text.append(f"    {name:<{width}}  {extent}{' ' + unit if unit else ''}{_kind(column)}")
    if len(columns) > _COLUMNS:
        text.append(f"    ... and {len(columns) - _COLUMNS} columns more")
    return text


def _kind(column: ColumnFacts) -> str:
    words = []
    if column.constant and column.share:
        words.append("always the same")
    elif column.whole and not column.constant:
        words.append("whole numbers")
        for bits in (16, 32):
            if 0.98 * 2**bits < column.high < 2**bits and column.low >= 0:
                words.append(f"perhaps of {bits} bits: {2**bits - 1} would be -1; write bits: {bits}")
    if 0 < column.share < 1:
        words.append(f"{1 - column.share:.2%} without a number")
    return f"  ({', '.join(words)})" if words else ""


def _log_lines(log: Log, facts: LogFacts) -> list[str]:
    head = [f"As mapped: {facts.samples} samples of {facts.joints} joint{'s' if facts.joints > 1 else ''}"]
    head += [f"{facts.duration:.6g} s"] if math.isfinite(facts.duration) else []
    head.append(f"{facts.rate:.5g} Hz" if math.isfinite(facts.rate) else "rate not observed")
    text = [", ".join(head), *(f"  note: {note}" for note in log.notes)]
    text += [f"  {remark}" for remark in _remarks(log, facts)]
    names = ["t", *(f"q{j + 1}" for j in range(log.n)), *(f"tau{j + 1}" for j in range(log.n))]
    columns = [log.t, *log.q.T, *log.tau.T][:_WIDE]
    heads = " ".join(f"{name:>10}" for name in names[:_WIDE])
    text.append(f"  {heads}{' ...' if len(names) > _WIDE else ''}")
    for k in range(min(_ROWS, log.samples)):
        cells = (f"{x[k]:.4g}" if math.isfinite(x[k]) else "-" for x in columns)
        text.append("  " + " ".join(f"{cell:>10}" for cell in cells))
    for group, array in (("q", log.q), ("tau", log.tau)):
        for j in range(log.n):
            extent = _interval(*_extent(array[:, j]))
            text.append(f"  {group}{j + 1:<4} {spark(array[:, j], _CELLS)} {extent}")
    return text


def _remarks(log: Log, facts: LogFacts) -> list[str]:
    even = f"intervals even to {facts.jitter:.1%}" if facts.jitter < 1 else "intervals uneven"
    gap = ""
    if facts.gaps:
        at, length = facts.gaps[0]
        more = f", and {len(facts.gaps) - 1} more" if len(facts.gaps) > 1 else ""
        gap = f"a gap of {length:.4g} s at {at:.4g} s{more}"
    moving = ", ".join(map(str, facts.move))
    unseen = ", ".join(f"q{j + 1}" for j in range(log.n) if not np.isfinite(log.q[:, j]).any())
    linked = ", ".join(f"ql{j + 1}" for j in log.linked)
    remarks: dict[str, Any] = {  # and whether they hold
        "no two times differ" if math.isnan(facts.jitter) else even: True,
        gap: facts.gaps,
        f"times go back {facts.backwards} times": facts.backwards,
        f"{facts.repeated} rows repeat the one before them in every digit": facts.repeated,
        f"{facts.missing} rows without a number in t, q or tau": facts.missing,
        f"standstill {facts.standstill:.0%} of the time": facts.standstill > 0.02,
        f"joints that move: {moving}" if moving else "no joint moves": True,
        f"not observed, no number in them: {unseen}": unseen,
        f"second encoders: {linked}": linked,
    }
    return [remark for remark, holds in remarks.items() if holds]


def _extent(x: Floats) -> tuple[float, float]:
    finite = x[np.isfinite(x)]
    return (float(finite.min()), float(finite.max())) if len(finite) else (math.nan, math.nan)


def _interval(low: float, high: float) -> str:
    return f"{low:.4g} to {high:.4g}" if math.isfinite(low) else "no numbers"


def spark(x: Floats, cells: int) -> str:
    """``x`` [K] as bars, ``cells`` of them: means of parts of even length, a blank where nothing is known."""
    low, high = _extent(x)
    bars = []
    for part in np.array_split(x, min(cells, len(x))):
        finite = part[np.isfinite(part)]
        level = (float(finite.mean()) - low) / (high - low) if len(finite) and high > low else 0.0
        bars.append(_BARS[min(int(level * len(_BARS)), len(_BARS) - 1)] if len(finite) else " ")
    return "".join(bars)


def _check_lines(checks: Sequence[JointCheck], robot: str) -> list[str]:
    text = [f"Beside {robot}:"]
    for check in checks:
        limits = "" if check.limits is None else f" of {check.limits[0]:.4g} to {check.limits[1]:.4g}"
        gravity = "gravity says nothing here"
        if math.isfinite(check.correlation):
            times = f"{check.correlation:+.2f}, {check.gain:.3g} times as large"
            gravity = f"torque goes with gravity's: {times}"
        text.append(f"  joint {check.joint}: {_interval(check.low, check.high)}{limits}; {gravity}")
        text += [f"    {remark}" for remark in check.remarks]
    return text
