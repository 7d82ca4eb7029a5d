"""From programs to files: one object makes the header and the source, the templates only place lines."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from robodyn.counts.count import count
from robodyn.emit import misra
from robodyn.emit.functions import c_function, fortran_function
from robodyn.emit.spelling import WIDTH, Spelling, c_spelling, fortran_spelling
from robodyn.emit.statements import statements
from robodyn.emit.trig import trig_context
from robodyn.emit.unit import ARRAYS, LANGUAGES, OF_LIBM, PURPOSES, Unit, calls, counted_text, has_sines
from robodyn.errors import InputError
from robodyn.resources import data_dir
from robodyn.robot.names import check_names

if TYPE_CHECKING:
    import jinja2


def render(unit: Unit, languages: Sequence[str] = LANGUAGES) -> dict[str, str]:
    """The files of ``unit`` in ``languages`` (``c``, ``fortran``): text by file name.

    Raises
    ------
    InputError: a number does not fit, or a name cannot be emitted.
    """
    check_names(unit.robot.name, unit.functions[0][0].parameters)
    try:
        return _render(unit, languages)
    except InputError as error:  # a number that does not fit
        raise InputError(
            f"{unit.robot.name}: {error.what}",
            found=error.found,
            expected=error.expected,
            remedy=error.remedy,
        ) from None


def _render(unit: Unit, languages: Sequence[str]) -> dict[str, str]:
    name = unit.robot.name
    bodies = [
        (
            signature,
            count(program),
            statements(program, in_order=unit.soon),
        )
        for signature, program in unit.functions
    ]
    files: dict[str, str] = {}
    if "c" in languages:
        context = _context(unit, [c_function(*body, unit) for body in bodies], "c")
        files[f"{name}.h"] = _template("c/kernel.h.j2").render(context)
        files[f"{name}.c"] = _template("c/kernel.c.j2").render(context)
    if "fortran" in languages:
        context = _context(unit, [fortran_function(*body, unit) for body in bodies], "fortran")
        files[f"{name}.f90"] = _template("fortran/kernel.f90.j2").render(context)
    return files


@cache
def environment() -> jinja2.Environment:
    """Where the templates of kernels are; what one of them asks for and is not given is an error."""
    import jinja2

    return jinja2.Environment(
        loader=jinja2.FileSystemLoader(data_dir("templates")),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,  # C and Fortran, not HTML; texts from files pass through comment
    )


def _template(name: str) -> jinja2.Template:
    return environment().get_template(name)


def _context(unit: Unit, functions: list[dict[str, Any]], language: str) -> dict[str, Any]:
    signature = unit.functions[0][0]
    single = signature.scalar == "float"
    if language == "c":
        trig = trig_context(c_spelling(single=single), f"const {unit.robot.name}_real ", ";")
    else:
        trig = trig_context(fortran_spelling(single=single))
    return {
        "name": unit.robot.name,
        "trig": trig if has_sines(unit) else None,
        "contraction": None if unit.contraction is None else unit.contraction.upper(),
        "math": not unit.builtin or bool(calls(unit) & OF_LIBM),
        "guard": f"{unit.robot.name.upper()}_H",
        "scalar": signature.scalar,
        "kind": "c_float" if single else "c_double",
        "parameters": signature.parameters,
        "states": _states(unit),
        "functions": functions,
        "head": _head(unit, language),
    }


def _head(unit: Unit, language: str) -> list[str]:
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
        say(f"  {array:4} {ARRAYS[array]}", "      ")
    if robot.torque_side == "link":
        say("Torques act behind the gear: rotor inertia and friction are not in them.")
    if unit.functions[0][0].parameters:
        say(f"Run-time parameters, in {robot.name}_params: {', '.join(unit.functions[0][0].parameters)}")
    if _states(unit):
        say(
            f"inverse_dynamics remembers: {robot.name}_state begins at zero and a call with dt = 0; then "
            "call it at every sample, dt > 0 [s] after the one before."
        )
    if unit.sc:
        say("sc, the sines and cosines that the functions read:")
        for k, text in enumerate(unit.sc):
            say(f"  sc[{k}] = {text}" if language == "c" else f"  sc({k + 1}) = {text}")
    for note in unit.notes:
        say(note)
    if unit.misra and language == "c":
        for note in misra.notes("builtin" if unit.builtin else "libm"):
            say(note)
    for note in unit.advice:
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
    """``text`` from a file, made harmless inside a comment of C, C++ or Fortran: ASCII, one line, no
    comment marks, no trigraphs, no line splice."""
    text = "".join(ch if " " <= ch <= "~" else ("?" if ch > " " else " ") for ch in text)
    text = text.replace("\\", "|")
    for mark in ("*/", "/*", "//", "??"):
        while mark in text:
            text = text.replace(mark, f"{mark[0]} {mark[1]}")
    return text


__all__ = ["ARRAYS", "LANGUAGES", "PURPOSES", "Spelling", "Unit", "render"]
