"""What a diagnosis looks for: which effects, at which joints, and how many it may name."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from typing import Final

from robodyn.diagnose.select.limits import MOST_KINDS
from robodyn.effects.catalogue import CATALOGUE, effect
from robodyn.errors import InputError


@dataclass(frozen=True, slots=True)
class Scope:
    """``only``: ids of the effects that are looked for (None: all but ``without``); ``joints`` (from 1) at
    which they may be (None: at all, and at the whole robot); ``most``: kinds of effects that are named at
    most."""

    only: frozenset[str] | None = None
    without: frozenset[str] = frozenset()
    joints: frozenset[int] | None = None
    most: int = MOST_KINDS

    def has_effect(self, id: str) -> bool:
        """Whether the effect is looked for."""
        return id not in self.without and (self.only is None or id in self.only)

    @property
    def has_contact(self) -> bool:
        """Whether contacts are looked for."""
        return any(self.has_effect(each.id) for each in CATALOGUE.values() if each.place == "outside")

    def has_joint(self, joint: int | None) -> bool:
        """Whether effects at ``joint`` (from 1; None: of the whole robot) are looked for."""
        return self.joints is None or joint in self.joints

    def at_rest(self) -> Scope:
        """Of an arm that stands: nothing but contacts. Its torques are one number a joint, which a load, a
        wrong mass, a tilt and an offset explain alike, and stiction leaves nothing of friction."""
        inside = {each.id for each in CATALOGUE.values() if each.place != "outside"}
        return replace(self, without=self.without | inside)

    def allows(self, id: str, joint: int | None) -> bool:
        """Whether the effect is looked for there."""
        return self.has_effect(id) and self.has_joint(joint)

    def of(self, ids: Collection[str], joints: Collection[int]) -> Scope:
        """Of what is looked for these effects at these joints."""
        return replace(
            self, only=frozenset(id for id in ids if self.has_effect(id)), joints=frozenset(joints)
        )

    def words(self) -> tuple[str, ...]:
        """What a reader of the result must know of it: nothing, if all effects are looked for."""
        parts = [] if self.only is None else [f"only {', '.join(sorted(self.only))}"]
        parts += [f"not {', '.join(sorted(self.without))}"] if self.without else []
        parts += [f"at joints {', '.join(map(str, sorted(self.joints)))} only"] if self.joints else []
        return (f"looked for on request: {'; '.join(parts)}",) if parts else ()


#: All effects everywhere.
EVERYTHING: Final = Scope()


def scope_of(
    joints_of_robot: int,
    only: Sequence[str] = (),
    without: Sequence[str] = (),
    joints: Sequence[int] = (),
    most: int | None = None,
) -> Scope:
    """The scope that these words and numbers state, empty ones for all.

    Raises
    ------
    InputError: there is no such effect or joint, nothing is left to look for, or ``most`` is not positive.
    """
    for id in (*only, *without):
        effect(id)
    for joint in joints:
        if not 1 <= joint <= joints_of_robot:
            raise InputError("there is no such joint", found=str(joint), expected=f"1 to {joints_of_robot}")
    if only and not set(only) - set(without):
        raise InputError(
            "no effect is left to look for",
            found=f"only {', '.join(only)} without {', '.join(without)}",
            remedy="name an effect in one of the two lists",
        )
    if most is not None and most < 1:
        raise InputError(
            "the number of effects to name is not positive", found=str(most), expected="1 or more"
        )
    return Scope(
        frozenset(only) if only else None,
        frozenset(without),
        frozenset(joints) if joints else None,
        MOST_KINDS if most is None else most,
    )
