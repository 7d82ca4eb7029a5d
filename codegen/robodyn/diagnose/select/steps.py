"""What may be done to a model on the way: a candidate comes in, a member goes, rows change."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.select.compare import (
    foretells,
    is_level,
    is_other_law,
    is_sum_of_others,
    overlap,
    read_link,
    special_cases,
)
from robodyn.diagnose.select.families import Family, Key, families
from robodyn.diagnose.select.limits import (
    ALPHA,
    FIT_ROUNDS,
    OVERLAP,
    PRACTICAL,
    RIVAL_LEAST,
)
from robodyn.diagnose.select.members import Fit, Member, fitted, solve
from robodyn.diagnose.select.nuisance import with_own_numbers
from robodyn.diagnose.select.rows import Rows, rows_of, with_noise
from robodyn.diagnose.select.scope import Scope
from robodyn.diagnose.select.score import Trial, trials
from robodyn.diagnose.select.tuning import judge_shape, tuned, with_tried
from robodyn.effects.catalogue import CATALOGUE
from robodyn.gate.gate import Gate


class Steps:
    """What a search in ``rows`` among ``families`` is made of."""

    def __init__(
        self, gates: Sequence[Gate], rows: Rows, found: Sequence[Family], dry: Floats,
        tell: Callable[[str], object], scope: Scope,
    ) -> None:  # fmt: skip
        self.gates, self.rows, self.families, self.tell, self.scope = gates, rows, list(found), tell, scope
        self.threshold = float(np.log(max(len(found), 1) / ALPHA))
        self.banned: set[Key] = set()
        self.dry = dry.copy()
        self.tuned: set[tuple[Key, tuple[int, ...]]] = set()
        self.plain: set[int | None] = {None}
        self.turns: set[tuple[object, ...]] = set()
        self.pairs: set[frozenset[Key]] = set()

    def passes(self, one: Trial) -> bool:
        """Whether it is worth a name, and its gain more than its standard error over the blocks: not of one
        alone, unless it is a thing that happens once, nor lost in others."""
        return self.is_worth(one) and (one.family.first.local or one.gain > one.error)

    def is_worth(self, one: Trial) -> bool:
        """Whether it foretells more than chance would have it of one of so many, and enough to matter; what
        is rare in arms must take away more."""
        rare = 1 - np.sqrt(1 - one.family.first.least_share)  # of the RMS, as the drop is
        return one.is_possible and one.gain > self.threshold and bool(one.drop > max(PRACTICAL, rare))

    def choice(self, tried: Iterable[Trial]) -> Trial | None:
        """The simplest of those that pass and foretell as much as the best."""
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
            and is_level(one, best, self.threshold, self.rows.robot)
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

    def tried(self, fit: Fit) -> list[Trial]:
        """The trials of what may come in; of what is not linear the values are those that explain most, where
        it may be in the place of the best."""
        tried = self.trials(fit, self.open_to(fit))
        good = [one for one in tried if self.is_worth(one)]
        if not good:
            return tried
        best = max(good, key=lambda one: one.gain)
        close = [
            one
            for one in tried
            if one.gain > RIVAL_LEAST * best.gain
            and overlap(one, best) > OVERLAP
            and not one.family.first.reach  # links on springs take long, once they are in
            and (one.family.key, one.family.kept) not in self.tuned
        ]
        others = {}
        for one in close:
            self.tuned.add((one.family.key, one.family.kept))
            (member, *_) = self._members(one)
            others[id(one.family)] = tuned(fit.model, member).family
        self._swap(others)
        again = self.trials(fit, list(others.values()))
        better = {id(one): other for one, other in zip(close, again, strict=True)}
        return [better.get(id(one), one) for one in tried]

    def trials(self, fit: Fit, found: Sequence[Family]) -> list[Trial]:
        """What each family foretells. A law that has friction come up by and by is impossible if it foretells
        no more than one that knows nothing but the side on which friction holds a joint at rest."""
        tried = trials(fit, found)
        most = max((one.gain for one in tried if self.is_worth(one)), default=0.0)
        return [
            judge_shape(fit, one, self.threshold) if one.gain >= RIVAL_LEAST * most > 0 else one
            for one in tried
        ]

    def with_rest_set(self, fit: Fit, j: int) -> Fit | None:
        """The fit with rows at rest that say a set at joint ``j`` (from 0) too."""
        more = np.where(np.arange(self.rows.n) == j, self.dry, 0.0)
        return fitted(replace(fit.model, rows=replace(self.rows, level=self.rows.level + more)))

    def adopt_rest_set(self, fit: Fit, j: int) -> Fit:
        """The fit, whose rows at rest say a set at joint ``j`` (from 0), from now on."""
        self.dry[j], self.rows = 0.0, fit.model.rows
        self.banned.clear()
        return fit

    def with_resolution(self, fit: Fit, speeds: Floats) -> Fit | None:
        """The model in rows with other speeds below which directions are not resolved, and candidates of dry
        friction along these; None where it had these already, or members and speeds might take turns."""
        turn = *speeds.tolist(), *sorted(map(str, (one.key for one in fit.model.members)))
        if turn in self.turns:
            return None
        self.turns.add(turn)
        rows = rows_of(self.rows.robot, self.gates, speeds)
        self.rows = with_noise(rows, self.rows.sigma, self.rows.correlation, self.rows.level)
        self.banned.clear()
        laws = {each.id for each in CATALOGUE.values() if each.dissipative and each.level == "joint"}
        joints = np.flatnonzero(speeds != fit.model.rows.speeds) + 1
        scope = self.scope.of(laws, [int(j) for j in joints])
        fresh = {(one.key, one.second, one.kept): one for one in families(self.rows, scope)}
        pairs = [(one, fresh.get((one.key, one.second, one.kept))) for one in self.families]
        self._swap({id(one): with_tried(other, one, self.rows) for one, other in pairs if other is not None})
        return fitted(replace(fit.model, rows=self.rows, _known={}))

    def with_family(self, fit: Fit, one: Trial, rounds: int = FIT_ROUNDS) -> Fit | None:
        """The model with a family's best one, in the place of its special cases, after so many ``rounds``."""
        members = [each for each in fit.model.members if not self._replaces(one.family, each.key)]
        new = self._members(one)
        if len(members) < len(fit.model.members):  # its numbers beside those that stay
            rest = self.without(fit, members)
            if rest is None:
                return None
            (again,) = self.trials(rest, [one.family])
            new = self._members(again)
        beside, better_ones = fit.model.with_members(members), list[Member]()
        for each in new:
            other = tuned(beside, each)
            self._swap({id(each.family): other.family})
            better_ones.append(other)
        model = fit.model.with_members([*members, *better_ones])
        if model.tilts != fit.model.tilts:
            model = with_own_numbers(model, model.share, is_timed=model.is_timed)
        return fitted(model, rounds)

    def _swap(self, others: Mapping[int, Family]) -> None:
        """Families in the place of some, by these."""
        self.families = [others.get(id(one), one) for one in self.families]

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

    def without(self, fit: Fit, members: Sequence[Member]) -> Fit | None:
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
        while k >= 0:
            member = fit.model.members[k]
            if not changed & set(member.family.rows):
                k -= 1
                continue
            others = [one for one in fit.model.members if one is not member]
            rest = self.without(fit, others)
            k -= 1
            if rest is None:
                continue
            places = set(member.family.rows)
            tried = self.trials(rest, [one for one in self.open_to(rest) if places & set(one.rows)])
            own = [one for one in tried if one.family.key == member.key or member.key in one.family.keys]
            best = self.choice(tried)
            if best is None or not any(map(self.passes, own)):
                again = fitted(fit.model.with_members(others))
                if again is not None:
                    self.banned.add(member.key)
                    fit = again
            elif not any(best is one for one in own):
                mine = max(own, key=lambda one: one.gain)
                is_simpler = best.family.order < mine.family.order
                if overlap(best, mine) > OVERLAP:
                    other = self.with_family(rest, best)
                    least = -self.threshold if is_simpler else self.threshold
                    if other is not None and foretells(other, fit) > least:
                        self.tell(f"found {best.family.first.name}")
                        self.banned.add(member.key)  # or the two would take turns
                        fit = other
            k = min(k, len(fit.model.members) - 1)
        return fit

    def of_one_cause(self, fit: Fit) -> Fit | None:
        """The model with one effect in the place of two at a joint, if one foretells as much, or less by no
        more than a second one has to gain; not a law that has both as special cases."""
        for one, other in combinations(fit.model.members, 2):
            joint, kinds = one.key[1], {one.key[0], other.key[0]}
            pair = frozenset((one.key, other.key))
            if joint is None or other.key[1] != joint or pair in self.pairs:
                continue
            self.pairs.add(pair)
            rest = self.without(fit, [each for each in fit.model.members if each.key not in pair])
            if rest is None:
                continue
            place = [each for each in self.families if each.first.joint == joint]
            best = self.choice(self.trials(rest, [x for x in place if not kinds <= special_cases(x.key[0])]))
            whole = None if best is None or best.family.key in pair else self.with_family(rest, best)
            if best is not None and whole is not None and foretells(whole, fit) > -self.threshold:
                self.tell(f"found {best.family.first.name}")
                self.banned |= pair
                return whole
        return None
