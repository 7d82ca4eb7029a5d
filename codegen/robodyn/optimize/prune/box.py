"""The box of states that a pruned kernel is good for, the limits of the joints; torques at many of these
states at once, and the largest that can be found. numpy comes when it is called.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from robodyn.errors import InputError
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input, Program
from robodyn.robot.model import Robot

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Box:
    """What the joints may do.

    ``angles`` are the variables of revolute joints: they enter by sine and cosine only, and every point of
    the circle is taken to be possible. ``ranges`` hold all others [m, and per s, per s^2; rad/s, rad/s^2].
    """

    angles: tuple[Input, ...]
    ranges: dict[Input, tuple[Fraction, Fraction]]
    #: Position limits of revolute joints [rad]: where torques are sampled.
    sampled: dict[Input, tuple[Fraction, Fraction]]

    @property
    def inputs(self) -> tuple[Input, ...]:
        """All variables, in a fixed order."""
        return (*self.angles, *self.ranges)

    def interval(self, x: Input) -> tuple[Fraction, Fraction]:
        """Where ``x`` is sampled."""
        return self.ranges[x] if x in self.ranges else self.sampled[x]


def box_of(robot: Robot, arrays: Sequence[str] = ("q", "qd", "qdd")) -> Box:
    """The limits of ``robot``, for the variables of ``arrays``.

    Raises
    ------
    InputError: a joint lacks a limit, or the robot has run-time parameters.
    """
    if robot.parameters:
        raise InputError(
            f"{robot.name} cannot be pruned",
            found=f"run-time parameters ({', '.join(robot.parameters)}), whose values no bound can know",
            expected="numbers",
            remedy="write numbers in their place, or leave out --prune",
        )
    missing = _missing(robot)
    if missing:
        raise InputError(
            f"{robot.name} cannot be pruned without limits of its joints",
            found=missing,
            expected="limits of position, velocity and acceleration at every joint",
            remedy="add for example `limits: {position: [-pi, pi], velocity: 3, acceleration: 10}` to each "
            "of these links",
        )
    angles: list[Input] = []
    ranges: dict[Input, tuple[Fraction, Fraction]] = {}
    sampled: dict[Input, tuple[Fraction, Fraction]] = {}
    for i, link in enumerate(robot.links):
        position, x = link.joint.limits.position, Input("q", i)
        assert position is not None
        if link.joint.kind == "revolute":
            angles.append(x)
            sampled[x] = position
        else:
            ranges[x] = position
    for array, kind in (("qd", "velocity"), ("qdd", "acceleration")):
        for i, link in enumerate(robot.links if array in arrays else ()):
            most = getattr(link.joint.limits, kind)
            ranges[Input(array, i)] = (-most, most)
    return Box(tuple(angles), ranges, sampled)


def _missing(robot: Robot) -> str:
    """Which limits which joints lack, in words; empty if none."""
    lacking: dict[str, list[str]] = {}
    for i, link in enumerate(robot.links, 1):
        kinds = ("position", "velocity", "acceleration")
        keys = ", ".join(kind for kind in kinds if getattr(link.joint.limits, kind) is None)
        if keys:
            lacking.setdefault(keys, []).append(str(i))
    return "; ".join(
        f"no {keys} of joint{'s' if len(joints) > 1 else ''} {', '.join(joints)}"
        for keys, joints in lacking.items()
    )


#: States looked at before the best of them are improved, and how many of them for each output.
_FIRST, _STARTS = 4096, 6
#: Rounds of coordinate ascent: each looks half as far as the one before.
_ROUNDS = 14


def functions() -> dict[str, Callable[[Any], Any]]:
    """The functions of a program over arrays."""
    import numpy as np

    return {"sin": np.sin, "cos": np.cos, "sqrt": np.sqrt, "tanh": np.tanh, "sign": np.sign}


def values(program: Program, box: Box, states: Floats) -> Floats:
    """Outputs ``[m, N]`` of ``program`` at ``states`` ``[d, N]``, in the order of ``box.inputs``."""
    import numpy as np

    inputs: dict[Input, Floats] = dict(zip(box.inputs, states, strict=True))
    outputs = evaluate(program, inputs, functions=functions())
    rows = [row for elements in outputs.values() for row in elements]
    return np.stack([np.broadcast_to(np.asarray(row, dtype=np.float64), states.shape[1:]) for row in rows])


def draw(box: Box, count: int, seed: int) -> Floats:
    """``count`` states ``[d, N]`` of the box. In every other one all but the angles are at one of their
    limits: torques are largest there."""
    import numpy as np

    random = np.random.RandomState(seed)  # its stream is the same in every version of numpy
    low, high = edges(box)
    share = random.random_sample((count, len(low)))
    angles = len(box.angles)
    share[::2, angles:] = np.round(share[::2, angles:])
    drawn: Floats = np.ascontiguousarray((low + (high - low) * share).T)
    return drawn


def edges(box: Box) -> tuple[Floats, Floats]:
    """The smallest and largest values of the inputs, rounded to double inwards."""
    import numpy as np

    low = np.array([float(box.interval(x)[0]) for x in box.inputs])
    high = np.array([float(box.interval(x)[1]) for x in box.inputs])
    return low, high


def largest(of: Callable[[Floats], Floats], box: Box, seed: int, first: int = _FIRST) -> Floats:
    """The largest sizes ``[m]`` of the outputs of ``of`` (states ``[d, N]`` to ``[m, N]``) that random states
    and coordinate ascent from the best of them find: lower bounds of the true ones."""
    import numpy as np

    states = draw(box, first, seed)
    magnitudes = np.abs(of(states))
    outputs = len(magnitudes)
    low, high = edges(box)
    starts = np.argsort(-magnitudes, axis=1, kind="stable")[:, :_STARTS]
    here = states[:, starts.ravel()]  # [d, outputs * starts]
    own = np.repeat(np.arange(outputs), starts.shape[1])
    best = magnitudes[own, starts.ravel()]
    steps = np.linspace(-1.0, 1.0, 9)
    for k in range(_ROUNDS):
        for d in range(len(low)):
            if low[d] == high[d]:
                continue
            width = (high[d] - low[d]) * 0.5**k
            tried = np.clip(here[d][:, None] + width * steps, low[d], high[d])  # [starts, 9]
            many = np.repeat(here, len(steps), axis=1)
            many[d] = tried.ravel()
            sizes = np.abs(of(many))[np.repeat(own, len(steps)), np.arange(many.shape[1])].reshape(
                tried.shape
            )
            pick = np.argmax(sizes, axis=1)
            gain = sizes[np.arange(len(own)), pick]
            better = gain > best
            here[d] = np.where(better, tried[np.arange(len(own)), pick], here[d])
            best = np.maximum(best, gain)
    peaks: Floats = np.maximum(magnitudes.max(axis=1), best.reshape(outputs, -1).max(axis=1))
    return peaks
