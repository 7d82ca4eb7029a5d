"""What a search has found, as findings: names with their numbers, place, rivals and odds."""

from __future__ import annotations

from dataclasses import replace

from robodyn.diagnose.judgement import explained
from robodyn.diagnose.limits import MOST_RIVALS, WITHDRAWN
from robodyn.diagnose.refit import without_vague_claim
from robodyn.diagnose.result import Estimate, Finding, Rival
from robodyn.diagnose.select.compare import ahead, overlap, special_cases
from robodyn.diagnose.select.errors import Sure, body_parameters, sureness
from robodyn.diagnose.select.families import SPEED, Key
from robodyn.diagnose.select.limits import OVERLAP, RIVAL, RIVAL_LEAST
from robodyn.diagnose.select.odds import odds
from robodyn.diagnose.select.outcome import Found, Outcome
from robodyn.diagnose.select.rows import Rows
from robodyn.diagnose.select.score import Trial
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.traits import Law
from robodyn.robot.model import Robot


def findings_of(robot: Robot, outcome: Outcome, *, is_doubtful: bool) -> tuple[Finding, ...]:
    """What was found as findings, the one that explains most first; claims if the logs are not
    ``is_doubtful``."""
    sure = dict(zip(map(id, outcome.fit.model.members), sureness(outcome.fit), strict=True))
    findings = []
    for one in outcome.found:
        finding = without_vague_claim(_finding(robot, outcome, one, sure[id(one.member)]))
        if is_doubtful:
            finding = replace(finding, confidence=min(finding.confidence, WITHDRAWN))
        findings.append(finding)
    return tuple(sorted(findings, key=lambda f: -f.gain))


def _finding(robot: Robot, outcome: Outcome, one: Found, sure: Sure) -> Finding:
    id, joint = one.member.key
    entry, trial = CATALOGUE[id], one.trial
    revolute = joint is None or robot.links[joint - 1].joint.kind == "revolute"
    values = body_parameters(outcome.fit, one.member) if one.member.is_linear else one.member.parameters
    parameters = {
        name: Estimate(value, sure.errors.get(name), unit_of(id, name, revolute), sure.bounds.get(name))
        for name, value in values.items()
    }
    together = {name: Estimate(value, error, "") for name, (value, error) in sure.together.items()}
    rivals = rivals_of(one)
    slow = laws_at_rest(one.member.key, outcome.fit.model.rows)
    close = sorted({*slow, *(each.effect for each, z, _ in rivals if z < RIVAL)})
    j = int(trial.at.argmax())
    place = f"joint {joint}" if joint else "the whole robot"
    where = f"{place}: {entry.signature}; seen best at joint {j + 1}"
    experiment = f"to tell it from {', '.join(close)}: {entry.separates}" if close else None
    against = [(z, more) for _, z, more in rivals] + [
        (0.0, more - trial.family.order) for more in slow.values()
    ]
    if one.throughout is not None:
        z = ahead(trial.gains - one.throughout)
        against.append((z, 0.0))
        where += "; wrong numbers of all links explain as much" if z < RIVAL else ""
    confidence = round(odds(against, float(explained(outcome)[j])), 2)
    return Finding(
        id, joint, parameters, confidence, tuple(close), where, experiment,
        trial.gain, trial.gain / max(trial.error, 1e-300), tuple(each for each, *_ in rivals[:MOST_RIVALS]),
        tuple(map(float, trial.gains)), together,
    )  # fmt: skip


def rivals_of(one: Found) -> list[tuple[Rival, float, float]]:
    """Other candidates in the place of what was found, by how many standard errors they foretell less, the
    nearest first, and how many more numbers they have. A law that has the name as a special case is none, nor
    one that foretells no more than its own special case; nor is the same body."""
    trial, (id, joint) = one.trial, one.member.key
    found: dict[tuple[str, int | None], tuple[Rival, float, float]] = {}
    plain = [each for each in one.beside if each.is_possible and not each.family.second]
    for other in one.beside:
        first = other.family.first
        key = other.family.key
        if (
            other is trial
            or one.member.key in other.family.keys
            or key in found
            or not other.is_possible
            or other.gain < RIVAL_LEAST * trial.gain
            or overlap(other, trial) < OVERLAP
            or (key[1] == joint and id in special_cases(key[0]))
            or any(_is_no_more(other, each) for each in plain)
            or _is_same_body(one, other)
        ):
            continue
        z = ahead(trial.gains - other.gains)
        gains = tuple(map(float, other.gains))
        rival = Rival(first.effect, first.joint, other.gain, gains, why_not(other, trial, z))
        found[key] = rival, z, other.family.order - trial.family.order
    return sorted(found.values(), key=lambda each: each[1])


def laws_at_rest(key: Key, rows: Rows) -> dict[str, float]:
    """Laws, with their orders, that have this one as a special case and change with the speed, where the log
    wants directions of its joint to be unresolved at higher speeds than its rates and encoders make them so:
    something changes below, of which it cannot tell what."""
    id, joint = key
    if joint is None or rows.speeds[joint - 1] <= rows.expected[joint - 1]:
        return {}
    laws = {
        other.id: one
        for other in CATALOGUE.values()
        for one in other.traits.candidates
        if isinstance(one, Law) and id in special_cases(other.id)
    }
    speeds = {id: {p.name for p in CATALOGUE[id].parameters if p.unit == SPEED} for id in laws}
    return {id: float(one.order) for id, one in laws.items() if any(speeds[id] & set(x) for x in one.grid)}


def _is_no_more(one: Trial, plain: Trial) -> bool:
    """Whether a law foretells no more than a ``plain`` one that it has as a special case."""
    (id, joint), (simple, at) = one.family.key, plain.family.key
    return joint == at and simple in special_cases(id) and ahead(one.gains - plain.gains) <= 1


def _is_same_body(one: Found, other: Trial) -> bool:
    """Whether both are about the last link: a load is a part of it."""

    def last(effect: str, joint: int | None) -> bool:
        traits = CATALOGUE[effect].traits
        n = len(one.trial.at)
        return traits.body or (traits.fold is not None and traits.fold.into == "link" and joint == n)

    return last(*one.member.key) and last(*other.family.key)


def why_not(other: Trial, named: Trial, z: float) -> str:
    """Why ``other`` is not the name that ``named`` is, ``z`` standard errors behind it."""
    if z >= RIVAL:
        return "explains less on parts of the log that were not fitted"
    if other.family.order > named.family.order:
        return "explains no more, with more numbers"
    return "explains as much: the log cannot tell them apart"


def unit_of(effect: str, name: str, revolute: bool) -> str:
    """The unit of a parameter, by the kind of joint."""
    for parameter in CATALOGUE[effect].parameters:
        if parameter.name == name:
            return parameter.unit_at(revolute=revolute)
    return "m" if name.startswith("com_") else "kg m^2"
