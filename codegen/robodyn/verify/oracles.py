"""The references behind one face: torques of arrays of states, and what functions make of them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.drives.drive import layer_of, rigid_part
from robodyn.dynamics.arm import (
    Arm,
    JointAngle,
    Motion,
    Trigonometry,
    build_arm,
    build_motion,
    trigonometry_at,
)
from robodyn.dynamics.functions import Function, Rotor
from robodyn.dynamics.reference import PlainDynamics
from robodyn.dynamics.state import with_rotors
from robodyn.dynamics.vectors import Vector
from robodyn.errors import InputError
from robodyn.ir.evaluate import turn
from robodyn.optimize.programs import base_set_of
from robodyn.robot.coupling import transmission_of
from robodyn.robot.model import Robot
from robodyn.robot.values import ZERO, circle_point
from robodyn.verify.coupled import in_coordinates
from robodyn.verify.exact import exact_torque, exact_torque_slope
from robodyn.verify.free_bodies import joint_reactions
from robodyn.verify.lagrangian import lagrangian
from robodyn.verify.numbers import Parameters, filled, real
from robodyn.verify.reference import Reference

if TYPE_CHECKING:
    from robodyn.dynamics.base_set import BaseParameter
    from robodyn.verify.against.arm import PeerArm

#: float64, or Fractions in an array of objects.
Numbers = NDArray[Any]


class TorquesAlone(InputError):
    """A reference has torques, and nothing that says what is asked for."""


@dataclass(frozen=True, slots=True)
class Oracle:
    """A reference by name; ``torque(q, qd, qdd)`` takes and gives ``[N, n]``.

    ``matrix(q)`` gives ``[N, n, n]`` where the reference has a better way than by differences of torques.
    """

    name: str
    torque: Callable[[Floats, Floats, Floats], Numbers]
    robot: Robot
    parameters: Parameters
    matrix: Callable[[Floats], Numbers] | None = None
    #: Torques ``[N, n]`` at ``(q, qd, qdd, w)``, if it knows what a wrench on the tool does to drives.
    under_wrench: Callable[[Floats, Floats, Floats, Floats], Numbers] | None = None
    #: Derivatives ``[N, n]`` of the torques at ``(q, qd, qdd)`` along ``(dq, dqd)``, if it has any.
    slope: Callable[[Floats, Floats, Floats, Floats, Floats], Numbers] | None = None
    #: Force and moment ``[N, n, 6]`` in the joints at ``(q, qd, qdd, w)``, if it has any.
    reactions: Callable[[Floats, Floats, Floats, Floats], Numbers] | None = None
    #: Whether the torques are Fractions.
    exact: bool = False
    #: The same reference of another robot.
    other: Callable[[Robot, Parameters], Oracle] | None = None

    def mass_matrix(self, q: Floats) -> Numbers:
        """``[N, n, n]``: torques of unit accelerations less those of none."""
        if self.matrix is not None:
            return self.matrix(q)
        rest = np.zeros_like(q)
        still = self.torque(q, rest, rest)
        columns = []
        for j in range(q.shape[1]):
            unit = np.zeros_like(q)
            unit[:, j] = 1.0
            columns.append(self.torque(q, rest, unit) - still)
        return np.stack(columns, axis=-1)

    def links(self) -> Oracle:
        """The same reference of the links alone, in no gravity."""
        if self.other is None:
            raise TorquesAlone("it has torques and a mass matrix")
        links = replace(rigid_part(self.robot, bare=True), gravity=(ZERO, ZERO, ZERO))
        return self.other(links, self.parameters)

    def expected(self, function: Function, inputs: Mapping[str, Floats]) -> Numbers:
        """The elements ``[N, m]`` of the results of ``function``, of arrays ``[N, n]`` by name.

        Raises
        ------
        TorquesAlone: exact numbers do not have what it takes.
        """
        assert function.expected is not None
        with self._exact_values():
            elements = function.expected(_Columns(self, inputs))
        return self._rows(elements, len(inputs["q"]))

    def compared(
        self, function: Function, inputs: Mapping[str, Floats], result: Numbers, anywhere: Floats
    ) -> tuple[Numbers, Numbers]:
        """What is to be equal if the elements ``[N, m]`` of ``result`` are those of ``function``;
        ``anywhere`` ``[N, n]`` are numbers that no rule connects.

        Raises
        ------
        TorquesAlone: exact numbers do not have what it takes.
        """
        count = len(result)
        at = _Columns(self, inputs)
        with self._exact_values():
            one, other = function.compared(at, self._columns(result), self._columns(anywhere))
        return self._rows(one, count), self._rows(other, count)

    @contextmanager
    def _exact_values(self) -> Iterator[None]:
        """Where an exact reference asks for what no fraction has."""
        try:
            yield
        except TypeError as error:  # numpy, of a Fraction
            if not self.exact or "no callable" not in str(error):
                raise
            raise TorquesAlone("roots, exponentials and the like have no exact values") from error

    def _columns(self, array: Numbers) -> list[Numbers]:
        """``[N, m]`` as columns of the reference's numbers."""
        if not self.exact:
            return list(array.T)
        columns = []
        for column in array.T.tolist():
            columns.append(np.empty(len(column), object))
            columns[-1][:] = [Fraction(x) if math.isfinite(x) else x for x in column]
        return columns

    def _rows(self, elements: Sequence[Any], count: int) -> Numbers:
        """``[N, m]`` of ``m`` columns, some of them maybe a number; floats stay floats."""
        rows = np.stack([np.broadcast_to(np.asarray(x), (count,)) for x in elements], axis=-1)
        return rows if self.exact else rows.astype(np.float64)


class _Columns(PlainDynamics):
    """A reference over columns ``[N]`` of states; see :class:`robodyn.dynamics.functions.Dynamics`."""

    def __init__(self, oracle: Oracle, inputs: Mapping[str, Floats]) -> None:
        self._oracle, self._q = oracle, inputs["q"]
        self.inputs = {name: oracle._columns(array) for name, array in inputs.items()}
        self.rest = [0] * self._q.shape[1]
        self.number = self._scalar = Fraction if oracle.exact else real
        self.transmission = transmission_of(oracle.robot) if oracle.robot.couplings else None

    @cached_property
    def arm(self) -> Arm:  # type: ignore[override]  # what is alone has none
        """The arm as it is described.

        Raises
        ------
        TorquesAlone: the reference knows the arm from elsewhere.
        """
        if self._oracle.other is None:
            raise TorquesAlone("it has torques and a mass matrix")
        robot, values = self._oracle.robot, self._oracle.parameters
        rigid = rigid_part(robot.free)
        return build_arm(rigid, self._scalar, lambda name: self._scalar(Fraction(values[name])))

    def motion(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Motion:
        """The arm at ``q``, with these rates and accelerations."""
        q, scalar = self.joint_positions(), self._scalar
        qd, qdd = self.spread(qd), self.spread(qdd)
        trigonometry = _exact_trigonometry(q) if self._oracle.exact else trigonometry_at(q)
        return build_motion(self.arm, q, qd, qdd, trigonometry, scalar)

    def base_set(self) -> tuple[BaseParameter, ...]:
        """The base parameters."""
        return base_set_of(self._oracle.robot)

    def rotors(self) -> list[Rotor]:
        """The rotors of the drives."""
        robot, values = self._oracle.robot, self._oracle.parameters
        layer = layer_of(robot, self._scalar, lambda name: self._scalar(Fraction(values[name])))
        return super().rotors() + self.rotors_in_coordinates(layer.rotors())

    def torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Torques, ``n`` columns."""
        speeds, accelerations = (self._oracle._rows(x, len(self._q)) for x in (qd, qdd))
        return list(self._oracle.torque(self._q, speeds, accelerations).T)

    def torques_under_wrench(
        self, qd: Sequence[Any], qdd: Sequence[Any], wrench_torques: Sequence[Any]
    ) -> Sequence[Any]:
        """Torques under the wrench, ``n`` columns."""
        if self._oracle.under_wrench is None:
            return super().torques_under_wrench(qd, qdd, wrench_torques)
        speeds, accelerations, wrench = (
            self._oracle._rows(x, len(self._q)) for x in (qd, qdd, self.inputs["w"])
        )
        return list(self._oracle.under_wrench(self._q, speeds, accelerations, wrench).T)

    def reactions(
        self, qd: Sequence[Any], qdd: Sequence[Any], w: Sequence[Any]
    ) -> Sequence[tuple[Vector, Vector]]:
        """Force and moment in each joint, of columns.

        Raises
        ------
        TorquesAlone: the reference has none.
        """
        if self._oracle.reactions is None:
            raise TorquesAlone("it has torques and no forces in the joints")
        speeds, accelerations, wrench = (self._oracle._rows(x, len(self._q)) for x in (qd, qdd, w))
        rows = self._oracle.reactions(self._q, speeds, accelerations, wrench)
        joints = [[rows[:, k, j] for j in range(6)] for k in range(rows.shape[1])]
        return [((fx, fy, fz), (nx, ny, nz)) for fx, fy, fz, nx, ny, nz in joints]

    def inertial_torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """The reference's torques of links in no gravity, and what accelerates the rotors."""
        links = self._oracle.links()
        speeds, accelerations = (self._oracle._rows(x, len(self._q)) for x in (qd, qdd))
        return with_rotors(list(links.torque(self._q, speeds, accelerations).T), self.rotors(), qdd)

    def torque_slopes(self, qdd: Sequence[Any], dq: Sequence[Any], dqd: Sequence[Any]) -> list[Any]:
        """Derivatives of the torques, ``n`` columns.

        Raises
        ------
        TorquesAlone: the reference has none.
        """
        if self._oracle.slope is None:
            raise TorquesAlone("it has torques and no derivatives of them")
        arrays = (self._oracle._rows(x, len(self._q)) for x in (self.inputs["qd"], qdd, dq, dqd))
        return list(self._oracle.slope(self._q, *arrays).T)

    def mass_matrix(self) -> list[list[Any]]:
        """Mass matrix ``[n][n]``, of columns."""
        matrix = self._oracle.mass_matrix(self._q)
        n = len(self.rest)
        return [[matrix[:, i, j] for j in range(n)] for i in range(n)]


def reference_oracle(robot: Robot, parameters: Parameters) -> Oracle:
    """Plain Newton-Euler in double precision."""
    if robot.couplings:
        return in_coordinates(reference_oracle, robot, parameters)
    reference = Reference(robot, parameters)
    values = filled(robot, parameters)
    return Oracle(
        "reference",
        reference.inverse_dynamics,
        robot,
        values,
        reference.mass_matrix,
        reference.inverse_dynamics,
        reference.torque_slope,
        lambda q, qd, qdd, w: joint_reactions(robot, q, qd, qdd, w, values),
        other=reference_oracle,
    )


def library_oracle(robot: Robot, parameters: Parameters, arm: PeerArm) -> Oracle:
    """What another library makes of the file that ``robot`` comes from."""
    if robot.couplings:
        return in_coordinates(lambda free, values: library_oracle(free, values, arm), robot, parameters)
    return Oracle(arm.title, arm.torques, robot, filled(robot, parameters), arm.mass_matrix)


def exact_oracle(robot: Robot, parameters: Parameters) -> Oracle:
    """Virtual work over rationals; an array of Fractions."""
    if robot.couplings:
        return in_coordinates(exact_oracle, robot, parameters)

    def torque(q: Floats, qd: Floats, qdd: Floats) -> Numbers:
        torques = np.empty(q.shape, dtype=object)
        for k in range(len(q)):
            torques[k] = exact_torque(robot, q[k].tolist(), qd[k].tolist(), qdd[k].tolist(), parameters)
        return torques

    def slope(*arrays: Floats) -> Numbers:
        slopes = np.empty(arrays[0].shape, dtype=object)
        for k in range(len(slopes)):
            q, qd, qdd, dq, dqd = (array[k].tolist() for array in arrays)
            slopes[k] = exact_torque_slope(robot, q, qd, qdd, dq, dqd, parameters)
        return slopes

    values = filled(robot, parameters)

    def reactions(q: Floats, qd: Floats, qdd: Floats, w: Floats) -> Numbers:
        return joint_reactions(robot, q, qd, qdd, w, values, exact=True)

    return Oracle(
        "exact", torque, robot, values, slope=slope, reactions=reactions, exact=True, other=exact_oracle
    )


def lagrangian_oracle(robot: Robot, parameters: Parameters) -> Oracle:
    """Energies and derivatives; however many joints there are."""
    if robot.couplings:
        return in_coordinates(lagrangian_oracle, robot, parameters)
    values = filled(robot, parameters)
    return Oracle(
        "lagrangian", lagrangian(robot, parameters, limit=robot.n), robot, values, other=lagrangian_oracle
    )


def _exact_trigonometry(q: Sequence[Numbers]) -> Trigonometry:
    """Cosines and sines of columns of Fractions, right to 1e-30."""

    def trigonometry(angle: JointAngle) -> tuple[Numbers, Numbers]:
        ((joint, _),) = angle.terms
        points = [turn((angle.offset.cos, angle.offset.sin), circle_point(x)) for x in q[joint]]
        c, s = np.empty((2, len(points)), object)
        c[:], s[:] = zip(*points, strict=True)
        return c, s

    return trigonometry


def differences(actual: Numbers, expected: Numbers) -> Floats:
    """``|actual - expected|`` without rounding ``expected`` first; infinite where one is not finite."""
    if expected.dtype != object:
        sound = np.isfinite(actual) & np.isfinite(expected)
        with np.errstate(invalid="ignore", over="ignore"):
            return np.where(sound, np.abs(actual - expected), np.inf)
    result = np.full(actual.shape, np.inf)
    for place in np.ndindex(actual.shape):
        value: Any = actual[place]
        if isinstance(value, Fraction) or np.isfinite(value):
            exact = value if isinstance(value, Fraction) else Fraction(float(value))
            result[place] = real(abs(exact - expected[place]))
    return result
