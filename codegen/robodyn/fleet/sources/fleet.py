"""A fleet: types of arms, and the logs of their units."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Final

#: The date of a log whose own times say it: it is known once the log has been read.
IN_LOG: Final = math.nan


@dataclass(frozen=True, slots=True)
class ArmType:
    """Arms that are built alike: ``spec`` is how their description was named (a path, or a bundled arm),
    ``text`` the description in YAML, ``mapping`` the text of the map by which their logs are read (None: by
    the usual names of columns)."""

    name: str
    spec: str
    text: str
    mapping: str | None = None


@dataclass(frozen=True, slots=True)
class LogFile:
    """A log: its ``source`` as logs are named (a path, or two joined by ``+``), of a ``unit`` of a ``type``;
    when it was recorded, ``date`` [s since 1970, UTC; :data:`IN_LOG`: its times say it]; ``conditions`` by
    name, such as a temperature."""

    source: str
    type: str
    unit: str
    date: float
    conditions: Mapping[str, float]

    @property
    def order(self) -> tuple[str, str, float, str]:
        """By what the logs of a fleet are sorted; one without a date comes last of its unit's."""
        return self.type, self.unit, math.inf if math.isnan(self.date) else self.date, self.source


@dataclass(frozen=True, slots=True)
class Fleet:
    """``types`` by name, and ``logs`` in the order of type, unit, date and source."""

    name: str
    types: Mapping[str, ArmType]
    logs: tuple[LogFile, ...]

    def completed(self, began: Mapping[str, float], conditions: Mapping[str, Mapping[str, float]]) -> Fleet:
        """This fleet with what only the logs themselves say, by their sources: when they ``began`` [s since
        1970], of those that have no date, and ``conditions`` that nothing else states. A log that says
        nothing of it keeps :data:`IN_LOG`."""
        logs = [
            replace(
                log,
                date=began.get(log.source, IN_LOG) if math.isnan(log.date) else log.date,
                conditions={**conditions.get(log.source, {}), **log.conditions},
            )
            for log in self.logs
        ]
        return replace(self, logs=tuple(sorted(logs, key=lambda log: log.order)))
