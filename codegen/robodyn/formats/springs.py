"""Springs of joints: in files a stiffness and a position, in a description the effect that says as much."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from robodyn.formats.chain import Spring
from robodyn.robot.model import EffectEntry
from robodyn.robot.numbers import shortest


def entries_of(springs: Iterable[Spring | None]) -> tuple[EffectEntry, ...]:
    """The effects of the ``springs`` of joints, base to tip; None: the joint has none."""
    hung = [(joint, spring) for joint, spring in enumerate(springs, 1) if spring is not None]
    if not hung:
        return ()
    from robodyn.effects.catalogue import CATALOGUE  # an arm without springs does without it

    (effect,) = (effect for effect in CATALOGUE.values() if effect.traits.in_files)
    stiffness, rest = effect.traits.in_files
    entries = []
    for joint, spring in hung:
        stated = {stiffness: shortest(spring.stiffness), rest: shortest(spring.rest)}
        settings = [(each.name, stated.get(each.name, each.default)) for each in effect.parameters]
        entries.append(
            EffectEntry(effect.id, joint, tuple((name, x) for name, x in settings if x is not None))
        )
    return tuple(entries)


def spring_of(entry: EffectEntry) -> Spring | None:
    """The spring of a file that ``entry`` is; None where files have no words for it."""
    stated = entry.definition.traits.in_files
    more = [value for name, value in entry.settings if name not in stated]
    if not stated or entry.joint is None or any(more):
        return None
    stiffness, rest = (entry[name] if name in entry else Fraction(0) for name in stated)
    return Spring(float(stiffness), float(rest))
