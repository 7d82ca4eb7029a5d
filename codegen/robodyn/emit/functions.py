"""The text of one function: statements, results, arguments, as the templates of C and Fortran place them."""

from __future__ import annotations

import textwrap
from typing import Any

from robodyn.counts.count import Count
from robodyn.emit.body import Lines, Said, arrays_read, body_lines, reads_parameters
from robodyn.emit.results import Result
from robodyn.emit.sines import COSINES, SINES, c_sines, fortran_sines
from robodyn.emit.spelling import WIDTH, c_spelling, fortran_spelling
from robodyn.emit.statements import Apply, Body, Expression, Statement
from robodyn.emit.unit import PURPOSES, Unit, counted_text
from robodyn.ir.signature import Signature


def c_function(signature: Signature, counted: Count, body: Body, unit: Unit) -> dict[str, Any]:
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
    read = arrays_read(body)
    unused = [array for array, _ in signature.inputs if array not in read]
    if signature.parameters and not reads_parameters(body):
        unused.append("p")
    if signature.states and "dt" not in read:
        unused.append("dt")
    return {
        "symbol": signature.symbol,
        "arguments": arguments,
        "prototype": _prototype(f"void {signature.symbol}(", arguments),
        "purpose": PURPOSES[signature.function],
        "counted": textwrap.wrap(counted_text(counted), WIDTH, break_on_hyphens=False),
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


def fortran_function(signature: Signature, counted: Count, body: Body, unit: Unit) -> dict[str, Any]:
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
    read = arrays_read(body)
    unused = [array for array, _ in signature.inputs if array not in read]
    if signature.parameters and not reads_parameters(body):
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
        "counted": textwrap.wrap(counted_text(counted), WIDTH, break_on_hyphens=False),
        "locals": locals_,
        "lines": lines.angles + lines.statements,
        "results": lines.results,
        "unused": unused,
    }


def _sine_of_input(expression: Expression) -> bool:
    return (
        isinstance(expression, Apply) and expression.op == "sin" and not isinstance(expression.args[0], str)
    )
