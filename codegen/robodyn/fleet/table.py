"""A fleet's result as one table, ``fleet.parquet``: a row for each feature of each unit."""

from __future__ import annotations

import io
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, Final, Literal

from robodyn.fleet.result import Claim, Feature, FleetResult, UnitResult
from robodyn.tools.libraries import PYARROW

#: Kinds of columns: Arrow's types by their names.
Kind = Literal["string", "strings", "int32", "double", "bool", "time"]


@dataclass(frozen=True, slots=True)
class Cells:
    """What a row is about: a unit, a feature of its type, and what is claimed of it."""

    unit: UnitResult
    feature: Feature
    claim: Claim | None

    def claimed(self, field: str) -> Any:
        """A field of the claim; None where nothing is claimed."""
        return None if self.claim is None else getattr(self.claim, field)

    def day(self, end: int) -> float | None:
        """An end of the interval of days of a change."""
        interval = self.claimed("since_interval")
        return None if interval is None else float(interval[end])

    def now(self, part: int) -> float | None:
        """The value (0) or its standard error (1), after pooling."""
        return self.unit.now[self.feature.name][part] if self.feature.name in self.unit.now else None


COLUMNS: Final[dict[str, tuple[Kind, Callable[[Cells], Any]]]] = {
    "type": ("string", lambda row: row.unit.type),
    "unit": ("string", lambda row: row.unit.unit),
    "feature": ("string", lambda row: row.feature.name),
    "effects": ("strings", lambda row: list(row.feature.effects)),
    "joint": ("int32", lambda row: row.feature.joint),
    "measure": ("string", lambda row: row.feature.unit),
    "logs": ("int32", lambda row: len(row.unit.readings.get(row.feature.name, ()))),
    "value": ("double", lambda row: row.now(0)),
    "stderr": ("double", lambda row: row.now(1)),
    "unusual": ("double", lambda row: row.unit.unusual.get(row.feature.name)),
    "mean": ("double", lambda row: row.feature.mean),
    "between_units": ("double", lambda row: row.feature.between_units),
    "claimed": ("bool", lambda row: row.claim is not None),
    "claimed_effects": ("strings", lambda row: row.claim and list(row.claim.effects)),
    "shape": ("string", lambda row: row.claimed("shape")),
    "since": ("time", lambda row: row.claimed("since")),
    "since_from": ("time", lambda row: row.day(0)),
    "since_to": ("time", lambda row: row.day(1)),
    "until": ("time", lambda row: row.claimed("until")),
    "size": ("double", lambda row: row.claimed("size")),
    "size_stderr": ("double", lambda row: row.claimed("stderr")),
    "share": ("double", lambda row: row.claimed("share")),
    "p": ("double", lambda row: row.claimed("p")),
    "q": ("double", lambda row: row.claimed("q")),
}
"""Columns by name: their kind, and what a row has there. ``measure`` is the unit of measurement, ``joint`` is
null for the whole arm; what is claimed is null where nothing is."""


def parquet(result: FleetResult) -> bytes:
    """The table of ``result`` as Parquet; the same bytes from the same result, by one version of pyarrow.

    Raises
    ------
    ToolError: pyarrow is not installed.
    """
    arrow, files = PYARROW.load(), PYARROW.load("parquet")
    types = {
        "string": arrow.string(), "strings": arrow.list_(arrow.string()), "int32": arrow.int32(),
        "double": arrow.float64(), "bool": arrow.bool_(), "time": arrow.timestamp("s", tz="UTC"),
    }  # fmt: skip
    rows = list(rows_of(result))
    columns = {
        name: arrow.array([_value(kind, read(row)) for row in rows], types[kind])
        for name, (kind, read) in COLUMNS.items()
    }
    stream = io.BytesIO()
    files.write_table(arrow.table(columns), stream)
    return stream.getvalue()


def rows_of(result: FleetResult) -> Iterator[Cells]:
    """A row for each unit and each feature of its type, in the order of the result."""
    features = {kind.name: kind.features for kind in result.types}
    for unit in result.units:
        claims = {claim.feature: claim for claim in reversed(unit.claims)}  # the surest of each
        for feature in features[unit.type]:
            yield Cells(unit, feature, claims.get(feature.name))


def _value(kind: Kind, value: Any) -> Any:
    """``value`` as a cell has it: what is no number is null, a point in time is whole seconds."""
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return round(value) if kind == "time" and value is not None else value
