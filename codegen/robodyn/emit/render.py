"""From programs to files: one object makes the header and the source, the templates only place lines."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

from robodyn.dynamics.functions import function_named
from robodyn.emit.body import Lines, body_lines
from robodyn.emit.head import comment, contained, head_lines, state_members
from robodyn.emit.language import FunctionText, Language
from robodyn.emit.languages import defaults, languages_named
from robodyn.emit.spelling import WIDTH
from robodyn.emit.stages import Repeated, repeated
from robodyn.emit.statements import Body, statements
from robodyn.emit.unit import Unit, counted
from robodyn.errors import InputError
from robodyn.ir.program import Program
from robodyn.ir.signature import Signature
from robodyn.resources import data_dir
from robodyn.robot.names import check_names

if TYPE_CHECKING:
    import jinja2


def render(unit: Unit, languages: Sequence[str] | None = None) -> dict[str, str]:
    """The files of ``unit`` in ``languages`` (default: those that are written unless others are asked for):
    text by file name.

    Raises
    ------
    InputError: a number does not fit, a name cannot be emitted, or there is no such language.
    """
    chosen = languages_named(defaults() if languages is None else languages)
    check_names(unit.robot.name, unit.functions[0][0].parameters)
    try:
        return _render(unit, chosen)
    except InputError as error:  # a number that does not fit
        raise InputError(
            f"{unit.robot.name}: {error.what}",
            found=error.found,
            expected=error.expected,
            remedy=error.remedy,
        ) from None


def _render(unit: Unit, languages: Sequence[Language]) -> dict[str, str]:
    every = [piece for signature, program in unit.functions for piece in pieces(signature, program, unit)]
    files: dict[str, str] = {}
    for language in languages:
        functions = [function_text(language, piece, unit) for piece in every]
        context = _context(unit, functions, language)
        for file, template in language.files.items():
            files[file.replace("NAME", unit.robot.name)] = _template(template).render(context)
    return files


@cache
def environment() -> jinja2.Environment:
    """Where the templates of kernels are; what one of them asks for and is not given is an error."""
    import jinja2

    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(data_dir("templates")),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,  # code, not HTML; texts from files pass through comment
    )
    environment.filters["comment"] = comment
    environment.filters["sentence"] = lambda text: text[:1].upper() + text[1:] + "."
    return environment


def _template(name: str) -> jinja2.Template:
    return environment().get_template(name)


def _context(unit: Unit, functions: list[dict[str, Any]], language: Language) -> dict[str, Any]:
    signature = unit.functions[0][0]
    own = language.context(unit)
    return {
        "name": unit.robot.name,
        "scalar": signature.scalar,
        "parameters": signature.parameters,
        "states": state_members(unit),
        "functions": functions,
        "head": head_lines(unit, language),
        **own,
        "trig": own.get("trig"),
        "arctangent": own.get("arctangent"),
    }


__all__ = ["Unit", "comment", "render"]


@dataclass(frozen=True, slots=True)
class Piece:
    """A function before it is written in a language: its statements, or the stages that it repeats one of;
    ``stage``: only another function calls it."""

    signature: Signature
    body: Body | Repeated
    purpose: str
    counted: str
    stage: bool = False


def pieces(signature: Signature, program: Program, unit: Unit) -> tuple[Piece, ...]:
    """The function, before it the stages that it consists of."""

    def body(program: Program) -> Body:
        return statements(
            program, in_order=unit.early_writes, readable=unit.readable, concise=not unit.readable
        )

    purpose, words = function_named(signature.function).purpose, counted(program)
    if program.iteration is None:
        return (Piece(signature, body(program), purpose, words),)
    whole = repeated(signature, program)
    stages = (
        Piece(each.signature, body(each.program), each.words, counted(each.program), True)
        for each in whole.stages
    )
    return (*stages, Piece(signature, whole, purpose, words))


def function_text(language: Language, piece: Piece, unit: Unit) -> dict[str, Any]:
    """``piece`` as ``language``'s templates place it."""
    signature, body = piece.signature, piece.body
    if isinstance(body, Repeated):
        unused, rereads = body.unread, False
        lines = _repeating(language, body)
    else:
        syntax = language.syntax(signature, unit)
        lines = body_lines(
            body, syntax, builtin=unit.builtin, lanes=unit.lanes, early_writes=unit.early_writes
        )
        read = body.arrays
        unused = [array for array, _ in signature.inputs if array not in read]
        if signature.parameters and not body.reads_parameters:
            unused.append("p")
        if signature.states and "dt" not in read:
            unused.append("dt")
        rereads = not unit.builtin and any(syntax.rereads(s.expression) for s in body.statements)
    return {
        "symbol": signature.symbol,
        "purpose": piece.purpose,
        "contains": textwrap.wrap(
            "" if piece.stage else _contains(signature, unit), WIDTH, break_on_hyphens=False
        ),
        "counted": textwrap.wrap(piece.counted, WIDTH, break_on_hyphens=False),
        "unused": unused,
        "stage": piece.stage,
        **language.function(FunctionText(signature, unit, lines, tuple(unused), rereads, piece.stage)),
    }


def _repeating(language: Language, body: Repeated) -> Lines:
    """The lines of a function that repeats a step.

    Raises
    ------
    InputError: the language has no such functions.
    """
    if language.repeating is None:
        raise InputError(
            f"{body.whole.symbol} repeats a step, and {language.title} is written without such functions",
            remedy=f"leave the function out, or {language.name} out of the languages (--lang)",
        )
    return language.repeating(body)


def _contains(signature: Signature, unit: Unit) -> str:
    """What of the drives is in a function's torques; empty if nothing is."""
    function = function_named(signature.function)
    taken = {array.name for array in function.inputs}
    drives: tuple[str, ...] = ()
    if "qd" in taken:
        accelerated = "qdd" in taken or function.solves
        drives = contained(unit.robot, accelerated=accelerated, remembers=bool(signature.states))
    return f"with {', '.join(drives)}" if drives else ""
