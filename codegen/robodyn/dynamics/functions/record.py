"""What a function of an arm is: one record that everything reads which writes, counts or checks it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from robodyn.dynamics.functions.arguments import INPUTS, Array
from robodyn.dynamics.limits import FEW_JOINTS, MANY_JOINTS
from robodyn.dynamics.moving import Moving as Moving
from robodyn.dynamics.rotor import Rotor as Rotor
from robodyn.dynamics.vectors import Mark
from robodyn.errors import InputError

if TYPE_CHECKING:
    from robodyn.dynamics.arm import Arm, Motion
    from robodyn.dynamics.base_parameter import BaseParameter
    from robodyn.dynamics.choosing import Chooser
    from robodyn.dynamics.iterative import Iterative
    from robodyn.dynamics.lump import MomentForm
    from robodyn.dynamics.parallel import Turns

#: Scalars of any kind, one for each joint.
Vector = Sequence[Any]
#: What a function is called that has the wrench as a further input, behind the name of the one without.
WITH_WRENCH = "_with_wrench"
#: Names of other arguments: run-time parameters, memory, time step, states of a batch.
_TAKEN = {"p", "state", "dt", "N", "n"}


class Dynamics(Protocol):
    """An arm at one state, over any scalar: nodes of a graph, fractions, elements of a field, columns of
    numbers, sympy expressions. All that functions are written in terms of, and checked by.

    Attributes
    ----------
    inputs: by name the arrays that the function is given, see :data:`INPUTS`.
    rest: ``[n]``, zeros: no velocity, no acceleration.
    mark: gives a quantity its name in emitted code; where nothing is emitted it does nothing.
    arm: the links as they are described, the base in the world, and the tool.
    cheapest: chooses, of several ways to write the same values, those that take the fewest operations.
    rounding: the rounding unit of the numbers that the program is for, as a share.
    """

    @property
    def inputs(self) -> Mapping[str, Vector]: ...
    @property
    def rest(self) -> Vector: ...
    @property
    def mark(self) -> Mark: ...
    @property
    def arm(self) -> Arm: ...
    @property
    def cheapest(self) -> Chooser: ...
    @property
    def rounding(self) -> Fraction: ...

    def motion(self, qd: Vector, qdd: Vector) -> Motion:
        """``arm`` at ``inputs["q"]``, with these velocities and accelerations ``[n]``."""
        ...

    def turns(self, qd: Vector, qdd: Vector) -> Turns:
        """How its joints turn: parallel ones as one where that takes fewer operations."""
        ...

    def links(self, qd: Vector, qdd: Vector, form: MomentForm = "second_moment") -> Moving:
        """The same arm with the masses where they take the fewest operations: with ``second_moment`` the
        second moments along the axes of revolute joints are 0, with ``inertia`` the inertias about y."""
        ...

    def torque_derivatives(self, qdd: Vector) -> tuple[Sequence[Vector], Sequence[Vector]] | None:
        """Derivatives of the torques at ``inputs["qd"]`` and these accelerations by positions and by
        velocities, as rows, the accelerations constant whatever they are made of; None for the rigid arm,
        whose derivatives are written out."""
        ...

    def base_set(self) -> Sequence[BaseParameter]:
        """The combinations of the links' numbers that the torques depend on.

        Raises
        ------
        InputError: they are not linear in any, or a length is a run-time parameter.
        """
        ...

    def rotors(self) -> Sequence[Rotor]:
        """The rotors whose inertia is in the torques."""
        ...

    def torques(self, qd: Vector, qdd: Vector) -> Vector:
        """Joint torques ``[n]`` at these velocities and accelerations, drives included [N m, prismatic N]."""
        ...

    def torques_under_wrench(self, qd: Vector, qdd: Vector, wrench_torques: Vector) -> Vector:
        """The same while ``inputs["w"]`` pushes the tool; ``wrench_torques`` ``[n]`` are its ``J^T w``."""
        ...

    def inertial_torques(self, qd: Vector, qdd: Vector) -> Vector:
        """The same of links and rotors alone, without gravity and all else that drives do."""
        ...

    def reactions(self, qd: Vector, qdd: Vector, w: Vector) -> Sequence[tuple[Vector, Vector]]:
        """Force [N] and moment [N m] of link i-1 on link i for each joint, base to tip, along the axes and
        about the origin of link i's frame in ``arm``, while ``w`` ``[6]`` pushes the tool. Whatever passes
        from one link to the other is in them, drives and springs as well as bearings."""
        ...

    def mass_matrix(self) -> Sequence[Vector]:
        """Mass matrix ``[n][n]``, rotors included [kg m^2, kg m, kg]."""
        ...


class ReferenceDynamics(Dynamics, Protocol):
    """Dynamics that functions are checked by."""

    def torque_slopes(self, qdd: Vector, dq: Vector, dqd: Vector) -> Vector:
        """The derivative ``[n]`` of the torques at ``inputs["qd"]`` and these accelerations, which stay,
        along the direction ``dq, dqd`` ``[n]`` of positions and velocities."""
        ...


class NoSuchFunction(InputError):
    """An arm does not have a function; ``found`` says why."""


#: What must be equal, element by element.
Pair = tuple[Sequence[Any], Sequence[Any]]


class Derivative(NamedTuple):
    """Where the derivative of a function's result by the input ``by`` is: in the result ``array`` of
    ``function``, of which those inputs that the first has not are zero. A row for each element of the result,
    a column for each of ``by``; with ``of_frame`` the result is a frame ``[R p]``, and a column is how fast
    it moves and how fast it turns, along the world's axes. ``affine``: only where torques are affine in the
    accelerations, which load-dependent friction is not."""

    by: str
    function: str
    array: str
    of_frame: bool = False
    affine: bool = False


class Answers(NamedTuple):
    """Of a function of a pose the names of its results: joint positions, a row for each branch or of one;
    whether each reaches the pose, is within the joints' limits, and is singular; which ``branch`` it is."""

    solutions: str
    exists: str
    within: str
    singular: str
    branch: str = ""


@dataclass(frozen=True, slots=True, eq=False, repr=False)  # one object each; every command imports this
class Function:
    """A function that kernels may have.

    Attributes
    ----------
    name: what it is called in C (``ROBOT_name``), on the command line, and in Python.
    purpose: one sentence, for headers and help.
    inputs, results: its arguments.
    outputs: the elements of the results, one after another, matrices row by row, from the dynamics: what is
        emitted.
    expected: the same by another way if there is one, from the dynamics of a reference that shares nothing
        with the kernels. None where only ``condition`` says what is right.
    condition: for the elements of the results, and ``[n]`` numbers that no rule connects, two sequences that
        are equal if the results are right: torques where there is nothing ``expected``. None: the results
        and ``expected``. Where both are there, it is what costs less.
    by_default: whether it is written unless functions are named.
    parts: functions whose programs it is put together from; none: it comes straight from the recursion.
    zeros: of the recursion's torques, the inputs that are zero in it, none in the inverse dynamics itself.
        None: it is something else.
    solves: whether it solves for accelerations: an arm in which a joint moves without inertia has no such
        function, nor has one with friction that depends on the accelerations.
    fuses: functions that it is the results of, one after another, see :mod:`robodyn.dynamics.fusing`.
    others: other ways to write ``outputs``; what is emitted is the one that takes the fewest operations.
    small: the same, for arms of few joints.
    of_rigid_arms: the same, for arms whose drives have no effects.
    of_long_arms: the same, for such arms of many joints.
    beside_parts: about how many operations it takes beside those of its parts, for so many joints, where few
        of the parts' results are numbers: what tells that another way takes fewer before it is built.
    apart: whether it is put together from its parts even where there is no record of them.
    by_parts: how it is put together from its parts; None: in any of the ways to write ``outputs``.
    drives: whether it depends on what drives do; if not, robots with effects have the rigid arm's.
    geometric: whether it is of the links' places and motion alone: drives and effects have no part in it.
    derivatives: of its only result by each of its inputs; none: no function has them.
    iterative: how its results are approached, of an arm of which it cannot be written straight; else None.
    answers: of a function of a pose, and of no state, its results. What is right is that the poses of its
        solutions are the one that it was given (:mod:`robodyn.dynamics.closing`).
    emitted: what it is called in emitted code, where another function, written around it, has its name; else
        nothing.
    """

    name: str
    purpose: str
    inputs: tuple[Array, ...]
    results: tuple[Array, ...]
    outputs: Callable[[Dynamics], Sequence[Any]]
    expected: Callable[[Dynamics], Sequence[Any]] | None = None
    condition: Callable[[ReferenceDynamics, Sequence[Any], Vector], Pair] | None = None
    by_default: bool = False
    parts: tuple[str, ...] = ()
    zeros: tuple[str, ...] | None = None
    solves: bool = False
    fuses: tuple[Function, ...] = ()
    others: tuple[Callable[[Dynamics], Sequence[Any]], ...] = ()
    small: tuple[Callable[[Dynamics], Sequence[Any]], ...] = ()
    of_rigid_arms: tuple[Callable[[Dynamics], Sequence[Any]], ...] = ()
    of_long_arms: tuple[Callable[[Dynamics], Sequence[Any]], ...] = ()
    beside_parts: Callable[[int], int] = lambda joints: 0
    apart: bool = False
    by_parts: Callable[[Dynamics], Sequence[Any]] | None = None
    drives: bool = True
    geometric: bool = False
    derivatives: tuple[Derivative, ...] = ()
    iterative: Callable[[Arm], Iterative | None] = lambda arm: None
    answers: Answers | None = None
    emitted: str = ""

    def __post_init__(self) -> None:
        """:class:`ValueError` for a record that is none: found where the package is imported."""
        if not self.name.isidentifier() or not self.purpose:
            raise ValueError(
                f"function {self.name!r}: a function has an identifier for a name, and a purpose"
            )
        if not self.inputs or not set(self.inputs) <= set(INPUTS):
            names = ", ".join(array.name for array in INPUTS)
            raise ValueError(f"function {self.name!r}: inputs are some of {names}")
        if not self.results or set(self.results) & set(self.inputs):
            raise ValueError(f"function {self.name!r}: a function has results, and none is an input as well")
        taken = _TAKEN & {array.name for array in self.results}
        if taken:
            raise ValueError(f"function {self.name!r}: emitted code has other arguments called {taken}")
        if self.expected is None and self.condition is None and self.answers is None:
            raise ValueError(
                f"function {self.name!r}: nothing says what is right: expected, condition or answers"
            )
        if self.derivatives and (len(self.results), tuple(d.by for d in self.derivatives)) != (
            1,
            self.input_names,
        ):
            raise ValueError(f"function {self.name!r}: derivatives are of one result by all inputs, or none")

    @property
    def is_recursion(self) -> bool:
        """Whether it is the inverse dynamics itself: formulations, ways of writing, peers and the thesis's
        counts are of it, and effects with memory take a step in it."""
        return self.zeros == ()

    @property
    def gives_torques(self) -> bool:
        """Whether the result is torques of the recursion, of all inputs or with some of them zero."""
        return self.zeros is not None

    @property
    def at_rest(self) -> bool:
        """Whether it is torques at which nothing moves."""
        return self.zeros is not None and {"qd", "qdd"} <= set(self.zeros)

    @property
    def searchable(self) -> bool:
        """Whether fewer operations are searched for, and recorded: not for what is made of other functions,
        not for what divides again and again, whose terms have too many factors, nor for what is of a pose:
        it is no polynomial."""
        return not self.parts and not self.fuses and not self.solves and not self.of_pose

    def nodes(self, node: Callable[[str, int], Any], n: int) -> dict[str, list[Any]]:
        """Its inputs by name, each element a ``node`` of name and index."""
        return {array.name: [node(array.name, i) for i in range(array.size_at(n))] for array in self.inputs}

    @property
    def has_parameters(self) -> bool:
        """Whether a shape depends on how many base parameters there are."""
        return any("p" in array.shape for array in (*self.inputs, *self.results))

    @property
    def has_branches(self) -> bool:
        """Whether a shape depends on how many branches the inverse kinematics has."""
        return any("b" in array.shape for array in self.results)

    @property
    def of_pose(self) -> bool:
        """Whether it is of a pose, and not of a state."""
        return self.answers is not None

    @property
    def words(self) -> str:
        """Its name in a sentence."""
        return self.name.replace("_", " ")

    @property
    def input_names(self) -> tuple[str, ...]:
        """Names of the inputs."""
        return tuple(array.name for array in self.inputs)

    def compositions(self, n: int) -> tuple[Callable[[Dynamics], Sequence[Any]], ...]:
        """All ways to put it together from its parts."""
        return self.writings(n) if self.by_parts is None else (self.by_parts,)

    def writings(self, n: int) -> tuple[Callable[[Dynamics], Sequence[Any]], ...]:
        """All ways to write the outputs of ``n`` joints."""
        return (self.outputs, *self.others, *(self.small if n <= FEW_JOINTS else ()))

    def without_effects(self, n: int) -> tuple[Callable[[Dynamics], Sequence[Any]], ...]:
        """All other ways to write them where drives have no effects."""
        return (*self.of_rigid_arms, *(self.of_long_arms if n >= MANY_JOINTS else ()))

    def size_at(self, n: int, p: int = 0, b: int = 0) -> int:
        """How many numbers the results are for ``n`` joints, ``p`` base parameters and ``b`` branches."""
        return sum(array.size_at(n, p, b) for array in self.results)

    def split(self, elements: Sequence[Any], n: int) -> list[tuple[str, Sequence[Any]]]:
        """``elements``, one after another, as ``(name, elements)`` of each result."""
        parts, start, lengths = [], 0, lengths_of([self], len(elements), n)
        for array in self.results:
            end = start + array.size_at(n, *lengths)
            parts.append((array.name, elements[start:end]))
            start = end
        return parts

    def compared(self, dynamics: ReferenceDynamics, result: Sequence[Any], anywhere: Vector) -> Pair:
        """Two sequences that are equal if the elements ``result`` are what ``dynamics`` say; ``anywhere``
        ``[n]`` are numbers that no rule connects."""
        if self.condition is not None:
            return self.condition(dynamics, result, anywhere)
        assert self.expected is not None
        return result, self.expected(dynamics)


def lengths_of(functions: Sequence[Function], size: int, n: int) -> tuple[int, int]:
    """How many base parameters and how many branches an arm of ``n`` joints has if results of ``functions``,
    which do not depend on both, are ``size`` numbers; 0 where these do not depend on them."""
    known, with_parameter, with_branch = (
        sum(function.size_at(n, p, b) for function in functions) for p, b in ((0, 0), (1, 0), (0, 1))
    )
    p, b = ((size - known) // (more - known) if more > known else 0 for more in (with_parameter, with_branch))
    return p, b
