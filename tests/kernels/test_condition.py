"""No function of an arm with effects leaves that was compared with nothing but itself."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import pytest

from robodyn.dynamics import compose
from robodyn.ir.derivative import jacobian
from robodyn.ir.graph import Graph
from robodyn.ir.program import Input
from robodyn.kernels import with_effects
from robodyn.kernels.generate import Options, generate
from robodyn.kernels.proof import Unequal
from robodyn.robot import read_text

SPRING = """
name: pendulum
gravity: [0, 0, 0]
links:
  - joint: revolute
    mass: 1
    com: [0.5, 0, 0]
    inertia: {zz: 0.1}
    effects: [{effect: spring, stiffness: 20}]
"""


def test_a_spring_accelerates_back() -> None:
    """``-k / (I + m c^2)``: -20 / 0.35."""
    import robodyn

    kernel = robodyn.compile(read_text(SPRING), functions=("forward_dynamics_derivatives",))
    by_q, by_qd, by_tau = kernel.forward_dynamics_derivatives([0.3], [0.1], [0.2])
    assert by_q.item() == pytest.approx(-20 / 0.35, rel=1e-15)
    assert by_qd.item() == 0
    assert by_tau.item() == pytest.approx(1 / 0.35, rel=1e-15)


def test_a_total_derivative_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Accelerations that are differentiated as well: the torques are those put in, whatever the state."""

    def total(
        graph: Graph, torques: Callable[..., Sequence[Any]], qd: Sequence[Any], qdd: Sequence[Any]
    ) -> tuple[Any, Any]:
        tau = torques(qd, qdd)
        rows = [jacobian(graph, tau, [Input(array, i) for i in range(len(qdd))]) for array in ("q", "qd")]
        return rows[0], rows[1]

    for module in (compose, with_effects):
        monkeypatch.setattr(module, "torque_derivatives", total)
    options = Options(functions=("forward_dynamics_derivatives",))
    with pytest.raises(Unequal, match="forward_dynamics_derivatives of pendulum"):
        generate(read_text(SPRING), options)
