"""A record is text from a file: it is used only where it means exactly what the recursion means, and is as
good as the recursion in the arithmetic of a machine.

Records of other robots that compute the same function are taken too: the same arm in other frames, as
imported, also but for friction and rotors. What they add to a torque or to a mass matrix is the function of
an arm whose links have no mass, and is put on top of the record of the arm without them.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from robodyn.errors import InputError, Place
from robodyn.ir.digits import TooManyDigits
from robodyn.ir.evaluate import is_angle
from robodyn.ir.field import Field
from robodyn.ir.fingerprint import agree, constants, digest, fingerprint, in_drawn_field
from robodyn.ir.graph import Graph
from robodyn.ir.lowering import lower
from robodyn.ir.program import Input, Program
from robodyn.optimize.programs import Choice, build
from robodyn.optimize.records.find import record_at, records_with_keys
from robodyn.optimize.records.record import Record, function_key, labelled
from robodyn.optimize.records.rounding import Rounding
from robodyn.passes import Pass, unchecked
from robodyn.passes.specialise import at_rest
from robodyn.robot.identity import identity
from robodyn.robot.model import Inertia, Robot
from robodyn.robot.values import ZERO, circle_point

#: Operations that have a value everywhere, and whose rounding is bounded by magnitudes. All others must have
#: the arguments that they have in the recursion: x / x has no value at 0, 0 times the root of -1 is none.
_EVERYWHERE = frozenset(("add", "sub", "mul", "neg", "sin", "cos"))
#: So many times the recursion's operations, and so many more, a record may have: it is here to have fewer.
_TIMES, _MORE = 2, 100
#: The same for the digits of all constants: those that searches find have about as many as the recursion.
_DIGITS_TIMES, _DIGITS_MORE = 4, 4000
#: What is found in records that are refused.
_READING = "inputs that are read otherwise than by the recursion, or in a higher degree"
_LONG_PRODUCTS = "constants whose products have too many digits"


def validated(
    program: Program,
    recursion: Program,
    record: Record,
    passes: Sequence[Pass] = (),
    inputs: Collection[Input] = (),
    rounding: Rounding | None = None,
) -> Program:
    """``program``, made of ``record``, after ``passes``, if it computes what ``recursion`` does, and about as
    precisely.

    How it reads its inputs is for :func:`check_reading`, before all else. ``inputs`` are those that the
    function has, read by the recursion or not. ``rounding`` is that of the recursion of the record's own
    function, where ``program`` was made for another one.
    Field and point of the comparison are drawn from the programs: whoever writes a record changes them with
    every digit.

    Raises
    ------
    InputError: it does not, or cannot be compared.
    """
    # A sine of what is no angle would only be a random function here.
    comparable = all(is_angle(program, op.args[0]) for op in program.operations if op.op in ("sin", "cos"))
    comparable = comparable and {*recursion.inputs(), *inputs}.issuperset(program.inputs())
    ours, theirs = ([(name, len(elements)) for name, elements in p.outputs] for p in (program, recursion))
    try:
        if comparable and ours == theirs:
            rebuilt, prime = unchecked(program, passes), digest(record.program)
            equal = agree(rebuilt, recursion, circle_point, prime_of=prime)
            if equal and _same_arguments(rebuilt, recursion):
                if (rounding or Rounding(recursion)).allows(rebuilt):
                    return rebuilt
                raise _refused(record, "a program that loses too many digits to rounding")
    except TooManyDigits:
        raise _refused(record, _LONG_PRODUCTS) from None
    except (ValueError, ZeroDivisionError):  # a division by what is zero
        pass
    raise _refused(record, "a program that differs from the recursion")


def at_rest_of(record: Record, function: str) -> Program:
    """``gravity`` or ``bias`` by the program of ``record``, which computes the inverse dynamics.

    Raises
    ------
    InputError: its constants have products that nobody waits for.
    """
    try:
        return at_rest(record.program, function)
    except TooManyDigits:
        raise _refused(record, _LONG_PRODUCTS) from None


def check_reading(record: Record, rounding: Rounding) -> None:
    """:class:`InputError` where ``record`` reads inputs otherwise than the recursion of its function, whose
    ``rounding`` is given, or in a higher degree."""
    if not rounding.reads_as(record.program):
        raise _refused(record, _READING)


def check_length(record: Record, recursion: Program) -> None:
    """:class:`InputError` where ``record`` has far more operations or digits than ``recursion``, of the same
    function: then nothing else is looked at, which would take long."""
    own, others = len(record.program.operations), len(recursion.operations)
    if own > _TIMES * others + _MORE:
        raise _refused(record, f"{own} operations, where the recursion has {others}")
    digits, usual = _digits(record.program), _digits(recursion)
    if digits > _DIGITS_TIMES * usual + _DIGITS_MORE:
        raise _refused(
            record, f"constants of {digits} digits in all, where those of the recursion have {usual}"
        )


def _digits(program: Program) -> int:
    """How many decimal digits the constants have, about."""
    bits = sum(x.numerator.bit_length() + x.denominator.bit_length() for x in constants(program))
    return bits * 3 // 10


def _refused(record: Record, reason: str) -> InputError:
    return InputError(
        f"the record of {record.robot} does not compute its {record.function}",
        where=Place(record.file) if record.file is not None else None,
        found=reason,
        remedy="delete the record, or make it anew: robodyn gen --optimize full",
    )


def _same_arguments(program: Program, recursion: Program) -> bool:
    """Whether divisors, and arguments of roots, signs and the like, are those of the recursion."""
    if all(op.op in _EVERYWHERE for op in program.operations):
        return True

    def subset(field: Field) -> bool:
        return _arguments(program, field) <= _arguments(recursion, field)

    return bool(in_drawn_field(subset, digest(program), digest(recursion), b"arguments"))


def _arguments(program: Program, field: Field) -> set[tuple[str, tuple[int, ...]]]:
    """What operations that are not :data:`_EVERYWHERE` are of, up to sign, at a random point of ``field``."""
    partial = [op for op in program.operations if op.op not in _EVERYWHERE]
    of = [op.args[1:] if op.op == "div" else op.args for op in partial]
    outputs = tuple((str(k), args) for k, args in enumerate(of))
    values = iter(fingerprint(replace(program, outputs=outputs, origin=None), field, circle_point))
    result = set()
    for op, args in zip(partial, of, strict=True):
        here = [next(values) for _ in args]
        result.add((op.op, tuple(min(value, field.prime - value) for value in here)))
    return result


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
