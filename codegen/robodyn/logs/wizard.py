"""What is in a log, which map it needs, and what the mapped log is like: all that ``robodyn logs`` says."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

import numpy as np

from robodyn.errors import InputError, Place
from robodyn.logs.against_robot import JointCheck, check_joints, flipped
from robodyn.logs.assemble import assemble
from robodyn.logs.blocks import with_second
from robodyn.logs.content import split_pair
from robodyn.logs.formats import open_recording, readable
from robodyn.logs.log import Log, log_of_block, read_log
from robodyn.logs.mapping import Channel, LogMap
from robodyn.logs.propose import propose
from robodyn.logs.recording import Recording
from robodyn.logs.survey import LogFacts, StreamFacts, facts_of, look
from robodyn.robot.model import Robot


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
        return _examined(path, robot, mapping)


def _examined(path: str | os.PathLike[str], robot: Robot | None, mapping: LogMap | None) -> Examination:
    name, second = split_pair(os.fspath(path))
    recording = open_recording(name)
    with readable(recording.file):
        streams = look(recording)
    reasons: Mapping[str, str] = {}
    missing: tuple[str, ...] = ()
    proposed = mapping is None
    if mapping is None:
        proposal = propose(recording, streams, robot)
        mapping, reasons, missing = proposal.mapping, proposal.reasons, proposal.missing
    if second is not None:
        mapping = with_second(mapping, second)
    result = Examination(recording, streams, mapping, proposed, reasons, missing)
    if missing:
        problem = f"nothing in the file says which columns are {', '.join(missing)}"
        result = replace(result, problem=problem)
    if set(missing) - {"t"}:
        return result
    # Signs and limits show without times: any rate will do.
    rate = {"t": Channel((), Place(recording.file), rate=Fraction(100))} if missing else {}
    timed = replace(mapping, groups={**mapping.groups, **rate})
    try:
        log = _mapped(recording, timed, robot)
    except InputError as error:
        return replace(result, problem=str(error))
    if not missing:
        plain = proposed and _needs_none(name, second, robot, log)
        result = replace(result, log=log, facts=facts_of(log), plain=plain)
    if robot is None:
        return result
    if log.n != robot.n:
        return replace(result, problem=f"the log has {log.n} joints, and {robot.name} has {robot.n}")
    checks = check_joints(log, robot)
    turned = flipped(checks)
    return _turned(result, log, robot, turned) if proposed and turned else replace(result, checks=checks)


def _turned(result: Examination, log: Log, robot: Robot, joints: tuple[int, ...]) -> Examination:
    """``result`` with the sign of the torques of ``joints`` (from 1) turned."""
    tau = result.mapping.groups["tau"]
    signs = tuple(Fraction(-1 if j + 1 in joints else 1) for j in range(log.n))
    tau = replace(tau, numbers={**tau.numbers, "sign": signs})
    mapping = replace(result.mapping, groups={**result.mapping.groups, "tau": tau})
    against = [str(check.joint) for check in check_joints(log, robot) if check.correlation < 0]
    why = f"{result.reasons.get('tau', '')}; sign: against gravity's torque at joint {', '.join(against)}"
    reasons = {**result.reasons, "tau": why.removeprefix("; ")}
    log = replace(log, tau=log.tau * np.array([float(sign) for sign in signs]))
    shown = log if result.log is not None else None
    return replace(
        result, mapping=mapping, reasons=reasons, log=shown, plain=False, checks=check_joints(log, robot)
    )


def _mapped(recording: Recording, mapping: LogMap, robot: Robot | None) -> Log:
    with readable(recording.file):
        n = None if robot is None else robot.n
        [block] = assemble(recording, mapping, n, robot, whole=True)
        return log_of_block(block)


def _needs_none(name: str, second: str | None, robot: Robot | None, log: Log) -> bool:
    """Whether the file is read the same without a map."""
    try:
        own = read_log(name if second is None else f"{name}+{second}", robot=robot)
    except InputError:
        return False
    pairs = zip(own.arrays(), log.arrays(), strict=True)
    return own.columns == log.columns and all(one.tobytes() == other.tobytes() for one, other in pairs)
