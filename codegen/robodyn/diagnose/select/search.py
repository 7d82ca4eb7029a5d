"""Effects come in, go out and are exchanged, by what they foretell of parts of the log that are held out."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.select.baseline import with_baseline
from robodyn.diagnose.select.compare import is_of_link, rubs_at
from robodyn.diagnose.select.families import families
from robodyn.diagnose.select.limits import MOST_MEMBERS
from robodyn.diagnose.select.members import Fit, Model, fitted
from robodyn.diagnose.select.noise import dry_friction, with_noise_of
from robodyn.diagnose.select.nuisance import last_fit, own_numbers, throughout, timed, widened
from robodyn.diagnose.select.outcome import Found, Outcome
from robodyn.diagnose.select.resolution import foretold, likelier_speeds
from robodyn.diagnose.select.rows import rows_of
from robodyn.diagnose.select.scope import EVERYTHING, Scope
from robodyn.diagnose.select.score import Trial, foretold_by, log_likelihood
from robodyn.diagnose.select.steps import Steps
from robodyn.gate.gate import Gate
from robodyn.robot.model import Robot


class Search(Steps):
    """The steps in their order, until nothing passes."""

    def run(self, fit: Fit) -> tuple[Fit, list[Trial]]:
        """Until nothing passes."""
        tried: list[Trial] = []
        while len(fit.model.members) < MOST_MEMBERS:
            tried = self.tried(fit)
            best = self.choice(tried)
            if not fit.model.members and (base := with_baseline(self, fit, best)) is not None:
                fit = base
                continue
            if (rubs := self.where_it_rubs(fit, tried, best)) is not None:
                fit = rubs
                continue
            speeds = likelier_speeds(fit, self.rows.expected, self.threshold, best)
            if speeds is None and best is not None:
                speeds = self.speeds_of_plain(fit, tried, best)
            turned = None if speeds is None else self.with_resolution(fit, speeds)
            if turned is not None:
                fit = turned
                continue
            if best is None:
                more = self.of_one_cause(fit) or widened(fit, self.threshold) or timed(fit, self.threshold)
                again = self.reviewed(more or fit, range(self.rows.n))
                if again is fit:
                    break
                fit = again
                continue
            more = widened(fit, self.threshold, best) if is_of_link(best.family.first) else None
            if more is not None:
                fit = more
                continue
            more = self.with_family(fit, best)
            if more is None or more.cost > fit.cost - self.threshold / 2:
                self.banned |= set(best.family.keys)
                continue
            self.tell(f"found {best.family.first.name}")
            fit = self.reviewed(more, best.family.rows)
        return fit, tried

    def where_it_rubs(self, fit: Fit, tried: Sequence[Trial], best: Trial | None) -> Fit | None:
        """The fit with rows at rest that say a set at one more joint, which shows dry friction in motion: if
        the ``best`` of those ``tried`` is a law of dissipation there, or one foretells more so."""
        before = float(log_likelihood(fit).sum()) if best is None else foretold_by(fit, best)
        for j in np.flatnonzero(self.dry):
            if best is not None and j != best.at.argmax():
                continue
            other = self.with_rest_set(fit, int(j))
            if other is None:
                continue
            is_law = best is not None and rubs_at(best, int(j))
            if not is_law:
                law = self.choice(self.trials(other, [one.family for one in tried if j in one.family.rows]))
                is_law = law is not None and rubs_at(law, int(j)) and foretold_by(other, law) > before
            if is_law:
                return self.adopt_rest_set(other, int(j))
        return None

    def speeds_of_plain(self, fit: Fit, tried: Sequence[Trial], best: Trial) -> Floats | None:
        """Speeds [n] below which directions are not resolved, if plain dry friction with these foretells no
        less than the ``best`` one, a law of dissipation at that joint, with its likeliest."""
        joint = best.family.first.joint
        if joint in self.plain or not best.family.first.definition.dissipative:
            return None
        for one in tried:
            fold = one.family.first.definition.traits.fold
            if one.family.first.joint == joint and fold and fold.key == "coulomb" and one.is_possible:
                self.plain.add(joint)
                fits = self.with_family(fit, one, 0), self.with_family(fit, best, 0)
                if fits[0] is None or fits[1] is None:
                    return None
                (speeds, plain), (_, other) = (
                    foretold(x, self.rows.expected, self.threshold) for x in fits if x
                )
                is_level = plain > other - self.threshold
                return speeds if is_level and not np.array_equal(speeds, self.rows.speeds) else None
        return None


def search(
    robot: Robot, gates: Sequence[Gate], tell: Callable[[str], object], scope: Scope = EVERYTHING
) -> Outcome:
    """What ``robot`` lacks in ``scope`` to explain logs that have passed their ``gates``."""
    tell("fitting the catalogue")
    rows = rows_of(robot, gates)
    found = families(rows, scope)
    dry = dry_friction(rows, found)
    rows = with_noise_of(rows, found, dry)
    begun = fitted(Model(rows, own_numbers(rows, 0.0)))
    assert begun is not None
    one = Search(gates, rows, found, dry, tell, scope)
    fit, last = one.run(begun)
    final = last_fit(fit)
    return Outcome(tuple(_found(one, fit, final)), final, begun, tuple(last))


def _found(search: Search, fit: Fit, final: Fit) -> Iterable[Found]:
    for member, numbers in zip(fit.model.members, final.model.members, strict=True):
        rest = search.without(fit, [one for one in fit.model.members if one is not member])
        if rest is None:
            continue
        tried = sorted(search.trials(rest, search.open_to(rest)), key=lambda one: -one.gain)
        own = [one for one in tried if one.family.key == member.key]
        own = own or [one for one in tried if member.key in one.family.keys]
        if own:
            yield Found(numbers, own[0], tuple(tried), throughout(rest, own[0]))
