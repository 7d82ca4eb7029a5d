"""The whole diagnosis: gate, signals, selection, names, amendment, proof."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.amend.amend import apply_amendments, comments_of, difference
from robodyn.diagnose.evidence import (
    by_kind,
    doubtful,
    log_facts,
    operations,
    to_record,
    tried,
    why_not,
    windows,
)
from robodyn.diagnose.judgement import Lacking, may_stand, words_of
from robodyn.diagnose.limits import DRAWN_POINTS, FITTED_ROWS, FITTED_SAMPLES, FITTED_WINDOWS, WITHDRAWN
from robodyn.diagnose.one_body import one_body
from robodyn.diagnose.refit import refitted_places, share_allowed, without_vague_claim
from robodyn.diagnose.result import Diagnosis, Estimate, Finding, Rival, Series
from robodyn.diagnose.select.contact import without_contacts
from robodyn.diagnose.select.forward import Named
from robodyn.diagnose.select.library import Candidate
from robodyn.diagnose.select.scope import scope_of
from robodyn.diagnose.select.search import Detected, Outcome, search
from robodyn.diagnose.select.selection import what_matters
from robodyn.diagnose.settle import Completed, Logs, completed, settled
from robodyn.effects.catalogue import CATALOGUE
from robodyn.formats.loading import robot_of, text_of
from robodyn.gate.gate import Gate, inspect
from robodyn.identify.predict import agreement, signals_seen
from robodyn.identify.rigid import Model
from robodyn.logs.log import LogSource, log_of
from robodyn.robot.model import Robot
from robodyn.robot.rewriting import rewritten

Floats = NDArray[np.float64]


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
    robot = robot_of(robot).at(parameters or {})
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
    digests = [hashes[k] if k < len(hashes) else f"log {k + 1}" for k in range(len(whole))]
    cleaned, touched = without_contacts(robot, whole, digests) if scope.has_contact else (whole, ())
    gates = cleaned[: len(logs)]
    passed = Logs(
        gates, gates if validate is None else cleaned[len(logs) :], dict(zip(digests, whole, strict=True))
    )
    outcome = search(robot, gates, tell, scope.at_rest() if all(g.stands for g in gates) else scope)
    tell("validating the result")
    named, lacks = _findings(robot, outcome, is_doubtful=doubtful(gates)), Lacking()
    tell("fitting the arm's own numbers")
    by_torque = settled(robot, named, outcome, passed, scope, lacks)
    own, left = by_torque.own, by_torque.left
    result = completed(robot, by_torque, touched, passed, scope, lacks)
    model, findings = result.model, result.findings
    is_loaded = any(CATALOGUE[f.effect].traits.body for f in own.findings)
    heavier = one_body(robot, own.robot, gates) if own.is_refitted and not is_loaded else None
    remarks: dict[str, Any] = {}
    if own.is_refitted:
        remarks["refitted"] = share_allowed(robot, outcome.first.unstated)
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
        *words_of(result.verdict, left),
        *([heavier.words()] if heavier else []),
        *result.words,
        *scope.words(),
    )
    return Diagnosis(
        result.verdict, findings, result.gap, robot, model, new, difference(old, new),
        tuple(str(flag) for gate in whole for flag in gate.flags), left, words,
        tuple(_described(gate, k, names, hashes) for k, gate in enumerate(whole)),
        tuple(_series(lacks, name, robot, model, gate) for name, gate in drawn),
        (before.total, after.total),
        windows(whole[0], findings, _shown(digests, validated=validate is not None)),
        tried(outcome.last, findings), what_matters(outcome.last.context),
        (by_kind(before), by_kind(after)), agreement(model, gates[0]), to_record(robot, gates),
        remarks,
    )  # fmt: skip


def _findings(robot: Robot, outcome: Outcome, *, is_doubtful: bool) -> tuple[Finding, ...]:
    """What was detected as findings, the one that explains most first; claims if the logs are not
    ``is_doubtful``."""
    findings = []
    for one in outcome.findings.values():
        is_sure = not is_doubtful and may_stand(one, outcome.first, outcome.last)
        findings.append(without_vague_claim(_finding(robot, one, is_sure)))
    return tuple(sorted(findings, key=lambda f: -f.gain))


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


def _finding(robot: Robot, one: Detected, sure: bool) -> Finding:
    candidate, trial = one.named.trial.candidate, one.named.trial
    entry = CATALOGUE[candidate.effect]
    revolute = candidate.joint is None or robot.links[candidate.joint - 1].joint.kind == "revolute"
    parameters = {
        name: Estimate(
            value, one.errors.get(name), _unit(candidate.effect, name, revolute), one.bounds.get(name)
        )
        for name, value in one.parameters.items()
    }
    j = max(candidate.rows, key=lambda row: one.before[row])
    place = f"joint {candidate.joint}" if candidate.joint else "the whole robot"
    where = f"{place}: {entry.signature}; seen best at joint {j + 1}"
    experiment = None
    if one.named.rivals:
        experiment = f"to tell it from {', '.join(one.named.rivals)}: {entry.separates}"
    rivals = tuple(
        Rival(t.candidate.effect, t.candidate.joint, t.gain, tuple(map(float, t.per_part)), why_not(t, trial))
        for t in _strongest(one.named, candidate)
    )
    confidence = one.named.confidence if sure else WITHDRAWN
    return Finding(
        candidate.effect, candidate.joint, parameters, round(confidence, 2), one.named.rivals, where,
        experiment, trial.gain, trial.t, rivals, tuple(map(float, trial.per_part)),
    )  # fmt: skip


def _strongest(named: Named, candidate: Candidate) -> list[Any]:
    seen: set[tuple[str, int | None]] = {(candidate.effect, candidate.joint)}
    claims = []
    for one in named.beside:
        key = (one.candidate.effect, one.candidate.joint)
        if key in seen or not set(one.candidate.rows) & set(candidate.rows):
            continue
        seen.add(key)
        claims.append(one)
        if len(claims) == 5:
            break
    return claims


def _unit(effect: str, name: str, revolute: bool) -> str:
    for parameter in CATALOGUE[effect].parameters:
        if parameter.name == name:
            return parameter.unit_at(revolute=revolute)
    return "m" if name.startswith("com_") else "kg m^2"


def _series(lacks: Lacking, name: str, robot: Robot, model: Robot, gate: Gate) -> Series:
    s = signals_seen(gate)
    before, after = (lacks(r, gate) for r in (robot, model))
    load = Model(robot).evaluate(s.q, s.qd, s.qdd).rigid if robot.n else s.q
    step = max(1, len(gate.log.t) // DRAWN_POINTS)
    parts = (gate.log.t, s.q, s.qd, s.qdd, load, gate.log.tau, before, after)
    return Series(name, *(x[::step] for x in parts))
