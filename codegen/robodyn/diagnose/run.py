"""The whole diagnosis: gate, signals, selection, names, amendment, proof."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
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
from robodyn.diagnose.judgement import Lacking, gap_of, holds, left_over, may_stand, rms, verdict_of, words_of
from robodyn.diagnose.limits import DRAWN_POINTS, FITTED_ROWS, FITTED_SAMPLES, FITTED_WINDOWS, WITHDRAWN
from robodyn.diagnose.one_body import one_body
from robodyn.diagnose.refit import (
    Renumbered,
    amendment,
    no_worse,
    refitted_places,
    renumbered,
    share_allowed,
    with_known_errors,
    without_vague_claim,
)
from robodyn.diagnose.result import Diagnosis, Estimate, Finding, Rival, Series
from robodyn.diagnose.select.contact import contact_findings, standing, without_contacts
from robodyn.diagnose.select.encoders import elastic_findings
from robodyn.diagnose.select.forward import Named
from robodyn.diagnose.select.library import Candidate
from robodyn.diagnose.select.scope import scope_of
from robodyn.diagnose.select.search import Detected, search
from robodyn.diagnose.select.selection import what_matters
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
    n = robot.n
    scope = scope_of(n, only, without, joints, most)
    share, rows = (count // max(1, len(logs)) for count in (FITTED_SAMPLES, FITTED_ROWS))
    gates = [
        inspect(
            log_of(log, n), robot, source=_name(names, k), most=share, windows=FITTED_WINDOWS, thinned=rows
        )
        for k, log in enumerate([*logs, *([] if validate is None else [validate])])
    ]
    whole = gates
    digests = [hashes[k] if k < len(hashes) else f"log {k + 1}" for k in range(len(whole))]
    cleaned, touched = without_contacts(robot, whole, digests) if scope.has_contact else (whole, ())
    gates = cleaned[: len(logs)]
    seen = gates if validate is None else cleaned[len(logs) :]
    outcome = search(robot, gates, tell, scope.at_rest() if all(g.stands for g in gates) else scope)
    model, accepted, last, first = outcome.model, outcome.findings, outcome.last, outcome.first
    tell("validating the result")
    unsure = doubtful(gates)
    checked = [(one, not unsure and may_stand(one, first, last)) for one in accepted.values()]
    named = (without_vague_claim(_finding(robot, one, sure)) for one, sure in checked)
    findings = tuple(sorted(named, key=lambda f: -f.gain))
    left = left_over(last)
    verdict = verdict_of(findings, last, left)
    lacks = Lacking()
    tell("fitting the arm's own numbers")

    def renumber(named: Sequence[Finding], *, unexplained: bool) -> Renumbered:
        return renumbered(
            robot, named, gates, lambda arm: (rms(lacks, arm, gates), rms(lacks, arm, seen)),
            unstated=first.unstated,
            # A log with more in it than can be named still has the arm's numbers in it.
            everywhere=any(each.is_common for each in first.findings) or unexplained,
            may_load=scope.joints is None and scope.only is None and not unexplained,
        )  # fmt: skip

    own = Renumbered(robot, tuple(range(len(robot.effects))), (), is_refitted=False)
    if verdict != "unexplained":
        own = renumber(findings, unexplained=False)
        # The arm's own numbers may be so wrong that what is named shows beside better ones only.
        if verdict == "missing_effect" and not (
            holds(lacks, robot, model, gates, seen)
            or holds(lacks, renumber((), unexplained=False).robot, own.robot, gates, seen)
        ):
            verdict = "unexplained"
            findings = tuple(replace(f, confidence=WITHDRAWN) for f in findings)
    if verdict != "unexplained":
        findings = tuple(map(without_vague_claim, own.findings))
        verdict = verdict_of(findings, last, left)  # of better numbers, and perhaps a load
    if verdict == "unexplained" and (first.rough or own.findings):
        own = renumber((), unexplained=True)
    model, origins, amendments = own.robot, own.origins, [amendment(f) for f in own.findings]
    gap = gap_of(lacks, robot, model, gates, seen)
    is_loaded = any(CATALOGUE[f.effect].traits.body for f in own.findings)
    heavier = one_body(robot, model, gates) if own.is_refitted and not is_loaded else None
    extra: dict[str, Any] = {"refitted": share_allowed(robot, first.unstated)} if own.is_refitted else {}
    if heavier:
        extra["one_body"] = heavier.words()
    springs = [f for f in elastic_findings(model, gates) if scope.allows(f.effect, f.joint)]
    findings = tuple(map(with_known_errors, findings))
    touched = standing(touched, dict(zip(digests, whole, strict=True)), lambda gate: lacks(model, gate))
    findings = (*findings, *springs, *(added := contact_findings(touched)))  # not by a fit to torques
    stiff = apply_amendments(model, [amendment(f) for f in springs]).robot
    logs_of = (gates, seen)
    if springs and all(no_worse(*(rms(lacks, arm, which) for arm in (model, stiff))) for which in logs_of):
        added, gap = (*springs, *added), gap_of(lacks, robot, stiff, gates, seen)
    if added:
        more = apply_amendments(model, [amendment(f) for f in added])
        model, amendments = more.robot, [*amendments, *(amendment(f) for f in added)]
        origins = tuple(None if k is None else origins[k] for k in more.origins)
        verdict = "missing_effect" if verdict == "consistent" else verdict
    old = text if text is not None and parameters is None else to_yaml(robot)
    new = old
    if model != robot:
        note = f"robodyn diagnose: {', '.join(hashes[: len(logs)]) or 'a log'}"
        notes = dict.fromkeys(range(len(amendments)), note)
        comments = comments_of(apply_amendments(robot, amendments), amendments, notes)
        if own.is_refitted:
            comments += [(refitted_places(robot, model), [f"{note}: fitted within their confidence"])]
        new = to_yaml(model) if parameters else rewritten(old, robot, model, origins, comments)
    described = tuple(
        {
            "name": _name(names, k) or f"log {k + 1}",
            "sha256": hashes[k] if k < len(hashes) else "",
            **log_facts(whole[k]),
        }
        for k in range(len(logs) + (validate is not None))
    )
    before, after = operations(robot), operations(model)
    flags = tuple(str(f) for gate in whole for f in gate.flags)
    drawn = (("train", whole[0]), ("validate", whole[-1]))
    seen_names = _shown(digests, validated=validate is not None)
    return Diagnosis(
        verdict, findings, gap, robot, model, new, difference(old, new),
        flags, left, (*words_of(verdict, left), *([heavier.words()] if heavier else []), *scope.words()),
        described,
        tuple(_series(lacks, name, robot, model, gate) for name, gate in drawn),
        (before.total, after.total),
        windows(whole[0], findings, seen_names), tried(last, findings), what_matters(last.context),
        (by_kind(before), by_kind(after)), agreement(model, gates[0]), to_record(robot, gates),
        extra,
    )  # fmt: skip


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
