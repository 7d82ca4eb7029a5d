"""From programs to files: one object makes the header and the source, the templates only place lines."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from robodyn.emit.functions import function_text, pieces
from robodyn.emit.head import comment, head_lines, state_members
from robodyn.emit.language import Language
from robodyn.emit.languages import defaults, languages_named
from robodyn.emit.unit import Unit
from robodyn.errors import InputError
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
