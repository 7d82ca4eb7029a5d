"""Fortran 2008, free form; the kind of all reals is ``rk``."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from robodyn.emit.arctangent import arctangent_context
from robodyn.emit.body import Lines
from robodyn.emit.language import Compiled, FunctionText, Language, SelfTest
from robodyn.emit.runs import Run
from robodyn.emit.sines import ANGLES, COSINES, SINES
from robodyn.emit.spelling import WIDTH, Spelling, elements
from robodyn.emit.stages import NEXT, Repeated, Stage
from robodyn.emit.statements import Expression
from robodyn.emit.syntax import Sines, Syntax
from robodyn.emit.trig import trig_context
from robodyn.emit.unit import Unit, advice, has_arctangents, has_sines
from robodyn.ir.program import STATE
from robodyn.ir.signature import Signature
from robodyn.tools import Tool, Use


def fortran_spelling(*, single: bool, states: Sequence[str] = ()) -> Spelling:
    """``states`` are the members of ``state``, where a function has one; it has ``dt`` then."""

    return Spelling(
        literal=lambda digits: digits + "_rk",
        element=elements(states, "state%{}", "{}({})", first=1),
        member=lambda name: f"p%{name}",
        functions={
            "sin": lambda x: f"sin({x})",
            "cos": lambda x: f"cos({x})",
            "tanh": lambda x: f"tanh({x})",
            "sqrt": lambda x: f"sqrt({x})",
            "abs": lambda x: f"abs({x})",
            "exp": lambda x: f"exp({x})",
            "pow": lambda x, y: f"({x})**({y})",
            "atan2": lambda y, x: f"atan2({y}, {x})",
            "select": lambda c, a, b: f"merge({a}, {b}, {c} > 0.0_rk)",
            "sign": lambda x: f"merge(1.0_rk, merge(-1.0_rk, 0.0_rk, {x} < 0.0_rk), {x} > 0.0_rk)",
        },
        single=single,
        continuation=" &",
    )


def _plain_syntax(spelling: Spelling) -> Syntax:
    def assign(target: str, text: str) -> str:
        return f"{target} = {text}"

    return Syntax(spelling, comment="! %s", declare=assign, assign=assign)


def _syntax(signature: Signature, unit: Unit) -> Syntax:
    spelling = fortran_spelling(single=signature.scalar == "float", states=signature.states)
    if unit.builtin:
        spelling = spelling.calling(atan2=lambda y, x: f"{signature.robot}_atan2({y}, {x})")
    syntax = _plain_syntax(spelling)
    return replace(syntax, sines=_sines(signature.robot, syntax))


def _sines(name: str, syntax: Syntax) -> Sines:
    """``NAME_sincos`` in Fortran, which is elemental."""

    def loop(angles: Sequence[Expression]) -> list[str]:
        lines = []
        for i, angle in enumerate(angles):
            lines += syntax.result(syntax.spelling.element(ANGLES, i), angle)
        return [*lines, f"    call {name}_sincos({ANGLES}, {SINES}, {COSINES})"]

    def pair(array: str, angle: Expression) -> list[str]:
        return syntax.line(f"call {name}_sincos({syntax.spelling.text(angle)}, {array}(1), {array}(2))")

    def run(it: Run) -> list[str]:
        lines = []
        for array, values in zip(it.arrays, (it.ups, it.alongs), strict=False):
            for i, value in enumerate(values):
                lines += syntax.result(syntax.spelling.element(array, i), value)
        ups, alongs, angles = it.arrays
        return [*lines, f"    {angles} = {name}_atan2({ups}, {alongs})"]

    return Sines(loop, pair, run)


def _repeating(it: Repeated) -> Lines:
    syntax = _plain_syntax(fortran_spelling(single=it.whole.scalar == "float"))

    def call(stage: Stage, indent: str = "", **places: str) -> list[str]:
        return [indent + line for line in syntax.line(f"call {stage.call(**places)}")]

    def loop(row: str, last: str) -> list[str]:
        return [
            f"    do k = 1, {it.most}",
            f"      if ({last} > 0.0_rk) exit",
            *call(it.step, "  ", **{STATE: row}),
            f"      {row} = {NEXT}",
            "    end do",
        ]

    steps = loop(STATE, f"{STATE}({it.size})")
    if it.rows > 1:
        size = it.size
        row = f"{STATE}({size}*(j - 1) + 1:{size}*j)"
        steps = [
            f"    do j = 1, {it.rows}",
            *(f"  {line}" for line in loop(row, f"{STATE}({size}*j)")),
            "    end do",
        ]
    arrays = {STATE: it.size * it.rows, NEXT: it.size}
    return Lines.of([*call(it.start), *steps, *call(it.finish)], arrays, ["k", "j"][: 1 + (it.rows > 1)])


def _function(text: FunctionText) -> dict[str, Any]:
    signature, lines = text.signature, text.lines
    names = [*lines.names, *(f"{array}({size})" for array, size in lines.arrays.items())]
    arguments = [array for array, _ in (*signature.inputs, *signature.outputs)]
    if signature.parameters:
        arguments.append("p")
    if signature.states:
        arguments += ["state", "dt"]
    return {
        "bound": _bound(signature),
        "arguments": _listed(arguments, len(f"  pure subroutine {signature.symbol}() &")),
        "inputs": signature.inputs,
        "outputs": signature.outputs,
        "states": signature.states,
        "locals": [line.rstrip(",") for line in textwrap.wrap(", ".join(names), WIDTH - 16)],
        "counters": lines.counters,
        "lines": lines.angles + lines.statements,
        "results": lines.results,
        "unused": [f"p%{signature.parameters[0]}" if name == "p" else name for name in text.unused],
    }


def _listed(arguments: Sequence[str], beside: int) -> str:
    """``arguments``, on lines of their own where they are too long for one with so many other characters."""
    text = ", ".join(arguments)
    if beside + len(text) <= WIDTH:
        return text
    return " &\n      ".join(["", *textwrap.wrap(text, WIDTH - 16)])


def _bound(signature: Signature) -> str:
    """The name in the object file: that of the C with a tail, so that both can stand in one program."""
    return f"{signature.symbol}_f"


def _context(unit: Unit) -> dict[str, Any]:
    single = unit.functions[0][0].scalar == "float"
    syntax = _plain_syntax(fortran_spelling(single=single))
    return {
        "trig": trig_context(syntax) if has_sines(unit) else None,
        "arctangent": arctangent_context(syntax) if has_arctangents(unit) else None,
        "bits": 32 if single else 64,
        "kind": "c_float" if single else "c_double",
    }


def _selftest_types(single: bool) -> dict[str, str]:
    return {
        "kind": "c_float" if single else "c_double",
        "bits": "int32" if single else "int64",
        "integers": "int32, int64" if single else "int64",
    }


_FLAGS = ("-std=f2018", "-O2", "-ffp-contract=off")


LANGUAGE = Language(
    name="fortran",
    title="Fortran",
    aliases=("f90",),
    default=True,
    suffixes=(".f90", ".f"),
    files={"NAME.f90": "fortran/kernel.f90.j2"},
    package_tests={"NAME_vectors.f90": "fortran/vectors.f90.j2"},
    spelling=lambda single: fortran_spelling(single=single),
    syntax=_syntax,
    function=_function,
    repeating=_repeating,
    context=_context,
    advice=advice,
    longest_name=63,
    features=frozenset({"firmware"}),
    compiled=Compiled(
        compiler=Tool(
            ("gfortran", "flang", "flang-new"),
            Use.KERNELS,
            "Fortran kernels called from Python, and verified",
            "gfortran",
            "Fedora: dnf install gcc-gfortran; macOS: brew install gcc",
            variable="FC",
        ),
        flags=_FLAGS,
        symbol=_bound,
    ),
    selftest=SelfTest(
        file="NAME_selftest.f90",
        template="selftest.f90.j2",
        flags=_FLAGS,
        types=_selftest_types,
    ),
)
