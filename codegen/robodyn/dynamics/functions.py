"""The kernels of an arm: which inputs they have, and the recursion that gives their outputs.

Here a robot becomes a graph: the recursions of this room run on nodes.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm, JointAngle, Motion, Trigonometry, build_arm, build_motion
from robodyn.dynamics.base_parameters import base_newton_euler
from robodyn.dynamics.mass_matrix import mass_matrix, solve_symmetric
from robodyn.dynamics.parallel import chain_turns, chained, single_turns
from robodyn.dynamics.regroup import MomentForm, lumps_of, regrouped, suited_forms
from robodyn.dynamics.slide import slid
from robodyn.dynamics.vectors import Mark
from robodyn.errors import InputError
from robodyn.ir import Graph, Label, Node, Program, Signature
from robodyn.ir.graph import lower
from robodyn.ir.signature import ScalarType
from robodyn.robot.model import Robot

#: Inputs of each function, beside what it returns.
FUNCTIONS: dict[str, tuple[tuple[str, ...], str]] = {
    "inverse_dynamics": (("q", "qd", "qdd"), "tau"),
    "gravity": (("q",), "tau"),
    "bias": (("q", "qd"), "tau"),
    "mass_matrix": (("q",), "M"),
    "forward_dynamics": (("q", "qd", "tau"), "qdd"),
}

#: Formulations of the inverse dynamics, from the description as it stands.
FORMULATIONS = (
    "modified_newton_euler",
    "newton_euler",
    "balafoutis",
    "kane",
    "lagrange_3x3",
    "lagrange_4x4",
    "lagrange",
)


@dataclass(frozen=True, slots=True)
class Choice:
    """How the recursion is written: the formulation, and whether base parameters are regrouped (in the
    modified Newton-Euler recursion); then ``chains`` says whether parallel joints turn as one, and
    ``forms`` picks the form of each link's moment (empty: the forms that suit the arm)."""

    formulation: str = "modified_newton_euler"
    regroup: bool = True
    chains: bool = True
    forms: tuple[MomentForm, ...] = ()


def signature(robot: Robot, function: str, scalar: ScalarType = "double") -> Signature:
    """The interface of ``function`` of ``robot``; :class:`InputError` for an unknown function."""
    if function not in FUNCTIONS:
        raise InputError(
            f"unknown function {function!r}",
            expected=f"one of {', '.join(FUNCTIONS)}",
            remedy="choose one of those",
        )
    arguments, result = FUNCTIONS[function]
    n = robot.n
    size = n * n if result == "M" else n
    return Signature(
        robot=robot.name,
        function=function,
        inputs=tuple((name, n) for name in arguments),
        outputs=((result, size),),
        parameters=robot.parameters,
        scalar=scalar,
    )


def build(robot: Robot, function: str, choice: Choice) -> Program:
    """The program of ``function`` as the recursion leaves it: equal nodes merged, constants folded,
    nothing dead, no pass run yet."""
    graph = Graph()
    interface = signature(robot, function)
    given = {name: [graph.input(name, i) for i in range(size)] for name, size in interface.inputs}
    arm = build_arm(robot, exact, graph.input)
    if choice.regroup:
        arm = slid(arm)

    def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
        return turned(graph, given["q"], angle)

    def mark(value: Any, label: Label) -> Any:
        return graph.label(value, label)

    values = outputs_of(function, arm, choice, given, trigonometry, exact, mark)
    (result, _), *_ = interface.outputs
    return lower(graph, [(result, values)])


def has_chains(robot: Robot) -> bool:
    """Whether some joint turns about an axis parallel to the one before (see :mod:`.parallel`)."""
    return any(chained(build_arm(robot, exact, lambda _: 1)))


def outputs_of(
    function: str,
    arm: Arm,
    choice: Choice,
    given: Mapping[str, Sequence[Any]],
    trigonometry: Trigonometry,
    number: Callable[[Fraction], Any],
    mark: Mark,
) -> list[Any]:
    """The outputs of ``function``, one after another, over the scalars of ``arm`` and ``given``."""
    zeros = [0] * len(arm.bodies)
    inverse = _inverse_dynamics(arm, choice, trigonometry)

    def motion(qd: Sequence[Any], qdd: Sequence[Any]) -> Motion:
        return build_motion(arm, given["q"], qd, qdd, trigonometry, number)

    if function == "inverse_dynamics":
        return inverse(motion(given["qd"], given["qdd"]), mark)
    if function == "gravity":
        return inverse(motion(zeros, zeros), mark)
    if function == "bias":
        return inverse(motion(given["qd"], zeros), mark)
    lumps = regrouped(arm, ["second_moment"] * len(arm.bodies)) if choice.regroup else lumps_of(arm)
    at_rest = motion(zeros, zeros)
    turns = chain_turns(arm, at_rest, trigonometry) if choice.chains else single_turns(at_rest)
    matrix = mass_matrix(arm, at_rest, turns, lumps, mark)
    if function == "mass_matrix":
        return [entry for row in matrix for entry in row]
    bias = inverse(motion(given["qd"], zeros), mark)
    right = [tau - h for tau, h in zip(given["tau"], bias, strict=True)]
    return solve_symmetric(matrix, right, mark)


def turned(graph: Graph, q: Sequence[Node], angle: JointAngle) -> tuple[Any, Any]:
    """Cosine and sine of ``angle``; an offset of quarter turns costs nothing."""
    total: Any = 0
    for joint, sign in angle.terms:
        total = total + sign * q[joint]
    cosine, sine = exact(angle.offset.cos), exact(angle.offset.sin)
    if angle.offset.quarter is None:
        total = total + Fraction(angle.offset.radians)
        cosine, sine = 1, 0
    total = graph.label(total, angle.label("angle"))
    c = graph.label(graph.cos(total), angle.label("c"))
    s = graph.label(graph.sin(total), angle.label("s"))
    return cosine * c - sine * s, cosine * s + sine * c


def exact(x: Fraction) -> Fraction | int:
    """``x``, as an integer where it is one: arithmetic among 0 and 1 is most of a recursion's."""
    return x.numerator if x.denominator == 1 else x


def _inverse_dynamics(
    arm: Arm, choice: Choice, trigonometry: Trigonometry
) -> Callable[[Motion, Mark], list[Any]]:
    if choice.formulation not in FORMULATIONS:
        raise InputError(
            f"unknown formulation {choice.formulation!r}", expected=f"one of {', '.join(FORMULATIONS)}"
        )
    if choice.formulation != "modified_newton_euler" or not choice.regroup:
        # A module and its function bear the formulation's name; only the one asked for is imported.
        home = importlib.import_module(f"robodyn.dynamics.{choice.formulation}")
        book = getattr(home, choice.formulation)
        return lambda motion, mark: list(book(arm, motion, mark))
    forms = choice.forms or suited_forms(arm)
    lumps = regrouped(arm, forms)

    def recursion(motion: Motion, mark: Mark) -> list[Any]:
        turns = chain_turns(arm, motion, trigonometry) if choice.chains else single_turns(motion)
        return base_newton_euler(arm, motion, turns, lumps, forms, mark)

    return recursion
