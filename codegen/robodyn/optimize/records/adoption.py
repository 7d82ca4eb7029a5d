"""Records of other robots that compute the same function: the same arm in other frames, as imported.

Also but for friction and rotors: what they add to a torque or to a mass matrix is the function of an arm
whose links have no mass, and is put on top of the record of the arm without them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from robodyn.errors import InputError
from robodyn.ir.graph import Graph
from robodyn.ir.lowering import lower
from robodyn.ir.program import Program
from robodyn.optimize.programs import Choice, build
from robodyn.optimize.records.find import record_at, records_with_keys
from robodyn.optimize.records.record import Record, function_key, labelled
from robodyn.optimize.records.rounding import Rounding
from robodyn.optimize.records.validation import check_length, check_reading, validated
from robodyn.robot.identity import identity
from robodyn.robot.model import Inertia, Robot
from robodyn.robot.values import ZERO


def adopted(
    robot: Robot,
    function: str,
    recursion_of: Callable[[str], Program],
    rounding_of: Callable[[str], Rounding],
    objective: str = "total",
    folders: Sequence[Path] = (),
) -> Record | None:
    """The first record of any robot that computes ``function`` of ``robot``, or does with what the joints of
    ``robot`` add to it, as a record of ``robot``; None where there is none.

    ``recursion_of`` has the program of a function, ``rounding_of`` what that loses; neither is asked where no
    record of the function states its key. A record that is found by its key and does not pass what every
    record must pass is passed over: it belongs to another robot.
    """
    records = list(records_with_keys(robot, function, objective, folders))
    if not records:
        return None
    recursion = recursion_of(function)
    for words, joints in _of_joints(robot, function):
        key = function_key(recursion, joints)
        for path in (path for computes, path in records if computes == key):
            try:
                record = record_at(path)
                if joints is not None:
                    record = replace(record, program=summed(record.program, joints))
                check_length(record, recursion)
                check_reading(record, rounding_of(function))
                validated(record.program, recursion, record, rounding=rounding_of(function))
            except InputError:
                continue
            return replace(
                record,
                robot=robot.name,
                identity=identity(robot),
                origin=f"{record.origin}, for {record.robot}{words}",
                program=labelled(record.program, recursion),
            )
    return None


def _of_joints(robot: Robot, function: str) -> Iterator[tuple[str, Program | None]]:
    """What may be put on top of a record, and what to say of it: nothing, friction, friction and rotors."""
    yield "", None
    joints = [link.joint for link in robot.links]
    friction = any(joint.viscous or joint.coulomb for joint in joints)
    if friction:
        yield ", with friction", build(joints_of(robot), function, Choice())
    if any(joint.motor_inertia for joint in joints):
        words = ", with friction and rotors" if friction else ", with rotors"
        yield words, build(joints_of(robot, rotors=True), function, Choice())


def joints_of(robot: Robot, *, rotors: bool = False) -> Robot:
    """``robot`` with its friction, with its rotors if asked for, and nothing else that needs a torque."""
    links = [
        replace(
            link,
            mass=ZERO,
            com=(ZERO, ZERO, ZERO),
            inertia=Inertia(),
            joint=link.joint if rotors else replace(link.joint, motor_inertia=ZERO),
        )
        for link in robot.links
    ]
    return replace(robot, links=tuple(links), effects=())


def frictionless(robot: Robot) -> Robot:
    """``robot`` without viscous and Coulomb friction."""
    links = [replace(link, joint=replace(link.joint, viscous=ZERO, coulomb=ZERO)) for link in robot.links]
    return replace(robot, links=tuple(links))


def summed(one: Program, other: Program) -> Program:
    """The program of both, output by output."""
    graph = Graph()
    values = [x + y for x, y in zip(graph.replay(one), graph.replay(other), strict=True)]
    outputs: list[tuple[str, list[Any]]] = []
    for name, elements in one.outputs:
        outputs.append((name, values[: len(elements)]))
        values = values[len(elements) :]
    return lower(graph, outputs)
