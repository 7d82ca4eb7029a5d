"""What is to be added to a model, and the model with it.

Where a number of the rigid arm can take it, it goes there; else into the effects. What is there already is
summed where the effect is linear in it, and replaced elsewhere. A joint keeps one law of friction.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from robodyn.diagnose.amend.amending import Work
from robodyn.robot.model import Robot
from robodyn.robot.rewriting import Place, rewritten


@dataclass(frozen=True, slots=True)
class Amendment:
    """An effect that is to be added at a ``joint`` (from 1; None: the whole robot), with SI parameters by the
    names of ``diagnosis.json``: increments, rounded to six digits when they are added."""

    effect: str
    joint: int | None
    parameters: Mapping[str, float | str]


@dataclass(frozen=True, slots=True)
class Amended:
    """A model with its amendments. ``origins``: of each of its effects the index among those of the model
    before, None where it is new; ``places`` and ``remarks``: of each amendment what it changed, and where the
    model is not what it says."""

    robot: Robot
    origins: tuple[int | None, ...]
    places: tuple[frozenset[Place], ...]
    remarks: tuple[tuple[str, ...], ...]


def amended(robot: Robot, amendments: Iterable[Amendment]) -> Robot:
    """``robot`` with all ``amendments``, one after the other.

    Raises
    ------
    InputError: an amendment names no effect, joint or parameter of the catalogue, or leads to values which
    that does not allow. (A sum that must not be negative is 0 instead.)
    """
    return apply_amendments(robot, amendments).robot


def apply_amendments(robot: Robot, amendments: Iterable[Amendment]) -> Amended:
    """As :func:`amended`, with what became of each."""
    work = Work(robot)
    places, remarks = [], []
    for amendment in amendments:
        work.places, work.remarks = set(), []
        work.add(amendment.effect, amendment.joint, amendment.parameters)
        places.append(frozenset(work.places))
        remarks.append(tuple(work.remarks))
    places = [changed | {work.became[one] for one in changed if one in work.became} for changed in places]
    order = sorted(work.entries, key=lambda one: (one[1].joint is None, one[1].joint or 0))
    done = replace(work.robot, effects=tuple(entry for _, entry in order))
    return Amended(done, tuple(origin for origin, _ in order), tuple(places), tuple(remarks))


def amended_text(
    text: str, robot: Robot, amendments: Iterable[Amendment], notes: Mapping[int, str] | None = None
) -> str:
    """``text``, the description of ``robot``, with the ``amendments``: it reads as :func:`amended` gives.

    Comments, order and layout stay; ``notes`` become comments above the first line that the amendment of that
    index changes. Where that cannot be (standard DH and new inertials, aliases) the robot is written anew.

    Raises
    ------
    InputError: ``text`` does not describe ``robot``, and as :func:`amended`.
    """
    amendments = tuple(amendments)
    done = apply_amendments(robot, amendments)
    return rewritten(text, robot, done.robot, done.origins, comments_of(done, amendments, notes or {}))


def comments_of(
    done: Amended, amendments: Sequence[Amendment], notes: Mapping[int, str]
) -> list[tuple[frozenset[Place], Sequence[str]]]:
    """What stands above the places that each of the ``amendments`` changed: its note, and what is to be
    remarked of it."""
    comments: list[tuple[frozenset[Place], Sequence[str]]] = []
    for i, (amendment, places, remarks) in enumerate(zip(amendments, done.places, done.remarks, strict=True)):
        lines = (*notes.get(i, "").splitlines(), *(f"{amendment.effect}: {remark}" for remark in remarks))
        comments.append((places, lines))
    return comments


def difference(old: str, new: str, name: str = "model.yaml") -> str:
    """The unified diff of two texts; "" where they are equal."""
    lines = difflib.unified_diff(old.splitlines(), new.splitlines(), f"a/{name}", f"b/{name}", lineterm="")
    return "".join(f"{line}\n" for line in lines)
