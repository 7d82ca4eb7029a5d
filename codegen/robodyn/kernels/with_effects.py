"""Programs of robots whose drives have effects: the rigid arm's program with the drives on top of it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from robodyn.drives.coupling import TwistState, link_rates, memory_of, motor_rates, next_twist
from robodyn.drives.drive import (
    Layer,
    Loads,
    Rates,
    at_motors,
    combined,
    directions,
    layer_of,
    passed_on,
    rigid_part,
)
from robodyn.dynamics.arm import JointAngle, build_arm, build_motion
from robodyn.dynamics.compose import DynamicsOnTop, Rows, torque_derivatives
from robodyn.dynamics.functions import Function, Rotor, torques_at
from robodyn.dynamics.kinematics import frames
from robodyn.dynamics.modified_newton_euler import modified_newton_euler
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.state import with_rotors
from robodyn.dynamics.vectors import cross, plus, scaled
from robodyn.effects.effect import Site
from robodyn.errors import InputError
from robodyn.ir.graph import Graph
from robodyn.ir.lowering import lower
from robodyn.ir.program import Input, Label, Program
from robodyn.optimize.programs import Choice, NoForwardDynamics, base_set_of, exact, recursion_in, turned
from robodyn.robot.model import Robot

if TYPE_CHECKING:
    from robodyn.dynamics.base_set import BaseParameter

#: Recursions that pass by the force and the moment in every joint.
REACTIONS = {"modified_newton_euler": modified_newton_euler, "newton_euler": newton_euler}


def as_is(x: Any) -> Any:
    """``x``: a Fraction stays one even where it is whole, for integers divide to floats."""
    return x


class ImplicitDynamics(NoForwardDynamics):
    """Friction depends on the load, the load on the accelerations: forward dynamics has no formula."""


def layered(
    robot: Robot,
    function: Function,
    rigid: Callable[[str], Program | None],
    formulation: str,
    *,
    writing: int | None = 0,
) -> Program:
    """The program of ``function`` of ``robot``. ``rigid`` has the programs of :func:`.drive.rigid_part` by
    the function's name; of torques maybe none: then the recursion ``formulation`` runs here, with the forces
    in the joints. ``writing`` is one of the function's ``writings``; None: the way that it is checked by.

    Raises
    ------
    InputError: ``formulation`` has no forces in joints, and bearings feel them.
    """
    if writing is None:
        at = _Layered(robot, function, rigid, formulation, Choice("newton_euler", False, False))
        write = function.expected or function.outputs
    else:
        at = _Layered(robot, function, rigid, formulation, Choice())
        write = function.writings(robot.n)[writing]
    outputs = function.split(list(write(at)), robot.n)
    return lower(at.graph, outputs + ([("state", at.states)] if at.states else []))


class _Layered(DynamicsOnTop):
    """Drives on a rigid arm, in a graph; see :class:`robodyn.dynamics.functions.Dynamics`."""

    def __init__(
        self,
        robot: Robot,
        function: Function,
        rigid: Callable[[str], Program | None],
        formulation: str,
        choice: Choice,
    ) -> None:
        self.graph = Graph()
        self._layer = layer_of(robot, as_is, self.graph.input)
        self._robot, self._rigid, self._formulation = robot, rigid, formulation
        #: Whether states take a step; else effects are in their steady form.
        self._remembers = function.is_recursion
        #: The states after the step.
        self.states: list[Any] = []
        self.rest: Sequence[Any] = [0] * robot.n
        self.inputs = function.nodes(self.graph.input, robot.n)
        super().__init__(recursion_in(self.graph, rigid_part(robot), choice, self.inputs))

    def torque_derivatives(self, qdd: Sequence[Any]) -> tuple[Rows, Rows]:
        """Derivatives of the torques by positions and by velocities, through all effects, as rows."""
        return torque_derivatives(self.graph, self.torques, self.inputs["qd"], qdd)

    def base_set(self) -> tuple[BaseParameter, ...]:
        """There are none: torques are not linear in any."""
        return base_set_of(self._robot)

    def rotors(self) -> list[Rotor]:
        """The rotors of the drives."""
        return [*self.beneath.rotors(), *self._layer.rotors()]

    def inertial_torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Torques [n] of the rigid arm and all rotors, without gravity and what drives do besides."""
        return with_rotors(self.beneath.inertial_torques(qd, qdd), self._layer.rotors(), qdd)

    def mark(self, value: Any, label: Label) -> Any:
        """Name ``value``."""
        return self.graph.label(value, label)

    def torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Motor torques [n]."""
        return self._torques(qd, qdd, None)

    def torques_under_wrench(
        self, qd: Sequence[Any], qdd: Sequence[Any], wrench_torques: Sequence[Any]
    ) -> list[Any]:
        """The same under the wrench, which bearings and gears feel as they feel the arm."""
        placed = frames(self.arm, self.motion(self.rest, self.rest), self.arm.base)
        place = self.arm.tool.within(placed[-1]).origin
        fx, fy, fz, nx, ny, nz = self.inputs["w"]
        f: dict[int, Any] = {}
        n: dict[int, Any] = {}
        for i in self._layer.needs_reactions:
            lever = plus(place, scaled(-1, placed[i].origin))
            f[i] = placed[i].back((fx, fy, fz))
            n[i] = placed[i].back(plus((nx, ny, nz), cross(lever, (fx, fy, fz))))
        return self._torques(qd, qdd, Loads(wrench_torques, f, n))

    def _torques(self, qd: Sequence[Any], qdd: Sequence[Any], relief: Loads | None) -> list[Any]:
        motion = (self.inputs["q"], list(qd), list(qdd))
        tau, self.states = outputs(
            self._robot,
            self._layer,
            self.graph,
            motion,
            self._rigid(torques_at(qd, qdd).name),
            self._formulation,
            remembers=self._remembers,
            relief=relief,
        )
        return tau

    def mass_matrix(self) -> list[list[Any]]:
        """The rigid arm's mass matrix [n][n] with all rotors."""
        rigid, n = self._rigid("mass_matrix"), self._robot.n
        assert rigid is not None  # no force in a joint is in it
        entries = _with_rotors(self._layer, self.graph.replay(rigid), n)
        return [entries[n * i : n * (i + 1)] for i in range(n)]


def outputs(
    robot: Robot,
    layer: Layer,
    graph: Graph,
    motion: tuple[list[Any], list[Any], list[Any]],
    rigid: Program | None,
    formulation: str,
    *,
    remembers: bool,
    relief: Loads | None = None,
) -> tuple[list[Any], list[Any]]:
    """Motor torques [n] at positions, rates and accelerations, and the states after the step, if what has
    memory ``remembers``. ``relief`` is what a wrench on the tool takes from the joints."""
    twists, memories = _given_states(layer, graph) if remembers else ({}, {})
    measured = Rates(*motion, directions(robot, motion[1], as_is))
    link, moved = measured, measured
    if twists:
        link = link_rates(layer, measured, twists)
        link = Rates(link.q, link.qd, link.qdd, directions(robot, link.qd, as_is))
    loads = rigid_loads(robot, layer, graph, link, rigid, formulation)
    if relief is not None:
        loads = _relieved(loads, relief)
    passed = passed_on(layer, loads, link)
    states: list[Any] = []
    dt = graph.input("dt", 0) if twists or memories else 0
    after = {i: next_twist(layer.joints[i], passed[i], twist, dt) for i, twist in twists.items()}
    if after:
        moved = motor_rates(layer, measured, after)
        moved = Rates(moved.q, moved.qd, moved.qdd, directions(robot, moved.qd, as_is))
    remembered: dict[int, list[Any]] = {}
    for i, drive in enumerate(layer.joints):
        if i in after:
            states += [after[i].twist, after[i].rate, after[i].acceleration]
        at = Site(drive.revolute, moved.q[i], moved.qd[i], moved.qdd[i], moved.direction[i])
        for acting, state in zip(drive.memories, memories.get(i, ()), strict=remembers):
            new, torque = memory_of(acting).step(acting.values, at, tuple(state), dt)
            states += new
            remembered.setdefault(i, []).append(torque)
    pairs = directions(robot, [combined(pair, moved.qd) for pair in layer.pairs], as_is)
    tau = at_motors(layer, passed, moved, pairs, remembered if remembers else None)
    return [graph.label(x, Label(i, "tau", "")) for i, x in enumerate(tau, 1)], states


def _relieved(loads: Loads, relief: Loads) -> Loads:
    """``loads`` less ``relief``."""
    f, n = (
        {i: plus(u, scaled(-1, less[i])) for i, u in vectors.items()}
        for vectors, less in ((loads.f, relief.f), (loads.n, relief.n))
    )
    return Loads([tau - push for tau, push in zip(loads.tau, relief.tau, strict=True)], f, n)


def steady_torques(robot: Robot) -> Program:
    """Motor torques ``tau`` of ``q, qd, qdd`` by the recursion of the book with the drives on it; what
    remembers is in its steady form."""
    graph = Graph()
    q, qd, qdd = ([graph.input(name, i) for i in range(robot.n)] for name in ("q", "qd", "qdd"))
    layer = layer_of(robot, as_is, graph.input)
    tau, _ = outputs(robot, layer, graph, (q, qd, qdd), None, "newton_euler", remembers=False)
    return lower(graph, [("tau", tau)])


def _given_states(layer: Layer, graph: Graph) -> tuple[dict[int, TwistState], dict[int, list[list[Any]]]]:
    """The states before the step, by joint: of couplers, and of stateful effects."""
    names = iter(range(len(layer.state_names)))
    twists: dict[int, TwistState] = {}
    memories: dict[int, list[list[Any]]] = {}
    for i, drive in enumerate(layer.joints):
        if drive.coupler is not None:
            twists[i] = TwistState(*(graph.input("state", next(names)) for _ in range(3)))
        for acting in drive.memories:
            state = [graph.input("state", next(names)) for _ in memory_of(acting).names]
            memories.setdefault(i, []).append(state)
    return twists, memories


def rigid_loads(
    robot: Robot, layer: Layer, graph: Graph, link: Rates, rigid: Program | None, formulation: str
) -> Loads:
    """What the rigid arm puts on its joints, as nodes of ``graph``."""
    if rigid is not None:
        arrays = {"q": link.q, "qd": link.qd, "qdd": link.qdd}
        inputs = {Input(name, i): x for name, array in arrays.items() for i, x in enumerate(array)}
        return Loads(graph.replay(rigid, inputs=inputs))
    if formulation not in REACTIONS:
        raise InputError(
            f"the formulation {formulation} has no forces in the joints, which bearings feel",
            expected=" or ".join(REACTIONS),
        )
    arm = build_arm(rigid_part(robot), exact, graph.input)

    def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
        return turned(graph, link.q, angle)

    loads: dict[tuple[int, str, str], Any] = {}

    def mark(value: Any, label: Label) -> Any:
        loads[label.link - 1, label.quantity, label.axis] = value
        return graph.label(value, label)

    motion = build_motion(arm, link.q, link.qd, link.qdd, trigonometry, exact)
    tau = REACTIONS[formulation](arm, motion, mark)

    def vectors(quantity: str) -> dict[int, tuple[Any, Any, Any]]:
        axes = {i: [loads[i, quantity, axis] for axis in "xyz"] for i in layer.needs_reactions}
        return {i: (x, y, z) for i, (x, y, z) in axes.items()}

    return Loads(tau, vectors("f"), vectors("n"))


def _with_rotors(layer: Layer, entries: list[Any], n: int) -> list[Any]:
    """The rigid arm's mass matrix with the rotors and the motors that drive two joints: row by row."""
    matrix = list(entries)
    for rotor in layer.rotors():
        for i, one in rotor.rates:
            for j, other in rotor.rates:
                matrix[n * i + j] = matrix[n * i + j] + rotor.inertia * (one * other)
    return matrix


def is_affine(robot: Robot) -> bool:
    """Whether torques are affine in accelerations: no friction depends on the load."""
    return not robot.effects or layer_of(robot, as_is, lambda _: 1).is_affine


def check_solvable(robot: Robot, function: Function) -> None:
    """:class:`ImplicitDynamics` where ``function`` solves for accelerations of ``robot``, on which friction
    depends through the load."""
    if function.solves and not is_affine(robot):
        raise ImplicitDynamics(
            f"{robot.name} has no {function.words} in closed form",
            found="friction that depends on the load, and so on the accelerations",
            remedy="robodyn simulate solves for them; or leave those effects out",
        )
