"""Where a simulation begins: motors of elastic joints twisted as the arm's weight has them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.drives.coupling import coupler_of
from robodyn.drives.drive import Layer, Loads, Rates, layer_of, passed_on, rigid_part
from robodyn.dynamics.arm import Arm, JointAngle, Trigonometry, build_arm, build_motion, trigonometry_at
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.ir.graph import Graph
from robodyn.ir.lowering import lower
from robodyn.ir.program import Program
from robodyn.kernels.with_effects import as_is
from robodyn.optimize.costing import exact
from robodyn.optimize.programs import turned
from robodyn.passes import FRESH, run
from robodyn.simulate.system import System


def start_state(
    system: System, q: Floats, qd: Floats, parameters: Mapping[str, float]
) -> tuple[Floats, Floats, Floats]:
    """Coordinates, velocities and internal states for links at ``q``, moving at ``qd`` [n].

    Couplers are twisted by the torque that holds the arm still there, their two sides move alike; bristles
    are straight.
    """
    n, coupled = system.robot.n, list(system.coupled)
    y, v = np.concatenate([q, q[coupled]]), np.concatenate([qd, qd[coupled]])
    if coupled:
        arm = build_arm(rigid_part(system.robot, bare=True), float, parameters.__getitem__)
        layer = layer_of(system.robot, float, parameters.__getitem__, bare=True)
        places = [float(x) for x in q]
        y[n:] += _twists(system, arm, layer, places, trigonometry_at(places), float)
    return y, v, np.zeros(len(system.states))


def start_program(system: System) -> Program:
    """The same as a program: from ``q`` [n] to ``motor``, the coordinates of the motors of couplers."""
    graph = Graph()
    arm = build_arm(rigid_part(system.robot, bare=True), exact, graph.input)
    layer = layer_of(system.robot, as_is, graph.input, bare=True)
    q = [graph.input("q", i) for i in range(system.robot.n)]

    def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
        return turned(graph, q, angle)

    twists = _twists(system, arm, layer, q, trigonometry, exact)
    motors = [q[i] + twist for i, twist in zip(system.coupled, twists, strict=True)]
    return run(lower(graph, [("motor", motors)]), FRESH)


def _twists(
    system: System,
    arm: Arm,
    layer: Layer,
    q: Sequence[Any],
    trigonometry: Trigonometry,
    constant: Callable[[Any], Any],
) -> list[Any]:
    """How far the motors of couplers are ahead of links that rest at ``q`` [n]."""
    zeros: list[Any] = [0] * system.robot.n
    tau = newton_euler(arm, build_motion(arm, q, zeros, zeros, trigonometry, constant))
    none = dict.fromkeys(range(system.robot.n), (0, 0, 0))
    passed = passed_on(layer, Loads(tau, none, none), Rates(q, zeros, zeros, zeros))
    twists = []
    for i in system.coupled:
        acting = layer.joints[i].coupler
        assert acting is not None
        twists.append(coupler_of(acting).twist(acting.values, passed[i]))
    return twists
