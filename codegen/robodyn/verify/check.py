"""Compiled kernels against the independent references: how far off, where, and whether it matters.

The yardstick of torques is T, the largest torque (in absolute value, over all joints) that the reference's
inverse dynamics needs anywhere in the sample; of other results it is the largest element in the sample. The
**error** of a comparison is the largest difference of any joint at any state, divided by its yardstick. It
must not exceed the tolerance: 1e-10 in double, 1e-5 in single precision. A number that is not finite where
the reference's is counts as infinitely wrong; so does everything where the yardstick overflows.

Forward dynamics is judged by its torque: the accelerations that the kernel gives are put into the reference's
inverse dynamics and must need the torque that the kernel was given. (A direct comparison would measure the
condition of the mass matrix instead.) States at which the mass matrix, scaled to a unit diagonal, is singular
to the kernel's precision are left out, and counted.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.dynamics.functions import INPUTS, Function, function_named
from robodyn.dynamics.functions.fusing import parts_of
from robodyn.errors import InputError, ToolError
from robodyn.robot.model import Robot
from robodyn.verify.coupled import Following
from robodyn.verify.judging import beside_terms, is_regular, relative_to, ulps_of
from robodyn.verify.lagrangian import LIMIT
from robodyn.verify.numbers import real
from robodyn.verify.oracles import (
    Oracle,
    TorquesAlone,
    differences,
    exact_oracle,
    lagrangian_oracle,
    library_oracle,
    reference_oracle,
)
from robodyn.verify.poses import pose_errors, references
from robodyn.verify.reference import Reference
from robodyn.verify.report import Comparison, VerifyReport
from robodyn.verify.sample import draw, draw_parameters, drawn_besides, poses_of
from robodyn.verify.stateful import Stepping

if TYPE_CHECKING:
    from robodyn.kernels.kernel import Kernel
    from robodyn.verify.against.arm import PeerArm

#: What the error may be at most, by scalar type.
TOLERANCE: Mapping[str, float] = {"double": 1e-10, "float": 1e-5}
#: How many states are compared with the exact torque.
EXACT_STATES = 5

Progress = Callable[[int, int], None]
Trig = Callable[[Floats], Floats]

#: A step of what remembers [s], and how far memories are from rest [rad, m, per second ...].
_STEP, _DEFLECTION = 1e-3, 1e-3


@np.errstate(all="ignore")  # what overflows is judged, not warned of
def verify(
    robot: Robot,
    kernel: Kernel,
    *,
    states: int = 200,
    seed: int = 0,
    parameters: Mapping[str, float] | None = None,
    exact_states: int = EXACT_STATES,
    lagrangian: bool | None = None,
    trig: Trig | None = None,
    progress: Progress | None = None,
    original: PeerArm | None = None,
) -> VerifyReport:
    """Compare every function that ``kernel`` offers with every reference.

    Parameters
    ----------
    robot: what the kernel was made of.
    states, seed: size and seed of the sample (:func:`robodyn.verify.sample.draw`).
    parameters: values of the run-time parameters, SI units; random ones if not given.
    exact_states: how many states to compare with the exact torques; of matrices at most two.
    lagrangian: whether to compare with the Lagrangian; if not said, up to three joints.
    trig: for kernels that take ``sc``: the function that makes it ``[N, ...]`` of ``q`` ``[N, n]``.
    progress: called with (comparisons done, comparisons in all).
    original: what another library reads in the robot's file (:mod:`robodyn.verify.against`).

    Raises
    ------
    InputError: the kernel is another robot's; ``trig`` is missing; ``parameters`` do not fit.
    ToolError: the Lagrangian is asked for, and sympy is missing.
    """
    if kernel.robot != robot.name:
        raise InputError("the kernel is another robot's", found=kernel.robot, expected=robot.name)
    values = draw_parameters(robot, parameters, seed, kernel.dtype)
    run = _Run(robot, kernel, values, states, seed, trig)
    oracles = [(reference_oracle(robot, values), states)]
    skipped: dict[str, str] = {}
    if robot.effects or robot.dead_band is not None:
        skipped["exact and Lagrangian torques"] = "they know the rigid arm alone, and sgn without a dead band"
        lagrangian, exact_states = False, 0
    if exact_states > 0:
        oracles.append((exact_oracle(robot, values), exact_states))
    if lagrangian or (lagrangian is None and robot.n <= LIMIT):
        try:
            oracles.append((lagrangian_oracle(robot, values), states))
        except ToolError as error:
            if lagrangian:
                raise
            skipped["the Lagrangian"] = error.message()
    if original is not None:
        oracles.append((library_oracle(robot, values, original), states))
    obstacles = {name: run.obstacle(name) for name in kernel.functions}
    skipped |= {name: reason for name, reason in obstacles.items() if reason is not None}
    wanted: list[partial[Comparison]] = []
    for name in (name for name, reason in obstacles.items() if reason is None):
        if function_named(name).of_pose:
            wanted.append(partial(run.compare_poses, name))
        else:
            # Where things are is no matter of energies: it would be the first comparison once more.
            pointless = "lagrangian" if function_named(name).geometric else ""
            wanted += [partial(run.compare, name, o, count) for o, count in oracles if o.name != pointless]
    comparisons = []
    for done, comparison in enumerate(wanted, start=1):
        try:
            comparisons.append(comparison())
        except TorquesAlone as error:
            name, oracle = comparison.args[0], comparison.args[1]
            skipped[f"{name} with {oracle.name}"] = error.message()
        if progress is not None:
            progress(done, len(wanted))
    return VerifyReport(
        robot=robot.name,
        scalar=kernel.scalar,
        language=kernel.language,
        seed=seed,
        states=states,
        largest_torque=run.largest,
        parameters=values,
        functions=tuple(kernel.functions),
        comparisons=tuple(comparisons),
        skipped=skipped,
    )


class _Run:
    """A kernel, its sample, and what the kernel makes of it."""

    def __init__(
        self,
        robot: Robot,
        kernel: Kernel,
        values: Mapping[str, float],
        states: int,
        seed: int,
        trig: Trig | None,
    ) -> None:
        self.robot, self.kernel = robot, kernel
        self.values = values
        self.tolerance = TOLERANCE[kernel.scalar]
        sample = draw(robot, states, seed, kernel.dtype)
        self.reference = Reference(robot.free, values)
        self._reference = reference_oracle(robot, values)
        tau = self._reference.torque(sample.q, sample.qd, sample.qdd)
        self.largest = float(np.abs(tau).max())
        self.regular = is_regular(self._reference.mass_matrix(sample.q), kernel.dtype)
        self._largest: dict[str, Floats] = {}
        rounded = tau.astype(kernel.dtype).astype(np.float64)
        more = drawn_besides(kernel.signatures.values(), states, seed, kernel.dtype)
        poses = poses_of(self.reference, Following.of(robot).joints(sample.q), kernel.dtype)
        of_poses = any("q_near" in dict(signature.inputs) for signature in kernel.signatures.values())
        near = references(robot, sample.q).astype(kernel.dtype) if of_poses else sample.q
        drawn = (sample.q, sample.qd, sample.qdd, rounded, *more, poses, near.astype(np.float64))
        self.inputs: dict[str, Floats] = dict(zip((array.name for array in INPUTS), drawn, strict=True))
        if any(name == "sc" for s in kernel.signatures.values() for name, _ in s.inputs):
            if trig is None:
                raise InputError(
                    f"the kernel of {robot.name} takes sines and cosines",
                    expected="trig, a function that makes them of q",
                )
            self.inputs["sc"] = np.asarray(trig(sample.q), kernel.dtype).astype(np.float64)
        self.results: dict[str, Floats] = {}
        self.stepping = Stepping(robot.free, values)
        random = np.random.default_rng([seed, 2])
        memory = random.uniform(-1, 1, (len(self.regular), self.stepping.states)) * _DEFLECTION
        self.memory: Floats = memory.astype(kernel.dtype).astype(np.float64)

    def obstacle(self, function: str) -> str | None:
        """Why ``function`` cannot be compared."""
        try:
            record = function_named(function)
        except InputError:
            return "no reference knows it"
        unknown = [name for name, _ in self.kernel.signatures[function].inputs if name not in self.inputs]
        if unknown:
            return f"its input {', '.join(unknown)} is unknown"
        if record.solves and not self.regular.any():
            return "the mass matrix is singular at every state"
        return None

    def compare(self, function: str, oracle: Oracle, count: int) -> Comparison:
        """``function`` against ``oracle`` at ``count`` states, evenly picked; of what is fused the worst
        part."""
        record, n = function_named(function), self.inputs["q"].shape[1]
        elements = range(sum(length for _, length in self.kernel.signatures[function].outputs))
        parts = parts_of(record.fuses, elements, n, self.robot.n) if record.fuses else [(record, elements)]
        compared = [self._compare(function, part, list(own), oracle, count) for part, own in parts]
        return max(compared, key=lambda comparison: (not comparison.passed, comparison.error))

    def compare_poses(self, function: str) -> Comparison:
        """``function``, of poses, against the reference's forward kinematics at all of them."""
        outputs = self.kernel.signatures[function].outputs
        ends = np.cumsum([length for _, length in outputs])[:-1]
        rows = np.split(self._result(function), ends, axis=1)
        results = dict(zip((name for name, _ in outputs), rows, strict=True))
        record, dtype = function_named(function), self.kernel.dtype
        error = pose_errors(self.robot, self.reference, record, results, self.inputs, self.tolerance, dtype)
        return self._comparison(function, "reference", error)

    def _compare(
        self, function: str, record: Function, elements: list[int], oracle: Oracle, count: int
    ) -> Comparison:
        """The ``elements`` of ``function`` that are ``record``'s."""
        places = np.arange(len(self.regular))
        if record.solves:
            places = places[self.regular]
        left_out = len(self.regular) - len(places)
        if any(len(result.shape) > 1 for result in record.results) and oracle.name == "exact":
            count = min(count, 2)  # every column is a torque
        if count < len(places):
            places, left_out = places[np.linspace(0, len(places) - 1, count).astype(int)], 0
        said = partial(
            self._comparison, function, oracle.name, record=record, places=places, left_out=left_out
        )
        actual = self._result(function)[places][:, elements]
        inputs = {array.name: self.inputs[array.name][places] for array in INPUTS}
        yardstick: float | Floats = self.largest
        if record.expected is None:
            sound = np.isfinite(actual)
            sent = np.where(sound, actual, 0.0)
            reference, wanted = oracle.compared(record, inputs, sent, inputs["qdd"])
            error = differences(wanted, reference)
            error[~sound.all(axis=1)] = np.inf
            # What is compared may be no torque, and larger: of an arm without mass all torques are 0.
            yardstick = max(self.largest, max((real(abs(x)) for x in reference.flat), default=0.0))
            return said(relative_to(error, np.broadcast_to(yardstick, error.shape)))
        if self.kernel.signatures[function].states:
            expected, _ = self.stepping.step(
                inputs["q"], inputs["qd"], inputs["qdd"], self.memory[places], _STEP
            )
            yardstick = max(self.largest, float(np.abs(expected).max()))
        else:
            expected = oracle.expected(record, inputs)
            if not record.gives_torques:
                yardstick = self._largest_of(record)
        error = differences(actual, expected)
        ulps = ulps_of(record, error, expected, yardstick, self.kernel.dtype) if oracle.exact else None
        return said(relative_to(error, np.broadcast_to(yardstick, error.shape)), ulps=ulps)

    def _largest_of(self, record: Function) -> Floats:
        """For each element the largest of its result, by the reference, anywhere in the sample; see
        :func:`~robodyn.verify.judging.beside_terms`."""
        if record.name not in self._largest:
            n = self.inputs["q"].shape[1]
            sizes = np.abs(self._reference.expected(record, self.inputs)).max(axis=0)
            parts = [[max(part)] * len(part) for _, part in record.split(sizes.tolist(), n, self.robot.n)]
            if record.geometric:
                parts = [beside_terms(part, self.robot, self.inputs["qd"]) for part in parts]
            self._largest[record.name] = np.concatenate(parts)
        return self._largest[record.name]

    def _result(self, function: str) -> Floats:
        """The elements ``[N, m]`` that the kernel gives at all states of the sample, computed once."""
        if function not in self.results:
            arrays = [self.inputs[name] for name, _ in self.kernel.signatures[function].inputs]
            call = getattr(self.kernel, function)
            needs = self.kernel.signatures[function].parameters
            if self.kernel.signatures[function].states:
                results: Any = self._stepped(function, arrays)
            else:
                results = call(*arrays, params=self.values if needs else None)
            results = results if isinstance(results, tuple) else (results,)
            rows = [np.asarray(result, np.float64).reshape(len(self.regular), -1) for result in results]
            self.results[function] = np.concatenate(rows, axis=1)
        return self.results[function]

    def _stepped(self, function: str, arrays: list[Floats]) -> Floats:
        """Torques of a function that remembers: each state a step from a memory of its own."""
        call, memory = getattr(self.kernel, function), self.memory.astype(self.kernel.dtype)
        params = self.values if self.kernel.signatures[function].parameters else None
        rows = [
            call(*(array[k] for array in arrays), params=params, state=memory[k], dt=_STEP)
            for k in range(len(memory))
        ]
        return np.asarray(rows, np.float64)

    def _comparison(
        self,
        function: str,
        against: str,
        error: Floats,
        *,
        record: Function | None = None,
        places: NDArray[np.intp] | None = None,
        left_out: int = 0,
        ulps: float | None = None,
    ) -> Comparison:
        """The worst of the relative ``error`` ``[N]`` or, of the elements of ``record``, ``[N, m]``; at the
        states ``places``, or all."""
        worst = np.unravel_index(int(np.argmax(error)), error.shape)
        state = int(worst[0] if places is None else places[worst[0]])
        joint, column = (None, None) if record is None else self._place(record, int(worst[1]))
        inputs = {
            name: tuple(self.inputs[name][state].tolist())
            for name, _ in self.kernel.signatures[function].inputs
        }
        return Comparison(
            function, against, len(error), left_out, float(error[worst]), self.tolerance, joint, column,
            state, inputs, ulps,
        )  # fmt: skip

    def _place(self, function: Function, element: int) -> tuple[int | None, int | None]:
        """Joint and column, from 1, of an element of the results, or of torques that tell of them; None where
        it is of no joint, of no matrix."""
        n, joints = self.inputs["q"].shape[1], [joint + 1 for joint in self.robot.commanded]
        if function.expected is None:
            return joints[element % n], None
        for array in function.results:
            links = self.robot.n
            shape, size = array.shape_at(n, links=links), array.size_at(n, links=links)
            if element < size:
                place = np.unravel_index(element, shape) if shape else ()
                of = {"n": joints, "l": range(1, links + 1)}.get(str(*array.shape[:1]))
                joint = of[int(place[0])] if of else None
                return joint, int(place[-1]) + 1 if len(place) > 1 else None
            element -= size
        raise AssertionError("no such element")
