"""A function out of programs of its parts, however they were found: forward dynamics of bias and matrix."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from robodyn.dynamics.functions import Dynamics, Function, Rotor, torques_at
from robodyn.dynamics.state import RigidDrives, Vector
from robodyn.ir.derivative import jacobian
from robodyn.ir.graph import Graph
from robodyn.ir.lowering import lower
from robodyn.ir.program import Input, Label, Program

if TYPE_CHECKING:
    from robodyn.dynamics.base_set import BaseParameter

#: The dynamics in a graph, at inputs ``[n]`` by name.
Beneath = Callable[[Graph, Mapping[str, Vector]], Dynamics]
#: Matrices as rows.
Rows = list[list[Any]]


class DynamicsOnTop(RigidDrives):
    """What the dynamics ``beneath`` say of places, motion and masses, is what these say; see
    :class:`robodyn.dynamics.functions.Dynamics`."""

    def __init__(self, beneath: Dynamics) -> None:
        self.beneath, self.arm = beneath, beneath.arm
        self.cheapest, self.rounding = beneath.cheapest, beneath.rounding
        self.motion, self.turns, self.links = beneath.motion, beneath.turns, beneath.links
        self.reactions = beneath.reactions

    def base_set(self) -> Sequence[BaseParameter]:
        """The base parameters."""
        return self.beneath.base_set()

    def rotors(self) -> Sequence[Rotor]:
        """The rotors."""
        return self.beneath.rotors()

    def inertial_torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Sequence[Any]:
        """Joint torques [n] without gravity and what drives do besides."""
        return self.beneath.inertial_torques(qd, qdd)


def composed(function: Function, programs: Mapping[str, Program], n: int, beneath: Beneath) -> list[Program]:
    """``function`` of ``n`` joints, put together from ``programs`` in all ways that it has: one for each of
    its parts, by name; what is of no part comes from the dynamics ``beneath``."""
    ways = []
    for write in function.compositions(n):
        graph = Graph()
        elements = write(_OfParts(graph, function, programs, n, beneath))
        ways.append(lower(graph, function.split(elements, n)))
    return ways


def side_by_side(function: Function, programs: Sequence[Program]) -> Program:
    """The fused ``function``: what the ``programs`` of its functions, or of several of them together, have in
    common is worked out once."""
    graph = Graph()
    results: dict[str, Sequence[Any]] = {}
    for program in programs:
        values = iter(graph.replay(program))
        results |= {name: [next(values) for _ in elements] for name, elements in program.outputs}
    return lower(graph, [(array.name, results[array.name]) for array in function.results])


def torque_derivatives(
    graph: Graph, torques: Callable[[Vector, Vector], Vector], qd: Vector, qdd: Vector
) -> tuple[Rows, Rows]:
    """Derivatives of ``torques(qd, qdd)`` by positions and by velocities, as rows. The accelerations are
    constant, also where they are made of positions and velocities: they are variables until all is
    differentiated, and only then what they are made of."""
    n = len(qdd)
    variables = [Input("qdd", i) for i in range(n)]
    tau = torques(qd, [graph.input("qdd", i) for i in range(n)])
    rows = [jacobian(graph, tau, [Input(array, i) for i in range(n)]) for array in ("q", "qd")]
    program = lower(graph, [("", [x for matrix in rows for row in matrix for x in row])])
    entries = graph.replay(program, inputs=dict(zip(variables, qdd, strict=True)))
    matrix = [entries[k : k + n] for k in range(0, len(entries), n)]
    return matrix[:n], matrix[n:]


class _OfParts(DynamicsOnTop):
    """The dynamics that programs give."""

    def __init__(
        self, graph: Graph, function: Function, programs: Mapping[str, Program], n: int, beneath: Beneath
    ) -> None:
        self._graph, self._function, self._programs = graph, function, programs
        self._values: dict[str, list[Any]] = {part: graph.replay(programs[part]) for part in function.parts}
        self.rest: Sequence[Any] = [0] * n
        self.inputs = function.nodes(graph.input, n)
        super().__init__(beneath(graph, self.inputs))

    def mark(self, value: Any, label: Label) -> Any:
        """Name ``value``."""
        return self._graph.label(value, label)

    def torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Joint torques [n], of the part that gives them."""
        part = torques_at(qd, qdd).name
        values, rates = self._part(part), {"qd": qd, "qdd": qdd}
        other = [name for name, x in rates.items() if x is not self.rest and x is not self.inputs.get(name)]
        if not other:
            return values
        inputs = {Input(name, i): x for name in other for i, x in enumerate(rates[name])}
        return self._graph.replay(self._programs[part], inputs=inputs)

    def torque_derivatives(self, qdd: Sequence[Any]) -> tuple[Rows, Rows]:
        """Derivatives of the part that gives torques by positions and by velocities, as rows."""
        return torque_derivatives(self._graph, self.torques, self.inputs["qd"], qdd)

    def mass_matrix(self) -> list[list[Any]]:
        """Mass matrix [n][n]."""
        entries, n = self._part("mass_matrix"), len(self.rest)
        return [list(entries[n * i : n * (i + 1)]) for i in range(n)]

    def _part(self, name: str) -> list[Any]:
        if name not in self._values:
            raise ValueError(
                f"function {self._function.name!r} asks for what {name} gives, and its parts are "
                f"{', '.join(self._function.parts)}"
            )
        return self._values[name]
