"""A fleet's result as ``fleet.json`` has it, and what may stand there."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from datetime import UTC, datetime
from typing import Any, Final

from robodyn.fleet.result import FleetResult, Reading

#: Fields that are points in time.
DAYS: Final = frozenset({"since", "since_interval", "until", "first", "last", "date"})


def document(result: FleetResult) -> dict[str, Any]:
    """``result`` of plain values: the fields of its dataclasses by their names, but readings as columns.

    Points in time are ISO 8601, UTC, to the second. What is no number (NaN, infinity) is None.
    """
    plain = _plain(result)
    assert isinstance(plain, dict)
    return plain


def text(document: Mapping[str, Any]) -> str:
    """A ``document`` as text: types, units, logs and so on a line each, so that a fleet of any size can be
    searched and compared by lines; the same bytes from the same result."""
    parts = [f"{json.dumps(key)}: {_lines(value)}" for key, value in document.items()]
    return "{\n" + ",\n".join(parts) + "\n}\n"


def day(seconds: float) -> str:
    """A point in time [s since 1970] as ISO 8601."""
    return datetime.fromtimestamp(round(seconds), UTC).isoformat().replace("+00:00", "Z")


def _lines(value: Any) -> str:
    if isinstance(value, list) and value:
        return "[\n" + ",\n".join(_dumped(each) for each in value) + "\n]"
    return _dumped(value)


def _dumped(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def _plain(value: Any, key: str = "") -> Any:
    if isinstance(value, float):
        if not math.isfinite(value):
            return None
        return day(value) if key in DAYS else value
    if is_dataclass(value):
        return {each.name: _plain(getattr(value, each.name), each.name) for each in fields(value)}
    if isinstance(value, Mapping):
        if key == "readings":
            return {name: _columns(several) for name, several in value.items()}
        return {name: _plain(each) for name, each in value.items()}
    if isinstance(value, tuple | list):
        return [_plain(each, key) for each in value]
    return value


def _columns(readings: Sequence[Reading]) -> dict[str, list[Any]]:
    """Readings as columns, which take a third of the room."""
    names = [each.name for each in fields(Reading)]
    return {name: [_plain(getattr(reading, name), name) for reading in readings] for name in names}
