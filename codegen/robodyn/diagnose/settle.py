"""What names come to, beside numbers of the arm that are fitted along: findings, verdict, model."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from robodyn.arrays import Floats
from robodyn.diagnose.amend.amend import Amendment, apply_amendments
from robodyn.diagnose.judgement import Lacking, confirmed, gap_of, rms, standing, structure_left, verdict_of
from robodyn.diagnose.limits import WITHDRAWN
from robodyn.diagnose.refit import (
    Renumbered,
    amendment,
    no_worse,
    renumbered,
    with_known_errors,
)
from robodyn.diagnose.result import Finding, Gap, Verdict
from robodyn.diagnose.select.contact import Touched, contact_findings
from robodyn.diagnose.select.encoders import elastic_findings, elasticity, stiff_words
from robodyn.diagnose.select.outcome import Outcome
from robodyn.diagnose.select.scope import Scope
from robodyn.effects.catalogue import CATALOGUE
from robodyn.gate.gate import Gate
from robodyn.identify.contact.contact import without
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True, eq=False)
class Logs:
    """Logs that have passed: ``gates`` without the windows of contacts, of which the first ``fits`` are
    fitted; their hashes or names ``digests``; by these all of them ``whole``."""

    gates: Sequence[Gate]
    fits: int
    digests: Sequence[str]
    whole: dict[str, Gate]

    @property
    def fitted(self) -> Sequence[Gate]:
        """Those that are fitted."""
        return self.gates[: self.fits]

    @property
    def stand(self) -> bool:
        """Whether the arm stands still in all that is fitted: contacts show, and nothing of what it lacks."""
        return all(gate.stands for gate in self.fitted)

    @property
    def judged(self) -> Sequence[Gate]:
        """Those that names are judged in: what is not fitted, if there is such."""
        return self.gates[self.fits :] or self.gates

    def without(self, touched: Sequence[Touched]) -> Logs:
        """The logs without the windows of these contacts."""
        pairs = zip(self.gates, self.digests, strict=True)
        gates = [without(gate, [one.contact for one in touched if one.log == log]) for gate, log in pairs]
        return replace(self, gates=gates)


@dataclass(frozen=True, slots=True, eq=False)
class Settled:
    """The ``verdict`` with its ``findings``; the arm's ``own`` numbers with those of them that go with a fit
    to torques; what nothing explains, ``left`` [n], in units of what would matter."""

    verdict: Verdict
    findings: tuple[Finding, ...]
    own: Renumbered
    left: Floats


def settled(
    robot: Robot, findings: tuple[Finding, ...], outcome: Outcome, logs: Logs, lacks: Lacking
) -> Settled:
    """The ``findings`` of a search and its ``outcome``, with the arm's own numbers; names that do not hold in
    the logs they are judged in are withdrawn."""
    if logs.judged is not logs.gates:
        findings = _confirmed(robot, findings, outcome, logs)
    findings = standing(findings, outcome)
    verdict = verdict_of(findings, outcome)
    rubbing = {f.joint for f in findings if CATALOGUE[f.effect].dissipative}
    named = findings if verdict == "missing_effect" else ()
    left = structure_left(outcome)
    is_fixed = outcome.fit.model.share is None and all(link.confidence is None for link in robot.links)
    if (left.max(initial=0.0) <= 1 and is_fixed) or robot.covariance is not None or logs.stand:
        # Nothing is left for other numbers, they are known, or one torque a joint says nothing of them.
        done = apply_amendments(robot, [amendment(f) for f in named])
        own = Renumbered(done.robot, done.origins, named, is_refitted=False)
        return Settled(verdict, findings, own, left)
    own = renumbered(
        robot, named, logs.fitted,
        lambda arm: (rms(lacks, arm, logs.fitted), rms(lacks, arm, logs.judged)),
        unstated=outcome.fit.model.share,
        everywhere=2 * len(rubbing) > robot.n or verdict == "unexplained",
    )  # fmt: skip
    if verdict != "unexplained":
        findings = own.findings
    return Settled(verdict, findings, own, left)


def _confirmed(
    robot: Robot, findings: tuple[Finding, ...], outcome: Outcome, logs: Logs
) -> tuple[Finding, ...]:
    """Those that hold in logs that were not fitted; others are named and no claim."""
    every = [amendment(f) for f in findings]
    models = [apply_amendments(robot, [*every[:k], *every[k + 1 :]]).robot for k in range(len(every))]
    whole = apply_amendments(robot, every).robot
    kept = confirmed([whole, *models], logs.judged, outcome.fit.model.rows)
    return tuple(
        f if holds else replace(f, confidence=min(f.confidence, WITHDRAWN))
        for f, holds in zip(findings, kept, strict=True)
    )


@dataclass(frozen=True, slots=True, eq=False)
class Completed:
    """The amended ``model``, the ``origins`` of its effects among those of the description (None: new), the
    ``amendments`` that it has, the ``gap`` that it leaves, ``findings`` and ``verdict``; ``words`` for people
    of what second encoders show no spring."""

    model: Robot
    origins: tuple[int | None, ...]
    amendments: tuple[Amendment, ...]
    gap: Gap
    findings: tuple[Finding, ...]
    verdict: Verdict
    words: tuple[str, ...]


def completed(
    robot: Robot, by_torque: Settled, touched: Sequence[Touched], logs: Logs, scope: Scope, lacks: Lacking
) -> Completed:
    """What was settled ``by_torque``, with what no fit to torques finds: springs that second encoders show,
    where the torques fit no worse with them, and the contacts ``touched``."""
    own, verdict = by_torque.own, by_torque.verdict
    model, origins = own.robot, own.origins
    amendments = [amendment(f) for f in own.findings]
    gap = gap_of(lacks, robot, model, logs.fitted, logs.judged)
    by_encoders = elasticity(model, logs.fitted)
    springs = [f for f in elastic_findings(model, by_encoders) if scope.allows(f.effect, f.joint)]
    contacts = contact_findings(touched)
    findings = (*map(with_known_errors, by_torque.findings), *springs, *contacts)
    stiff = apply_amendments(model, [amendment(f) for f in springs]).robot
    added = list(contacts)
    if springs and all(
        no_worse(*(rms(lacks, arm, which) for arm in (model, stiff))) for which in (logs.fitted, logs.judged)
    ):
        added, gap = [*springs, *contacts], gap_of(lacks, robot, stiff, logs.fitted, logs.judged)
    if added:
        more = apply_amendments(model, [amendment(f) for f in added])
        model, amendments = more.robot, [*amendments, *(amendment(f) for f in added)]
        origins = tuple(None if k is None else origins[k] for k in more.origins)
        verdict = "missing_effect" if verdict == "consistent" else verdict
    elif logs.stand:
        verdict = "unexplained"
    words = stiff_words(robot, by_encoders)
    return Completed(model, origins, tuple(amendments), gap, findings, verdict, words)
