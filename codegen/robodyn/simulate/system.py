"""A robot with all its effects as a mechanical system for the engine: coordinates, programs, C.

Coordinates are the joints' positions [n], then those of the motors whose joints are elastic. With friction
exact at rest the directions of dry friction are inputs of the programs (the engine decides who sticks), else
they follow from the velocities.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.drives.coupling import coupler_of, memory_of
from robodyn.drives.drive import (
    Acting,
    Layer,
    Rates,
    at_motors,
    combined,
    directions,
    layer_of,
    passed_on,
    rigid_part,
)
from robodyn.dynamics.arm import JointAngle, build_arm, build_motion
from robodyn.dynamics.kinematics import frames, jacobian
from robodyn.effects.effect import Site
from robodyn.effects.scalars import is_zero
from robodyn.ir.derivative import directional
from robodyn.ir.derivative import jacobian as derivatives
from robodyn.ir.graph import Graph, Scalar
from robodyn.ir.lowering import lower
from robodyn.ir.program import Input, Program
from robodyn.kernels.options import Options
from robodyn.kernels.rigid_programs import RigidPrograms
from robodyn.kernels.with_effects import as_is, rigid_loads
from robodyn.optimize.costing import exact
from robodyn.optimize.programs import turned
from robodyn.passes import FRESH, run
from robodyn.robot.coupling import no_couplings
from robodyn.robot.model import EffectEntry, Robot
from robodyn.simulate.shape import Element, check_inertia, check_shape, elements_of, without_losses


@dataclass(frozen=True, slots=True)
class System:
    """The system of a robot.

    ``coordinates``: their number; ``motors`` [n]: the coordinate that motor j drives, ``encoders`` [n] that
    its encoder reads; ``coupled``: joints (from 0) with a coupler, in the order of their extra coordinates;
    ``states``: names of internal states; ``contacts``: external forces in windows of time.
    """

    robot: Robot
    coordinates: int
    motors: tuple[int, ...]
    encoders: tuple[int, ...]
    coupled: tuple[int, ...]
    elements: tuple[Element, ...]
    states: tuple[str, ...]
    affine: bool
    programs: dict[str, Program]
    contacts: tuple[EffectEntry, ...]

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the run-time parameters, in the order of the engine's block."""
        return self.robot.parameters

    @property
    def breaks(self) -> tuple[float, ...]:
        """Times at which external forces jump [s]."""
        return tuple(entry.number(name) for entry in self.contacts for name in ("start", "end"))


class _Builder:
    """Builds the programs of ``robot``."""

    def __init__(self, robot: Robot, options: Options) -> None:
        no_couplings(robot, "the simulator")
        self.robot, self.n = robot, robot.n
        self.exact_rest = robot.rest_velocity is None and robot.dead_band is None
        self.rigid_robot = rigid_part(robot, bare=True)
        self.drafts = RigidPrograms(self.rigid_robot, options)
        # Any values will do of which no sum is 0.
        values = {name: Fraction(10 + 3 * k, 7) for k, name in enumerate(robot.parameters)}
        shape = layer_of(robot, as_is, values.__getitem__, bare=True)
        self.coupled = tuple(i for i, drive in enumerate(shape.joints) if drive.coupler is not None)
        self.size = self.n + len(self.coupled)
        self.reactions = bool(shape.needs_reactions)
        self.affine = shape.is_affine
        self.elements = elements_of(shape, self.coupled, self.size) if self.exact_rest else ()
        self.states = tuple(
            f"{name}{i}"
            for i, drive in enumerate(shape.joints, 1)
            for acting in drive.memories
            for name in memory_of(acting).names
        )
        check_shape(robot, shape)

    def motor(self, joint: int) -> int:
        """The coordinate of the motor of ``joint``."""
        return self.n + self.coupled.index(joint) if joint in self.coupled else joint

    # -- forces ------------------------------------------------------------------------------------
    def force(
        self, graph: Graph, layer: Layer, v: list[Any], a: list[Any], *, lossless: bool = False
    ) -> list[Any]:
        """Generalised forces [coordinates] for the accelerations ``a``."""
        y = [graph.input("y", i) for i in range(self.size)]
        link_way, motor_way, pair_way = self._directions(graph, layer, v, lossless)
        n, motors = self.n, [self.motor(i) for i in range(self.n)]
        link = Rates(y[:n], v[:n], a[:n], link_way)
        q, qd, qdd = ([x[k] for k in motors] for x in (y, v, a))
        moved = Rates(q, qd, qdd, motor_way)
        rigid = None if self.reactions else self.drafts.best(self._rigid_function(a))
        loads = rigid_loads(self.rigid_robot, layer, graph, link, rigid, "modified_newton_euler")
        passed = passed_on(layer, loads, link)
        rows: list[Any] = [0] * self.size
        for i in self.coupled:
            acting = layer.joints[i].coupler
            assert acting is not None
            k = motors[i]
            pull = coupler_of(acting).torque(acting.values, y[k] - y[i], v[k] - v[i])
            rows[i] = passed[i] - pull
            passed[i] = pull
        remembered = {} if lossless else self._remembered(graph, layer, moved)
        tau = at_motors(layer, passed, moved, pair_way, remembered)
        for i, k in enumerate(motors):
            rows[k] = tau[i]
        return rows

    def _rigid_function(self, a: list[Any]) -> str:
        return "bias" if all(is_zero(x) for x in a) else "inverse_dynamics"

    def _directions(
        self, graph: Graph, layer: Layer, v: list[Any], lossless: bool
    ) -> tuple[list[Any], list[Any], list[Any]]:
        motors = [v[self.motor(i)] for i in range(self.n)]
        pairs = [combined(pair, motors) for pair in layer.pairs]
        if lossless:
            return [0] * self.n, [0] * self.n, [0] * len(pairs)
        if not self.exact_rest:
            link, motor, pair = (directions(self.robot, x, as_is) for x in (v[: self.n], motors, pairs))
            return link, motor, pair
        place = {element.what: k for k, element in enumerate(self.elements)}

        def way(*names: str) -> Any:
            return next((graph.input("s", place[name]) for name in names if name in place), 0)

        joints = range(1, self.n + 1)
        return (
            [way(f"link {i}", f"joint {i}") for i in joints],
            [way(f"motor {i}", f"joint {i}") for i in joints],
            [way(f"pair {k}") for k in range(1, len(pairs) + 1)],
        )

    def _remembered(self, graph: Graph, layer: Layer, moved: Rates) -> dict[int, list[Any]]:
        states: dict[int, list[Any]] = {}
        for i, acting, site, state in self._memories(graph, layer, moved):
            states.setdefault(i, []).append(memory_of(acting).torque(acting.values, site, state))
        return states

    def _memories(
        self, graph: Graph, layer: Layer, moved: Rates
    ) -> list[tuple[int, Acting, Site, tuple[Any, ...]]]:
        memories = []
        k = 0
        for i, drive in enumerate(layer.joints):
            site = Site(drive.revolute, moved.q[i], moved.qd[i], moved.qdd[i], moved.direction[i])
            for acting in drive.memories:
                count = len(memory_of(acting).names)
                memories.append((i, acting, site, tuple(graph.input("z", k + j) for j in range(count))))
                k += count
        return memories

    # -- programs ----------------------------------------------------------------------------------
    def programs(self) -> dict[str, Program]:
        """All programs that the engine needs, by name."""
        programs = {"mass": self._mass(), "conserved": self._bias(lossless=True)}
        if self.affine:
            programs["bias"] = self._bias()
        else:
            programs.update(self._implicit())
        if self.states:
            programs["rates"] = self._rates()
        for k, entry in enumerate(self._contacts()):
            programs[f"contact_{k}"] = self._contact(entry)
        return {name: run(program, FRESH) for name, program in programs.items()}

    def _fresh(self) -> tuple[Graph, Layer]:
        graph = Graph()
        layer = layer_of(self.robot, as_is, graph.input, bare=True)
        return graph, layer

    def _v(self, graph: Graph) -> list[Any]:
        return [graph.input("v", i) for i in range(self.size)]

    def _bias(self, *, lossless: bool = False) -> Program:
        graph, layer = self._fresh()
        if lossless:
            layer = without_losses(layer)
        h = self.force(graph, layer, self._v(graph), [0] * self.size, lossless=lossless)
        return lower(graph, [("h", h)])

    def _implicit(self) -> dict[str, Program]:
        graph, layer = self._fresh()
        a = [graph.input("a", i) for i in range(self.size)]
        f = self.force(graph, layer, self._v(graph), a)
        rows = derivatives(graph, f, [Input("a", i) for i in range(self.size)])
        flat: list[Scalar] = [x for row in rows for x in row]
        return {"force": lower(graph, [("f", f)]), "jacobian": lower(graph, [("J", flat)])}

    def tangents(self) -> dict[str, Program]:
        """How forces and rates change where positions, velocities and states change at the rates ``dy``,
        ``dv`` and ``dz``."""
        graph, layer = self._fresh()
        a = [graph.input("a", i) for i in range(self.size)]
        seeds: dict[Input, Scalar] = {
            Input(name, i): graph.input(f"d{name}", i)
            for name, count in (("y", self.size), ("v", self.size), ("z", len(self.states)))
            for i in range(count)
        }
        df = directional(graph, self.force(graph, layer, self._v(graph), a), seeds)
        rates = graph.replay(self._rates()) if self.states else []
        programs = {"force_tangent": lower(graph, [("df", df)])}
        if rates:
            programs["rates_tangent"] = lower(graph, [("dzdot", directional(graph, rates, seeds))])
        return {name: run(program, FRESH) for name, program in programs.items()}

    def _mass(self) -> Program:
        """The matrix of the rigid arm, of rotors and of motors that drive two joints."""
        graph, layer = self._fresh()
        size, n = self.size, self.n
        matrix: list[Scalar] = [0] * (size * size)
        inputs: dict[Input, Scalar] = {Input("q", i): graph.input("y", i) for i in range(n)}
        entries = graph.replay(self.drafts.best("mass_matrix"), inputs=inputs)
        for i in range(n):
            for j in range(n):
                matrix[size * i + j] = entries[n * i + j]
        for i, drive in enumerate(layer.joints):
            k = self.motor(i)
            matrix[size * k + k] = matrix[size * k + k] + drive.rotor
        for pair in layer.pairs:
            inertia = pair.acting.values["inertia"]
            ends = ((self.motor(pair.one), 1), (self.motor(pair.other), pair.ratio))
            for k, x in ends:
                for j, y in ends:
                    matrix[size * k + j] = matrix[size * k + j] + inertia * (x * y)
        return lower(graph, [("M", matrix)])

    def _rates(self) -> Program:
        graph, layer = self._fresh()
        v = self._v(graph)
        y = [graph.input("y", i) for i in range(self.size)]
        motors = [self.motor(i) for i in range(self.n)]
        nothing: list[Any] = [0] * self.n
        moved = Rates([y[k] for k in motors], [v[k] for k in motors], nothing, nothing)
        rates: list[Scalar] = []
        for _, acting, site, state in self._memories(graph, layer, moved):
            rates += memory_of(acting).rates(acting.values, site, state)
        return lower(graph, [("zdot", rates)])

    def _contacts(self) -> tuple[EffectEntry, ...]:
        return tuple(e for e in self.robot.effects if e.definition.place == "outside" and "log" not in e)

    def _contact(self, entry: EffectEntry) -> Program:
        """``J^T F`` of a force on the origin of a link's frame, along the base's axes."""
        graph, _ = self._fresh()
        arm = build_arm(self.rigid_robot, exact, graph.input)
        q = [graph.input("y", i) for i in range(self.n)]

        def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
            return turned(graph, q, angle)

        zeros = [0] * self.n
        placed = frames(arm, build_motion(arm, q, zeros, zeros, trigonometry, exact))
        rows = jacobian(arm, placed, link=entry["link"])[:3]
        force = [entry[f"force_{axis}"] for axis in "xyz"]
        torque: list[Scalar] = [
            sum((row[j] * f for row, f in zip(rows, force, strict=True)), start=0 * q[0])
            for j in range(self.n)
        ]
        return lower(graph, [("f", torque + [0] * len(self.coupled))])

    def system(self) -> System:
        """The system with its programs."""
        motors = tuple(self.motor(i) for i in range(self.n))
        encoders = []
        for i, entries in ((i, self.robot.effects_at(i + 1)) for i in range(self.n)):
            at_link = any("encoder" in e and e.text("encoder") == "link" for e in entries)
            encoders.append(i if at_link else motors[i])
        programs = self.programs()
        check_inertia(self.robot, programs["mass"], self.size)
        return System(
            self.robot, self.size, motors, tuple(encoders), self.coupled, self.elements, self.states,
            self.affine, programs, self._contacts(),
        )  # fmt: skip


def system_of(robot: Robot, options: Options | None = None) -> System:
    """The mechanical system of ``robot`` with its effects.

    Raises
    ------
    InputError: a coordinate would move without inertia, or the torque is the link's.
    """
    return _Builder(robot, options or Options()).system()


def tangents_of(robot: Robot, options: Options | None = None) -> dict[str, Program]:
    """Programs of directional derivatives of the same system: ``force_tangent``, of forces for accelerations
    ``a``, and ``rates_tangent``, of the rates of internal states if there are any.

    Raises
    ------
    InputError: as :func:`system_of`.
    """
    return _Builder(robot, options or Options()).tangents()
