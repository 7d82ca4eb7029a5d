"""Effects drawn at random, of shapes that occur and of a size that is wanted.

What is not drawn is how large they are: an effect has a scale ``x``, and who hides it turns that until it
shows as much as it should.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.amend.amend import Amendment
from robodyn.diagnose.blind.limits import DRAWN_SAMPLES, LOADED_SHARE, SIZE_TOLERANCE, SIZE_TRIALS
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect
from robodyn.effects.traits import Form
from robodyn.effects.traits import Usual as UsualJoint
from robodyn.errors import InputError
from robodyn.kernels.array_dynamics import Model
from robodyn.robot.effects import belongs
from robodyn.robot.model import Robot
from robodyn.simulate.trajectories.trajectory import Trajectory

Parameters = dict[str, float | str]


@dataclass(frozen=True, slots=True, eq=False)
class Usual:
    """What is usual of a robot on a motion, [n] each: RMS torque ``tau`` and largest torque ``peak``, RMS
    ``speed`` and ``rate`` (of acceleration), the speed below which a tenth of the time is spent (``slow``),
    the inertia that a joint's spring carries (``weight``), the RMS torque of ``gravity``, the ``middle``
    of the motion; of gravity's torque as a sine over a joint's own position the size, ``tip``, and where it
    would tip the joint, ``upright``."""

    robot: Robot
    duration: float
    tau: Floats
    peak: Floats
    speed: Floats
    rate: Floats
    slow: Floats
    weight: Floats
    gravity: Floats
    middle: Floats
    tip: Floats
    upright: Floats

    def at(self, joint: int | None) -> UsualJoint:
        """What is usual of a ``joint`` (from 1; None: of the first one)."""
        j = (joint or 1) - 1
        link = self.robot.links[j]
        of_joint = (self.tau, self.peak, self.speed, self.rate, self.slow, self.weight, self.middle)
        by_gravity = (self.tip, self.upright)
        return UsualJoint(
            j + 1, self.robot.n, link.joint.kind == "revolute", float(link.mass),  # type: ignore[arg-type]  # constants
            self.duration, *(float(x[j]) for x in (*of_joint, *by_gravity)),
        )  # fmt: skip


def usual(robot: Robot, motion: Trajectory) -> Usual:
    """What is usual of ``robot`` on ``motion``."""
    step = max(1, len(motion) // DRAWN_SAMPLES)
    q, qd, qdd = (x[::step] for x in (motion.q, motion.qd, motion.qdd))
    model = Model(robot)
    tau = model.torque(q, qd, qdd)
    few = q[:: max(1, len(q) // 20)]
    still = np.zeros_like(few)
    resting = model.evaluate(few, still, still).rigid
    weight = np.empty(robot.n)
    for j in range(robot.n):
        unit = still.copy()
        unit[:, j] = 1.0
        weight[j] = np.mean((model.evaluate(few, still, unit).rigid - resting)[:, j])
    rms = [np.maximum(np.sqrt(np.mean(x**2, axis=0)), 1e-9) for x in (tau, qd, qdd)]
    slow = np.maximum(np.quantile(np.abs(qd), 0.1, axis=0), 1e-3 * np.abs(qd).max() + 1e-9)
    middle = (q.max(axis=0) + q.min(axis=0)) / 2
    gravity = np.sqrt(np.mean(resting**2, axis=0))
    peak = np.abs(tau).max(axis=0)
    tip, upright = np.empty(robot.n), np.empty(robot.n)
    for j in range(robot.n):
        waves = np.stack([np.sin(few[:, j]), -np.cos(few[:, j]), np.ones(len(few))], axis=1)
        a, b, _ = np.linalg.lstsq(waves, -resting[:, j], rcond=1e-6)[0]
        tip[j], upright[j] = np.hypot(a, b), np.arctan2(b, a)
    of_motion = (rms[0], peak, rms[1], rms[2], slow, weight, gravity, middle, tip, upright)
    return Usual(robot, motion.duration, *of_motion)


def places(id: str, u: Usual) -> list[int | None]:
    """Joints (from 1; None: the whole robot) at which the effect ``id`` can be and would show."""
    known = CATALOGUE[id]
    hidden = known.traits.hidden
    if hidden is None:
        return []
    if belongs(known, of_robot=True) and not hidden.at_joint:
        return [None]
    joints: list[int | None] = []
    for j, link in enumerate(u.robot.links):
        if hidden.needs and u.tau[j] < LOADED_SHARE * u.tau.max():
            continue
        if hidden.kind not in ("any", link.joint.kind):
            continue
        if hidden.needs == "gravity" and u.gravity[j] <= LOADED_SHARE * u.gravity.max():
            continue
        if known.coupler is not None and link.joint.motor_inertia == 0:
            continue
        if known.place == "pair" and (j == 0 or link.joint.kind != u.robot.links[j - 1].joint.kind):
            continue
        if known.traits.levels and _rubs(u.robot, j + 1):
            continue
        joints.append(j + 1)
    return joints


def _rubs(robot: Robot, joint: int) -> bool:
    """Whether the joint has a law of friction already."""
    laws = any(entry.definition.traits.levels for entry in robot.effects_at(joint))
    return laws or robot.links[joint - 1].joint.coulomb != 0


def draw(
    u: Usual, count: int, rng: np.random.Generator, taken: Sequence[Amendment] = ()
) -> tuple[Amendment, ...]:
    """``count`` effects and joints beside those that are ``taken``, without parameters; no two of a kind, nor
    two that together look like a third.

    Raises
    ------
    InputError: the robot has no room for so many.
    """
    amendments = list(taken)
    free = {id: places(id, u) for id in CATALOGUE}
    while len(amendments) < len(taken) + count:
        left = {
            id: [joint for joint in joints if all(_apart(id, joint, one) for one in amendments)]
            for id, joints in free.items()
        }
        ids = [id for id, joints in left.items() if joints]
        if not ids:
            raise InputError(
                f"{u.robot.name} has no room for so many effects",
                found=f"{count}",
                expected=f"{len(amendments)}",
            )
        id = ids[int(rng.integers(len(ids)))]
        amendments.append(Amendment(id, left[id][int(rng.integers(len(left[id])))], {}))
    return tuple(amendments[len(taken) :])


def _apart(id: str, joint: int | None, other: Amendment) -> bool:
    both = CATALOGUE[id], CATALOGUE[other.effect]
    if id == other.effect or all(_is_body(known) for known in both):
        return False
    # While a joint moves one way some are constant there: two of them look like a third.
    alike = all(known.traits.one_way for known in both) or all(known.coupler is not None for known in both)
    return joint != other.joint or joint is None or not alike


def _is_body(known: Effect) -> bool:
    """Whether it is one body, at the tip or of a link."""
    fold = known.traits.fold
    return known.traits.body or (fold is not None and fold.into == "link")


def form(id: str, joint: int | None, u: Usual, rng: np.random.Generator) -> Form:
    """The effect ``id`` at ``joint``, its shape drawn by ``rng``, its size open.

    Raises
    ------
    InputError: its definition does not say how it is hidden.
    """
    hidden = CATALOGUE[id].traits.hidden
    if hidden is None:
        raise InputError(f"{id} cannot be drawn", remedy="give its parameters")
    way = float(rng.choice([-1.0, 1.0]))
    return hidden.form(u.at(joint), way, rng)


def sized(drawn: Form, wanted: float, shows: Callable[[float], float]) -> tuple[float, float]:
    """The scale of ``drawn`` at which it ``shows`` about as much as ``wanted``, and how much that is."""
    x, best = drawn.start, None
    tried: list[tuple[float, float]] = []
    for _ in range(SIZE_TRIALS):
        x = min(max(x, drawn.least), drawn.most)
        ratio = shows(x)
        if best is None or abs(np.log(ratio / wanted)) < abs(np.log(best[1] / wanted)):
            best = x, ratio
        tried.append((x, ratio))
        power = 1.0
        if len(tried) > 1 and tried[-1][0] != tried[-2][0]:
            power = float(np.log(ratio / tried[-2][1]) / np.log(x / tried[-2][0]))
        following = x * (wanted / ratio) ** (1 / min(max(power, 0.3), 4.0))
        following = min(max(following, drawn.least), drawn.most)
        if abs(ratio / wanted - 1) < SIZE_TOLERANCE or following == x or abs(power) < 1e-3:
            break
        x = following
    assert best is not None
    return best


def settings(build: Parameters, fixed: Mapping[str, float | str]) -> Parameters:
    """Parameters with what is ``fixed`` in their place, six digits each, as a model is amended by them."""
    both: Parameters = {**build, **fixed}
    return {name: value if isinstance(value, str) else float(f"{value:.6g}") for name, value in both.items()}
