"""Torques and accelerations of an arm whose tool is pushed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from robodyn.dynamics.articulated import articulated_bodies
from robodyn.dynamics.functions.arguments import QD, QDD, TAU, WRENCH, Array, Q
from robodyn.dynamics.functions.record import WITH_WRENCH, Function, Pair
from robodyn.dynamics.functions.standard import FUNCTIONS as STANDARD
from robodyn.dynamics.kinematics import frames, jacobian
from robodyn.dynamics.mass_matrix import factoring, solve_symmetric
from robodyn.dynamics.state import Dynamics, Vector
from robodyn.dynamics.wrenches import by_jacobian, carried_outward

TAU_WRENCH = Array("tau_wrench", "joint torques of the wrench, J^T w", "N m", "N")


def _through_the_jacobian(at: Dynamics) -> list[Any]:
    """``J^T w`` by the textbook's Jacobian."""
    arm, w = at.arm, at.inputs["w"]
    placed = frames(arm, at.motion(at.rest, at.rest), arm.base)
    columns = zip(*jacobian(arm, placed, arm.tool.origin), strict=True)
    return [sum(x * y for x, y in zip(column, w, strict=True)) for column in columns]


def _less(torques: Vector, wrench: Vector) -> list[Any]:
    return [tau - pushed for tau, pushed in zip(torques, wrench, strict=True)]


def _with_wrench(function: Function) -> Function:
    """Torques of ``function`` that hold the wrench as well."""
    zeros = function.zeros
    assert zeros is not None

    def under(wrench_torques: Callable[[Dynamics], Vector]) -> Callable[[Dynamics], Sequence[Any]]:
        def torques(at: Dynamics) -> Sequence[Any]:
            qd, qdd = (at.rest if name in zeros else at.inputs[name] for name in ("qd", "qdd"))
            return at.torques_under_wrench(qd, qdd, wrench_torques(at))

        return torques

    return Function(
        function.name + WITH_WRENCH,
        f"{function.purpose}, and bear a wrench on the tool",
        (*function.inputs, WRENCH),
        (TAU,),
        under(by_jacobian),
        expected=under(_through_the_jacobian),
        parts=(function.name,),
        apart=True,
        others=(under(carried_outward),),
    )


def _forward(at: Dynamics) -> Sequence[Any]:
    return _solved(at, by_jacobian(at))


def _forward_outward(at: Dynamics) -> Sequence[Any]:
    return _solved(at, carried_outward(at))


def _articulated(at: Dynamics) -> Sequence[Any]:
    """Without a mass matrix: what takes fewer operations for long arms."""
    pushed = [tau + w for tau, w in zip(at.inputs["tau"], carried_outward(at), strict=True)]
    return articulated_bodies(at.links(at.inputs["qd"], at.rest), pushed, at.mark)


def _solved(at: Dynamics, pushed: Vector) -> Sequence[Any]:
    """``qdd = M^-1 (tau + J^T w - h)``."""
    bias = at.torques(at.inputs["qd"], at.rest)
    right = zip(at.inputs["tau"], pushed, bias, strict=True)
    return solve_symmetric(at.mass_matrix(), [tau + w - h for tau, w, h in right], at.mark)


def _needs_the_torques(at: Dynamics, result: Sequence[Any], _: Vector) -> Pair:
    """The torques that the accelerations need beside the wrench."""
    needed = at.torques(at.inputs["qd"], result)
    return _less(needed, _through_the_jacobian(at)), at.inputs["tau"]


FUNCTIONS = (
    Function(
        "wrench_torques",
        "joint torques that a wrench on the tool does work with",
        (Q, WRENCH),
        (TAU_WRENCH,),
        by_jacobian,
        expected=_through_the_jacobian,
        others=(carried_outward,),
        geometric=True,
    ),
    *(_with_wrench(function) for function in STANDARD if function.gives_torques),
    Function(
        "forward_dynamics" + WITH_WRENCH,
        "accelerations that the torques tau and a wrench on the tool give",
        (Q, QD, TAU, WRENCH),
        (QDD,),
        _forward,
        condition=_needs_the_torques,
        others=(_forward_outward,),
        of_rigid_arms=(_articulated,),
        beside_parts=factoring,
        parts=("bias", "mass_matrix"),
        solves=True,
    ),
)
