"""From programs to files: one object makes the header and the source, the templates only place lines."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from robodyn.counts.count import count
from robodyn.dynamics.functions import array_named
from robodyn.emit.functions import function_text
from robodyn.emit.language import Language
from robodyn.emit.languages import defaults, languages_named
from robodyn.emit.spelling import WIDTH
from robodyn.emit.statements import statements
from robodyn.emit.unit import Unit, counted_text, has_sines
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
    bodies = [
        (signature, count(program), statements(program, in_order=unit.soon))
        for signature, program in unit.functions
    ]
    files: dict[str, str] = {}
    for language in languages:
        functions = [function_text(language, *body, unit) for body in bodies]
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
        "states": _states(unit),
        "functions": functions,
        "head": _head(unit, language),
        **own,
        "trig": own["trig"] if has_sines(unit) else None,
    }


def _head(unit: Unit, language: Language) -> list[str]:
    """The comment at the top: what this is, units, argument order, counts by kind."""
    robot = unit.robot
    width = WIDTH - 4
    lines: list[str] = []

    def say(text: str, indent: str = "", *, hyphens: bool = True) -> None:
        told = textwrap.wrap(comment(text), width, subsequent_indent=indent + "  ", break_on_hyphens=hyphens)
        lines.extend(told or [""])

    say(f"{robot.name}: {robot.title or 'a serial arm'}")
    if robot.source:
        say(f"Numbers: {robot.source}")
    say("Written by robodyn; do not edit, generate again.")
    lines.append("")
    say(
        "Joints, base to tip: " + ", ".join(f"{i} {link.joint.kind}" for i, link in enumerate(robot.links, 1))
    )
    say(f"Gravity in the base frame: {', '.join(repr(float(g)) for g in robot.gravity)} m/s^2")
    say("Arguments, in SI units, joint 1 first:")
    arrays = dict.fromkeys(a for s, _ in unit.functions for a, _ in (*s.inputs, *s.outputs))
    for array in arrays:
        say(f"  {array:4} {array_named(array).text}", "      ")
    if robot.torque_side == "link":
        say("Torques act behind the gear: rotor inertia and friction are not in them.")
    parameters = unit.functions[0][0].parameters
    if parameters:
        struct = language.type_name(robot.name, "params")
        say(f"Run-time parameters, in {struct}: {', '.join(parameters)}")
    if _states(unit):
        struct = language.type_name(robot.name, "state")
        say(
            f"inverse_dynamics remembers: {struct} begins at zero and a call with dt = 0; then "
            "call it at every sample, dt > 0 [s] after the one before."
        )
    if unit.sc:
        say("sc, the sines and cosines that the functions read:")
        spelling = language.spelling(unit.functions[0][0].scalar == "float")
        for k, text in enumerate(unit.sc):
            say(f"  {spelling.element('sc', k)} = {text}")
    for note in (*unit.notes, *language.notes(unit)):
        say(note)
    for note in language.advice(unit):
        say(note, hyphens=False)
    lines.append("")
    say("Operations (every binary * is a multiplication, every binary + or - an addition):")
    for signature, program in unit.functions:
        say(f"  {signature.function}: {counted_text(count(program))}", "    ")
    return lines


def _states(unit: Unit) -> tuple[str, ...]:
    """Members of the state struct of ``unit``, if a function has one."""
    return next((signature.states for signature, _ in unit.functions if signature.states), ())


def comment(text: str) -> str:
    """``text`` from a file, made harmless inside a comment of any language: ASCII, one line, no
    comment marks, no trigraphs, no line splice."""
    text = "".join(ch if " " <= ch <= "~" else ("?" if ch > " " else " ") for ch in text)
    text = text.replace("\\", "|")
    for mark in ("*/", "/*", "//", "??"):
        while mark in text:
            text = text.replace(mark, f"{mark[0]} {mark[1]}")
    return text


__all__ = ["Unit", "render"]
