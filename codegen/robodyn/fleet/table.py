"""A fleet's result as one table, ``fleet.parquet``: a row for each feature of each unit."""

from __future__ import annotations

import io
import math
from collections.abc import Iterator
from typing import Any, Final

from robodyn.fleet.result import FleetResult
from robodyn.tools.libraries import PYARROW

#: Fields of a claim that are columns of their own.
_CLAIMED: Final = ("shape", "since", "until", "size", "share", "p", "q")
#: Columns by name, with the names of their types in Arrow. ``measure`` is the unit of measurement, ``joint``
#: is null for the whole arm; what is claimed is null where nothing is.
COLUMNS: Final = {
    "type": "string", "unit": "string", "feature": "string", "effects": "strings", "joint": "int32",
    "measure": "string", "logs": "int32", "value": "double", "stderr": "double", "unusual": "double",
    "mean": "double", "between_units": "double", "claimed": "bool", "claimed_effects": "strings",
    "shape": "string", "since": "time", "since_from": "time", "since_to": "time", "until": "time",
    "size": "double", "size_stderr": "double", "share": "double", "p": "double", "q": "double",
}  # fmt: skip


def parquet(result: FleetResult) -> bytes:
    """The table of ``result`` as Parquet; the same bytes from the same result, by one version of pyarrow.

    Raises
    ------
    ToolError: pyarrow is not installed.
    """
    arrow, files = PYARROW.load(), PYARROW.load("parquet")
    kinds = {
        "string": arrow.string(), "strings": arrow.list_(arrow.string()), "int32": arrow.int32(),
        "double": arrow.float64(), "bool": arrow.bool_(), "time": arrow.timestamp("s", tz="UTC"),
    }  # fmt: skip
    rows = list(rows_of(result))
    columns = {
        name: arrow.array([_cell(kind, row[name]) for row in rows], kinds[kind])
        for name, kind in COLUMNS.items()
    }
    stream = io.BytesIO()
    files.write_table(arrow.table(columns), stream)
    return stream.getvalue()


def rows_of(result: FleetResult) -> Iterator[dict[str, Any]]:
    """A row, by the names of :data:`COLUMNS`, for each unit and each feature of its type, in the order of the
    result."""
    features = {kind.name: kind.features for kind in result.types}
    for unit in result.units:
        claims = {claim.feature: claim for claim in reversed(unit.claims)}  # the surest of each
        for one in features[unit.type]:
            claim = claims.get(one.name)
            value, error = unit.now.get(one.name, (None, None))
            since_from, since_to = (claim.since_interval if claim else None) or (None, None)
            yield {
                "type": unit.type, "unit": unit.unit, "feature": one.name, "effects": list(one.effects),
                "joint": one.joint, "measure": one.unit, "logs": len(unit.readings.get(one.name, ())),
                "value": value, "stderr": error, "unusual": unit.unusual.get(one.name), "mean": one.mean,
                "between_units": one.between_units, "claimed": claim is not None,
                "claimed_effects": claim and list(claim.effects), "since_from": since_from,
                "since_to": since_to, "size_stderr": claim and claim.stderr,
                **{name: getattr(claim, name, None) for name in _CLAIMED},
            }  # fmt: skip


def _cell(kind: str, value: Any) -> Any:
    """``value`` as a cell has it: what is no number is null, a point in time is whole seconds."""
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return round(value) if kind == "time" and value is not None else value
