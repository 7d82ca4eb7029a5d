"""The verdict of a diagnosis as one sentence: what all joints lack first, then what single ones lack, and how
much of the torque stays unexplained; and as one line, however much there is to say.

Findings of one kind are one thing: whatever rubs is friction, unless a single law is all there is of it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from robodyn.diagnose.result import Diagnosis, Finding
from robodyn.effects.catalogue import CATALOGUE
from robodyn.report.diagnosis_text import (
    chosen,
    claims,
    is_contact,
    joints_of,
    listed,
    named,
    still,
    times_noise,
    touched_at,
    traits_of,
    worst_joint,
)
from robodyn.report.figures import capital

#: Things in one sentence; the others are counted.
_MOST: Final = 5
#: Signs of a line.
LINE: Final = 72
#: Joints before the tip that make a wrist.
_WRIST: Final = 3
_UNEXPLAINED: Final = "A residual remains that no effect of the catalogue explains."
_TOUCHED: Final = "no effect is missing, but something touched the arm"
_TIMES: Final = {2: "twice", 3: "three times", 4: "four times", 5: "five times", 6: "six times"}


def headline(diagnosis: Diagnosis, *, validated: bool = True) -> str:
    """The verdict as a sentence; ``validated``: whether there was a log that was not fitted."""
    name = diagnosis.robot.name
    if diagnosis.verdict == "consistent":
        return f"{name} {''.join(consistent_words(diagnosis, validated=validated))}."
    if diagnosis.verdict == "unexplained":
        return " ".join((_UNEXPLAINED, *_worst(diagnosis)))
    lacking, touched = _claimed(diagnosis)
    if not lacking and touched:
        return f"{name}: no effect is missing, but {listed(touched)}."
    parts = [f"{name}: {_missing(missing_words(lacking, diagnosis.robot.n))}"]
    return "; ".join([*parts, *_further(diagnosis, touched, validated)]) + "."


def in_a_line(diagnosis: Diagnosis, *, validated: bool = True, room: int = LINE) -> tuple[str, str]:
    """The verdict within ``room`` signs, and as a text what they leave out.

    Where all that is missing does not fit, kinds without their joints stand for it, those that most joints
    lack first, and the others are counted.
    """
    name = diagnosis.robot.name
    if diagnosis.verdict == "consistent":
        claim, _, rest = consistent_words(diagnosis, validated=validated)
        return _first(f"{name} {claim}", f"the model {claim}", room=room), _sentence(rest)
    if diagnosis.verdict == "unexplained":
        return _UNEXPLAINED[:-1], " ".join(_worst(diagnosis))
    lacking, touched = _claimed(diagnosis)
    if not lacking and touched:
        return _first(f"{name}: {_TOUCHED}", _TOUCHED, room=room), _sentence(listed(touched))
    things = missing_words(lacking, diagnosis.robot.n)
    further, whole = _further(diagnosis, touched, validated), f"{name}: {_missing(things)}"
    if len(whole) <= room:
        return whole, _sentence("; ".join(further))
    kinds = list(dict.fromkeys(_kinds(lacking, diagnosis.robot.n)))
    shorter = [
        [*kinds[:k], *([_more(len(kinds) - k)] if k < len(kinds) else [])] for k in range(len(kinds), 0, -1)
    ]
    lines = [_missing(some) for some in shorter] + [f"{len(lacking)} effects are missing"]
    line = _first(*(f"{name}: {line}" for line in lines), *lines, room=room)
    return line, _sentence("; ".join([listed(things), *further]))


def _more(count: int) -> str:
    return "one more" if count == 1 else f"{count} more"


def _first(*texts: str, room: int) -> str:
    """The first text that fits, else the last, cut."""
    text = next((text for text in texts if len(text) <= room), texts[-1])
    return text if len(text) <= room else f"{text[: room - 1]}…"


def _sentence(text: str) -> str:
    return f"{capital(text)}." if text else ""


def _worst(diagnosis: Diagnosis) -> list[str]:
    worst = worst_joint(diagnosis.left)
    return [] if worst is None else [f"It is largest at joint {worst}."]


def _claimed(diagnosis: Diagnosis) -> tuple[list[Finding], list[str]]:
    """What the model lacks, and contacts in words."""
    lacking = [f for f in claims(diagnosis) if not is_contact(f.effect)]
    return lacking, [_touched(f) for f in claims(diagnosis) if is_contact(f.effect)]


def _missing(things: Sequence[str]) -> str:
    things = things or ["an effect"]
    first = things[0].partition(" at ")[0].partition(" of ")[0]
    is_plural = first.endswith("s") and not first.endswith("ss")
    verb = "are" if len(things) > 1 or " and " in first or is_plural else "is"
    return f"{listed(things)} {verb} missing"


def _further(diagnosis: Diagnosis, touched: Sequence[str], validated: bool) -> list[str]:
    """Contacts, and what stays unexplained."""
    return [text for text in (listed(touched), left_words(diagnosis, validated=validated)) if text]


def missing_words(lacking: Sequence[Finding], n: int) -> list[str]:
    """What ``lacking`` lists of an arm of ``n`` joints, by kind: what most joints have first, then in the
    order given; things at the same joints stand together, what is beyond a handful is counted."""
    places: dict[tuple[int, ...], list[str]] = {}
    alone: list[tuple[int, str]] = []
    for findings in by_kind(lacking):
        joints = tuple(sorted({f.joint for f in findings if f.joint is not None}))
        if _is_pair(findings[0]):
            alone += [(1, _coupled(f, n)) for f in findings]
        elif not joints:
            alone.append((n, _noun(findings, 1)))
        else:
            places.setdefault((*joints, -1) if _is_of_link(findings[0]) else joints, []).append(
                _noun(findings, len(joints))
            )
    things = alone
    for key, nouns in places.items():
        joints = tuple(joint for joint in key if joint > 0)
        of_links = len(joints) < len(key)
        where = f"of link{'s' if len(joints) > 1 else ''} " if of_links else "at "
        where += listed([str(j) for j in joints]) if of_links else _joints(joints, n)
        things.append((len(joints), f"{listed(nouns)} {where}"))
    words = [text for _, text in sorted(things, key=lambda thing: -thing[0])]
    return words if len(words) <= _MOST else [*words[: _MOST - 1], _more(len(words) - _MOST + 1)]


def _kinds(lacking: Sequence[Finding], n: int) -> list[str]:
    """What ``lacking`` lists without joints, what most joints have first."""
    groups = sorted(by_kind(lacking), key=lambda findings: -_breadth(findings, n))
    return [
        _coupled(some[0], n).partition(" (")[0] if _is_pair(some[0]) else _noun(some, len(some))
        for some in groups
    ]


def _breadth(findings: Sequence[Finding], n: int) -> int:
    """How many joints of ``n`` a kind is at."""
    joints = {f.joint for f in findings}
    return n if None in joints else len(joints)


def by_kind(lacking: Sequence[Finding]) -> list[list[Finding]]:
    """Findings of one kind together, kinds and findings in the order given."""
    kinds: dict[str, list[Finding]] = {}
    for finding in lacking:
        kinds.setdefault(kind_of(finding.effect), []).append(finding)
    return list(kinds.values())


def left_words(diagnosis: Diagnosis, *, validated: bool) -> str:
    """``12 % of the torque stays unexplained``; empty where that is not known."""
    share = diagnosis.gap.left_share(validated=validated)
    if share is None:
        return ""
    text = f"{100 * share:.0f} %" if share >= 0.01 else "less than 1 %"
    return f"{text} of the torque stays unexplained"


def consistent_words(diagnosis: Diagnosis, *, validated: bool) -> tuple[str, str, str]:
    """What a consistent model is, after the robot's name, and what it leaves, with what joins the two:
    nothing beyond the noise, or more within what is stated of the arm's numbers.

    ``refitted`` in :attr:`Diagnosis.extra` is the share within which these numbers were moved; None or absent
    where they were not.
    """
    rest, refitted = still(diagnosis, validated), diagnosis.extra.get("refitted")
    within = "" if refitted is None else f"is within your {100 * float(refitted):.0f} %"
    numbers = "refitted numbers are in model.yaml, "
    if not rest and within:
        return within, ": ", f"{numbers}what they leave is at the noise floor"
    if not rest:
        known = bool(np.isfinite(diagnosis.gap.noise_floor).all())
        floor = (", ", "what it leaves is at the noise floor") if known else ("", "")
        return ("explains the logs: no effect needs to be added", *floor)
    _, after = chosen(diagnosis, validated)
    ratio = times_noise(diagnosis, after)
    most = max(rest, key=lambda joint: float(ratio[joint - 1]))
    leaves = f"joint {most} leaves {_times(float(ratio[most - 1]))} the noise"
    if within:
        return within, ": ", numbers + leaves
    return "lacks no effect that the logs could name", ", but ", leaves


def _times(ratio: float) -> str:
    return _TIMES.get(round(ratio), f"{ratio:.2g} times") if ratio >= 1.75 else f"{ratio:.2g} times"


def kind_of(effect: str) -> str:
    """What ``effect`` is an instance of: findings of one kind are one thing in a sentence."""
    known = CATALOGUE.get(effect)
    if known is not None and known.level == "joint" and known.dissipative:
        return "friction"
    return effect


def _noun(findings: Sequence[Finding], count: int) -> str:
    effects = list(dict.fromkeys(f.effect for f in findings))
    if len(effects) > 1:
        return "friction"
    noun = traits_of(effects[0]).noun or named(effects[0])
    article, _, thing = noun.partition(" ")
    return f"{thing}s" if count > 1 and article in ("a", "an") else noun


def _is_pair(finding: Finding) -> bool:
    return finding.effect in CATALOGUE and CATALOGUE[finding.effect].level == "pair"


def _is_of_link(finding: Finding) -> bool:
    fold = traits_of(finding.effect).fold
    return fold is not None and fold.into == "link"


def _coupled(finding: Finding, n: int) -> str:
    """Joints that share a motor; the last ones of an arm are its wrist."""
    other = finding.parameters["with"].value if "with" in finding.parameters else None
    joints = sorted({finding.joint or 0, *([int(other)] if isinstance(other, float | int) else [])})
    is_wrist = n > _WRIST and joints[0] > n - _WRIST
    return f"{'a coupled wrist' if is_wrist else 'coupled joints'} ({', '.join(map(str, joints))})"


def _joints(joints: Sequence[int], n: int) -> str:
    """``all joints``, ``all joints but 3``, ``joints 1 to 3``, ``joints 1 and 4``."""
    others = [j for j in range(1, n + 1) if j not in joints]
    if len(joints) > 1 and not others:
        return "all joints"
    if len(others) == 1 and n > _WRIST:
        return f"all joints but {others[0]}"
    return joints_of(joints)


def _touched(contact: Finding) -> str:
    """A contact within a sentence."""
    place, time = touched_at(contact)
    return f"something touched {place} {time}".rstrip()
