"""The whole diagnosis: gate, signals, selection, names, amendment, proof."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from os import PathLike
from typing import Any

import numpy as np

from robodyn.diagnose.accounts import accounted
from robodyn.diagnose.amend.amend import apply_amendments, comments_of, difference
from robodyn.diagnose.evidence import (
    by_kind,
    log_facts,
    operations,
    to_record,
    tried,
    windows,
)
from robodyn.diagnose.judgement import STANDS, Lacking, what_matters, words_of
from robodyn.diagnose.limits import (
    DRAWN_POINTS,
    FITTED_ROWS,
    FITTED_SAMPLES,
    FITTED_WINDOWS,
    LOOKING_COST,
    STAGE_COSTS,
)
from robodyn.diagnose.one_body import one_body
from robodyn.diagnose.refit import refitted_places, share_allowed
from robodyn.diagnose.result import Diagnosis, Series
from robodyn.diagnose.select.contact import touches
from robodyn.diagnose.select.resolution import rest_speeds
from robodyn.diagnose.select.scope import scope_of
from robodyn.diagnose.settle import Completed, Logs, completed
from robodyn.effects.catalogue import CATALOGUE
from robodyn.errors import InputError
from robodyn.formats.loading import robot_of, text_of
from robodyn.gate.gate import Gate, inspect
from robodyn.identify.known import with_covariance_read
from robodyn.identify.limits import LEAST_NOISE
from robodyn.identify.predict import agreement, signals_seen
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.limits import FASTEST_RATE
from robodyn.logs.log import Log, LogSource, log_of
from robodyn.logs.signals import thinning
from robodyn.robot.coupling import no_couplings
from robodyn.robot.model import Robot
from robodyn.robot.rewriting import rewritten


def diagnose(
    robot: Robot | str | PathLike[str],
    logs: Sequence[LogSource],
    validate: LogSource | None = None,
    *,
    text: str | None = None,
    names: Sequence[str] = (),
    hashes: Sequence[str] = (),
    parameters: Mapping[str, float] | None = None,
    progress: Callable[[str], object] | None = None,
    only: Sequence[str] = (),
    without: Sequence[str] = (),
    joints: Sequence[int] = (),
    most: int | None = None,
) -> Diagnosis:
    """What ``robot`` lacks to explain ``logs``; ``validate`` is a log that is not fitted.

    A robot may be a path or a name, a log the path of a CSV or Parquet file, or what hands it over
    (:data:`robodyn.logs.log.LogSource`).

    ``text`` is the robot's description, to be amended; ``names`` and ``hashes`` are those of the logs, the
    validation's last. ``only`` these effects (ids) are looked for, or all ``without`` those; at these
    ``joints`` (from 1) and not of the whole robot; ``most`` kinds of them are named.

    Raises
    ------
    InputError: there is no such robot, file, effect or joint, a log cannot be used, or ``parameters`` do
    not fit the robot (:meth:`Robot.at`).
    """
    from robodyn.robot.writer import to_yaml

    tell = progress or (lambda _: None)
    if text is None and not isinstance(robot, Robot):
        text = text_of(robot)
    robot = with_covariance_read(robot_of(robot).at(parameters or {}))
    no_couplings(robot, "a diagnosis")
    tell("looking at the logs")
    scope = scope_of(robot.n, only, without, joints, most)
    share, rows = (count // max(1, len(logs)) for count in (FITTED_SAMPLES, FITTED_ROWS))
    whole = [
        inspect(
            log_of(log, robot.n), robot, source=_name(names, k), most=share, windows=FITTED_WINDOWS,
            thinned=rows,
        )
        for k, log in enumerate([*logs, *([] if validate is None else [validate])])
    ]  # fmt: skip
    if all(np.abs(gate.log.tau).max() <= LEAST_NOISE for gate in whole):
        raise InputError(
            f"no torque of {robot.name} is observed",
            found=f"none beyond {LEAST_NOISE:g} N m or N in the logs",
            expected="the torque of every joint",
            remedy="record the torques of all joints",
        )
    digests = [hashes[k] if k < len(hashes) else f"log {k + 1}" for k in range(len(whole))]
    free, touched = touches(robot, whole, digests) if scope.has_contact else (whole, ())
    evidence = Logs(free, len(logs), digests, dict(zip(digests, whole, strict=True)))
    lacks = Lacking()
    account = accounted(robot, evidence, touched, scope, lacks, tell)
    outcome, by_torque, gates = account.outcome, account.by_torque, account.logs.fitted
    own, left = by_torque.own, by_torque.left
    result = completed(robot, by_torque, account.contacts, account.logs, scope, lacks)
    # What was identified does not lie beside the new description, and new numbers are not in it.
    model, findings = replace(result.model, covariance=None), result.findings
    is_loaded = any(CATALOGUE[f.effect].traits.body for f in own.findings)
    heavier = one_body(robot, own.robot, gates) if own.is_refitted and not is_loaded else None
    remarks: dict[str, Any] = {}
    if own.is_refitted:
        remarks["refitted"] = share_allowed(robot, outcome.fit.model.share)
    if account.logs.stand:
        remarks["stands"] = STANDS
    if heavier:
        remarks["one_body"] = heavier.words()
    old = text if text is not None and parameters is None else to_yaml(robot)
    new = old
    if model != robot:
        comments = _comments(robot, result, hashes[: len(logs)], is_refitted=own.is_refitted)
        new = to_yaml(model) if parameters else rewritten(old, robot, model, result.origins, comments)
    before, after = operations(robot), operations(model)
    drawn = (("train", whole[0]), ("validate", whole[-1]))
    words = (
        *words_of(result.verdict, left, stands=account.logs.stand),
        *([heavier.words()] if heavier else []),
        *result.words,
        *scope.words(),
    )
    return Diagnosis(
        result.verdict, findings, result.gap, robot, model, new, difference(old, new),
        tuple(str(flag) for gate in whole for flag in gate.flags), left, words,
        tuple(_described(gate, k, names, hashes) for k, gate in enumerate(whole)),
        rest_speeds(model, outcome.fit.model.rows),
        tuple(_series(lacks, name, robot, model, gate) for name, gate in drawn),
        (before.total, after.total),
        windows(whole[0], findings, _shown(digests, validated=validate is not None)),
        tried(outcome, findings), what_matters(outcome),
        (by_kind(before), by_kind(after)), agreement(model, gates[0]), to_record(robot, gates),
        remarks,
    )  # fmt: skip


def _comments(robot: Robot, result: Completed, hashes: Sequence[str], *, is_refitted: bool) -> list[Any]:
    """What stands beside the numbers that are new."""
    note = f"robodyn diagnose: {', '.join(hashes) or 'a log'}"
    notes = dict.fromkeys(range(len(result.amendments)), note)
    comments: list[Any] = [*comments_of(apply_amendments(robot, result.amendments), result.amendments, notes)]
    if is_refitted:
        places = refitted_places(robot, result.model)
        comments.append((places, [f"{note}: fitted within their confidence"]))
    return comments


def _described(gate: Gate, k: int, names: Sequence[str], hashes: Sequence[str]) -> dict[str, str]:
    """Log ``k`` (from 0) as the report has it."""
    digest = hashes[k] if k < len(hashes) else ""
    return {"name": _name(names, k) or f"log {k + 1}", "sha256": digest, **log_facts(gate)}


def _name(names: Sequence[str], k: int) -> str | None:
    return names[k] if k < len(names) else None


def _shown(digests: Sequence[str], *, validated: bool) -> dict[str, str]:
    """Names of the series by the hashes of their logs."""
    return {digests[-1]: "validate" if validated else "train", digests[0]: "train"}


def _series(lacks: Lacking, name: str, robot: Robot, model: Robot, gate: Gate) -> Series:
    s = signals_seen(gate)
    before, after = (lacks(r, gate) for r in (robot, model))
    load = Model(robot).evaluate(s.q, s.qd, s.qdd).rigid if robot.n else s.q
    step = max(1, len(gate.log.t) // DRAWN_POINTS)
    parts = (gate.log.t, s.q, s.qd, s.qdd, load, gate.log.tau, before, after)
    return Series(name, *(x[::step] for x in parts))


# --- how long it takes -----------------------------------------------------------------------------------


def stages(n: int, logs: Sequence[Log]) -> dict[str, float]:
    """The stages of a diagnosis of ``n`` joints by ``logs`` in their order, as ``progress`` is told of them,
    and about how long each takes [s]; what is found decides how often some of them are done."""
    rows = sum(log.samples / thinning(_rate(log)) for log in logs)
    squares = n * n * min(rows, float(FITTED_ROWS))
    base, each = LOOKING_COST
    costs = {"looking at the logs": base + each * n * sum(log.samples for log in logs)}
    return costs | {name: base + each * squares for name, (base, each) in STAGE_COSTS.items()}


def _rate(log: Log) -> float:
    """About how many samples a second ``log`` has, which nobody has looked at yet."""
    steps = np.diff(log.t)
    steps = steps[steps > 1 / FASTEST_RATE]
    return 1 / float(np.median(steps)) if len(steps) else FASTEST_RATE
