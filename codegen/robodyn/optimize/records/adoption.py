"""Records of other robots that compute the same function: the same arm in other frames, as imported."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from robodyn.errors import InputError
from robodyn.ir.program import Program
from robodyn.optimize.records.find import record_at, records_with_keys
from robodyn.optimize.records.function_key import function_key
from robodyn.optimize.records.labels import labelled
from robodyn.optimize.records.record import Record
from robodyn.optimize.records.rounding import Rounding
from robodyn.optimize.records.validation import check_length, check_reading, validated
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot


def adopted(
    robot: Robot,
    function: str,
    recursion_of: Callable[[str], Program],
    rounding_of: Callable[[str], Rounding],
    objective: str = "total",
    folders: Sequence[Path] = (),
) -> Record | None:
    """The first record of any robot that computes ``function`` of ``robot``, as a record of ``robot``; None
    where there is none.

    ``recursion_of`` has the program of a function, ``rounding_of`` what that loses; neither is asked where no
    record of the function states its key. A record that is found by its key and does not pass what every
    record must pass is passed over: it belongs to another robot.
    """
    records = list(records_with_keys(robot, function, objective, folders))
    if not records:
        return None
    key = function_key(recursion_of(function))
    for path in (path for computes, path in records if computes == key):
        try:
            record = record_at(path)
            check_length(record, recursion_of(function))
            check_reading(record, rounding_of(function))
            validated(record.program, recursion_of(function), record, rounding=rounding_of(function))
        except InputError:
            continue
        return replace(
            record,
            robot=robot.name,
            identity=identity(robot),
            origin=f"{record.origin}, for {record.robot}",
            program=labelled(record.program, recursion_of(function)),
        )
    return None
