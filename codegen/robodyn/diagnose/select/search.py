"""The search: one effect after another, all refitted together, and those not needed in the end removed."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.diagnose.result import Bounds
from robodyn.diagnose.select.fit import share_taken, tighter
from robodyn.diagnose.select.forward import Key, Named, is_of_link, special_cases
from robodyn.diagnose.select.library import Candidate
from robodyn.diagnose.select.limits import BY_PRIOR, FEW, PASSES, PASSES_ROUGH, PRICE, STANDING
from robodyn.diagnose.select.refine import costs, refined
from robodyn.diagnose.select.scope import EVERYTHING, Scope
from robodyn.diagnose.select.selection import Selection, select
from robodyn.diagnose.select.trial import evidence_threshold, numbers_of
from robodyn.diagnose.select.uncertainty import uncertainties
from robodyn.diagnose.select.walk import walked
from robodyn.effects.catalogue import CATALOGUE
from robodyn.gate.gate import Gate
from robodyn.kernels.array_dynamics import Model, physical
from robodyn.logs.log import Log
from robodyn.robot.model import AXES, Robot

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Detected:
    """A detected effect: the evidence for it, its parameters with errors, and the mean squares [n] that were
    left before it was named, in units of the noise; ``bounds``: 95 % intervals of parameters that were
    profiled, None where a side is open."""

    named: Named
    parameters: dict[str, float | str]
    errors: dict[str, float]
    before: Floats
    bounds: Mapping[str, Bounds] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, eq=False)
class Outcome:
    """The detected effects by effect and joint, the ``model`` with it, the ``first`` look at the logs and the
    ``last``."""

    findings: dict[Key, Detected]
    model: Robot
    first: Selection
    last: Selection


def search(
    robot: Robot, gates: Sequence[Gate], tell: Callable[[str], object], scope: Scope = EVERYTHING
) -> Outcome:
    """What ``robot`` lacks in ``scope`` to explain logs that have passed their ``gates``; windows of contacts
    are not in them."""
    pieces = [_piece(gate.log, part) for gate in gates for part in gate.segments]
    resting = [gate.resting[part] for gate in gates for part in gate.segments]

    def look(model: Robot, known: Iterable[Key], unstated: float | None) -> Selection:
        return select(
            model, pieces, known=frozenset(known), unstated=unstated, scope=scope, resting=resting,
            progress=lambda name: tell(f"found {name}"),
        )  # fmt: skip

    tell("fitting the catalogue")
    first = last = look(robot, (), None)
    model, findings = robot, dict[Key, Detected]()
    for _ in range(PASSES_ROUGH if first.rough else PASSES):
        if not last.findings:
            break
        more = dict(findings)
        _take(last, more)
        _refit(robot, more, first)
        _walk(robot, more, set(more) - set(findings), first)
        if _levelled(more, first):
            _refit(robot, more, first)
        _pruned(robot, more, first)
        if not _is_better(robot, findings, more, first):
            break  # what was left out comes again, or in another guise
        findings, model = more, amended(robot, _amendments(more))
        tell("fitting what is left")
        last = look(model, findings, first.unstated)
    if findings:
        tell("asking how sure the numbers are")
        _judge(robot, findings, first, last.share)
        model = amended(robot, _amendments(findings))
    return Outcome(findings, model, first, last)


def _judge(robot: Robot, findings: dict[Key, Detected], begun: Selection, share: float) -> None:
    """The findings with errors and intervals of their numbers in the joint fit, the arm's own numbers being
    wrong by a ``share`` of what is said of them."""
    start = tighter(begun.start, min(1.0, share / share_taken(begun.start)))
    better, sure = uncertainties(robot, _amendments(findings), begun.contexts, start)
    for key, amendment, known in zip(list(findings), better, sure, strict=True):
        one = findings[key]
        # What nothing was fitted to has no error.
        errors = {name: error for name, error in one.errors.items() if error and name not in known}
        errors |= {name: each.stderr for name, each in known.items() if each.stderr is not None}
        bounds = {**one.bounds, **{name: (each.low, each.high) for name, each in known.items()}}
        findings[key] = replace(one, parameters=dict(amendment.parameters), errors=errors, bounds=bounds)


def _is_better(
    robot: Robot, findings: Mapping[Key, Detected], more: Mapping[Key, Detected], first: Selection
) -> bool:
    """Whether ``more`` explains more of the logs than ``findings``, by as much as its numbers are worth; the
    first that are named need only be of an arm that can be."""
    if set(more) == set(findings):
        return False
    added = [one for key, one in more.items() if key not in findings]
    before, after = costs(robot, [_amendments(findings), _amendments(more)], first.contexts, first.start)
    if not findings:
        return bool(np.isfinite(after))
    worth = sum(evidence_threshold(first.start, numbers_of(one.named.trial)) for one in added)
    return before - after > PRICE * worth


def _pruned(robot: Robot, findings: dict[Key, Detected], first: Selection) -> None:
    """Remove, one by one, the effects for which the others compensate."""
    while len(findings) > 1:
        without = []
        for key in findings:
            others = {other: one for other, one in findings.items() if other != key}
            if len(findings) <= FEW:
                _refit(robot, others, first)
            without.append(others)
        models = [_amendments(findings), *(_amendments(others) for others in without)]
        # Of effects that diverge together each is spare, first those without which nothing does.
        whole, *less = np.nan_to_num(costs(robot, models, first.contexts, first.start))
        spare = [
            cost - whole - PRICE * evidence_threshold(first.start, numbers_of(one.named.trial))
            for cost, one in zip(less, findings.values(), strict=True)
        ]
        laws = {(part, joint) for effect, joint in findings for part in CATALOGUE[effect].traits.one_law_with}
        for k, (effect, joint) in enumerate(findings):
            if (effect, joint) in laws:
                spare[k] = np.inf
        k = int(np.argmin(spare))
        if spare[k] >= 0:
            return
        findings.clear()
        findings.update(without[k])


def _amendments(findings: Mapping[Key, Detected]) -> list[Amendment]:
    return [Amendment(effect, joint, one.parameters) for (effect, joint), one in findings.items()]


def _refit(robot: Robot, findings: dict[Key, Detected], begun: Selection) -> None:
    """All detected effects, fitted together to the logs as they were at first."""
    better = refined(robot, _amendments(findings), begun.contexts, begun.start)
    for key, one in zip(list(findings), better, strict=True):
        findings[key] = replace(findings[key], parameters=dict(one.parameters))


def _walk(robot: Robot, findings: dict[Key, Detected], new: Collection[Key], begun: Selection) -> None:
    """The ``new`` ones among the effects, if they are springs between motor and link, in tune."""
    springs = [key for key in new if CATALOGUE[key[0]].coupler is not None]
    if springs:
        better = walked(robot, _amendments(findings), begun.contexts, begun.start, springs)
        for key, one in zip(list(findings), better, strict=True):
            findings[key] = replace(findings[key], parameters=dict(one.parameters))
        _refit(robot, findings, begun)


def _levelled(findings: dict[Key, Detected], begun: Selection) -> bool:
    """Whether an effect was no more than its limit, as a power of the speed may be a level: it is Coulomb
    friction then."""
    limits = [(key, CATALOGUE[key[0]].traits.limit) for key in findings]
    flat = [(key, limit) for key, limit in limits if limit and limit.when(findings[key].parameters)]
    for key, limit in flat:
        one, j = findings.pop(key), (key[1] or 1) - 1
        speed = np.abs(begun.context.signals.qd[:, j])
        usual = float(np.median(speed[speed > STANDING * speed.max()]))
        parameters = limit.parameters(one.parameters, usual)
        plain = (limit.id, key[1])
        if plain in findings:
            before = findings[plain]
            sums = {name: float(x) + float(before.parameters[name]) for name, x in parameters.items()}
            findings[plain] = replace(before, parameters={**before.parameters, **sums})
            continue
        candidate = replace(
            one.named.trial.candidate, effect=plain[0], signs=(1,), values={}, beside=(), again=None, order=1
        )
        named = replace(one.named, trial=replace(one.named.trial, candidate=candidate), rivals=())
        errors = {name: one.errors[name] for name in parameters if name in one.errors}
        findings[plain] = Detected(named, parameters, errors, one.before)
    return bool(flat)


def _take(step: Selection, findings: dict[Key, Detected]) -> None:
    """A step's findings join those of the same effect and place; a law takes the place of its special
    cases."""
    for named in step.findings:
        candidate = named.trial.candidate
        model = step.context.model
        values, errors = estimates(candidate, named.x, named.spread, model)
        _, by_prior = estimates(candidate, named.x, named.by_prior, model)
        open_ones = [name for name, error in errors.items() if by_prior[name] > BY_PRIOR * error > 0]
        errors |= dict.fromkeys(open_ones, 0.0)
        bounds = dict.fromkeys(open_ones, (None, None))
        key = (candidate.effect, candidate.joint)
        for plain in [(id, candidate.joint) for id in special_cases(candidate)]:
            if plain in findings:
                _take_levels(candidate, values, findings.pop(plain).parameters)
        if key in findings:
            before = findings[key]
            linear = CATALOGUE[candidate.effect].linear
            joined = dict(before.parameters)
            for name, value in values.items():
                both = isinstance(value, float) and isinstance(joined.get(name), float)
                joined[name] = joined[name] + value if both and name in linear else value  # type: ignore[operator]
            findings[key] = replace(before, parameters=joined)
        else:
            findings[key] = Detected(named, values, errors, step.first.held_out.mean(axis=0), bounds)


def _take_levels(candidate: Candidate, values: dict[str, float | str], plain: Mapping[str, Any]) -> None:
    """A law's levels with that of the plainer law in whose place it stands."""
    (level, *_) = plain.values()
    for name in candidate.definition.traits.levels:
        if isinstance(values.get(name), float) and isinstance(level, float):
            values[name] = float(values[name]) + level


def _piece(log: Log, part: slice) -> Log:
    if part == slice(0, log.samples):
        return log
    cut = [None if x is None else x[part] for x in (log.t, log.q, log.qd, log.qdd, log.tau)]
    return Log(*cut, ql=None if log.ql is None else log.ql[part])  # type: ignore[arg-type, misc]


def estimates(
    candidate: Candidate, x: Floats, spread: Floats, model: Model
) -> tuple[dict[str, float | str], dict[str, float]]:
    """The catalogue's parameters of the coefficients ``x`` [c], and their standard errors by the ``spread``
    [c, c] of those."""
    read = (lambda v: _deltas(candidate, v, model)) if is_of_link(candidate) else candidate.read
    values = read(x)
    errors: dict[str, float] = {}
    for name, value in values.items():
        if isinstance(value, str):
            continue
        square = 0.0
        for way in spread.T:
            other = read(x + way)[name]
            square += (float(other) - value) ** 2
        errors[name] = float(np.sqrt(square))
    return values, errors


def _deltas(candidate: Candidate, x: Floats, model: Model) -> dict[str, float | str]:
    """Changes of a link's numbers, of changes of its standard parameters."""
    assert candidate.joint is not None
    old = model.standard_parameters()[candidate.joint - 1]
    before, after = physical(old), physical(old + x)
    names = ("mass", "com_x", "com_y", "com_z", *AXES)
    return {f"delta_{name}": float(b - a) for name, a, b in zip(names, before, after, strict=True)}
