"""The kernels of an arm: which inputs they have, and the recursion that gives their outputs.

Here a robot becomes a graph: the recursions of this room run on nodes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from robodyn.dynamics.arm import Arm, JointAngle, Motion, Trigonometry, build_arm, build_motion, inertial
from robodyn.dynamics.functions import Moving, NoSuchFunction, Rotor, function_named
from robodyn.dynamics.functions.record import Writing
from robodyn.dynamics.joints import rotors_of
from robodyn.dynamics.limits import ROUNDING
from robodyn.dynamics.lump import NO_LUMP, MomentForm
from robodyn.dynamics.mass_matrix import mass_matrix
from robodyn.dynamics.modified_newton_euler import beyond_the_last_link, reactions
from robodyn.dynamics.parallel import Turns, chain_turns, single_turns
from robodyn.dynamics.regroup import lumps_of, regrouped_with_ground
from robodyn.dynamics.state import RigidDrives
from robodyn.dynamics.vectors import Mark, Vector
from robodyn.errors import InputError
from robodyn.ir import Graph, Node, Program, Signature
from robodyn.ir.fingerprint import in_drawn_field
from robodyn.ir.lowering import lower
from robodyn.ir.signature import ScalarType
from robodyn.optimize.base_parameters import BaseNewtonEuler
from robodyn.optimize.cheapest import Cheapest
from robodyn.optimize.choice import FORMULATIONS as FORMULATIONS
from robodyn.optimize.choice import Choice as Choice
from robodyn.optimize.choice import Inputs, Split, formulation_named, in_reading_order, iterated
from robodyn.optimize.costing import exact as exact
from robodyn.optimize.fast import centred, slid, suited_variant
from robodyn.optimize.gauge import regrouped_as, with_displacements
from robodyn.optimize.merging import MergingGraph
from robodyn.robot.identity import identity
from robodyn.robot.masses import require_masses
from robodyn.robot.model import Robot

if TYPE_CHECKING:
    from robodyn.dynamics.base_set import BaseParameter
    from robodyn.dynamics.inverse import Inverse as ClosedForm
    from robodyn.dynamics.inverse import Numerical


#: Joint torques [n] from rates ``qd`` and accelerations ``qdd``.
Inverse = Callable[[Sequence[Any], Sequence[Any]], list[Any]]


class NoForwardDynamics(NoSuchFunction):
    """An arm has no forward dynamics, or none in closed form; ``found`` says why."""


def signature(robot: Robot, function: str, scalar: ScalarType = "double") -> Signature:
    """The interface of ``function`` of ``robot``.

    Raises
    ------
    InputError: an unknown function, or one that would rest on masses that nobody knows.
    """
    record, n = function_named(function), len(robot.commanded)
    if not record.geometric:
        require_masses(robot)
    if record.of_pose and robot.couplings:
        raise NoSuchFunction(
            f"{robot.name} has no {record.words} yet: joints follow others",
            found=f"{robot.n - n} of {robot.n} joints follow others",
            expected="joints that move by themselves",
            remedy="leave the function out",
        )
    columns = base_set_of(robot) if record.has_parameters else ()
    p = len(columns)
    b = inverse_kinematics_of(robot).branches if record.has_branches else 0
    return Signature(
        robot=robot.name,
        function=function,
        inputs=tuple((array.name, array.size_at(n, p, b, robot.n)) for array in record.inputs),
        outputs=tuple(
            (array.name, size) for array in record.results if (size := array.size_at(n, p, b, robot.n))
        ),
        parameters=robot.parameters,
        scalar=scalar,
        states=_states(robot) if record.is_recursion and robot.effects else (),
        joints=n,
        columns=tuple(map(str, columns)),
    )


def base_set_of(robot: Robot) -> tuple[BaseParameter, ...]:
    """The base parameters of ``robot``, base to tip.

    Raises
    ------
    NoSuchFunction: its drives have effects, or a length is a run-time parameter.
    """
    from robodyn.drives.drive import has_drive_effects
    from robodyn.dynamics.base_set import base_set

    if has_drive_effects(robot):
        raise NoSuchFunction(
            f"{robot.name}: torques are not linear in base parameters",
            found="drives with effects",
            remedy="leave the effects out; torque_side: link leaves out all but springs and bearings",
        )
    try:
        return base_set(build_arm(robot.free, exact, Graph().input))
    except InputError as error:
        raise NoSuchFunction(error.what, found=error.found, remedy=error.remedy) from None


def inverse_kinematics_of(robot: Robot) -> ClosedForm | Numerical:
    """How the joint positions of a pose are solved for.

    Raises
    ------
    NoSuchFunction: a length is a run-time parameter.
    """
    from robodyn.dynamics.inverse import solver_of

    return solver_of(build_arm(robot, exact, Graph().input))


def _states(robot: Robot) -> tuple[str, ...]:
    from robodyn.drives.drive import layer_of

    return layer_of(robot, lambda x: x, lambda _: 1).state_names


def build(
    robot: Robot,
    function: str,
    choice: Choice,
    writing: Writing | None = None,
    *,
    scalar: ScalarType = "double",
) -> Program:
    """The program of ``function`` as the recursion leaves it: equal nodes merged, constants folded,
    nothing dead, no pass run yet. ``writing`` says how its outputs are written, if not as usual; ``scalar``
    what it is for, which programs with thresholds depend on."""
    # Where equal values are one node whichever way they were written, there is nothing to choose from.
    known = function_named(function)
    if choice.variant is None or known.geometric or known.at_rest:
        return _built(Graph(), robot, function, choice, writing, scalar)
    numbers = identity(robot).encode()
    program: Program = in_drawn_field(
        lambda field: _built(MergingGraph(field), robot, function, choice, writing, scalar),
        function.encode(),
        numbers,
        prime_of=b"merging " + numbers,
    )
    return program


def _built(
    graph: Graph, robot: Robot, function: str, choice: Choice, writing: Writing | None, scalar: ScalarType
) -> Program:
    interface, known = signature(robot, function), function_named(function)

    def written(graph: Graph, inputs: Inputs, writing: Writing, split: Split) -> Program:
        values = list(writing(recursion_in(graph, robot, choice, inputs, scalar)))
        if choice.regroup:
            graph, values = in_reading_order(graph, values)
        return lower(graph, split(values))

    approach = known.iterative(build_arm(robot, exact, graph.input))
    if approach is not None:
        return iterated(known, approach, robot.n, written)
    inputs = {name: [graph.input(name, i) for i in range(size)] for name, size in interface.inputs}
    return written(graph, inputs, writing or known.outputs, lambda values: known.split(values, robot.n))


def outputs_of(
    function: str,
    arm: Arm,
    choice: Choice,
    inputs: Mapping[str, Sequence[Any]],
    trigonometry: Trigonometry,
    constant: Callable[[Fraction], Any],
    mark: Mark,
    writing: Writing | None = None,
) -> list[Any]:
    """The outputs of ``function``, one after another, over the scalars of ``arm`` and ``inputs``."""
    recursion = Recursion(arm, choice, inputs, trigonometry, constant, mark)
    return list((writing or function_named(function).outputs)(recursion))


class Recursion(RigidDrives):
    """The dynamics of ``arm`` by the recursion that ``choice`` says; see :class:`Dynamics`."""

    def __init__(
        self,
        arm: Arm,
        choice: Choice,
        inputs: Mapping[str, Sequence[Any]],
        trigonometry: Trigonometry,
        constant: Callable[[Fraction], Any],
        mark: Mark,
        scalar: ScalarType = "double",
    ) -> None:
        self.inputs, self.mark, self.rounding = inputs, mark, ROUNDING[scalar]
        self.rest: Sequence[Any] = [0] * len(arm.bodies)
        self.arm, self._choice, self._trigonometry, self._number = arm, choice, trigonometry, constant
        self._inverse: Inverse | None = None
        self.cheapest = Cheapest()

    def torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Joint torques [n]."""
        if self._inverse is None:
            self._inverse = self._inverse_of(self.arm)
        return self._inverse(qd, qdd)

    def inertial_torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Joint torques [n] without gravity and friction."""
        return self._inverse_of(inertial(self.arm))(qd, qdd)

    def reactions(
        self, qd: Sequence[Any], qdd: Sequence[Any], w: Sequence[Any]
    ) -> Sequence[tuple[Vector, Vector]]:
        """Force and moment in each joint, by the recursion of the thesis."""
        beyond = beyond_the_last_link(self.arm, self.motion(self.rest, self.rest), w)
        return reactions(self.arm, self.motion(qd, qdd), self.mark, beyond)

    def _inverse_of(self, arm: Arm) -> Inverse:
        choice, trigonometry = self._choice, self._trigonometry

        def moved(arm: Arm, qd: Sequence[Any], qdd: Sequence[Any]) -> Motion:
            return build_motion(arm, self.inputs["q"], qd, qdd, trigonometry, self._number)

        if choice.formulation != "modified_newton_euler" or not choice.regroup:
            book = formulation_named(choice.formulation)
            return lambda qd, qdd: list(book(arm, moved(arm, qd, qdd), self.mark))
        variant = choice.variant or suited_variant(arm, choice.chains)
        links, unit = regrouped_as(arm, variant)
        placed = with_displacements(arm, links, unit)

        def recursion(qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
            motion = moved(placed, qd, qdd)
            turns = chain_turns(placed, motion, trigonometry, [link.chained for link in variant.links])
            per_unit = 1 if unit == 1 else 1 / unit
            return BaseNewtonEuler(placed, motion, turns, links, variant, per_unit, self.mark).torques()

        return recursion

    def mass_matrix(self) -> list[list[Any]]:
        """Mass matrix [n][n], by composite bodies."""
        at = self.links(self.rest, self.rest)
        return mass_matrix(at, self.mark)

    def motion(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Motion:
        """The arm at ``q``, with these rates and accelerations."""
        return build_motion(self.arm, self.inputs["q"], qd, qdd, self._trigonometry, self._number)

    def turns(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Turns:
        """How its joints turn, chains of parallel joints as one; each for itself as in the book."""
        motion = self.motion(qd, qdd)
        if not self._choice.regroup:
            return single_turns(motion)
        return chain_turns(self.arm, motion, self._trigonometry)

    def links(self, qd: Sequence[Any], qdd: Sequence[Any], form: MomentForm = "second_moment") -> Moving:
        """The same, regrouped where the choice has it, chains of parallel joints turning as one."""
        choice, trigonometry = self._choice, self._trigonometry
        arm = centred(slid(self.arm)) if choice.regroup else self.arm
        lumps, ground = lumps_of(arm), NO_LUMP
        if choice.regroup:
            lumps, ground = regrouped_with_ground(arm, [form] * len(arm.bodies))
        motion = build_motion(arm, self.inputs["q"], qd, qdd, trigonometry, self._number)
        turns = chain_turns(arm, motion, trigonometry) if choice.chains else single_turns(motion)
        return Moving(arm, motion, turns, lumps, ground)

    def torque_derivatives(self, qdd: Sequence[Any]) -> None:
        """The rigid arm's derivatives are written out."""

    def base_set(self) -> tuple[BaseParameter, ...]:
        """The base parameters."""
        from robodyn.dynamics.base_set import base_set

        return base_set(self.arm)

    def rotors(self) -> list[Rotor]:
        """The rotors of the joints."""
        return rotors_of(self.arm)


def recursion_in(
    graph: Graph,
    robot: Robot,
    choice: Choice,
    inputs: Mapping[str, Sequence[Any]],
    scalar: ScalarType = "double",
) -> Recursion:
    """The dynamics of ``robot`` in ``graph``, ``inputs`` ``[n]`` by name."""

    def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
        return turned(graph, inputs["q"], angle)

    arm = build_arm(robot, exact, graph.input)
    return Recursion(arm, choice, inputs, trigonometry, exact, graph.label, scalar)


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
