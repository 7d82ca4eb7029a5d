"""From programs to files: one object makes the header and the source, the templates only place lines."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

from robodyn.dynamics.functions import function_named
from robodyn.emit.body import body_lines
from robodyn.emit.head import comment, contained, head_lines
from robodyn.emit.language import FunctionText, Language
from robodyn.emit.languages import languages_named
from robodyn.emit.spelling import WIDTH
from robodyn.emit.stages import Repeated, repeated
from robodyn.emit.statements import Body, statements
from robodyn.emit.trig import builtin_context
from robodyn.emit.unit import Unit, counted, has_arctangents, has_sines
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
    chosen = languages_named(languages)
    check_names(unit.robot.name, unit.functions[0][0].parameters)
    every = [piece for signature, program in unit.functions for piece in _pieces(signature, program, unit)]
    files: dict[str, str] = {}
    try:
        for language in chosen:
            context = _context(unit, [_function_text(language, piece, unit) for piece in every], language)
            for file, template in language.files.items():
                text = environment().get_template(template).render(context)
                files[file.replace("NAME", unit.robot.name)] = text
    except InputError as error:  # a number that does not fit
        raise InputError(
            f"{unit.robot.name}: {error.what}",
            found=error.found,
            expected=error.expected,
            remedy=error.remedy,
        ) from None
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


def _context(unit: Unit, functions: list[dict[str, Any]], language: Language) -> dict[str, Any]:
    signature = unit.functions[0][0]
    syntax = language.syntax(signature, unit)
    return {
        "name": unit.robot.name,
        "scalar": signature.scalar,
        "parameters": signature.parameters,
        "states": unit.states,
        "functions": functions,
        "head": head_lines(unit, language),
        **builtin_context(syntax, sines=has_sines(unit), arctangents=has_arctangents(unit)),
        **language.context(unit),
    }


class _Piece(NamedTuple):
    """A function before it is written in a language: its statements, or the stages that it repeats one of;
    ``stage``: only another function calls it."""

    signature: Signature
    body: Body | Repeated
    purpose: str
    counted: str
    stage: bool = False


def _pieces(signature: Signature, program: Program, unit: Unit) -> Iterator[_Piece]:
    """The function, before it the stages that it consists of."""

    def body(program: Program) -> Body:
        return statements(
            program, in_order=unit.early_writes, readable=unit.readable, concise=not unit.readable
        )

    whole: Body | Repeated
    if program.iteration is None:
        whole = body(program)
    else:
        whole = repeated(signature, program)
        for each in (whole.start, whole.step, whole.finish):
            yield _Piece(each.signature, body(each.program), each.words, counted(each.program), True)
    yield _Piece(signature, whole, function_named(signature.function).purpose, counted(program))


def _function_text(language: Language, piece: _Piece, unit: Unit) -> dict[str, Any]:
    """``piece`` as ``language``'s templates place it.

    Raises
    ------
    InputError: it repeats a step, and the language has no such functions.
    """
    signature, body, purpose, counts, stage = piece
    syntax = language.syntax(signature, unit)
    if isinstance(body, Repeated):
        if language.repeating is None:
            raise InputError(
                f"{signature.symbol} repeats a step, and {language.title} is written without such functions",
                remedy=f"leave the function out, or {language.name} out of the languages (--lang)",
            )
        unused, lines = body.unread, language.repeating(body, syntax)
    else:
        joined = unit.builtin or language.joins_sines
        lines = body_lines(body, syntax, builtin=joined, lanes=unit.lanes, early_writes=unit.early_writes)
        read = {x.array for x in body.inputs if x.index is not None}
        unused = [array for array, _ in signature.inputs if array not in read]
        if signature.parameters and all(x.index is not None for x in body.inputs):
            unused.append("p")
        if signature.states and "dt" not in read:
            unused.append("dt")
    contains = "" if stage else contained(unit.robot, signature)
    return {
        "symbol": signature.symbol,
        "purpose": purpose,
        "contains": textwrap.wrap(contains, WIDTH, break_on_hyphens=False),
        "counted": textwrap.wrap(counts, WIDTH, break_on_hyphens=False),
        "unused": unused,
        "stage": stage,
        **language.function(FunctionText(signature, lines, unused, stage)),
    }
