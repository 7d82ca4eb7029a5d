"""What is in a log, which map it needs, what the mapped log is like, and how it goes with a robot: all that
``robodyn logs`` says."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.logs.assemble import assemble
from robodyn.logs.blocks import with_second
from robodyn.logs.content import split_pair
from robodyn.logs.formats import open_recording, readable
from robodyn.logs.limits import BEYOND, GAIN_MATCH, LARGE_GAIN, SIGN_MATCH, SMALL_GAIN, TELLING
from robodyn.logs.log import Log, log_of_block, read_log
from robodyn.logs.mapping import Channel, LogMap
from robodyn.logs.propose import propose
from robodyn.logs.recording import Recording
from robodyn.logs.survey import LogFacts, StreamFacts, facts_of, look
from robodyn.robot.model import Robot

#: Rows at which gravity is evaluated.
STATES = 4000


@dataclass(frozen=True, slots=True)
class JointCheck:
    """A ``joint`` (from 1): its range [rad or m] beside the limits; how its torque goes with gravity's:
    ``correlation``, and ``gain``, how many times gravity's torque is in it; NaN where gravity's hardly
    changes, and ``low`` and ``high`` where no position is a number. ``remarks``: what that means."""

    joint: int
    low: float
    high: float
    limits: tuple[float, float] | None
    correlation: float
    gain: float
    remarks: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Examination:
    """A file looked into: its ``streams``; the ``mapping``, whether it was ``proposed``, the ``reasons`` and
    what is ``missing`` of it; the mapped ``log`` and its ``facts``, or the ``problem`` that there is none;
    ``checks`` of its joints beside a robot; and whether the file needs no map at all (``plain``)."""

    recording: Recording
    streams: tuple[StreamFacts, ...]
    mapping: LogMap
    proposed: bool
    reasons: Mapping[str, str] = field(default_factory=dict)
    missing: tuple[str, ...] = ()
    log: Log | None = None
    facts: LogFacts | None = None
    problem: str = ""
    checks: tuple[JointCheck, ...] = ()
    plain: bool = False


def examine(
    path: str | os.PathLike[str], robot: Robot | None = None, mapping: LogMap | None = None
) -> Examination:
    """Look into the log at ``path``; ``mapping`` None: propose one.

    Raises
    ------
    InputError: the file cannot be read, is damaged or empty.
    ToolError: the library for its format is missing.
    """
    with np.errstate(invalid="ignore", over="ignore"):  # a file may hold any number
        return _examined(os.fspath(path), robot, mapping)


def _examined(path: str, robot: Robot | None, mapping: LogMap | None) -> Examination:
    name, second = split_pair(path)
    recording = open_recording(name)
    with readable(recording.file):
        streams = look(recording)
    is_proposed, reasons, missing = mapping is None, dict[str, str](), tuple[str, ...]()
    if mapping is None:
        mapping, reasons, missing = propose(recording, streams, robot)
    if second is not None:
        mapping = with_second(mapping, second)
    result = Examination(recording, streams, mapping, is_proposed, reasons, missing)
    if missing:
        problem = f"nothing in the file says which columns are {', '.join(missing)}"
        result = replace(result, problem=problem)
        if missing != ("t",):
            return result
        # Signs and limits show without times: any rate will do.
        rate = Channel((), Place(recording.file), rate=Fraction(100))
        mapping = replace(mapping, groups={**mapping.groups, "t": rate})
    try:
        with readable(recording.file):
            n = None if robot is None else robot.n
            [block] = assemble(recording, mapping, n, robot, whole=True)
            log = log_of_block(block)
    except InputError as error:
        return replace(result, problem=str(error))
    if not missing:
        is_plain = is_proposed and _needs_none(path, robot, log)
        result = replace(result, log=log, facts=facts_of(log), plain=is_plain)
    if robot is None:
        return result
    if log.n != robot.n:
        return replace(result, problem=f"the log has {log.n} joints, and {robot.name} has {robot.n}")
    checks = check_joints(log, robot)
    turned = flipped(checks)
    if not is_proposed or not turned:
        return replace(result, checks=checks)
    signs = [-1 if j + 1 in turned else 1 for j in range(log.n)]
    tau = result.mapping.groups["tau"]
    tau = replace(tau, numbers={**tau.numbers, "sign": tuple(map(Fraction, signs))})
    log = replace(log, tau=log.tau * np.array(signs, dtype=np.float64))
    against = ", ".join(str(check.joint) for check in checks if check.correlation < 0)
    why = f"{reasons.get('tau', '')}; sign: against gravity's torque at joint {against}"
    return replace(
        result,
        mapping=replace(result.mapping, groups={**result.mapping.groups, "tau": tau}),
        reasons={**reasons, "tau": why.removeprefix("; ")},
        log=None if missing else log,
        plain=False,
        checks=check_joints(log, robot),
    )


def _needs_none(path: str, robot: Robot | None, log: Log) -> bool:
    """Whether the file is read the same without a map."""
    try:
        own = read_log(path, robot=robot)
    except InputError:
        return False
    pairs = zip(own.arrays(), log.arrays(), strict=True)
    return own.columns == log.columns and all(one.tobytes() == other.tobytes() for one, other in pairs)


# --- beside a robot ---------------------------------------------------------------------------------------


def check_joints(log: Log, robot: Robot) -> tuple[JointCheck, ...]:
    """Each joint of ``log`` beside the ``robot``, which has as many."""
    rows = np.unique(np.linspace(0, log.samples - 1, min(STATES, log.samples)).astype(int))
    q, tau = log.q[rows], log.tau[rows]
    sound = np.isfinite(q).all(axis=1) & np.isfinite(tau).all(axis=1)
    q, tau = q[sound], tau[sound]
    gravity = np.zeros_like(q)
    if len(q) and not robot.parameters:
        from robodyn.kernels.array_dynamics import Model
        from robodyn.robot.masses import massless

        gravity = Model(massless(robot)).torque(q, np.zeros_like(q), np.zeros_like(q))
    largest = float(np.ptp(gravity, axis=0).max(initial=0.0)) if len(q) else 0.0
    checks = []
    for j, link in enumerate(robot.links):
        pair = link.joint.limits.position
        limits = None if pair is None else (float(pair[0]), float(pair[1]))
        x = log.q[:, j][np.isfinite(log.q[:, j])]
        low, high = (float(x.min()), float(x.max())) if len(x) else (np.nan, np.nan)
        correlation, gain = _match(gravity[:, j], tau[:, j], largest)
        remarks = []
        room = 0.0 if limits is None else BEYOND * (limits[1] - limits[0])
        if limits is not None and (low < limits[0] - room or high > limits[1] + room):
            remarks.append("positions beyond the joint's limits: another unit, zero or joint?")
        if correlation < -SIGN_MATCH:
            remarks.append("the torque goes against gravity's: turn the sign of tau or of q")
        if abs(correlation) > GAIN_MATCH and gain < SMALL_GAIN:
            remarks.append("far smaller than gravity's: of the motor, in front of its gear? write gear")
        if abs(correlation) > GAIN_MATCH and gain > LARGE_GAIN:
            remarks.append("far larger than gravity's: another unit, such as mN m?")
        checks.append(JointCheck(j + 1, low, high, limits, correlation, gain, tuple(remarks)))
    return tuple(checks)


def flipped(checks: tuple[JointCheck, ...]) -> tuple[int, ...]:
    """The joints (from 1) whose torques have the other sign: all of them, where all do of which gravity says
    something, and these are several."""
    telling = [check for check in checks if abs(check.correlation) > SIGN_MATCH]
    turned = [check for check in telling if check.correlation < 0]
    if len(turned) == len(telling) > 1:
        return tuple(check.joint for check in checks)
    return tuple(check.joint for check in turned)


def _match(gravity: Floats, tau: Floats, largest: float) -> tuple[float, float]:
    """Correlation of a torque with gravity's, and the gain between them."""
    if len(gravity) < 10 or np.ptp(gravity) <= TELLING * largest or np.ptp(gravity) == 0:
        return float("nan"), float("nan")
    g, x = gravity - gravity.mean(), tau - tau.mean()
    power, other = float(g @ g), float(x @ x)
    if not other > 0:
        return float("nan"), float("nan")
    return float(g @ x) / (power * other) ** 0.5, float(g @ x) / power
