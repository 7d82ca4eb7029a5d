"""A record is text from a file: it is used only where it means exactly what the recursion means."""

from __future__ import annotations

import hashlib
from collections.abc import Collection, Sequence

from robodyn.errors import InputError, Place
from robodyn.ir.evaluate import fingerprint, is_angle
from robodyn.ir.program import Input, Program
from robodyn.passes import Pass, run
from robodyn.records.record import Record
from robodyn.robot.values import circle_point

#: What the recursion must have, too, if a program is to have it: elsewhere it may have no value, as x / x has
#: none at 0.
_PARTIAL = frozenset(("div", "sqrt"))


def trusted(
    program: Program,
    recursion: Program,
    record: Record,
    passes: Sequence[Pass] = (),
    inputs: Collection[Input] = (),
) -> Program:
    """``program``, made of ``record``, after ``passes``, if it computes what ``recursion`` does (in
    GF(2^61 - 1)).

    ``inputs`` are those that the function has, read by the recursion or not. The points at which the two are
    compared depend on the record's text: nobody can write one that is right at these points only.

    Raises
    ------
    InputError: it does not, or cannot be compared.
    """
    try:
        made = run(program, passes) if passes else program
        if (
            _angles_only(program)
            and _comparable(made, recursion, {*recursion.inputs(), *inputs})
            and _same(made, recursion, record)
        ):
            return made
    except (ValueError, ZeroDivisionError):  # a division by what is zero
        pass
    raise InputError(
        f"the record of {record.robot} does not compute its {record.function}",
        where=Place(record.file) if record.file is not None else None,
        found="a program that differs from the recursion",
        remedy="delete the record, or make it anew: robodyn gen --optimize full",
    )


def _angles_only(program: Program) -> bool:
    """Whether every sine is of an angle: of anything else it would only be a random function here."""
    return all(is_angle(program, op.args[0]) for op in program.operations if op.op in ("sin", "cos"))


def _comparable(program: Program, recursion: Program, known: set[Input]) -> bool:
    def interface(p: Program) -> list[tuple[str, int]]:
        return [(name, len(elements)) for name, elements in p.outputs]

    def partial(p: Program) -> set[str]:
        return {operation.op for operation in p.operations} & _PARTIAL

    return (
        interface(program) == interface(recursion)
        and known.issuperset(program.inputs())
        and partial(program) <= partial(recursion)
    )


def _same(program: Program, recursion: Program, record: Record) -> bool:
    digest = hashlib.blake2b(record.text().encode(), digest_size=16).digest()
    seeds = (int.from_bytes(digest[:8], "little"), int.from_bytes(digest[8:], "little"))
    return all(
        fingerprint(program, seed, circle_point) == fingerprint(recursion, seed, circle_point)
        for seed in seeds
    )
