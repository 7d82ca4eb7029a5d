"""The equations of an arm, typeset: the recursion as the book has it, customised for the arm."""

from __future__ import annotations

from typing import Any, Final

from robodyn.draw.mathml import equation, of_expression, of_input, of_name
from robodyn.emit.statements import statements
from robodyn.kernels.generate import Options, generate
from robodyn.robot.model import Robot

#: What is typeset, and what each is called.
_TITLES: Final = {"gravity": "Holding the arm", "inverse_dynamics": "Torques of a motion"}
#: Longer recursions are no reading matter: the emitted C has them.
MOST: Final = 700


def equations(robot: Robot) -> list[dict[str, Any]]:
    """By function the steps of the recursion, grouped under what they compute: MathML, an element a step."""
    options = Options(functions=tuple(_TITLES), readable=True, optimize="none", order="recursion")
    unit = generate(robot, options).unit
    records = []
    for signature, program in unit.functions:
        body = statements(program, readable=True)
        groups: list[dict[str, Any]] = []
        for statement in body.statements[:MOST]:
            if statement.heading is not None or not groups:
                groups.append({"heading": statement.heading or "", "steps": []})
            groups[-1]["steps"].append(equation(of_name(statement.name), of_expression(statement.expression)))
        results = [
            equation(of_input(array, index), of_expression(element))
            for array, elements in body.outputs
            if array != "state"
            for index, element in enumerate(elements)
        ]
        records.append(
            {
                "function": signature.function,
                "title": _TITLES[signature.function],
                "steps": len(body.statements),
                "left_out": max(0, len(body.statements) - MOST),
                "groups": groups,
                "results": results,
            }
        )
    return records
