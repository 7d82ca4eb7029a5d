"""Effects come in, go out and are exchanged, by what they foretell of parts of the log that are held out."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.compare import (
    better,
    is_of_link,
    is_other_law,
    is_preferred,
    is_sum_of_others,
    margin,
    overlap,
    read_link,
    special_cases,
)
from robodyn.diagnose.select.families import Family, Key, families, is_resolved
from robodyn.diagnose.select.library import without_regressor
from robodyn.diagnose.select.library.prepared import prepared
from robodyn.diagnose.select.limits import (
    ALPHA,
    FINEST,
    FIT_WORTH,
    HARM,
    MOST_MEMBERS,
    OVERLAP,
    PRACTICAL,
    SHARES,
)
from robodyn.diagnose.select.members import Fit, Member, Model, fitted, own_numbers, solve
from robodyn.diagnose.select.noise import with_noise_of
from robodyn.diagnose.select.resolution import likelier_speeds
from robodyn.diagnose.select.rows import Rows, rows_of, with_noise
from robodyn.diagnose.select.scope import EVERYTHING, Scope
from robodyn.diagnose.select.score import Trial, held_out, trials
from robodyn.effects.catalogue import CATALOGUE
from robodyn.gate.gate import Gate
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """A member of the model that was found, its own trial beside the others, and the trials of all families
    there, best first."""

    member: Member
    trial: Trial
    beside: tuple[Trial, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Outcome:
    """What a search has found: the ``fit`` with it and that of the model as described, ``begun``."""

    found: tuple[Found, ...]
    fit: Fit
    begun: Fit
    last: tuple[Trial, ...]


class Search:
    """The search in ``rows`` among families ``found``."""

    def __init__(
        self, gates: Sequence[Gate], rows: Rows, found: Sequence[Family], tell: Callable[[str], object],
        scope: Scope,
    ) -> None:  # fmt: skip
        self.gates, self.rows, self.families, self.tell, self.scope = gates, rows, list(found), tell, scope
        self.threshold = float(np.log(max(len(found), 1) / ALPHA))
        self.lowest = rows.speeds.copy()
        self.banned: set[Key] = set()

    def passes(self, one: Trial) -> bool:
        """Whether it is worth a name, and there in most of the log that shows it at all."""
        gains = one.gains
        return self.is_worth(one) and -gains[gains < 0].sum() < HARM * gains[gains > 0].sum()

    def is_worth(self, one: Trial) -> bool:
        """Whether it foretells more than chance would have it of one of so many, and enough to matter; what
        is rare in arms must take away more."""
        rare = 1 - np.sqrt(1 - one.family.first.least_share)  # of the RMS, as the drop is
        return one.is_possible and one.gain > self.threshold and bool(one.drop > max(PRACTICAL, rare))

    def choice(self, tried: Iterable[Trial]) -> Trial | None:
        """The simplest of those that pass and foretell as much as the best, within a standard error or what
        is worth a name (Breiman et al. 1984)."""
        tried = list(tried)
        good = [one for one in tried if self.passes(one) and not is_sum_of_others(one, tried)]
        if not good:
            return None
        best = max(good, key=lambda one: one.gain)
        near = [
            one
            for one in tried
            if self.is_worth(one)
            and not is_sum_of_others(one, tried)
            and overlap(one, best) > OVERLAP
            and (margin(best, one)[0] <= max(margin(best, one)[1], 1.0) or better(best, one) < PRACTICAL)
        ]
        return min(near, key=lambda one: (one.family.order, -one.gain))

    def open_to(self, fit: Fit) -> list[Family]:
        """Families that may come in beside the members."""
        taken = {one.key for one in fit.model.members}
        kinds = {id for id, _ in taken}
        return [
            one
            for one in self.families
            if not taken & set(one.keys)
            and not self.banned & set(one.keys)
            and not any(is_other_law(one, each) for each in taken)
            and (len(kinds) < self.scope.most or one.key[0] in kinds)
        ]

    def run(self, fit: Fit) -> tuple[Fit, list[Trial]]:
        """Until nothing passes."""
        tried: list[Trial] = []
        while len(fit.model.members) < MOST_MEMBERS:
            tried = trials(fit, self.open_to(fit))
            best = self.choice(tried)
            speeds = likelier_speeds(fit, self.lowest, self.threshold, best)
            turned = None if speeds is None else self._with_speeds(fit, speeds)
            if turned is not None:
                fit = turned
                continue
            if best is None:
                wider = self.widened(fit, None)
                if wider is None:
                    break
                fit = self.reviewed(wider, range(self.rows.n))
                continue
            wider = self.widened(fit, best) if is_of_link(best.family.first) else None
            if wider is not None:
                fit = wider
                continue
            more = self.with_family(fit, best)
            if more is None or more.cost > fit.cost - self.threshold / 2:
                self.banned |= set(best.family.keys)
                continue
            self.tell(f"found {best.family.first.name}")
            fit = self.reviewed(more, best.family.rows)
        return fit, tried

    def widened(self, fit: Fit, best: Trial | None) -> Fit | None:
        """The model with wider bounds of all of the arm's own numbers, where that foretells enough more, and
        clearly more than the ``best`` candidate: wrong numbers of one link."""
        before, choices = held_out(fit), []
        for share in SHARES:
            if fit.model.share is not None and share <= fit.model.share:
                continue
            other = fitted(replace(fit.model, own=own_numbers(self.rows, share), share=share), 0)
            if other is None:
                continue
            after = held_out(other)
            gains = (before - after).sum(axis=1) / 2
            drop = 1 - np.sqrt((after.sum(axis=0) / np.maximum(before.sum(axis=0), 1e-300)).min())
            beyond = gains if best is None else gains - best.gains
            error = 0.0 if best is None else float(np.sqrt(len(gains)) * beyond.std(ddof=1))
            if gains.sum() > self.threshold and drop > PRACTICAL and beyond.sum() > error:
                choices.append((float(gains.sum()), other))
        if not choices:
            return None
        most = max(gain for gain, _ in choices)
        near = [other for gain, other in choices if gain > most - self.threshold]
        return fitted(near[0].model)

    def _with_speeds(self, fit: Fit, speeds: Floats) -> Fit | None:
        """The model in rows with other speeds below which directions are not resolved, and candidates of dry
        friction along these."""
        rows = rows_of(self.rows.robot, self.gates, speeds)
        self.rows = with_noise(rows, self.rows.sigma, self.rows.correlation, self.rows.level)
        laws = {each.id for each in CATALOGUE.values() if each.dissipative and each.level == "joint"}
        joints = np.flatnonzero(speeds != fit.model.rows.speeds) + 1
        scope = self.scope.of(laws, [int(j) for j in joints])
        fresh = {(one.key, one.second, one.kept): one for one in families(self.rows, scope)}
        self.families = [fresh.get((one.key, one.second, one.kept), one) for one in self.families]
        return fitted(replace(fit.model, rows=self.rows, _known={}))

    def with_family(self, fit: Fit, one: Trial) -> Fit | None:
        """The model with a family's best one, in the place of its special cases."""
        members = [each for each in fit.model.members if not self._replaces(one.family, each.key)]
        new = self._members(one)
        if len(members) < len(fit.model.members):  # its numbers beside those that stay
            rest = self._without(fit, members)
            if rest is None:
                return None
            (again,) = trials(rest, [one.family])
            new = self._members(again)
        tuned = [self._tuned(fit.model.with_members(members), each) for each in new]
        return fitted(fit.model.with_members([*members, *tuned]))

    def _replaces(self, family: Family, key: Key) -> bool:
        if family.first.joint is None or key[1] != family.first.joint:
            return False
        return any(key[0] in special_cases(id) for id, _ in family.keys)

    def _members(self, one: Trial) -> list[Member]:
        family, candidate = one.family, one.family.ones[one.k]
        if family.scale is not None:
            columns = np.zeros((len(self.rows.unresolved), self.rows.n, len(family.scale)))
            columns[:, family.rows] = family.columns[one.k] * family.scale
            return [Member(family.key, family, one.k, read_link(candidate, one.x, self.rows), columns)]
        if family.second:
            (name,) = CATALOGUE[family.second].linear
            pair = [Member(family.key, family, one.k, dict(candidate.read(one.x[:1])))]
            return [*pair, Member(family.keys[1], family, one.k, {name: float(one.x[1])})]
        return [Member(family.key, family, one.k, dict(candidate.read(family.whole(one.x))))]

    def _tuned(self, model: Model, new: Member) -> Member:
        """A new member with values of what is not linear between those that were tried."""
        candidate = new.family.ones[new.k]
        if candidate.again is None or not candidate.values or new.is_linear or new.family.second:
            return new
        kept = list(new.family.kept) or slice(None)
        left = model.left()
        if left is None:
            return new
        columns, held = model.design(model.slopes(left))

        def cost(values: dict[str, float]) -> tuple[float, Floats]:
            assert candidate.again is not None
            if not is_resolved(candidate, values, self.rows):
                return np.inf, np.zeros(0)
            parts = []
            for c in self.rows.contexts:
                (one,) = prepared(c, [candidate.again(c, values)])
                parts.append(one[1])
                without_regressor(c)
            z = np.zeros((*left.shape, new.family.columns.shape[3]))
            z[:, new.family.rows] = np.concatenate(parts)[:, :, kept]
            if candidate.fixed:
                return solve(columns, held, left - z[:, :, 0], self.rows.weight)[1], np.ones(1)
            x, misfit = solve(
                np.concatenate([columns, z], axis=2), np.concatenate([held, np.zeros(z.shape[2])]), left,
                self.rows.weight,
            )  # fmt: skip
            return misfit, x[columns.shape[2] :]

        values = {name: float(x) for name, x in candidate.values.items()}
        best, x = cost(values)
        step = {name: candidate.reach[name] for name in candidate.reach if name in values}
        step = step or {name: float(np.log(candidate.spread[0])) for name in values}
        finest = min(float(np.log(candidate.spread[1])), FINEST * max(step.values()))
        ways = [way for way in product((-1, 0, 1), repeat=len(step)) if any(way)]
        while max(step.values()) > finest:
            moved = False
            for way in ways:  # all of them at once: a valley seldom lies along one number
                factors = zip(step.items(), way, strict=True)
                other = {
                    **values,
                    **{name: values[name] * float(np.exp(k * size)) for (name, size), k in factors},
                }
                misfit, y = cost(other)
                if misfit < best - FIT_WORTH:
                    best, x, values, moved = misfit, y, other, True
            if not moved:
                step = {name: size / 2 for name, size in step.items()}
        again = candidate.again(self.rows.contexts[0], values)
        return replace(new, parameters=dict(again.read(new.family.whole(x))))

    def _without(self, fit: Fit, members: Sequence[Member]) -> Fit | None:
        """The model with fewer members, their slopes as they are."""
        model = fit.model.with_members(members)
        left = model.left()
        if left is None:
            return None
        kept = {id(one) for one in members}
        which = [id(fit.model.exact[k]) in kept for k, _ in fit.model.places]
        count = len(fit.model.places)
        slopes = fit.columns[:, :, fit.columns.shape[2] - count :][:, :, np.array(which, dtype=bool)]
        columns, held = model.design(slopes)
        x, cost = solve(columns, held, left, self.rows.weight)
        return Fit(model, left, columns, held, x, cost)

    def reviewed(self, fit: Fit, rows: Iterable[int]) -> Fit:
        """The model without members for which the others make up, and with better ones in the place of
        some; of those that show at joints ``rows`` (from 0), where something has changed."""
        changed = set(rows)
        k = len(fit.model.members) - 1
        while k >= 0 and len(fit.model.members) > 1:
            member = fit.model.members[k]
            if not changed & set(member.family.rows):
                k -= 1
                continue
            others = [one for one in fit.model.members if one is not member]
            rest = self._without(fit, others)
            k -= 1
            if rest is None:
                continue
            places = set(member.family.rows)
            tried = trials(rest, [one for one in self.open_to(rest) if places & set(one.rows)])
            own = [one for one in tried if one.family.key == member.key or member.key in one.family.keys]
            best = self.choice(tried)
            if best is None or not any(map(self.is_worth, own)):
                again = fitted(fit.model.with_members(others))
                if again is not None:
                    self.banned.add(member.key)
                    fit = again
            elif not any(best is one for one in own):
                mine = max(own, key=lambda one: one.gain)
                is_simpler = best.family.order < mine.family.order
                if overlap(best, mine) > OVERLAP and (is_simpler or better(best, mine) > PRACTICAL):
                    other = self.with_family(rest, best)
                    if other is not None and is_preferred(other, fit, is_simpler=is_simpler):
                        self.tell(f"found {best.family.first.name}")
                        self.banned.add(member.key)  # or the two would take turns
                        fit = other
            k = min(k, len(fit.model.members) - 1)
        return fit


def search(
    robot: Robot, gates: Sequence[Gate], tell: Callable[[str], object], scope: Scope = EVERYTHING
) -> Outcome:
    """What ``robot`` lacks in ``scope`` to explain logs that have passed their ``gates``."""
    tell("fitting the catalogue")
    rows = rows_of(robot, gates)
    found = families(rows, scope)
    rows = with_noise_of(rows, found)
    begun = fitted(Model(rows, own_numbers(rows, 0.0)))
    assert begun is not None
    one = Search(gates, rows, found, tell, scope)
    fit, last = one.run(begun)
    return Outcome(tuple(_found(one, fit)), fit, begun, tuple(last))


def _found(search: Search, fit: Fit) -> Iterable[Found]:
    for member in fit.model.members:
        rest = search._without(fit, [one for one in fit.model.members if one is not member])
        if rest is None:
            continue
        tried = sorted(trials(rest, search.open_to(rest)), key=lambda one: -one.gain)
        own = [one for one in tried if one.family.key == member.key]
        own = own or [one for one in tried if member.key in one.family.keys]
        if own:
            yield Found(member, own[0], tuple(tried))
