"""Many blind tests of one arm: how often a diagnosis is right, effect by effect."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from robodyn.diagnose.amend.amend import Amendment
from robodyn.diagnose.blind.hide import Setup, hide
from robodyn.diagnose.blind.seal import score
from robodyn.diagnose.run import diagnose
from robodyn.robot.reader import read_text


def trial(text: str, spec: str, wanted: Sequence[Amendment], random: int, setup: Setup) -> bytes:
    """A blind test of the arm described by ``text`` (called ``spec``), its diagnosis and the score, as JSON:
    see :func:`robodyn.diagnose.blind.hide.hide` for what is hidden.

    Raises
    ------
    InputError: an effect does not fit the arm, or cannot be as large as is wanted.
    ToolError: no C compiler.
    """
    robot = read_text(text, spec, warn=lambda _: None)
    blind = hide(robot, wanted, random=random, setup=setup, text=text)
    diagnosis = diagnose(robot, [blind.train], blind.validate, text=text).to_dict()
    answer = blind.answer()
    result = score(answer, json.loads(json.dumps(diagnosis), parse_constant=lambda _: None))
    answered = {claim.answers: claim.status for claim in result.claims}
    hidden = [
        {"effect": one["effect"], "joint": one["joint"], "status": answered.get(k, "missed")}
        for k, one in enumerate(answer["effects"])
    ]
    wrong = [
        {"effect": claim.effect, "joint": claim.joint} for claim in result.claims if claim.status == "wrong"
    ]
    record = {
        "seed": setup.seed,
        "result": result.result,
        "verdict": result.verdict,
        "hidden": hidden,
        "wrong": wrong,
        "gap_closed": result.closed,
    }
    return json.dumps(record).encode()


@dataclass(frozen=True, slots=True)
class Tally:
    """Of an ``effect``, how often it was hidden and named ``right``, hidden and among what a claim could not
    be told from (``declared``), hidden and ``missed``; and how often it was named and not hidden
    (``wrong``)."""

    effect: str
    right: int = 0
    declared: int = 0
    missed: int = 0
    wrong: int = 0

    def to_dict(self) -> dict[str, Any]:
        """Ready for JSON."""
        return asdict(self)


def tallies(trials: Iterable[Mapping[str, Any]]) -> list[Tally]:
    """Of what :func:`trial` says of each trial, the tally of each effect, by their ids."""
    fields = {"right": "right", "in the declared set": "declared", "missed": "missed"}
    counts: dict[str, dict[str, int]] = {}

    def add(effect: str, field: str) -> None:
        own = counts.setdefault(effect, {})
        own[field] = own.get(field, 0) + 1

    for one in trials:
        for hidden in one["hidden"]:
            add(hidden["effect"], fields[hidden["status"]])
        for claim in one["wrong"]:
            add(claim["effect"], "wrong")
    return [Tally(effect, **own) for effect, own in sorted(counts.items())]
