"""Programs of arms whose joints follow others: those of the same arm with every joint moving by itself, of
``q = G u + o`` in the place of ``q``, and what comes out for each joint mapped by ``G^T``.

This happens before anything is optimised, in a graph that merges equal values: what a ratio makes 0 or 1
costs nothing, and where the angles of parallel joints add up to a constant, as those of a palletizer's level
axis do, sines, cosines and all that rests on them are numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from math import prod
from typing import Any

from robodyn.dynamics.arm import Body, build_arm
from robodyn.dynamics.compose import Rows
from robodyn.dynamics.functions import Function, NoSuchFunction, torques_at
from robodyn.dynamics.limits import ROUNDING
from robodyn.dynamics.state import First, RigidDrives
from robodyn.ir.evaluate import angle_form, is_angle
from robodyn.ir.fingerprint import digest, in_drawn_field
from robodyn.ir.graph import Graph, Scalar
from robodyn.ir.lowering import lower
from robodyn.ir.program import Input, Label, Operand, Program
from robodyn.optimize.costing import exact
from robodyn.optimize.merging import MergingGraph
from robodyn.robot.coupling import Transmission, transmission_of
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot
from robodyn.robot.values import Angle, angle, circle_point

#: Arrays with an element for each joint, in whose place coordinates take.
_MOTION = ("q", "qd", "qdd")


def folded(program: Program, function: Function, robot: Robot) -> Program:
    """``program``, of ``function`` of ``robot`` with every joint moving by itself, as one of the coordinates
    that its joints follow."""
    transmission, numbers = transmission_of(robot), identity(robot).encode()
    folded: Program = in_drawn_field(
        lambda field: _Folding(MergingGraph(field), transmission).program(program, function),
        digest(program),
        numbers,
        prime_of=b"merging " + numbers,
    )
    return folded


class _Folding:
    """A program of joints, in a graph in which joints follow coordinates."""

    def __init__(self, graph: Graph, transmission: Transmission) -> None:
        self._graph, self._transmission = graph, transmission
        m, offsets = range(len(transmission.commanded)), transmission.offsets
        self._inputs: dict[Input, Scalar] = {}
        for name in _MOTION:
            spread = transmission.spread([graph.input(name, k) for k in m], exact)
            if name == "q":
                spread = [q + exact(o) if o else q for q, o in zip(spread, offsets, strict=True)]
            self._inputs |= {Input(name, i): x for i, x in enumerate(spread)}
        self._values: list[Scalar] = []

    def program(self, program: Program, function: Function) -> Program:
        """``program`` of ``function`` in the coordinates."""
        cache: dict[int, Any] = {}
        for op, args, label in program.operations:
            if op in ("sin", "cos") and is_angle(program, args[0], cache):
                value = self._turned(angle_form(program, args[0], cache), label)[op == "sin"]
            else:
                value = self._graph.apply(op, [self._value(arg) for arg in args])
            self._values.append(self._graph.label(value, label) if label is not None else value)
        shapes = {array.name: array.shape for array in function.results}
        outputs = []
        for name, elements in program.outputs:
            values: Sequence[Any] = [self._value(element) for element in elements]
            outputs.append((name, mapped(self._transmission, values, shapes.get(name, ()))))
        return lower(self._graph, outputs)

    def _value(self, operand: Operand) -> Scalar:
        if isinstance(operand, int):
            return self._values[operand]
        if isinstance(operand, Input):
            return self._inputs[operand] if operand in self._inputs else self._graph.input(*operand)
        return operand

    def _turned(self, form: Any, label: Label | None) -> tuple[Any, Any]:
        """Cosine and sine of a sum of joints' angles and a constant.

        Of constant angles that are no quarter turns one may be added to the coordinates; points of the circle
        that stand for others are turned by, so that what is exactly an angle of the arm stays that.
        """
        terms, constant = form
        total: dict[Input, Fraction] = {}
        starts = [Angle(float(constant), *circle_point(constant), None)] if constant else []
        for x, multiple in terms:
            if x.array != "q":
                total[x] = total.get(x, Fraction(0)) + multiple
                continue
            if offset := self._transmission.offsets[x.index]:
                starts.append(angle(multiple * offset))
            for k, g in self._transmission.rows[x.index].items():
                u = Input("q", k)
                total[u] = total.get(u, Fraction(0)) + multiple * g
        kept = [(x, factor) for x, factor in sorted(total.items()) if factor]
        argument: Any = 0
        for x, factor in kept:
            argument = argument + exact(factor) * self._graph.input(*x)
        added = next((start for start in starts if start.quarter is None), None) if kept else None
        if added is not None:
            argument = argument + (constant if constant and added is starts[0] else Fraction(added.radians))
        c, s = self._graph.cos(argument), self._graph.sin(argument)
        for start in starts:
            if start is not added:
                e, f = exact(start.cos), exact(start.sin)
                c, s = e * c - f * s, e * s + f * c
        return c, s


def mapped(
    transmission: Transmission,
    elements: Sequence[Any],
    shape: Sequence[Any],
    number: Callable[[Fraction], Any] = exact,
) -> Sequence[Any]:
    """``elements`` of a result of that ``shape``, one after another, by ``G^T`` along each axis of joints:
    those of links, base parameters and the world stay. Over scalars that ``number`` makes of rationals."""
    n, m = len(transmission.rows), len(transmission.commanded)
    lengths = [n if length in ("n", "l") else 1 if length == "p" else length for length in shape]
    if "p" in shape:
        lengths[list(shape).index("p")] = len(elements) // prod(lengths)
    for axis, length in enumerate(shape):
        if length != "n":
            continue
        outer, inner = prod(lengths[:axis]), prod(lengths[axis + 1 :])
        rows = [elements[k * n * inner : (k + 1) * n * inner] for k in range(outer)]
        folded = [
            transmission.folded([row[joint * inner + k] for joint in range(n)], number)
            for row in rows
            for k in range(inner)
        ]
        elements = [
            folded[block * inner + k][column]
            for block in range(outer)
            for column in range(m)
            for k in range(inner)
        ]
        lengths[axis] = m
    return elements


#: The program of a function in the coordinates.
Programs = Callable[[str], Program]


def in_coordinates(function: Function, robot: Robot, programs: Programs) -> Program:
    """``function`` put together from functions in the coordinates of ``robot``: what is solved there."""
    assert function.in_coordinates is not None
    at: Any = _InCoordinates(Graph(), function, robot, programs)  # all that such functions ask for
    return lower(at.graph, function.split(list(function.in_coordinates(at)), len(robot.commanded)))


class _InCoordinates(RigidDrives):
    """The dynamics of ``robot`` in the coordinates that its joints follow, as programs give them; see
    :class:`robodyn.dynamics.functions.Dynamics`."""

    cheapest, rounding = First(), ROUNDING["double"]

    def __init__(self, graph: Graph, function: Function, robot: Robot, programs: Programs) -> None:
        self.graph, self._robot, self._programs = graph, robot, programs
        self.inputs = function.nodes(graph.input, len(robot.commanded))
        self.rest: Sequence[Any] = [0] * len(robot.commanded)

    def driven(self) -> Sequence[Body]:
        """The bodies whose joints are commanded.

        Raises
        ------
        NoSuchFunction: a joint that follows another has a motor of its own.
        """
        joints = {coupling.joint - 1 for coupling in self._robot.couplings}
        geared = [str(joint + 1) for joint in sorted(joints) if self._robot.links[joint].joint.gear]
        if geared:
            raise NoSuchFunction(
                "how several motors share a torque is not known",
                found=f"a gear at joint {', '.join(geared)}, which follows another",
                expected="gears at joints that follow no other",
                remedy="delete that gear, or leave the function out",
            )
        bodies = build_arm(self._robot.free, exact, self.graph.input).bodies
        return [bodies[joint] for joint in self._robot.commanded]

    def mark(self, value: Any, label: Label) -> Any:
        """Name ``value``."""
        return self.graph.label(value, label)

    def of(self, function: str) -> list[Any]:
        """The results of another function at the same state."""
        return self._at(function, {})

    def torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Torques [n]."""
        return self._at(torques_at(qd, qdd).name, {"qd": qd, "qdd": qdd})

    def mass_matrix(self) -> Rows:
        """Mass matrix [n][n]."""
        return self._rows(self.of("mass_matrix"))

    def torque_derivatives(self, qdd: Sequence[Any]) -> tuple[Rows, Rows]:
        """Derivatives of the torques by positions and by velocities, as rows."""
        entries, n = self._at("inverse_dynamics_derivatives", {"qdd": qdd}), len(self.rest)
        return self._rows(entries[: n * n]), self._rows(entries[n * n :])

    def _rows(self, entries: Sequence[Any]) -> Rows:
        n = len(self.rest)
        return [list(entries[k : k + n]) for k in range(0, len(entries), n)]

    def _at(self, function: str, arrays: Mapping[str, Sequence[Any]]) -> list[Any]:
        """The results of ``function`` at the motion of these ``arrays``, else at the inputs."""
        inputs = {Input(name, i): x for name, array in arrays.items() for i, x in enumerate(array)}
        return self.graph.replay(self._programs(function), inputs=inputs)
