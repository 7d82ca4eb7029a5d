"""From programs to files: one object makes the header and the source, the templates only place lines."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import TYPE_CHECKING, Any

from robodyn.counts.count import Count, count
from robodyn.emit import misra
from robodyn.emit.body import Lines, Said, body_lines, inputs_read
from robodyn.emit.results import Result
from robodyn.emit.sines import COSINES, SINES, c_sines, fortran_sines
from robodyn.emit.spelling import WIDTH, Spelling, c_spelling, fortran_spelling
from robodyn.emit.statements import Apply, Body, Expression, Statement, statements
from robodyn.emit.trig import trig_context
from robodyn.errors import InputError
from robodyn.ir.program import Program
from robodyn.ir.signature import Signature
from robodyn.resources import data_dir
from robodyn.robot.model import Robot

if TYPE_CHECKING:
    import jinja2

LANGUAGES = ("c", "fortran")

#: What an array of an interface holds; the unit at prismatic joints stands in brackets.
ARRAYS: dict[str, str] = {
    "q": "joint positions [rad, prismatic m]",
    "qd": "joint velocities [rad/s, prismatic m/s]",
    "qdd": "joint accelerations [rad/s^2, prismatic m/s^2]",
    "tau": "joint torques [N m, prismatic N]",
    "M": "mass matrix, row by row [kg m^2, kg m, kg]",
    "sc": "sines and cosines, as listed below",
}

PURPOSES: dict[str, str] = {
    "inverse_dynamics": "torques that give the accelerations qdd",
    "gravity": "torques that hold the arm at rest",
    "bias": "torques at zero acceleration: Coriolis, centrifugal, gravity, friction",
    "mass_matrix": "mass matrix, rotor inertias on its diagonal",
    "forward_dynamics": "accelerations that the torques tau give",
}


@dataclass(frozen=True, slots=True)
class Unit:
    """What goes into one header and one source: a robot's functions with their programs.

    ``sc`` describes the elements of the array of given sines and cosines, if there is one; ``notes``
    are lines for the head of the file; ``misra``: C with products within sums in parentheses.
    ``builtin``: with our own sine and cosine, those of ``lanes`` angles at a time. ``soon``: results are
    written as soon as they are there. ``contraction``, on or off, stands in a pragma; ``advice`` is for the
    head too, with flags of compilers.
    """

    robot: Robot
    functions: tuple[tuple[Signature, Program], ...]
    sc: tuple[str, ...] = ()
    notes: tuple[str, ...] = field(default=())
    misra: bool = False
    builtin: bool = False
    lanes: int = 4
    soon: bool = False
    contraction: str | None = None
    advice: tuple[str, ...] = ()


def render(unit: Unit, languages: Sequence[str] = LANGUAGES) -> dict[str, str]:
    """The files of ``unit`` in ``languages`` (``c``, ``fortran``): text by file name."""
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
        context = _context(unit, [_c_function(*body, unit) for body in bodies], "c")
        files[f"{name}.h"] = _template("c/kernel.h.j2").render(context)
        files[f"{name}.c"] = _template("c/kernel.c.j2").render(context)
    if "fortran" in languages:
        context = _context(unit, [_fortran_function(*body, unit) for body in bodies], "fortran")
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
        "math": not unit.builtin or bool(_calls(unit) & _OF_LIBM),
        "guard": f"{unit.robot.name.upper()}_H",
        "scalar": signature.scalar,
        "kind": "c_float" if single else "c_double",
        "parameters": signature.parameters,
        "states": _states(unit),
        "functions": functions,
        "head": _head(unit, language),
    }


#: What is libm's, whoever makes the sines.
_OF_LIBM = frozenset({"tanh", "sqrt", "abs", "exp", "pow"})


def _calls(unit: Unit) -> set[str]:
    """The operations of all functions."""
    return {operation.op for _, program in unit.functions for operation in program.operations}


def has_sines(unit: Unit) -> bool:
    """Whether a function of ``unit`` calls our own sine and cosine."""
    return unit.builtin and any(count(program).sincos for _, program in unit.functions)


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
        say(f"  {signature.function}: {_counted(count(program))}", "    ")
    return lines


def _states(unit: Unit) -> tuple[str, ...]:
    """Members of the state struct of ``unit``, if a function has one."""
    return next((signature.states for signature, _ in unit.functions if signature.states), ())


def _counted(found: Count) -> str:
    parts = [str(found), f"{found.neg} unary minus", f"{found.sincos} sine/cosine"]
    if found.other:
        parts.append(f"{found.other} other calls")
    return "; ".join(parts)


def comment(text: str) -> str:
    """``text`` from a file, made harmless inside a comment of C, C++ or Fortran: ASCII, one line, no
    comment marks, no trigraphs, no line splice."""
    text = "".join(ch if " " <= ch <= "~" else ("?" if ch > " " else " ") for ch in text)
    text = text.replace("\\", "|")
    for mark in ("*/", "/*", "//", "??"):
        while mark in text:
            text = text.replace(mark, f"{mark[0]} {mark[1]}")
    return text


def _c_function(signature: Signature, counted: Count, body: Body, unit: Unit) -> dict[str, Any]:
    spelling = c_spelling(single=signature.scalar == "float", states=signature.states, explicit=unit.misra)
    real = f"{signature.robot}_real"
    arguments = [f"const {real} {array}[{size}]" for array, size in signature.inputs]
    arguments += [f"{real} {array}[{size}]" for array, size in signature.outputs]
    if signature.parameters:
        arguments.append(f"const {signature.robot}_params *p")
    if signature.states:
        arguments += [f"{signature.robot}_state *state", f"{real} dt"]

    def second_read(argument: Expression) -> str:
        if isinstance(argument, str):
            return argument
        text = spelling.text(argument)
        return text.replace("q[", "again[", 1)

    reads_angle = not unit.builtin and any(_sine_of_input(s.expression) for s in body.statements)

    def declared(statement: Statement) -> list[str]:
        kind = f"const volatile {real}" if statement.angle and not unit.builtin else f"const {real}"
        text = f"{kind} {statement.name} = {spelling.text(statement.expression, second_read)};"
        return spelling.wrapped(text, "    ")

    def written(result: Result) -> list[str]:
        element = spelling.element(result.array, result.place)
        return spelling.wrapped(f"{element} = {spelling.text(result.expression)};", "    ")

    said = Said("/* %s */", declared, written, c_sines(signature.robot, spelling))
    lines = body_lines(body, said, builtin=unit.builtin, lanes=unit.lanes, soon=unit.soon)
    read = inputs_read(body)
    unused = [array for array, _ in signature.inputs if array not in read]
    if signature.parameters and not any(name in read for name in signature.parameters):
        unused.append("p")
    if signature.states and "dt" not in read:
        unused.append("dt")
    return {
        "symbol": signature.symbol,
        "arguments": arguments,
        "prototype": _prototype(f"void {signature.symbol}(", arguments),
        "purpose": PURPOSES[signature.function],
        "counted": textwrap.wrap(_counted(counted), WIDTH, break_on_hyphens=False),
        "lines": lines.statements,
        "results": lines.results,
        "unused": unused,
        "again": reads_angle,
        "inner": _inner(signature, lines, arguments) if lines.angles else None,
    }


def _inner(signature: Signature, lines: Lines, arguments: list[str]) -> dict[str, Any]:
    """The part of a function that is given sines and cosines: what it is called with, and how."""
    passed = [array for array in (SINES, COSINES) if array in lines.reads]
    taken = [f"const {signature.robot}_real {array}[{lines.arrays[array]}]" for array in passed]
    outputs = {array for array, _ in signature.outputs}
    for argument in arguments:
        name = argument.split()[-1].lstrip("*").partition("[")[0]
        is_parameters = argument.endswith("_params *p")
        read = lines.parameters if is_parameters else name in lines.reads | outputs
        if read or name == "state":
            taken.append(argument)
            passed.append(name)
    symbol = f"{signature.symbol}_given_"
    return {
        "prototype": _prototype(f"{signature.robot}_APART_ void {symbol}(", taken),
        "angles": lines.angles,
        "call": f"{symbol}({', '.join(passed)});",
    }


def _prototype(head: str, arguments: list[str]) -> str:
    """``head`` with its arguments, without the closing parenthesis, in lines of moderate length."""
    line = head + ", ".join(arguments)
    if len(line) < WIDTH - 2:
        return line
    return head + (",\n" + " " * 4).join(["\n    " + arguments[0], *arguments[1:]])


def _fortran_function(signature: Signature, counted: Count, body: Body, unit: Unit) -> dict[str, Any]:
    spelling = fortran_spelling(single=signature.scalar == "float", states=signature.states)

    def assigned(statement: Statement) -> list[str]:
        return spelling.wrapped(f"{statement.name} = {spelling.text(statement.expression)}", "    ")

    def written(result: Result) -> list[str]:
        element = spelling.element(result.array, result.place)
        return spelling.wrapped(f"{element} = {spelling.text(result.expression)}", "    ")

    said = Said("! %s", assigned, written, fortran_sines(signature.robot, spelling))
    lines = body_lines(body, said, builtin=unit.builtin, lanes=unit.lanes, soon=unit.soon)
    names = [*lines.names, *(f"{array}({size})" for array, size in lines.arrays.items())]
    locals_ = [line.rstrip(",") for line in textwrap.wrap(", ".join(names), WIDTH - 16)]
    arguments = [array for array, _ in (*signature.inputs, *signature.outputs)]
    if signature.parameters:
        arguments.append("p")
    if signature.states:
        arguments += ["state", "dt"]
    read = inputs_read(body)
    unused = [array for array, _ in signature.inputs if array not in read]
    if signature.parameters and not any(name in read for name in signature.parameters):
        unused.append("p%" + signature.parameters[0])
    if signature.states and "dt" not in read:
        unused.append("dt")
    return {
        "symbol": signature.symbol,
        "bound": signature.fortran_symbol,
        "arguments": ", ".join(arguments),
        "inputs": signature.inputs,
        "outputs": signature.outputs,
        "states": signature.states,
        "purpose": PURPOSES[signature.function],
        "counted": textwrap.wrap(_counted(counted), WIDTH, break_on_hyphens=False),
        "locals": locals_,
        "lines": lines.angles + lines.statements,
        "results": lines.results,
        "unused": unused,
    }


def _sine_of_input(expression: Expression) -> bool:
    return (
        isinstance(expression, Apply) and expression.op == "sin" and not isinstance(expression.args[0], str)
    )


__all__ = ["ARRAYS", "LANGUAGES", "PURPOSES", "Spelling", "Unit", "render"]
