"""What ``robodyn logs`` found, as data and as lines of text."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.logs.map_text import map_text
from robodyn.logs.survey import ColumnFacts, LogFacts, StreamFacts
from robodyn.logs.wizard import Examination, JointCheck

Floats = NDArray[np.float64]

#: Columns of a stream, and rows of the mapped log, that are shown; cells of a sparkline.
_COLUMNS, _ROWS, _CELLS = 40, 3, 48
_BARS: Final = "▁▂▃▄▅▆▇█"


def data(result: Examination) -> dict[str, Any]:
    """The examination for JSON."""
    facts = result.facts
    return {
        "file": result.recording.file,
        "format": result.recording.format,
        "notes": [*result.recording.notes, *(result.log.notes if result.log is not None else ())],
        "streams": [_stream_data(one) for one in result.streams],
        "map": map_text(result.mapping, {}, ()),
        "proposed": result.proposed,
        "needs_map": not result.plain,
        "reasons": dict(result.reasons),
        "missing": list(result.missing),
        "problem": result.problem or None,
        "log": None if facts is None or result.log is None else _log_data(result, facts),
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
    rate = _rate(one)
    return {
        "name": one.stream.name,
        "kind": one.stream.kind,
        "rows": one.rows,
        "rate": rate,
        "columns": columns,
    }


def _log_data(result: Examination, facts: LogFacts) -> dict[str, Any]:
    assert result.log is not None
    log = result.log
    ranges = [[_number(array.min()), _number(array.max())] for array in log.arrays()]
    return {
        "samples": facts.samples, "joints": facts.joints, "duration": _number(facts.duration),
        "rate": _number(facts.rate), "jitter": _number(facts.jitter),
        "gaps": [{"at": at, "length": length} for at, length in facts.gaps], "backwards": facts.backwards,
        "repeated": facts.repeated, "missing": facts.missing, "standstill": _number(facts.standstill),
        "move": list(facts.move), "ranges": dict(zip(log.columns, ranges, strict=True)),
        "linked": [j + 1 for j in log.linked],
    }  # fmt: skip


def _check_data(check: JointCheck) -> dict[str, Any]:
    return {
        "joint": check.joint, "low": _number(check.low), "high": _number(check.high),
        "limits": None if check.limits is None else list(check.limits),
        "correlation": _number(check.correlation), "gain": _number(check.gain),
        "remarks": list(check.remarks),
    }  # fmt: skip


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
    text = [f"{recording.file}: {recording.format}"]
    text += [f"  note: {note}" for note in recording.notes]
    for one in result.streams[:8]:
        text += _stream_lines(one)
    if len(result.streams) > 8:
        text.append(f"  ... and {len(result.streams) - 8} streams more")
    text.append("")
    if result.plain:
        text.append("No map is needed: names and units are the usual ones.")
    else:
        text.append("Proposed map:" if result.proposed else "Map:")
        text += [
            f"  {line}" for line in map_text(result.mapping, result.reasons, result.missing).splitlines()
        ]
    if result.problem:
        text += ["", f"Not read yet: {result.problem}"]
    if result.log is not None and result.facts is not None:
        text += ["", *_log_lines(result, result.facts)]
    if result.checks:
        text += ["", *_check_lines(result.checks, robot)]
    return text


def _stream_lines(one: StreamFacts) -> list[str]:
    rate = _rate(one)
    head = [one.stream.name or "table", one.stream.kind, f"{one.rows} rows", f"{len(one.columns)} columns"]
    head += [f"{rate:.4g} Hz"] if rate else []
    text = ["  " + ", ".join(dict.fromkeys(head))]
    width = max((len(name) for name in list(one.columns)[:_COLUMNS]), default=0)
    for name, column in list(one.columns.items())[:_COLUMNS]:
        unit = one.stream.units.get(name, "")
        text.append(
            f"    {name:<{min(width, 48)}}  {_range(column)}{' ' + unit if unit else ''}{_kind(column)}"
        )
    if len(one.columns) > _COLUMNS:
        text.append(f"    ... and {len(one.columns) - _COLUMNS} columns more")
    return text


def _range(column: ColumnFacts) -> str:
    if not column.share:
        return "no numbers"
    return f"{column.low:.6g}" if column.constant else f"{column.low:.6g} to {column.high:.6g}"


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


def _log_lines(result: Examination, facts: LogFacts) -> list[str]:
    log = result.log
    assert log is not None
    text = [
        f"As mapped: {facts.samples} samples of {facts.joints} joint{'s' if facts.joints > 1 else ''}, "
        + (f"{facts.duration:.6g} s, " if math.isfinite(facts.duration) else "")
        + (f"{facts.rate:.5g} Hz" if math.isfinite(facts.rate) else "rate not observed")
    ]
    text += [f"  note: {note}" for note in log.notes]
    remarks = [f"intervals even to {facts.jitter:.1%}" if facts.jitter < 1 else "intervals uneven"]
    if math.isnan(facts.jitter):
        remarks = ["no two times differ"]
    if facts.gaps:
        at, length = facts.gaps[0]
        more = f", and {len(facts.gaps) - 1} more" if len(facts.gaps) > 1 else ""
        remarks.append(f"a gap of {length:.4g} s at {at:.4g} s{more}")
    if facts.backwards:
        remarks.append(f"times go back {facts.backwards} times")
    if facts.repeated:
        remarks.append(f"{facts.repeated} rows repeat the one before them in every digit")
    if facts.missing:
        remarks.append(f"{facts.missing} rows without a number in t, q or tau")
    if facts.standstill > 0.02:
        remarks.append(f"standstill {facts.standstill:.0%} of the time")
    moving = ", ".join(map(str, facts.move))
    remarks.append(f"joints that move: {moving}" if moving else "no joint moves")
    unseen = ", ".join(f"q{j + 1}" for j in range(log.n) if not np.isfinite(log.q[:, j]).any())
    if unseen:
        remarks.append(f"not observed, no number in them: {unseen}")
    if log.linked:
        remarks.append("second encoders: " + ", ".join(f"ql{j + 1}" for j in log.linked))
    text += [f"  {remark}" for remark in remarks]
    names = ["t", *(f"q{j + 1}" for j in range(log.n)), *(f"tau{j + 1}" for j in range(log.n))]
    columns = [log.t, *log.q.T, *log.tau.T]
    shown = names[:9]
    text.append(
        "  " + " ".join(f"{name:>10}" for name in shown) + (" ..." if len(names) > len(shown) else "")
    )
    for k in range(min(_ROWS, log.samples)):
        cells = (f"{x:.4g}" if math.isfinite(x) else "-" for x in (column[k] for column in columns))
        text.append("  " + " ".join(f"{cell:>10}" for cell in list(cells)[: len(shown)]))
    for group, array in (("q", log.q), ("tau", log.tau)):
        for j in range(log.n):
            bars = spark(array[:, j], _CELLS)
            text.append(f"  {group}{j + 1:<4} {bars} {_interval(*_extent(array[:, j]))}")
    return text


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
        if not len(finite):
            bars.append(" ")
        else:
            level = (float(finite.mean()) - low) / (high - low) if high > low else 0.0
            bars.append(_BARS[min(int(level * len(_BARS)), len(_BARS) - 1)])
    return "".join(bars)


def _check_lines(checks: Sequence[JointCheck], robot: str) -> list[str]:
    text = [f"Beside {robot}:"]
    for check in checks:
        limits = "" if check.limits is None else f" of {check.limits[0]:.4g} to {check.limits[1]:.4g}"
        line = f"  joint {check.joint}: {_interval(check.low, check.high)}{limits}"
        if math.isfinite(check.correlation):
            line += f"; torque goes with gravity's: {check.correlation:+.2f}, {check.gain:.3g} times as large"
        else:
            line += "; gravity says nothing here"
        text.append(line)
        text += [f"    {remark}" for remark in check.remarks]
    return text
