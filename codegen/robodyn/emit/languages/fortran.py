"""Fortran 2008, free form; the kind of all reals is ``rk``."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from robodyn.emit.body import Lines
from robodyn.emit.language import Compiled, FunctionText, Language, SelfTest
from robodyn.emit.loops import ANGLES, COSINES, SINES, Run
from robodyn.emit.spelling import WIDTH, Sines, Spelling, Syntax, call, elements, functions_of
from robodyn.emit.stages import NEXT, Repeated, Stage
from robodyn.emit.statements import Expression
from robodyn.emit.unit import Unit, advice
from robodyn.ir.program import STATE
from robodyn.ir.signature import Signature
from robodyn.tools import Tool, Use


def _spelling(*, single: bool, states: Sequence[str] = ()) -> Spelling:
    return Spelling(
        literal=lambda digits: digits + "_rk",
        element=elements(states, "state%{}", "{}({})", first=1),
        member=lambda name: f"p%{name}",
        functions={
            **functions_of("{}"),
            "pow": lambda x, y: f"({x})**({y})",
            "select": lambda c, a, b: f"merge({a}, {b}, {c} > 0.0_rk)",
            "sign": lambda x: f"merge(1.0_rk, merge(-1.0_rk, 0.0_rk, {x} < 0.0_rk), {x} > 0.0_rk)",
        },
        single=single,
        continuation=" &",
    )


def _assignment(target: str, text: str) -> str:
    return f"{target} = {text}"


def _syntax(signature: Signature, unit: Unit) -> Syntax:
    spelling = _spelling(single=signature.scalar == "float", states=signature.states)
    if unit.builtin:
        spelling = spelling.calling(atan2=call(f"{signature.robot}_atan2"))
    syntax = Syntax(spelling, comment="! %s", declare=_assignment, assign=_assignment)
    return replace(syntax, sines=_sines(signature.robot, syntax))


def _sines(name: str, syntax: Syntax) -> Sines:
    """``NAME_sincos`` in Fortran, which is elemental."""

    def filled(array: str, values: Sequence[Expression]) -> list[str]:
        places = (syntax.spelling.element(array, i) for i in range(len(values)))
        return [line for place, x in zip(places, values, strict=True) for line in syntax.result(place, x)]

    def every(angles: Sequence[Expression]) -> list[str]:
        return [*filled(ANGLES, angles), f"    call {name}_sincos({ANGLES}, {SINES}, {COSINES})"]

    def pair(array: str, angle: Expression) -> list[str]:
        return syntax.line(f"call {name}_sincos({syntax.spelling.text(angle)}, {array}(1), {array}(2))")

    def run(it: Run) -> list[str]:
        ups, alongs, angles = it.arrays
        last = f"    {angles} = {name}_atan2({ups}, {alongs})"
        return [*filled(ups, it.ups), *filled(alongs, it.alongs), last]

    return Sines(every, pair, run)


def _repeating(it: Repeated, syntax: Syntax) -> Lines:
    def called(stage: Stage, indent: str = "", **places: str) -> list[str]:
        return [indent + line for line in syntax.line(f"call {stage.call(**places)}")]

    size, several = it.size, it.rows > 1
    row, last = STATE, f"{STATE}({size})"
    if several:
        row, last = f"{STATE}({size}*(j - 1) + 1:{size}*j)", f"{STATE}({size}*j)"
    steps = [
        f"    do k = 1, {it.most}",
        f"      if ({last} > 0.0_rk) exit",
        *called(it.step, "  ", **{STATE: row}),
        f"      {row} = {NEXT}",
        "    end do",
    ]
    if several:
        steps = [f"    do j = 1, {it.rows}", *(f"  {line}" for line in steps), "    end do"]
    lines = [*called(it.start), *steps, *called(it.finish)]
    return Lines(lines, it.arrays, counters=("k", "j") if several else ("k",))


def _function(text: FunctionText) -> dict[str, Any]:
    signature, lines = text.signature, text.lines
    names = [*lines.names, *(f"{array}({size})" for array, size in lines.arrays.items())]
    arguments = [array for array, _ in (*signature.inputs, *signature.outputs)]
    arguments += ["p"] if signature.parameters else []
    arguments += ["state", "dt"] if signature.states else []
    listed = ", ".join(arguments)
    if len(f"  pure subroutine {signature.symbol}() &{listed}") > WIDTH:
        listed = " &\n      ".join(["", *textwrap.wrap(listed, WIDTH - 16)])
    return {
        "bound": _bound(signature),
        "arguments": listed,
        "inputs": signature.inputs,
        "outputs": signature.outputs,
        "states": signature.states,
        "locals": [line.rstrip(",") for line in textwrap.wrap(", ".join(names), WIDTH - 16)],
        "counters": lines.counters,
        "lines": [*lines.angles, *lines.statements],
        "unused": [f"p%{signature.parameters[0]}" if name == "p" else name for name in text.unused],
    }


def _bound(signature: Signature) -> str:
    """The name in the object file: that of the C with a tail, so that both can stand in one program."""
    return f"{signature.symbol}_f"


def _selftest_types(single: bool) -> dict[str, str]:
    bits, integers = ("int32", "int32, int64") if single else ("int64", "int64")
    return {"kind": _kind(single), "bits": bits, "integers": integers}


def _kind(single: bool) -> str:
    return "c_float" if single else "c_double"


_FLAGS = ("-std=f2018", "-O2", "-ffp-contract=off")


LANGUAGE = Language(
    name="fortran",
    title="Fortran",
    aliases=("f90",),
    suffixes=(".f90", ".f"),
    files={"NAME.f90": "fortran/kernel.f90.j2"},
    package_tests={"NAME_vectors.f90": "fortran/vectors.f90.j2"},
    spelling=lambda single: _spelling(single=single),
    syntax=_syntax,
    function=_function,
    repeating=_repeating,
    context=lambda unit: {"kind": _kind(unit.single)},
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
    selftest=SelfTest("NAME_selftest.f90", "selftest.f90.j2", _FLAGS, _selftest_types),
)
