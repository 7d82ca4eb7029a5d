"""A type of arms: its description, and the map of its logs, as texts that any machine can do with."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from robodyn.errors import InputError, Place
from robodyn.files import label, read_text
from robodyn.fleet.sources.fleet import ArmType
from robodyn.formats.loading import load, text_of
from robodyn.logs.map_text import map_text
from robodyn.logs.mapping import SIZE, map_of_columns, map_of_text
from robodyn.robot.writer import to_yaml


def arm_type(
    name: str,
    spec: str,
    map_path: Path | None,
    columns: str | None,
    parameters: Mapping[str, float],
    place: Callable[[str], Place],
) -> ArmType:
    """The type ``name`` of the arms that ``spec`` describes, with its run-time ``parameters`` at these
    values; its logs by the map at ``map_path``, or by ``columns`` in one line. ``place``: where a key of it
    is stated.

    Raises
    ------
    InputError: a file is not there, or says what it may not; a parameter has no value.
    ToolError: a library for the description's format is missing.
    """
    robot = load(spec, warn=lambda _: None)  # whoever uses it says what is doubtful
    if robot.parameters or parameters:
        try:
            text = to_yaml(robot.at(parameters))
        except InputError as error:
            raise InputError(
                error.what,
                where=place("parameters"),
                found=error.found,
                expected=error.expected,
                remedy="say them in the table of the type: parameters = {NAME = VALUE}",
            ) from None
    else:
        text = text_of(spec)
    mapping = None
    if map_path is not None:
        if not map_path.is_file():
            raise InputError(
                "there is no such map",
                where=place("map"),
                found=label(map_path),
                expected="a path, as seen from this file's folder",
            )
        mapping = read_text(map_path, SIZE, "a map of logs, such as map.yaml")
        map_of_text(mapping, label(map_path))
    elif columns is not None:
        try:
            mapping = map_text(map_of_columns(columns), {})
        except InputError as error:
            raise error.at(place("columns")) from None
    return ArmType(name, spec, text, mapping)
