"""The map of a fleet: how unusual each unit is at each joint; a row a unit, a table a type."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any, Final

from robodyn.fleet.places import address, unit_folder
from robodyn.fleet.result import Feature, FleetResult, TypeResult, UnitResult
from robodyn.report.fleet_text import (
    brief,
    capital,
    effects_text,
    is_known,
    most_unusual,
    unusual_text,
    with_error,
    with_unit,
)

#: Rows of a type that are seen at once; the others are folded.
SHOWN: Final = 20
#: From how far beyond what is usual on, in standard deviations, a cell has its first, second, ... shade.
SHADES: Final = (2.0, 3.0, 4.5, 7.0, 10.0)


@dataclass(frozen=True, slots=True)
class Cell:
    """A joint of a unit: the feature that is furthest from usual there, and how far; ``shade``: 0 for what
    is usual, negative for less; ``is_named``: something there is a claim."""

    text: str
    shade: int
    is_named: bool

    @property
    def css(self) -> str:
        """The names of its looks."""
        shade = f"p{self.shade}" if self.shade > 0 else f"m{-self.shade}" if self.shade < 0 else ""
        return " ".join(part for part in (shade, "named" if self.is_named else "") if part)


@dataclass(frozen=True, slots=True)
class Row:
    """A unit: where its page is, its place in the data of the script, its cells, what is named of it."""

    unit: str
    page: str
    index: int
    cells: tuple[Cell, ...]
    named: str


@dataclass(frozen=True, slots=True)
class TypeMap:
    """The rows of a type, the most unusual first; ``places`` are the columns: joints, and the whole arm."""

    name: str
    index: int
    places: tuple[str, ...]
    titles: tuple[str, ...]
    shown: tuple[Row, ...]
    folded: tuple[Row, ...]


def ordered(result: FleetResult) -> list[UnitResult]:
    """The units, those with claims first, then the most unusual."""
    return sorted(result.units, key=lambda unit: (not unit.claims, -most_unusual(unit), unit.type, unit.unit))


def type_maps(result: FleetResult) -> list[TypeMap]:
    """A map of each type that has units."""
    by_type: dict[str, list[tuple[int, UnitResult]]] = {}
    for index, unit in enumerate(ordered(result)):
        by_type.setdefault(unit.type, []).append((index, unit))
    maps = []
    for k, kind in enumerate(result.types):
        places = _places(kind)
        rows = tuple(_row(unit, index, kind, places) for index, unit in by_type.get(kind.name, []))
        if rows:
            texts = tuple("arm" if place is None else f"J{place}" for place in places)
            titles = tuple("the whole arm" if place is None else f"joint {place}" for place in places)
            maps.append(TypeMap(kind.name, k, texts, titles, rows[:SHOWN], rows[SHOWN:]))
    return maps


def script_data(result: FleetResult) -> dict[str, Any]:
    """What the script is told, so that a cell can say what it shows and the map be made of one kind of
    effects: kinds; of each type the features; of each unit, in the order of the rows, how unusual and how
    much each feature is."""
    kinds = kinds_of(result)
    indices = {kind.name: k for k, kind in enumerate(result.types)}
    return {
        "shades": SHADES,
        "kinds": kinds,
        "types": [
            {
                "name": kind.name,
                "places": [place or 0 for place in _places(kind)],
                "features": [_feature(feature, kinds) for feature in kind.features],
            }
            for kind in result.types
        ],
        "units": [
            _unit(unit, indices[unit.type], result.types[indices[unit.type]].features)
            for unit in ordered(result)
        ],
    }


def kinds_of(result: FleetResult) -> list[str]:
    """The kinds of features that there are, in words, in the order in which the types have them."""
    every = [capital(effects_text(feature.effects)) for kind in result.types for feature in kind.features]
    return list(dict.fromkeys(every))


def furthest(values: Mapping[str, float], features: Sequence[Feature]) -> float | None:
    """The value of the feature that is furthest from usual, to a tenth; None where none is known."""
    known = [round(value, 1) for feature in features if is_known(value := values.get(feature.name))]
    return max(known, key=abs, default=None)


def shade_of(value: float | None) -> int:
    """The shade of a cell, with the sign of ``value``."""
    if not is_known(value):
        return 0
    steps = sum(abs(value) >= bound for bound in SHADES)
    return steps if value > 0 else -steps


def page_of(unit: UnitResult) -> str:
    """The address of the page of a unit."""
    return address(f"{unit_folder(unit.type, unit.unit)}/index.html")


def _places(kind: TypeResult) -> tuple[int | None, ...]:
    """The columns of a type: all its joints, and the whole arm (None) if there are features of it."""
    whole = any(feature.joint is None for feature in kind.features)
    return (*range(1, kind.joints + 1), *([None] if whole else []))


def _row(unit: UnitResult, index: int, kind: TypeResult, places: Sequence[int | None]) -> Row:
    named = {claim.joint for claim in unit.claims}
    by_place = {
        place: list(group)
        for place, group in groupby(
            sorted(kind.features, key=lambda feature: feature.joint or 0), key=lambda feature: feature.joint
        )
    }
    cells = []
    for place in places:
        value = furthest(unit.unusual, by_place.get(place, []))
        cells.append(Cell(unusual_text(value), shade_of(value), place in named))
    words = "; ".join(brief(claim) for claim in unit.claims)
    return Row(unit.unit, page_of(unit), index, tuple(cells), capital(words))


def _feature(feature: Feature, kinds: Sequence[str]) -> list[Any]:
    """Title, joint (0: the whole arm), kind, and what is usual."""
    title = capital(effects_text(feature.effects))
    usual = with_error(feature.mean, feature.between_units, feature.unit)
    return [title, feature.joint or 0, kinds.index(title), usual]


def _unit(unit: UnitResult, type: int, features: Sequence[Feature]) -> list[Any]:
    """Type, name, how unusual each feature is (tenths), how much it is, and which features are named."""
    unusual = [_tenths(unit.unusual.get(feature.name)) for feature in features]
    now = [_amount(unit.now.get(feature.name), feature.unit) for feature in features]
    named = [k for k, f in enumerate(features) if any(claim.feature == f.name for claim in unit.claims)]
    return [type, unit.unit, unusual, now, named]


def _tenths(value: float | None) -> int | None:
    return round(10 * value) if is_known(value) else None


def _amount(now: tuple[float, float] | None, unit: str) -> str:
    return with_unit(now[0], unit) if now is not None and is_known(now[0]) else ""
