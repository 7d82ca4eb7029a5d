"""What a function of an arm is: one record that everything reads which writes, counts or checks it; and its
arguments, arrays with shape, unit and meaning."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import prod
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from robodyn.dynamics.limits import FEW_JOINTS, MANY_JOINTS, TASK_JOINTS
from robodyn.dynamics.state import CoordinateDynamics, Dynamics, ReferenceDynamics, Vector

if TYPE_CHECKING:
    from robodyn.dynamics.arm import Arm
    from robodyn.dynamics.state import Iterative

#: Elements of a state along one axis: a number, or as many as there are joints that are commanded (n), base
#: parameters (p), branches of the inverse kinematics (b; t: of an arm that can do less than a pose asks for,
#: and more than bring its tool to a place; 0 of others), or links (l): n of them where no joint follows.
Length = int | Literal["n", "p", "b", "t", "l"]


class Array(NamedTuple):
    """An argument of a kernel: what it holds, its unit (and that at prismatic joints, where it is another),
    and the shape of one state's, ``()`` for a single number. C and Fortran have it as one row of numbers,
    matrices row by row. ``optional``: calls from Python may leave it out, it is zero then, and that of one
    state may go with many states. ``says``: whether its numbers are true (1) or not (0), or count; in Python
    they are bools and ints."""

    name: str
    holds: str
    unit: str
    prismatic: str = ""
    shape: tuple[Length, ...] = ("n",)
    optional: bool = False
    says: Literal["number", "truth", "count"] = "number"

    def shape_at(self, n: int, p: int = 0, b: int = 0, links: int = 0) -> tuple[int, ...]:
        """The shape for ``n`` joints, ``p`` base parameters, ``b`` branches, and so many ``links``, or else
        ``n``."""
        lengths = {"n": n, "p": p, "b": b, "t": b if n in TASK_JOINTS else 0, "l": links or n}
        return tuple(lengths[length] if isinstance(length, str) else length for length in self.shape)

    def size_at(self, n: int, p: int = 0, b: int = 0, links: int = 0) -> int:
        """How many numbers these are."""
        return prod(self.shape_at(n, p, b, links))

    def shape_of(self, size: int, n: int = 0) -> tuple[int, ...]:
        """The shape of so many numbers, for ``n`` joints if that is known.

        Raises
        ------
        ValueError: the array has not so many, whatever the number of joints.
        """
        count = 0  # of base parameters or branches; no array has both
        if {"p", "b", "t"} & set(self.shape):
            count = size // max(1, self.size_at(n, 1, 1))
        else:
            free = self.shape.count("n") + self.shape.count("l")
            n = round((size / self.size_at(1)) ** (1 / free)) if free else 0
        if self.size_at(n, count, count) != size:
            raise ValueError(f"{self.name} is {list(self.shape)}, and not of {size} numbers")
        return self.shape_at(n, count, count)

    @property
    def text(self) -> str:
        """What it holds and its unit, for the heads of files."""
        rows = ", row by row" if len(self.shape) > 1 else ""
        unit = self.unit + (f", prismatic {self.prismatic}" if self.prismatic else "")
        return f"{self.holds}{rows}" + (f" [{unit}]" if unit else "")

    @property
    def words(self) -> str:
        """The same for Python, where matrices are matrices."""
        units = " or ".join(unit for unit in (self.unit, self.prismatic) if unit)
        return f"{self.holds}, {units}" if units else self.holds


#: What a function may be given.
Q = Array("q", "joint positions", "rad", "m")
QD = Array("qd", "joint velocities", "rad/s", "m/s")
QDD = Array("qdd", "joint accelerations", "rad/s^2", "m/s^2")
TAU = Array("tau", "joint torques", "N m", "N")
#: In q's place, where sines and cosines are given.
SC = Array("sc", "sines and cosines, as listed below", "")
#: What pushes the tool, on request.
WRENCH = Array(
    "w", "force and moment on the tool at its origin, along the world's axes", "N, N m", shape=(6,)
)
PI = Array("pi", "base parameters, as listed below", "SI units", shape=("p",))
#: What poses are given and computed as.
POSE = Array("T", "frame of the tool in the world, [R p]", "1 and m", shape=(3, 4))
NEAR = Array(
    "q_near", "joint positions, which joints take that the pose leaves free", "rad", "m", optional=True
)
INPUTS = (Q, QD, QDD, TAU, WRENCH, PI, POSE, NEAR)

#: What a function is called that has the wrench as a further input, behind the name of the one without.
WITH_WRENCH = "_with_wrench"
#: Names of other arguments: run-time parameters, memory, time step, states of a batch.
_TAKEN = {"p", "state", "dt", "N", "n"}


#: What gives the elements of results, one after another.
Writing = Callable[[Dynamics], Sequence[Any]]
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
    fuses: functions that it is the results of, one after another, see :mod:`.functions.fusing`.
    in_coordinates: how it is written where joints follow others, of functions in the coordinates that are
        commanded: what is solved there, and what is of motors. None: its results at the joints are mapped.
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
        solutions are the one that it was given (:mod:`robodyn.dynamics.closure`).
    emitted: what it is called in emitted code, where another function, written around it, has its name; else
        nothing.
    """

    name: str
    purpose: str
    inputs: tuple[Array, ...]
    results: tuple[Array, ...]
    outputs: Writing
    expected: Writing | None = None
    condition: Callable[[ReferenceDynamics, Sequence[Any], Vector], Pair] | None = None
    by_default: bool = False
    parts: tuple[str, ...] = ()
    zeros: tuple[str, ...] | None = None
    solves: bool = False
    fuses: tuple[Function, ...] = ()
    in_coordinates: Callable[[CoordinateDynamics], Sequence[Any]] | None = None
    others: tuple[Writing, ...] = ()
    small: tuple[Writing, ...] = ()
    of_rigid_arms: tuple[Writing, ...] = ()
    of_long_arms: tuple[Writing, ...] = ()
    beside_parts: Callable[[int], int] = lambda joints: 0
    apart: bool = False
    by_parts: Writing | None = None
    drives: bool = True
    geometric: bool = False
    derivatives: tuple[Derivative, ...] = ()
    iterative: Callable[[Arm], Iterative | None] = lambda arm: None
    answers: Answers | None = None
    emitted: str = ""

    def __post_init__(self) -> None:
        """:class:`ValueError` for a record that is none: found where the package is imported."""
        taken = _TAKEN & {array.name for array in self.results}
        by = tuple(derivative.by for derivative in self.derivatives)
        problems = {
            "a function has an identifier for a name, and a purpose": not self.name.isidentifier()
            or not self.purpose,
            f"inputs are some of {', '.join(array.name for array in INPUTS)}": not self.inputs
            or not set(self.inputs) <= set(INPUTS),
            "a function has results, and none is an input as well": not self.results
            or set(self.results) & set(self.inputs),
            f"emitted code has other arguments called {taken}": taken,
            "nothing says what is right: expected, condition or answers": self.expected is None
            and self.condition is None
            and self.answers is None,
            "derivatives are of one result by all inputs, or none": by
            and (len(self.results), by) != (1, self.input_names),
        }
        for problem, is_there in problems.items():
            if is_there:
                raise ValueError(f"function {self.name!r}: {problem}")

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

    def compositions(self, n: int) -> tuple[Writing, ...]:
        """All ways to put it together from its parts."""
        return self.writings(n) if self.by_parts is None else (self.by_parts,)

    def writings(self, n: int) -> tuple[Writing, ...]:
        """All ways to write the outputs of ``n`` joints."""
        return (self.outputs, *self.others, *(self.small if n <= FEW_JOINTS else ()))

    def without_effects(self, n: int) -> tuple[Writing, ...]:
        """All other ways to write them where drives have no effects."""
        return (*self.of_rigid_arms, *(self.of_long_arms if n >= MANY_JOINTS else ()))

    def size_at(self, n: int, p: int = 0, b: int = 0, links: int = 0) -> int:
        """How many numbers the results are, as :meth:`Array.shape_at` says of each."""
        return sum(array.size_at(n, p, b, links) for array in self.results)

    def split(self, elements: Sequence[Any], n: int, links: int = 0) -> list[tuple[str, Sequence[Any]]]:
        """``elements``, one after another, as ``(name, elements)`` of each result; of so many ``links``, by
        default ``n``."""
        lengths = lengths_of([self], len(elements), n, links)
        if (size := self.size_at(n, *lengths, links)) != len(elements):
            raise ValueError(f"{self.name} returns {len(elements)} numbers; its results have {size}")
        there = [array for array in self.results if array.size_at(n, *lengths, links)]
        pieces = cut(elements, [array.size_at(n, *lengths, links) for array in there])
        return [(array.name, piece) for array, piece in zip(there, pieces, strict=True)]

    def compared(self, dynamics: ReferenceDynamics, result: Sequence[Any], anywhere: Vector) -> Pair:
        """Two sequences that are equal if the elements ``result`` are what ``dynamics`` say; ``anywhere``
        ``[n]`` are numbers that no rule connects."""
        if self.condition is not None:
            return self.condition(dynamics, result, anywhere)
        assert self.expected is not None
        return result, self.expected(dynamics)


def lengths_of(functions: Sequence[Function], size: int, n: int, links: int = 0) -> tuple[int, int]:
    """How many base parameters and how many branches an arm of ``n`` joints and so many ``links`` has if
    results of ``functions``, which do not depend on both, are ``size`` numbers; 0 where these do not depend
    on them."""
    known, with_parameter, with_branch = (
        sum(function.size_at(n, p, b, links) for function in functions) for p, b in ((0, 0), (1, 0), (0, 1))
    )
    p, b = ((size - known) // (more - known) if more > known else 0 for more in (with_parameter, with_branch))
    return p, b


def cut(elements: Sequence[Any], sizes: Sequence[int]) -> Iterator[Sequence[Any]]:
    """``elements`` in pieces of these ``sizes``, one after another."""
    start = 0
    for size in sizes:
        yield elements[start : start + size]
        start += size
