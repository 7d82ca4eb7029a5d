"""The arm's own numbers, fitted once more with all that was named: links, friction, rotors, loads.

The search gives names while the inertial numbers are a nuisance. Here they are estimated with what was named,
physically consistent and no farther from the description than its confidence and the logs say
(:mod:`robodyn.identify`).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.amend.amend import Amendment, apply_amendments
from robodyn.diagnose.limits import (
    REFIT_SHARE,
    REFIT_WORSE,
    SPRING_WORSE,
    WITHDRAWN,
)
from robodyn.diagnose.result import Estimate, Finding
from robodyn.diagnose.select.families import Key
from robodyn.diagnose.select.limits import VAGUE
from robodyn.effects.catalogue import CATALOGUE
from robodyn.gate.gate import Gate
from robodyn.identify.fit import Load, Options, fit_arm
from robodyn.identify.outcome import Estimate as Number
from robodyn.identify.outcome import Identified, identified
from robodyn.robot.model import AXES, Link, Robot
from robodyn.robot.parts import SHARE_NOT_STATED
from robodyn.robot.rewriting import Place

#: By the key of a joint that holds a number the name of its column.
_COLUMNS = {"viscous": "viscous", "coulomb": "coulomb", "motor_inertia": "rotor"}
_BODY = ("mass", "com_x", "com_y", "com_z", *(f"inertia_{axes}" for axes in AXES))


@dataclass(frozen=True, slots=True, eq=False)
class Refit:
    """``robot``: the model with its new numbers and all that was named; ``origins``: of each of its effects
    the index among those of the description, None where it is new; ``estimates``: of what was named, where
    the fit has better ones."""

    robot: Robot
    origins: tuple[int | None, ...]
    estimates: Mapping[Key, Mapping[str, Estimate]]


def refit(
    robot: Robot,
    amendments: Sequence[Amendment],
    gates: Sequence[Gate],
    *,
    unstated: float | None,
    everywhere: bool = False,
) -> Refit:
    """``robot`` with the ``amendments`` and new numbers of its own; ``unstated``: by which share
    the numbers may be wrong of which nothing is said; ``everywhere``: friction and rotors are fitted at all
    joints."""
    rigid = {(a.effect, a.joint) for a in amendments if _fold(a.effect) == "link"}
    bodies = [a for a in amendments if CATALOGUE[a.effect].traits.body]
    kept = [a for a in amendments if (a.effect, a.joint) not in rigid and a not in bodies]
    amended = apply_amendments(robot, kept)
    loose = {joint for _, joint in rigid}
    links = tuple(
        # What is said of a link that was named wrong does not hold.
        replace(link, confidence="unknown") if j in loose else _stated(link, unstated)
        for j, link in enumerate(robot.links, 1)
    )
    joints: dict[str, set[int]] = {}
    for one in kept:
        fold = CATALOGUE[one.effect].traits.fold
        if fold is not None and fold.into == "joint" and one.joint is not None:
            joints.setdefault(_COLUMNS[fold.key], set()).add(one.joint - 1)
    if everywhere:
        joints = {name: set(range(robot.n)) for name in _COLUMNS.values()}
    loads = (Load(tuple(range(len(gates)))),) if bodies else ()
    options = Options(
        offsets=False, loads=loads, joints={name: frozenset(places) for name, places in joints.items()}
    )
    beside = apply_amendments(replace(robot, links=links), kept).robot
    outcome = identified(fit_arm(beside, gates, options))
    model = replace(outcome.robot, links=tuple(map(_with_confidence, outcome.robot.links, robot.links)))
    estimates = _estimates(robot, model, kept, outcome)
    for joint in sorted(j for _, j in rigid if j is not None):
        (id,) = {effect for effect, j in rigid if j == joint}
        estimates[id, joint] = _changes(robot.links[joint - 1], outcome, joint)
    origins = amended.origins
    for body in bodies:
        estimates[body.effect, None] = _load(outcome)
        values = {name: one.value for name, one in estimates[body.effect, None].items()}
        again = apply_amendments(model, [replace(body, parameters=values)])
        model, origins = again.robot, tuple(None if k is None else origins[k] for k in again.origins)
    return Refit(model, origins, estimates)


@dataclass(frozen=True, slots=True, eq=False)
class Renumbered:
    """An arm with what was named: ``robot``, ``origins`` of its effects, the ``findings`` with their best
    numbers, and whether the arm's own numbers are new."""

    robot: Robot
    origins: tuple[int | None, ...]
    findings: tuple[Finding, ...]
    is_refitted: bool


def renumbered(
    robot: Robot,
    findings: Sequence[Finding],
    gates: Sequence[Gate],
    left: Callable[[Robot], tuple[Floats, Floats]],
    *,
    unstated: float | None,
    everywhere: bool,
) -> Renumbered:
    """``robot`` with its findings, and with numbers of its own that explain more, if there are such.

    ``left``: RMS [n] that an arm leaves of logs that were fitted and of one that was not; ``unstated`` as in
    :func:`refit`; ``everywhere``: friction and rotors are fitted at all joints, named or not.
    """
    amendments = [amendment(f) for f in findings]
    done = apply_amendments(robot, amendments)
    own = refit(robot, amendments, gates, unstated=unstated, everywhere=everywhere)
    best = Renumbered(done.robot, done.origins, tuple(findings), is_refitted=False)
    if not _explains_more(left, done.robot, own.robot):
        return best
    known = tuple(_with_estimates(f, own.estimates.get((f.effect, f.joint), {})) for f in findings)
    return Renumbered(own.robot, own.origins, known, is_refitted=True)


def _explains_more(left: Callable[[Robot], tuple[Floats, Floats]], one: Robot, other: Robot) -> bool:
    """Whether ``other`` leaves less of logs that were fitted and of one that was not."""
    return all(is_better(before, after) for before, after in zip(left(one), left(other), strict=True))


def amendment(f: Finding) -> Amendment:
    """What a finding adds to a model."""
    return Amendment(f.effect, f.joint, {name: p.value for name, p in f.parameters.items()})


def without_vague_claim(finding: Finding) -> Finding:
    """The finding, no claim where its only number is known no better than to half of itself: of a thing of
    which nothing is known but a sign it cannot be said that it is missing."""
    numbers = [one for one in finding.parameters.values() if isinstance(one.value, float) and one.value]
    if len(numbers) != 1 or numbers[0].stderr is None:
        return finding
    (only,) = numbers
    if only.stderr is not None and only.stderr > VAGUE * abs(float(only.value)):
        return replace(finding, confidence=min(finding.confidence, WITHDRAWN))
    return finding


def with_known_errors(finding: Finding) -> Finding:
    """The finding without errors of numbers that are not known to better than half of themselves: of these
    the logs tell bounds, and no more."""
    sizes = {p.name for p in CATALOGUE[finding.effect].parameters if p.sign != "any"}
    return replace(
        finding,
        parameters={name: _bounded(one, is_size=name in sizes) for name, one in finding.parameters.items()},
    )


def _bounded(size: Estimate, *, is_size: bool) -> Estimate:
    """A number; without its error, and with the bounds that are left, where that is too vague."""
    if isinstance(size.value, str) or size.stderr is None or size.stderr <= VAGUE * abs(size.value):
        return size
    low, high = size.interval or (None, None)
    return replace(
        size, stderr=None, bounds=(None if is_size and low is not None and low <= 0 else low, high)
    )


def _with_estimates(finding: Finding, estimates: Mapping[str, Estimate]) -> Finding:
    """The finding with better numbers; no claim where nothing is known of them. Of the numbers of a link
    torques show sums: each may be vague where it is certain that they are wrong."""
    known = [one for one in estimates.values() if isinstance(one.value, float) and one.value]
    vague = [one.stderr is None or one.stderr > VAGUE * abs(float(one.value)) for one in known]
    is_vague = bool(vague) and all(vague) and _fold(finding.effect) != "link"
    confidence = min(finding.confidence, WITHDRAWN) if is_vague else finding.confidence
    return replace(finding, parameters={**finding.parameters, **estimates}, confidence=confidence)


def refitted_places(robot: Robot, model: Robot) -> frozenset[Place]:
    """Where the arm's own numbers are new."""
    pairs = zip(robot.links, model.links, strict=True)
    return frozenset(
        (j, key)
        for j, (old, new) in enumerate(pairs, 1)
        for key in ("mass", "com", "inertia")
        if getattr(old, key) != getattr(new, key)
    )


def is_better(before: Floats, after: Floats) -> bool:
    """Whether what is left of logs, RMS [n] by joint, is clearly less at some joint ``after`` a refit, and
    nowhere more."""
    ratio = after / np.maximum(before, 1e-300)
    return bool(np.min(ratio) < np.sqrt(1 - REFIT_SHARE) and np.max(ratio) < REFIT_WORSE)


def no_worse(before: Floats, after: Floats) -> bool:
    """Whether what is left of logs, RMS [n] by joint, grows at no joint; a stiff spring of which no damping
    is known may ring."""
    return bool(np.all(after <= SPRING_WORSE * before))


def share_allowed(robot: Robot, unstated: float | None) -> float:
    """The share by which a refit may change the numbers of the links: what is stated of them at most,
    ``unstated`` of those of which nothing is."""
    plain = float(SHARE_NOT_STATED) if unstated is None else unstated
    return max(plain if link.confidence is None else float(link.inertial_share) for link in robot.links)


def _fold(id: str) -> str | None:
    fold = CATALOGUE[id].traits.fold
    return None if fold is None else fold.into


def _stated(link: Link, share: float | None) -> Link:
    """A link of which is stated how well it is known."""
    if link.confidence is not None:
        return link
    if share is None:
        return replace(link, confidence=SHARE_NOT_STATED)
    return replace(link, confidence="unknown" if share >= 1 else Fraction(share).limit_denominator(1000))


def _with_confidence(link: Link, described: Link) -> Link:
    return replace(link, confidence=described.confidence)


def _estimates(
    robot: Robot, model: Robot, kept: Sequence[Amendment], outcome: Identified
) -> dict[Key, Mapping[str, Estimate]]:
    """Of what every joint has, the increments to the description."""
    estimates: dict[Key, Mapping[str, Estimate]] = {}
    for one in kept:
        fold = CATALOGUE[one.effect].traits.fold
        if fold is None or fold.into != "joint" or one.joint is None:
            continue
        estimate = outcome.parameters.get(f"joint{one.joint}.{one.effect}.{fold.parameter}")
        if estimate is None:
            continue
        new, old = (getattr(arm.links[one.joint - 1].joint, fold.key) for arm in (model, robot))
        assert isinstance(new, Fraction)
        described = (
            float(old) if isinstance(old, Fraction) and robot.torque_side == model.torque_side else 0.0
        )
        value = float(new) - described
        estimates[one.effect, one.joint] = {fold.parameter: Estimate(value, estimate.stderr, estimate.unit)}
    return estimates


def _changes(link: Link, outcome: Identified, joint: int) -> dict[str, Estimate]:
    """What a link's numbers are more than described."""
    changes: dict[str, Estimate] = {}
    for name in _BODY:
        estimate = outcome.parameters.get(f"link{joint}.{name}")
        if estimate is not None:
            axis = name.removeprefix("inertia_")
            changes[f"delta_{axis}"] = Estimate(
                estimate.value - estimate.described, estimate.stderr, estimate.unit
            )
    return changes


def _load(outcome: Identified) -> dict[str, Estimate]:
    """The body that the arm carries."""
    numbers: dict[str, Number] = {name: outcome.parameters[f"load1.{name}"] for name in _BODY}
    return {name: Estimate(one.value, one.stderr, one.unit) for name, one in numbers.items()}
