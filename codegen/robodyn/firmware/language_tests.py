"""Tests with vectors that go with the sources of a language (``Language.tests``), or with a package of them
(``Language.package_tests``).

What is expected is the program evaluated to 40 digits, and confirmed by exact torques where the arm is rigid
(what is of a pose was compared with forward kinematics when it was generated); the tolerance is what rounding
can change (:mod:`robodyn.firmware.rounding`).
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.functions import function_named
from robodyn.emit.head import head_of
from robodyn.emit.languages import languages_named
from robodyn.emit.render import environment
from robodyn.emit.spelling import Spelling
from robodyn.firmware.digest import DTYPE, Range, draw, program_inputs, ranges
from robodyn.firmware.rounding import UNIT, rounding_bounds
from robodyn.firmware.vectors import SMALLEST, confirm, evaluated, pose_states, rounded_up
from robodyn.ir.program import Input, Program
from robodyn.ir.signature import ScalarType, Signature
from robodyn.kernels.generate import Generated
from robodyn.verify.numbers import real
from robodyn.verify.sample import draw_parameters

#: States that are drawn for each function; one more is the first of them at rest.
_STATES, _SEED = 7, 3
#: How far what is remembered goes [rad, m or N m], and the time step [s]; a power of two, which float has.
_MEMORY, _STEP = 2.0**-10, 2.0**-10
_MOVING = ("qd", "qdd")
_TITLE = (
    "Tests of {name}: results evaluated to 40 digits{confirmed}, and as the tolerance of each the bound that "
    "a running error analysis of the function's operations gives, constants and sines included."
)


def language_tests(
    generated: Generated, languages: Sequence[str], *, packaged: bool = False, entry: str = "main"
) -> dict[str, str]:
    """The tests that go with ``languages``: text by file name; none for languages without any. ``packaged``:
    those that go with packages only, which are programs; in C another ``entry`` than ``main`` makes it a
    function.

    Raises
    ------
    InputError: there is no such language.
    """
    chosen = [
        (language, templates)
        for language in languages_named(languages)
        if (templates := language.package_tests if packaged else language.tests)
    ]
    if not chosen:
        return {}
    robot, scalar = generated.unit.robot, generated.options.scalar
    values = draw_parameters(robot, None, 0, np.dtype(DTYPE[scalar]))
    rigid = not robot.effects and robot.dead_band is None
    confirmed = rigid and not generated.unit.sc
    functions = []
    # Where a step is repeated rounding decides how often: there is no bound of what it changes.
    straight = [each for each in generated.unit.functions if each[1].iteration is None]
    if not straight:
        return {}
    for signature, program in straight:
        inputs = _states(generated, signature)
        inputs |= {Input(name, None): np.full(_STATES + 1, value) for name, value in values.items()}
        rows = _rows(signature, program, inputs, scalar)
        if confirmed and rows and not function_named(signature.function).of_pose:
            _confirm(generated, signature, inputs, values, rows)
        if rows:
            functions.append((signature, inputs, rows))
    head = _TITLE.format(
        name=robot.name, confirmed=" and confirmed by exact torques from virtual work" if confirmed else ""
    )
    files: dict[str, str] = {}
    for language, templates in chosen:
        spelling = language.spelling(scalar == "float")
        context = {
            "parameters": robot.parameters,
            "states": generated.unit.states,
            **language.context(generated.unit),
            "name": robot.name,
            "entry": entry,
            "head": head_of(robot, [head]),
            "values": [spelling.number(Fraction(values[name])) for name in robot.parameters],
            "functions": [_spelled(*function, spelling, SMALLEST[scalar]) for function in functions],
        }
        for file, template in templates.items():
            text = environment().get_template(template).render(context)
            files[file.replace("NAME", robot.name)] = text
    return files


def _states(generated: Generated, signature: Signature) -> dict[Input, NDArray[np.float64]]:
    """Each input of a function at the states: within the joints' limits what has such, else in -1 .. 1."""
    robot, scalar = generated.unit.robot, generated.options.scalar
    if function_named(signature.function).of_pose:
        values = draw_parameters(robot, None, 0, np.dtype(DTYPE[scalar]))
        return program_inputs(pose_states(robot, values, _STATES + 1, _SEED, scalar), {})
    known = ("q", "qd", "qdd", "tau")
    states: dict[Input, NDArray[np.float64]] = {}
    sizes = [*signature.inputs, ("state", len(signature.states)), ("dt", int(bool(signature.states)))]
    for k, (array, size) in enumerate(sizes):
        span = Range(array, (0.0,) * size, (_MEMORY if array == "state" else 1.0,) * size)
        if array in known and size == len(robot.commanded):
            (span,) = ranges(robot, (array,), scalar)
        if not size:
            continue
        x = draw((span,), _STATES, _SEED + k, scalar)[array].astype(np.float64)
        last = x[:1] * (array not in _MOVING)
        rows = np.concatenate([x, last]) if array != "dt" else np.full((_STATES + 1, 1), _STEP)
        states |= {Input(array, i): rows[:, i] for i in range(size)}
    return states


#: Of a state its number, and for each output its name, the expected elements and their tolerances.
_Row = tuple[int, list[tuple[str, list[Fraction], list[float]]]]


def _rows(
    signature: Signature, program: Program, inputs: Mapping[Input, NDArray[np.float64]], scalar: ScalarType
) -> list[_Row]:
    """The vectors; states at which rounding may leave no digit are left out."""
    bounds = rounding_bounds(program, inputs, scalar)
    rows: list[_Row] = []
    for k in range(_STATES + 1):
        outputs = []
        for array, elements in evaluated(program, inputs, k).items():
            size = np.array([real(abs(x)) for x in elements])
            tolerance = bounds[array][k] + UNIT[scalar] * size  # the literal is rounded, too
            outputs.append((array, elements, [float(x) for x in tolerance]))
        largest = max((real(abs(x)) for _, elements, _ in outputs for x in elements), default=0.0)
        if all(t <= max(largest, SMALLEST[scalar]) for _, _, most in outputs for t in most):
            rows.append((k, outputs))
    return rows


def _confirm(
    generated: Generated,
    signature: Signature,
    inputs: Mapping[Input, NDArray[np.float64]],
    values: Mapping[str, float],
    rows: Sequence[_Row],
) -> None:
    kept = [k for k, _ in rows]
    states = {
        array: np.stack([inputs[Input(array, i)][kept] for i in range(size)], axis=1)
        for array, size in signature.inputs
    }
    pruning = generated.prunings.get(signature.function)
    spare = pruning.proven if pruning is not None else ()
    results = [array for array, _ in signature.outputs]
    expected = [[x for array, xs, _ in outputs if array in results for x in xs] for _, outputs in rows]
    confirm(generated.unit.robot, signature.function, states, values, expected, spare)


def _spelled(
    signature: Signature,
    inputs: Mapping[Input, NDArray[np.float64]],
    rows: Sequence[_Row],
    spelling: Spelling,
    smallest: float,
) -> dict[str, Any]:
    """What a template is told of a function; numbers are lines of numbers with commas."""

    def numbers(values: Iterable[float | Fraction]) -> list[str]:
        exact = [Fraction(x) for x in values]
        small = [Fraction(0) if abs(x) < smallest else x for x in exact]
        return textwrap.wrap(", ".join(map(spelling.number, small)), 88, break_on_hyphens=False)

    def at(array: str, size: int, k: int) -> list[float]:
        return [float(inputs[Input(array, i)][k]) for i in range(size)]

    return {
        "name": signature.called,
        "symbol": signature.symbol,
        "inputs": [array for array, _ in signature.inputs],
        "outputs": signature.outputs,
        "states": signature.states,
        "rows": [
            {
                "inputs": [numbers(at(array, size, k)) for array, size in signature.inputs],
                "state": [spelling.number(Fraction(x)) for x in at("state", len(signature.states), k)],
                "step": spelling.number(Fraction(_STEP)),
                "outputs": [
                    {
                        "array": array,
                        "size": len(expected),
                        "expected": numbers(expected),
                        "tolerance": numbers(rounded_up(t, smallest) for t in tolerance),
                    }
                    for array, expected, tolerance in outputs
                ],
            }
            for k, outputs in rows
        ],
    }
