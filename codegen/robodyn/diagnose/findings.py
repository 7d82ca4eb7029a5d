"""What a search has detected, as findings: names with their numbers, their place, their rivals."""

from __future__ import annotations

from typing import Any

from robodyn.diagnose.evidence import why_not
from robodyn.diagnose.judgement import may_stand
from robodyn.diagnose.limits import WITHDRAWN
from robodyn.diagnose.refit import without_vague_claim
from robodyn.diagnose.result import Estimate, Finding, Rival
from robodyn.diagnose.select.forward import Named
from robodyn.diagnose.select.library import Candidate
from robodyn.diagnose.select.search import Detected, Outcome
from robodyn.effects.catalogue import CATALOGUE
from robodyn.robot.model import Robot


def findings_of(robot: Robot, outcome: Outcome, *, is_doubtful: bool) -> tuple[Finding, ...]:
    """What was detected as findings, the one that explains most first; claims if the logs are not
    ``is_doubtful``."""
    findings = []
    for one in outcome.findings.values():
        is_sure = not is_doubtful and may_stand(one, outcome.first, outcome.last)
        findings.append(without_vague_claim(_finding(robot, one, is_sure)))
    return tuple(sorted(findings, key=lambda f: -f.gain))


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
