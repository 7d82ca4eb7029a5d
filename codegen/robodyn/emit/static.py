"""Programs as static C functions of doubles, for code that is compiled and thrown away."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from robodyn.emit.c_syntax import c_spelling, c_syntax
from robodyn.emit.statements import statements
from robodyn.ir.program import Program


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
    for array, elements in body.outputs:
        target = outputs[array]
        lines += [line for i, x in enumerate(elements) for line in syntax.result(f"{target}[{i}]", x)]
    lines += [f"    (void){array};" for array in (*inputs, *outputs.values(), "p")]
    return "\n".join([*lines, "}"]) + "\n"
