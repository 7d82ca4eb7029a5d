"""Candidates by effect and place: the same law at values of what is not linear in it, along all logs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from robodyn.arrays import Floats, Singles
from robodyn.diagnose.select.library import Candidate, candidates, without_regressor
from robodyn.diagnose.select.library.matched import along, light
from robodyn.diagnose.select.library.prepared import prepared
from robodyn.diagnose.select.rows import Rows
from robodyn.diagnose.select.scope import EVERYTHING, Scope
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.friction import COULOMB

#: The unit of a speed, as parameters have it.
SPEED = "rad/s"
#: An effect's id and its joint (from 1), None where it is of the whole robot.
Key = tuple[str, int | None]


@dataclass(frozen=True, slots=True, eq=False)
class Family:
    """Candidates ``ones`` of one effect at one place that differ in values of what is not linear; their
    ``columns`` [G, N, rows, c], filtered. A pair of laws at one joint is a family too: ``second`` is the
    effect of its last column. So is a law of which some numbers are 0: its columns are those ``kept``."""

    ones: tuple[Candidate, ...]
    columns: Singles
    second: str = ""
    kept: tuple[int, ...] = ()

    @property
    def first(self) -> Candidate:
        """One of them."""
        return self.ones[0]

    @property
    def key(self) -> Key:
        """Effect and joint."""
        return self.first.effect, self.first.joint

    @property
    def keys(self) -> tuple[Key, ...]:
        """Both, of a pair."""
        return (self.key, (self.second, self.first.joint)) if self.second else (self.key,)

    @property
    def order(self) -> float:
        """Which of two that explain alike is the simpler."""
        return self.first.order + (0.9 if self.second else 0.0)

    @property
    def rows(self) -> list[int]:
        """Joints (from 0) at which it shows."""
        return list(self.first.rows)

    @property
    def scale(self) -> Floats | None:
        """Standard deviations [c] of a prior."""
        return self.first.scale

    @property
    def signs(self) -> tuple[int, ...]:
        """+1 for coefficients that must not be negative."""
        signs = tuple(self.first.signs[k] for k in self.kept) if self.kept else self.first.signs
        return signs + ((1,) if self.second else ())

    def whole(self, x: Floats) -> Floats:
        """Coefficients of all of the law's columns, of those [c] of the family's."""
        if not self.kept:
            return x
        every = np.zeros(len(self.first.signs))
        every[list(self.kept)] = x
        return every


def families(rows: Rows, scope: Scope = EVERYTHING) -> list[Family]:
    """What the catalogue has in ``scope`` and the logs can show."""
    groups: dict[tuple[Key, tuple[int, ...], int, bool], list[tuple[Candidate, Singles]]] = {}
    for one, columns in _along_all(rows, scope):
        if not np.isfinite(columns).all() or not columns.any():
            continue
        if not is_resolved(one, one.values, rows):
            continue
        shape = (one.effect, one.joint), one.rows, columns.shape[2], one.fixed
        groups.setdefault(shape, []).append((one, columns))
    found = [Family(tuple(one for one, _ in g), np.stack([z for _, z in g])) for g in groups.values()]
    return [*found, *_pairs(found), *_without_some(found)]


def is_resolved(one: Candidate, values: Mapping[str, float], rows: Rows) -> bool:
    """Whether a law changes over speeds that the log's rates and encoders resolve: of a shape within those
    below, a joint that turns round has no more than how it happened to turn."""
    if one.joint is None:
        return True
    speeds = {p.name for p in one.definition.parameters if p.unit == SPEED}
    return all(values[name] > rows.expected[one.joint - 1] for name in speeds & set(values))


def _along_all(rows: Rows, scope: Scope) -> Iterator[tuple[Candidate, Singles]]:
    first, *others = rows.contexts
    ones, parts = [], []
    for one, columns in prepared(first, candidates(first, scope)):
        ones.append(light(one))
        parts.append(columns)
    more = [along(c, ones, scope) for c in others]
    for k, one in enumerate(ones):
        rest = [next(each) for each in more]
        if all(x is not None for x in rest):
            yield one, np.concatenate([parts[k], *(x for x in rest if x is not None)])
    for c in rows.contexts:
        without_regressor(c)
        c.kept.clear()


def _pairs(found: Iterable[Family]) -> Iterator[Family]:
    """Viscous and dry friction at one joint, which are seldom without each other: of either alone the other
    would hide as much as it shows."""
    plain = {
        one.key: one
        for one in found
        if len(one.ones) == 1 and one.columns.shape[3] == 1 and one.first.order == 1
    }
    for (id, joint), one in plain.items():
        fold = CATALOGUE[id].traits.fold
        if fold is None or fold.key != "coulomb":
            continue
        for other in (each for (_, at), each in plain.items() if at == joint):
            into = CATALOGUE[other.first.effect].traits.fold
            if into is not None and into.key == "viscous":
                yield Family(one.ones, np.concatenate([one.columns, other.columns], axis=3), other.key[0])


def _without_some(found: Iterable[Family]) -> Iterator[Family]:
    """Laws of which some numbers are 0, where none may be negative: on that side a free fit finds nothing."""
    for one in found:
        count = one.columns.shape[3]
        known = one.first.definition
        if count < 2 or one.scale is not None or not all(sign > 0 for sign in one.signs):
            continue
        if known.level == "joint" and COULOMB.id in known.traits.contains:
            continue  # what is left of it is that
        for size in range(1, count):
            for kept in combinations(range(count), size):
                yield Family(one.ones, one.columns[:, :, :, list(kept)], kept=kept)
