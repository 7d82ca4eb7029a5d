"""Torques and accelerations of an arm whose tool is pushed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from robodyn.dynamics.functions.record import (
    QD,
    QDD,
    TAU,
    WITH_WRENCH,
    WRENCH,
    Array,
    Function,
    Pair,
    Q,
    Writing,
)
from robodyn.dynamics.functions.standard import FUNCTIONS as STANDARD
from robodyn.dynamics.mass_matrix import factoring, solve_symmetric
from robodyn.dynamics.state import Dynamics, Vector
from robodyn.dynamics.vectors import inner

At = TypeVar("At", bound=Dynamics)
TAU_WRENCH = Array("tau_wrench", "joint torques of the wrench, J^T w", "N m", "N")


def _by_jacobian(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.jacobians import wrench_torques

    return wrench_torques(at)


def _outward(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.jacobians import wrench_torques_outward

    return wrench_torques_outward(at)


def _by_the_textbook(at: Dynamics) -> list[Any]:
    """``J^T w`` by the textbook's Jacobian."""
    from robodyn.dynamics.kinematics import frames, jacobian

    arm = at.arm
    placed = frames(arm, at.motion(at.rest, at.rest), arm.base)
    columns = zip(*jacobian(arm, placed, arm.tool.origin), strict=True)
    return list(at.folded([inner(column, at.inputs["w"]) for column in columns]))


def _with_wrench(function: Function) -> Function:
    """Torques of ``function`` that hold the wrench as well."""
    zeros = function.zeros
    assert zeros is not None

    def under(wrench_torques: Callable[[Dynamics], Vector]) -> Writing:
        def torques(at: Dynamics) -> Sequence[Any]:
            qd, qdd = (at.rest if name in zeros else at.inputs[name] for name in ("qd", "qdd"))
            return at.torques_under_wrench(qd, qdd, wrench_torques(at))

        return torques

    return Function(
        function.name + WITH_WRENCH,
        f"{function.purpose}, and bear a wrench on the tool",
        (*function.inputs, WRENCH),
        (TAU,),
        under(_by_jacobian),
        expected=under(_by_the_textbook),
        parts=(function.name,),
        apart=True,
        others=(under(_outward),),
    )


def _forward(wrench_torques: Callable[[At], Vector]) -> Callable[[At], Sequence[Any]]:
    """``qdd = M^-1 (tau + J^T w - h)``."""

    def solved(at: At) -> Sequence[Any]:
        pushed = wrench_torques(at)
        bias = at.torques(at.inputs["qd"], at.rest)
        right = zip(at.inputs["tau"], pushed, bias, strict=True)
        return solve_symmetric(at.mass_matrix(), [tau + w - h for tau, w, h in right], at.mark)

    return solved


def _articulated(at: Dynamics) -> Sequence[Any]:
    """Without a mass matrix: what takes fewer operations for long arms."""
    from robodyn.dynamics.articulated import articulated_bodies

    pushed = [tau + w for tau, w in zip(at.inputs["tau"], _outward(at), strict=True)]
    return articulated_bodies(at.links(at.inputs["qd"], at.rest), pushed, at.mark)


def _needs_the_torques(at: Dynamics, result: Sequence[Any], _: Vector) -> Pair:
    """The torques that the accelerations need beside the wrench."""
    needed = zip(at.torques(at.inputs["qd"], result), _by_the_textbook(at), strict=True)
    return [tau - pushed for tau, pushed in needed], at.inputs["tau"]


FUNCTIONS = (
    Function(
        "wrench_torques",
        "joint torques that a wrench on the tool does work with",
        (Q, WRENCH),
        (TAU_WRENCH,),
        _by_jacobian,
        expected=_by_the_textbook,
        others=(_outward,),
        geometric=True,
    ),
    *(_with_wrench(function) for function in STANDARD if function.gives_torques),
    Function(
        "forward_dynamics" + WITH_WRENCH,
        "accelerations that the torques tau and a wrench on the tool give",
        (Q, QD, TAU, WRENCH),
        (QDD,),
        _forward(_by_jacobian),
        in_coordinates=_forward(lambda at: at.of("wrench_torques")),
        condition=_needs_the_torques,
        others=(_forward(_outward),),
        of_rigid_arms=(_articulated,),
        beside_parts=factoring,
        parts=("bias", "mass_matrix"),
        solves=True,
    ),
)
