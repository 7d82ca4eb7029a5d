"""What is said of a simulated fleet beside what is planted in it.

    python -m benchmarks.fleet.score DIR FLEET.json

compares what ``robodyn fleet`` has written with the answer in DIR. The exit code is 1 where it is not right.
"""

from __future__ import annotations

import json
import math
import statistics
import sys
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from benchmarks.fleet.limits import DAY, FALSE, NAMED, NEAR, RIGHT

from robodyn.diagnose.blind.json_part import Part
from robodyn.diagnose.blind.seal import unsealed

#: Cases of a score that are printed one by one.
_SHOWN = 20


@dataclass(frozen=True, slots=True)
class Case:
    """A unit that was named, or in which something is planted. What is ``planted`` (None: nothing) and what
    is ``named``, the surest first; whether it is ``right``, the effect and the joint; how far its date is off
    [days], and whether the stated interval holds the day (None: there is no date)."""

    type: str
    unit: str
    planted: str | None
    kind: str | None
    named: tuple[str, ...]
    right: bool
    days_off: float | None = None
    interval_holds: bool | None = None


@dataclass(frozen=True, slots=True)
class Kind:
    """Of one kind of change how many are ``planted``, in how many of their units something is ``named``, and
    in how many it is ``right``."""

    planted: int
    named: int
    right: int


@dataclass(frozen=True, slots=True)
class FleetScore:
    """How an answer about a fleet of ``units``, ``healthy`` of which are, did.

    By ``kinds`` what was found; ``false`` healthy units that are named. ``claims``: all names, those of
    healthy units too, and of them the ``right`` ones. Dates of right names: ``days_off``, their
    median; shares of them that are ``near`` and that the stated interval holds (None: no dates). ``same``:
    whether the answer is about this fleet. ``cases``: all units that are named, or should be.
    """

    units: int
    healthy: int
    kinds: Mapping[str, Kind]
    false: int
    claims: int
    right: int
    days_off: float | None
    near: float | None
    interval_holds: float | None
    same: bool
    cases: tuple[Case, ...]

    @property
    def planted(self) -> int:
        """Units in which something is planted."""
        return sum(kind.planted for kind in self.kinds.values())

    @property
    def named(self) -> int:
        """and that are named."""
        return sum(kind.named for kind in self.kinds.values())

    @property
    def result(self) -> str:
        """The worst of what there is to say: ``wrong`` (too many healthy units or wrong effects and joints
        are named), ``missed`` (too few of what is planted), or ``right``."""
        if self.false > max(FALSE * (self.named + self.false), 1) or self.right < RIGHT * self.claims:
            return "wrong"
        return "missed" if self.named < NAMED * self.planted else "right"

    def to_dict(self) -> dict[str, Any]:
        """Ready for JSON."""
        return {"result": self.result, "planted": self.planted, "named": self.named, **asdict(self)}


def score_fleet(answer: Part, result: Any, file: str = "fleet.json") -> FleetScore:
    """``result`` (what ``fleet.json`` holds) beside ``answer``.

    Every unit with a claim is named. A claim is right whose joint is the planted one, and of whose effects
    one is planted.

    Raises
    ------
    InputError: one of the two is none; with the part of it that is wrong.
    """
    whole = Part(
        result, file, "the answer about a fleet", "take the fleet.json that robodyn fleet has written"
    )
    units = {
        (type, unit.text())
        for type, listed in answer.need("fleet", "units by their types").items()
        for unit in listed.each()
    }
    planted = {_unit(one): one for one in answer.need("planted", "what is planted").each()}
    claims: dict[tuple[str, str], list[Part]] = {}
    reported = set()
    for one in whole.need("units", "a list of units").each():
        listed = one.need("claims", "a list of claims").each()
        reported.add(_unit(one))
        if listed:
            claims[_unit(one)] = listed
    cases = [
        _case(key, planted.get(key), claims.get(key, []))
        for key in sorted({*planted, *(key for key in claims if key in units)})
    ]
    sick = [case for case in cases if case.kind is not None]
    kinds = {}
    for name in sorted({str(case.kind) for case in sick}):
        of_kind = [case for case in sick if case.kind == name]
        kinds[name] = Kind(
            len(of_kind), sum(bool(case.named) for case in of_kind), sum(case.right for case in of_kind)
        )
    off = [case.days_off for case in sick if case.days_off is not None]
    holds = [case.interval_holds for case in sick if case.interval_holds is not None]
    rights = [
        key in planted and _is_right(claim, planted[key])
        for key in sorted(claims)
        if key in units
        for claim in claims[key]
    ]
    return FleetScore(
        len(units), len(units) - len(planted), kinds, len(cases) - len(sick), len(rights), sum(rights),
        statistics.median(off) if off else None,
        sum(x <= NEAR for x in off) / len(off) if off else None,
        sum(holds) / len(holds) if holds else None,
        bool(reported & units), tuple(cases),
    )  # fmt: skip


def _unit(one: Part) -> tuple[str, str]:
    return one.need("type", "the name of a type").text(), one.need("unit", "the name of a unit").text()


def _case(key: tuple[str, str], planted: Part | None, claims: list[Part]) -> Case:
    named = tuple(_called(claim) for claim in claims)
    if planted is None:
        return Case(*key, None, None, named, right=False)
    kind = planted.need("kind", "what kind of change it is").text()
    rights = [claim for claim in claims if _is_right(claim, planted)]
    begin, since = planted.get("since"), rights[0].get("since") if rights else None
    if begin is None or since is None:
        return Case(*key, _called(planted), kind, named, right=bool(rights))
    true = _seconds(begin)
    interval = rights[0].get("since_interval")
    ends = [_seconds(end) for end in interval.each()] if interval is not None else []
    return Case(
        *key, _called(planted), kind, named, True,
        abs(_seconds(since) - true) / DAY, ends[0] <= true <= ends[1] if len(ends) == 2 else None,
    )  # fmt: skip


def _is_right(claim: Part, planted: Part) -> bool:
    return bool(_effects(claim) & _effects(planted)) and _joint(claim) == _joint(planted)


def _effects(one: Part) -> set[str]:
    return {effect.name() for effect in one.need("effects", "ids of effects").each()}


def _joint(one: Part) -> int | None:
    joint = one.get("joint")
    return None if joint is None else joint.joint()


def _called(one: Part) -> str:
    """What is planted or named, for people."""
    effects = [effect.name() for effect in one.need("effects", "ids of effects").each()]
    joint = _joint(one)
    what = " and ".join(effects) or "unexplained torque"
    return what + (f" at joint {joint}" if joint else "")


def _seconds(part: Part) -> float:
    """A point in time [s since 1970] in ISO 8601."""
    try:
        seconds = datetime.fromisoformat(part.text()).timestamp()
    except ValueError:
        raise part.wrong("a time in ISO 8601, such as 2025-05-12T08:00:00Z") from None
    if not math.isfinite(seconds):
        raise part.wrong("a time in ISO 8601, such as 2025-05-12T08:00:00Z")
    return seconds


def _lines(score: FleetScore) -> list[str]:
    """A score for people."""
    lines = [
        f"{name}: {kind.named} of {kind.planted} units are named, {kind.right} with effect and joint right"
        for name, kind in score.kinds.items()
    ]
    lines.append(f"{score.false} of {score.healthy} healthy units are named")
    if score.claims:
        lines.append(f"{score.right} of {score.claims} names are right")
    if score.days_off is not None and score.near is not None:
        text = f"dates are off by {score.days_off:.0f} days (median), {score.near:.0%} by 30 or less"
        holds = score.interval_holds
        lines.append(text + ("" if holds is None else f"; {holds:.0%} are in the stated interval"))
    bad = [case for case in score.cases if not case.right]
    for case in bad[:_SHOWN]:
        planted, named = case.planted or "nothing", ", ".join(case.named) or "nothing"
        lines.append(f"  {case.type} {case.unit}: {planted} is planted, {named} is named")
    if len(bad) > _SHOWN:
        lines.append(f"  and {len(bad) - _SHOWN} more")
    return [*lines, f"overall: {score.result}"]


def main(arguments: Sequence[str] | None = None) -> int:
    """Print the score, and return the exit code."""
    folder, file = sys.argv[1:] if arguments is None else arguments
    answer = unsealed((Path(folder) / "answer.sealed").read_text(encoding="utf-8"))
    score = score_fleet(answer, json.loads(Path(file).read_text(encoding="utf-8")), file)
    print("\n".join(_lines(score)))
    return int(score.result != "right")


if __name__ == "__main__":
    sys.exit(main())
