"""A fleet: types of arms, as texts that any machine can do with, and the logs of their units."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from robodyn.errors import InputError
from robodyn.files import label, read_text
from robodyn.fleet.result import Unused
from robodyn.formats.loading import load, text_of
from robodyn.logs.mapping import SIZE, map_of_text
from robodyn.robot.coupling import no_couplings
from robodyn.robot.writer import to_yaml

#: The date of a log whose own times say it: it is known once the log has been read.
IN_LOG: Final = math.nan


@dataclass(frozen=True, slots=True)
class ArmType:
    """Arms that are built alike: ``spec`` is how their description was named (a path, or a bundled arm),
    ``text`` the description in YAML, ``mapping`` the text of the map by which their logs are read (None: by
    the usual names of columns), ``covariance`` that of a file with the covariance that the description names
    (None: it names none)."""

    name: str
    spec: str
    text: str
    mapping: str | None = None
    covariance: str | None = None


@dataclass(frozen=True, slots=True)
class LogFile:
    """A log: its ``source`` as logs are named (a path, or two joined by ``+``), of a ``unit`` of a ``type``;
    when it was recorded, ``date`` [s since 1970, UTC; :data:`IN_LOG`: its times say it]; ``conditions`` by
    name, such as a temperature; ``named``: the line of the manifest that names it, if one does."""

    source: str
    type: str
    unit: str
    date: float
    conditions: Mapping[str, float]
    named: str = ""

    @property
    def order(self) -> tuple[str, str, float, str]:
        """By what the logs of a fleet are sorted; one without a date comes last of its unit's."""
        return self.type, self.unit, math.inf if math.isnan(self.date) else self.date, self.source


@dataclass(frozen=True, slots=True)
class Fleet:
    """``types`` by name, and ``logs`` in the order of type, unit, date and source; ``missing``: logs that are
    named, but not there, and of which nothing says whose they are."""

    name: str
    types: Mapping[str, ArmType]
    logs: tuple[LogFile, ...]
    missing: tuple[Unused, ...] = ()

    def dated(self, began: Mapping[str, float]) -> Fleet:
        """This fleet with the dates that only the logs themselves say: when they ``began`` [s since 1970], by
        their sources. A log that says nothing of it keeps :data:`IN_LOG`."""
        logs = [
            replace(log, date=began.get(log.source, IN_LOG)) if math.isnan(log.date) else log
            for log in self.logs
        ]
        return replace(self, logs=tuple(sorted(logs, key=lambda log: log.order)))


def arm_type(
    name: str, spec: str, mapping: Path | None, parameters: Mapping[str, float] | None = None
) -> ArmType:
    """The type ``name`` of the arms that ``spec`` describes, with its run-time ``parameters`` at these
    values; its logs by the map in the file ``mapping``.

    Raises
    ------
    InputError: a file says what it may not; a parameter has no value.
    ToolError: a library for the description's format is missing.
    """
    robot = load(spec, warn=lambda _: None)  # whoever uses it says what is doubtful
    no_couplings(robot, "a fleet")
    text = text_of(spec)
    if robot.parameters or parameters:
        try:
            text = to_yaml(robot.at(parameters or {}))
        except InputError as error:
            error.remedy = "say them in the table of the type: parameters = {NAME = VALUE}"
            raise
    known = None
    if robot.covariance is not None:
        from robodyn.identify.known import covariance_text, with_covariance_read

        known = covariance_text(with_covariance_read(robot))
    if mapping is None:
        return ArmType(name, spec, text, covariance=known)
    columns = read_text(mapping, SIZE, "a map of logs, such as map.yaml")
    map_of_text(columns, label(mapping))
    return ArmType(name, spec, text, columns, known)
