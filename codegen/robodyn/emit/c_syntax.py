"""How C is spelled: by its kernels, and by whatever else is written in C (batches, threads, simulation)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from robodyn.emit.spelling import WIDTH, Spelling, Syntax, call, elements, functions_of
from robodyn.emit.statements import statements
from robodyn.ir.program import Program

#: Compilations that would not round as written, and what is said of them. gcc names -fassociative-math from
#: 12 on, clang never does: ``c/as_written.h.j2`` is for those. 16 is 0 but for _Float16: gcc has it with
#: -march=native where the processor computes in half precision.
_REFUSED = (
    (
        "defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST)",
        "{} are for arithmetic as written: no -ffast-math, -funsafe-math-optimizations, -fassociative-math",
    ),
    (
        "defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0",
        "{} are for all numbers, and NaN is one of their results: no -ffinite-math-only",
    ),
    (
        "defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16",
        "{} are for arithmetic in their own type: no x87, use -msse2 -mfpmath=sse",
    ),
)


def refused(builtin: Mapping[str, Any]) -> list[tuple[str, str]]:
    """The tests of such compilations and their words, of a file with the functions of our own in
    ``builtin``."""
    sines = (
        "sine and cosine" if builtin["trig"] else "arctangents" if builtin["arctangent"] else "square roots"
    )
    return [(test, reason.format(sines)) for test, reason in _REFUSED]


def c_spelling(*, single: bool, states: Sequence[str] = (), explicit: bool = False) -> Spelling:
    """``states`` are the members of ``state``, where a function has one; it has ``dt`` then. ``explicit``:
    products within sums stand in parentheses."""
    f = "f" if single else ""
    zero, one = f"0.0{f}", f"1.0{f}"

    def compared(x: str, sign: str) -> str:
        return f"({x} {sign} {zero})" if explicit else f"{x} {sign} {zero}"

    return Spelling(
        literal=lambda digits: digits + f,
        element=elements(states, "state->{}", "{}[{}]"),
        member=lambda name: f"p->{name}",
        functions={
            **functions_of(f"{{}}{f}"),
            "abs": call(f"fabs{f}"),
            "select": lambda c, a, b: f"({compared(c, '>')} ? {a} : {b})",
            "sign": lambda x: f"({compared(x, '>')} ? {one} : ({compared(x, '<')} ? -{one} : {zero}))",
        },
        single=single,
        explicit=explicit,
    )


def c_syntax(spelling: Spelling, real: str) -> Syntax:
    """Statements on numbers of the type ``real``."""
    return Syntax(
        spelling,
        comment="/* %s */",
        declare=lambda name, text: f"const {real} {name} = {text};",
        assign=lambda target, text: f"{target} = {text};",
    )


def prototype(head: str, arguments: Sequence[str]) -> str:
    """``head`` with its arguments, without the closing parenthesis, in lines of moderate length."""
    line = head + ", ".join(arguments)
    return line if len(line) < WIDTH - 2 else head + "\n    " + ",\n    ".join(arguments)


def static_function(
    name: str, inputs: Sequence[str], outputs: Mapping[str, str], program: Program, parameters: Sequence[str]
) -> str:
    """``static void name(const double *inputs..., double *outputs..., const double *p)``.

    ``outputs`` gives for each output of ``program`` the name of the argument; run-time ``parameters`` are
    elements of ``p``, in that order.
    """
    # Names of the description never reach this C: a parameter is a place in p.
    spelling = replace(c_spelling(single=False), member=lambda parameter: f"p[{parameters.index(parameter)}]")
    syntax = c_syntax(spelling, "double")
    body = statements(program)
    arguments = [f"const double *{array}" for array in inputs]
    arguments += [f"double *{array}" for array in outputs.values()]
    lines = [f"static void {name}({', '.join(arguments)}, const double *p)", "{"]
    lines += [line for statement in body.statements for line in syntax.statement(statement)]
    for array, results in body.outputs:
        for i, x in enumerate(results):
            lines += syntax.result(f"{outputs[array]}[{i}]", x)
    lines += [f"    (void){array};" for array in (*inputs, *outputs.values(), "p")]
    return "\n".join([*lines, "}"]) + "\n"
