"""Numbers of effects, fitted together with the arm's own: of springs, couplings and the like.

The arm's numbers are fitted to what effects leave of the torques, and what effects do may depend on the arm's
numbers: neither is right without the other. So torques are linearised by factors of the effects' numbers,
which are columns beside those of the arm, and that is repeated about the new values (Gauss and Newton). Dry
friction is held: under load it shows masses that the rigid arm's torques do not, and the fit before knew
that, and that joints stick at rest. What it does is worked out anew with the arm's new numbers.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from robodyn.diagnose.amend.amend import Amended, Amendment, apply_amendments
from robodyn.diagnose.limits import STRENGTH_ROUNDS, STRENGTH_STEP
from robodyn.diagnose.result import Estimate
from robodyn.diagnose.select.forward import Key
from robodyn.errors import InputError
from robodyn.gate.gate import Gate
from robodyn.identify.fit import Options, fit_arm
from robodyn.identify.outcome import Identified, identified
from robodyn.identify.rows import Strength
from robodyn.robot.model import EffectEntry, Robot


def fit_with(
    robot: Robot, amendments: Sequence[Amendment], gates: Sequence[Gate], options: Options
) -> tuple[Identified, dict[Key, Mapping[str, Estimate]]]:
    """``robot`` with the ``amendments``, its numbers fitted together with theirs, and what theirs are."""
    amended = apply_amendments(robot, amendments)
    strengths = strengths_of(amended, amendments)
    beside, estimates = amended.robot, dict[Key, Mapping[str, Estimate]]()
    feels_loads = any(entry.definition.needs_load for entry in amended.robot.effects)
    rounds = STRENGTH_ROUNDS if strengths or feels_loads else 1
    while True:
        rounds -= 1
        fit = fit_arm(amended.robot, gates, replace(options, strengths=tuple(strengths)), beside)
        outcome = identified(fit)
        at = fit.layout.strength
        factors = np.clip(fit.solution.z[at], 1 / STRENGTH_STEP, STRENGTH_STEP).tolist()
        errors = np.sqrt(np.diag(fit.covariance)[at]).tolist()
        fresh: dict[Key, dict[str, Estimate]] = {}
        for (k, name), factor, error in zip(strengths, factors, errors, strict=True):
            entry = beside.effects[k]
            was = entry.number(name)
            revolute = entry.joint is None or robot.links[entry.joint - 1].joint.kind == "revolute"
            unit = next(p.unit_at(revolute=revolute) for p in entry.definition.parameters if p.name == name)
            own = fresh.setdefault((entry.effect, entry.joint), {})
            own[name] = Estimate(was * factor, abs(was) * error, unit)
        better = [_with(one, fresh.get((one.effect, one.joint), {})) for one in amendments]
        try:
            again = apply_amendments(robot, better)
        except InputError:
            return outcome, estimates  # farther than such an effect goes
        amended, amendments, estimates = again, better, {**fresh}
        outcome = replace(outcome, robot=replace(outcome.robot, effects=again.robot.effects))
        beside = outcome.robot
        if not rounds:
            return outcome, estimates


def strengths_of(amended: Amended, amendments: Sequence[Amendment]) -> list[Strength]:
    """The numbers of new effects that torques are in proportion to, and show at once; not of dry friction."""
    keys = {(a.effect, a.joint): a for a in amendments}
    return [
        (k, name)
        for k, (entry, origin) in enumerate(zip(amended.robot.effects, amended.origins, strict=True))
        if origin is None
        and (one := keys.get((entry.effect, entry.joint))) is not None
        and entry.definition.memory is None
        and entry.definition.traits.channel is None
        and not _is_dry(amended.robot, entry)
        for name, value in one.parameters.items()
        if isinstance(value, float) and value and name in entry.definition.linear
    ]


def _is_dry(robot: Robot, entry: EffectEntry) -> bool:
    revolute = entry.joint is None or robot.links[entry.joint - 1].joint.kind == "revolute"
    return entry.definition.is_dry(dict(entry.settings), revolute)


def _with(one: Amendment, numbers: Mapping[str, Estimate]) -> Amendment:
    values = {name: estimate.value for name, estimate in numbers.items()}
    return replace(one, parameters={**one.parameters, **values})
