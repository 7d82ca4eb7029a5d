"""An arm at one state as its functions see it: what they ask of it, and the records that it answers with."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from robodyn.dynamics.vectors import Mark
from robodyn.errors import InputError

if TYPE_CHECKING:
    from robodyn.dynamics.arm import Arm, Body, Motion
    from robodyn.dynamics.lump import Lump, MomentForm
    from robodyn.dynamics.parallel import Turns

#: Scalars of any kind, one for each joint.
Vector = Sequence[Any]
#: Ways to write one vector of values.
Ways = Sequence[Sequence[Any]]


class Chooser(Protocol):
    """Chooses what takes the fewest operations beside what it has chosen before; the first where operations
    are not counted."""

    def __call__(self, choices: Sequence[Ways]) -> Sequence[Sequence[Any]]:
        """Of the ways to write each of some vectors those that together take the fewest."""
        ...

    def apart(self, ways: Sequence[Callable[[], Sequence[Any]]]) -> Sequence[Any]:
        """The values of the way that takes the fewest with all that it chooses itself, each being tried as if
        the others were not."""
        ...


class First:
    """The first of each: numbers are computed one way only."""

    def __call__(self, choices: Sequence[Ways]) -> Sequence[Sequence[Any]]:
        """The first way of each."""
        return [ways[0] for ways in choices]

    def apart(self, ways: Sequence[Callable[[], Sequence[Any]]]) -> Sequence[Any]:
        """The values of the first way."""
        return ways[0]()


@dataclass(frozen=True, slots=True)
class Posture:
    """An arm in motion, and how its joints turn."""

    arm: Arm
    motion: Motion
    turns: Turns


@dataclass(frozen=True, slots=True)
class Moving(Posture):
    """The same with mass, first and second moments of each link about its frame's origin: those described,
    or others that move alike (then a mass may be 0 or less), what they lack of mass and first moment being
    that of ``ground``, at rest, about the base's origin. Where they are ``weighed``, masses are times the
    largest component of gravity, and the arm's gravity in units of that."""

    lumps: Sequence[Lump]
    ground: Lump
    weighed: bool = False


class Rotor(NamedTuple):
    """A rotor: its inertia [kg m^2, kg], and the joints (from 0) whose rates add up to its own, each with a
    ratio."""

    inertia: Any
    rates: tuple[tuple[int, Any], ...]

    def rate(self, qd: Sequence[Any]) -> Any:
        """How fast it turns at the joints' rates, or accelerations."""
        return sum(ratio * qd[joint] for joint, ratio in self.rates)


def with_rotors(torques: Sequence[Any], rotors: Iterable[Rotor], qdd: Sequence[Any]) -> list[Any]:
    """Joint ``torques`` [n] and what accelerates ``rotors`` at the joints' accelerations ``qdd`` [n]."""
    total = list(torques)
    for rotor in rotors:
        acceleration = rotor.rate(qdd)
        for joint, ratio in rotor.rates:
            total[joint] = total[joint] + ratio * (rotor.inertia * acceleration)
    return total


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

    def base_set(self) -> Sequence[Any]:
        """The base parameters (:class:`~robodyn.dynamics.base_set.BaseParameter`).

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

    @property
    def link_count(self) -> int:
        """How many links there are where joints follow others; else 0: as many as joints."""
        ...

    def driven(self) -> Sequence[Body]:
        """The bodies ``[n]`` whose joints motors move: those that follow no other."""
        ...

    def spread(self, rates: Vector) -> Vector:
        """The rates of all joints of ``arm`` at the ``rates`` ``[n]``; more where some follow others."""
        ...

    def folded(self, torques: Vector) -> Vector:
        """The torques ``[n]`` that do as much work as ``torques`` of all joints of ``arm``."""
        ...


class CoordinateDynamics(Dynamics, Protocol):
    """Dynamics in the coordinates that joints follow, put together of those of other functions."""

    def of(self, function: str) -> Vector:
        """The results of another function at the same state."""
        ...


class ReferenceDynamics(Dynamics, Protocol):
    """Dynamics that functions are checked by."""

    def torque_slopes(self, qdd: Vector, dq: Vector, dqd: Vector) -> Vector:
        """The derivative ``[n]`` of the torques at ``inputs["qd"]`` and these accelerations, which stay,
        along the direction ``dq, dqd`` ``[n]`` of positions and velocities."""
        ...


class RigidDrives:
    """Dynamics without friction that depends on loads, of joints that move by themselves; see
    :class:`Dynamics`."""

    link_count = 0
    arm: Arm

    def driven(self) -> Sequence[Body]:
        """All bodies."""
        return self.arm.bodies

    def spread(self, rates: Vector) -> Vector:
        """The ``rates`` themselves."""
        return rates

    def folded(self, torques: Vector) -> Vector:
        """The ``torques`` themselves."""
        return torques

    @abstractmethod
    def torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Sequence[Any]:
        """Joint torques [n]."""

    def torques_under_wrench(
        self, qd: Sequence[Any], qdd: Sequence[Any], wrench_torques: Sequence[Any]
    ) -> Sequence[Any]:
        """Joint torques [n] less those that the wrench gives."""
        return [tau - push for tau, push in zip(self.torques(qd, qdd), wrench_torques, strict=True)]


#: What gives numbers of an arm at one state, a :class:`Dynamics`.
Stage = Callable[[Any], Sequence[Any]]


@dataclass(frozen=True, slots=True)
class Iterative:
    """Results that cannot be written straight: they are approached in ``most`` steps at most, from each of
    ``rows`` starts.

    ``start`` gives the states before the first step, one after another. ``step`` gives the state after the
    one in the input ``x``, whose first ``[n]`` numbers are the positions ``q`` at which it has the arm, and
    whose last one is more than 0 where nothing is left to do. ``finish`` gives the results, of all states in
    ``x``.
    """

    start: Stage
    step: Stage
    finish: Stage
    most: int
    rows: int = 1


class NoSuchFunction(InputError):
    """An arm does not have a function; ``found`` says why."""
