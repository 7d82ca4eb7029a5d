"""How C is spelled: by its kernels, and by whatever else is written in C (batches, threads, simulation)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from robodyn.emit.arctangent import arctangent_context
from robodyn.emit.spelling import Spelling, elements
from robodyn.emit.statements import statements
from robodyn.emit.syntax import Syntax
from robodyn.emit.trig import trig_context
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


def c_spelling(*, single: bool, states: Sequence[str] = (), explicit: bool = False) -> Spelling:
    """``states`` are the members of ``state``, where a function has one; it has ``dt`` then. ``explicit``:
    products within sums stand in parentheses."""

    f = "f" if single else ""
    zero, one = (f"0.0{f}", f"1.0{f}")
    positive, negative = (
        ("({} > " + zero + ")", "({} < " + zero + ")") if explicit else ("{} > " + zero, "{} < " + zero)
    )
    return Spelling(
        literal=lambda digits: digits + f,
        element=elements(states, "state->{}", "{}[{}]"),
        member=lambda name: f"p->{name}",
        functions={
            "sin": lambda x: f"sin{f}({x})",
            "cos": lambda x: f"cos{f}({x})",
            "tanh": lambda x: f"tanh{f}({x})",
            "sqrt": lambda x: f"sqrt{f}({x})",
            "abs": lambda x: f"fabs{f}({x})",
            "exp": lambda x: f"exp{f}({x})",
            "pow": lambda x, y: f"pow{f}({x}, {y})",
            "atan2": lambda y, x: f"atan2{f}({y}, {x})",
            "select": lambda c, a, b: f"({positive.format(c)} ? {a} : {b})",
            "sign": lambda x: f"({positive.format(x)} ? {one} : ({negative.format(x)} ? -{one} : {zero}))",
        },
        single=single,
        continuation="",
        explicit=explicit,
    )


def c_syntax(spelling: Spelling, real: str, *, libm: bool = True) -> Syntax:
    """Statements on numbers of the type ``real``.

    With the sines of ``libm``, their angles are volatile, or read a second time as elements of ``again``:
    otherwise gcc joins sine and cosine into sincos, which not every libm has.
    """
    return Syntax(
        spelling,
        comment="/* %s */",
        declare=lambda name, text: f"const {real} {name} = {text};",
        declare_angle=(lambda name, text: f"const volatile {real} {name} = {text};") if libm else None,
        assign=lambda target, text: f"{target} = {text};",
        reread={"q": "again"} if libm else {},
    )


def c_builtin(name: str, *, single: bool, sines: bool, arctangents: bool) -> dict[str, Any]:
    """What the templates of our sine and cosine, and of our arctangent, are told; None of what a file does
    not have. Those called ``lanes_...`` are on vectors."""
    one, lanes = (
        c_syntax(c_spelling(single=single), real, libm=False) for real in (f"{name}_real", "LANES_VEC")
    )
    what = "sine and cosine" if sines else "arctangents" if arctangents else "square roots"
    return {
        "bits": 32 if single else 64,
        "refused": [(test, reason.format(what)) for test, reason in _REFUSED],
        "trig": trig_context(one) if sines else None,
        "arctangent": arctangent_context(one) if arctangents else None,
        "lanes_trig": trig_context(lanes) if sines else None,
        "lanes_arctangent": arctangent_context(lanes) if arctangents else None,
    }


def static_function(
    name: str, inputs: Sequence[str], outputs: Mapping[str, str], program: Program, parameters: Sequence[str]
) -> str:
    """``static void name(const double *inputs..., double *outputs..., const double *p)``.

    ``outputs`` gives for each output of ``program`` the name of the argument; run-time ``parameters`` are
    elements of ``p``, in that order.
    """
    place = {parameter: k for k, parameter in enumerate(parameters)}
    # Names of the description never reach this C: a parameter is a place in p.
    spelling = replace(c_spelling(single=False), member=lambda parameter: f"p[{place[parameter]}]")
    syntax = c_syntax(spelling, "double", libm=False)  # joined sines are welcome here
    body = statements(program)
    arguments = [f"const double *{array}" for array in inputs]
    arguments += [f"double *{array}" for array in outputs.values()]
    lines = [f"static void {name}({', '.join(arguments)}, const double *p)", "{"]
    lines += [line for statement in body.statements for line in syntax.statement(statement)]
    for array, results in body.outputs:
        target = outputs[array]
        lines += [line for i, x in enumerate(results) for line in syntax.result(f"{target}[{i}]", x)]
    lines += [f"    (void){array};" for array in (*inputs, *outputs.values(), "p")]
    return "\n".join([*lines, "}"]) + "\n"
