"""The verdict of a diagnosis as one sentence: what all joints lack first, then what single ones lack, and how
much of the torque stays unexplained; and as one line, however much there is to say."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from robodyn.diagnose.result import Diagnosis, Finding
from robodyn.effects.catalogue import CATALOGUE
from robodyn.report import diagnosis_text as words
from robodyn.report.figures import capital

#: Things in one sentence; the others are counted.
_MOST: Final = 5
#: Signs of a line.
LINE: Final = 72
#: Joints before the tip that make a wrist.
_WRIST: Final = 3
_UNEXPLAINED: Final = "A residual remains that no effect of the catalogue explains"
_TOUCHED: Final = "no effect is missing, but something touched the arm"
_TIMES: Final = {2: "twice", 3: "three times", 4: "four times", 5: "five times", 6: "six times"}


def headline(diagnosis: Diagnosis, *, validated: bool = True) -> str:
    """The verdict as a sentence; ``validated``: whether there was a log that was not fitted."""
    return _verdict(diagnosis, validated)[0]


def in_a_line(diagnosis: Diagnosis, *, validated: bool = True, room: int = LINE) -> tuple[str, str]:
    """The verdict within ``room`` signs, and as a text what they leave out.

    Where all that is missing does not fit, kinds without their joints stand for it, those that most joints
    lack first, and the others are counted.
    """
    _, lines, rest, things = _verdict(diagnosis, validated)
    line = next((line for line in lines if len(line) <= room), lines[-1])
    text = "; ".join(rest if line == lines[0] or not things else [things, *rest])
    return line if len(line) <= room else f"{line[: room - 1]}…", f"{capital(text)}." if text else ""


def _verdict(diagnosis: Diagnosis, validated: bool) -> tuple[str, list[str], list[str], str]:
    """The verdict as a sentence; in one line, the longest first; what the first of these leaves out; and what
    the others leave out beside it."""
    name, n = diagnosis.robot.name, diagnosis.robot.n
    if diagnosis.verdict == "consistent":
        claim, joint, leaves = _consistent(diagnosis, validated)
        return f"{name} {claim}{joint}{leaves}.", [f"{name} {claim}", f"the model {claim}"], [leaves], ""
    if diagnosis.verdict == "unexplained":
        if "stands" in diagnosis.extra:
            return f"{name}: {diagnosis.extra['stands']}.", [capital(diagnosis.extra["stands"])], [], ""
        worst = words.worst_joint(diagnosis.left)
        parts = [] if worst is None else [f"It is largest at joint {worst}"]
        return f"{'. '.join([_UNEXPLAINED, *parts])}.", [_UNEXPLAINED], parts, ""
    lacking = [f for f in words.claims(diagnosis) if not words.is_contact(f.effect)]
    contacts = [words.touched_at(f) for f in words.claims(diagnosis) if words.is_contact(f.effect)]
    touched = words.listed([f"something touched {place} {time}".rstrip() for place, time in contacts])
    if not lacking and touched:
        return (
            f"{name}: no effect is missing, but {touched}.",
            [f"{name}: {_TOUCHED}", _TOUCHED],
            [touched],
            "",
        )
    things = missing_words(lacking, n)
    rest = [text for text in (touched, left_words(diagnosis, validated=validated)) if text]
    whole = f"{name}: {_missing(things)}"
    groups = sorted(words.by_kind(lacking), key=lambda findings: -_breadth(findings, n))
    kinds = list(dict.fromkeys(_kind_words(findings, n) for findings in groups))
    shorter = [
        _missing([*kinds[:k], *([words.more_text(len(kinds) - k)] if k < len(kinds) else [])])
        for k in range(len(kinds), 0, -1)
    ]
    shorter.append(f"{len(lacking)} effects are missing")
    lines = [whole, *(f"{name}: {line}" for line in shorter), *shorter]
    return f"{'; '.join([whole, *rest])}.", lines, rest, words.listed(things)


def _missing(things: Sequence[str]) -> str:
    things = things or ["an effect"]
    first = things[0].partition(" at ")[0].partition(" of ")[0]
    is_plural = first.endswith("s") and not first.endswith("ss")
    verb = "are" if len(things) > 1 or " and " in first or is_plural else "is"
    return f"{words.listed(things)} {verb} missing"


def missing_words(lacking: Sequence[Finding], n: int) -> list[str]:
    """What ``lacking`` lists of an arm of ``n`` joints, by kind: what most joints have first, then in the
    order given; things at the same joints stand together, what is beyond a handful is counted."""
    things: list[tuple[int, str]] = []
    places: dict[tuple[bool, tuple[int, ...]], list[str]] = {}
    for findings in words.by_kind(lacking):
        first, joints = findings[0], tuple(sorted({f.joint for f in findings if f.joint is not None}))
        if _is_pair(first):
            things += [(1, _coupled(f, n)) for f in findings]
        elif not joints:
            things.append((n, _noun(findings, 1)))
        else:
            fold = words.traits_of(first.effect).fold
            is_of_link = fold is not None and fold.into == "link"
            places.setdefault((is_of_link, joints), []).append(_noun(findings, len(joints)))
    for (is_of_link, joints), nouns in places.items():
        links = f"of link{'s' if len(joints) > 1 else ''} {words.listed([str(j) for j in joints])}"
        place = links if is_of_link else f"at {_joints(joints, n)}"
        things.append((len(joints), f"{words.listed(nouns)} {place}"))
    texts = [text for _, text in sorted(things, key=lambda thing: -thing[0])]
    return texts if len(texts) <= _MOST else [*texts[: _MOST - 1], words.more_text(len(texts) - _MOST + 1)]


def _kind_words(findings: Sequence[Finding], n: int) -> str:
    """A kind without its joints."""
    if _is_pair(findings[0]):
        return _coupled(findings[0], n).partition(" (")[0]
    return _noun(findings, len(findings))


def _breadth(findings: Sequence[Finding], n: int) -> int:
    """How many joints of ``n`` a kind is at."""
    joints = {f.joint for f in findings}
    return n if None in joints else len(joints)


def left_words(diagnosis: Diagnosis, *, validated: bool) -> str:
    """``12 % of the torque stays unexplained``; empty where that is not known."""
    share = diagnosis.gap.left_share(validated=validated)
    if share is None:
        return ""
    text = f"{100 * share:.0f} %" if share >= 0.01 else "less than 1 %"
    return f"{text} of the torque stays unexplained"


def _consistent(diagnosis: Diagnosis, validated: bool) -> tuple[str, str, str]:
    """What a consistent model is, after the robot's name, and what it leaves, with what joins the two:
    nothing beyond the noise, or more within what is stated of the arm's numbers.

    ``refitted`` in :attr:`Diagnosis.extra` is the share within which these numbers were moved; None or absent
    where they were not.
    """
    noisy, refitted = words.joints_above_noise(diagnosis, validated), diagnosis.extra.get("refitted")
    leaves = "what it leaves is at the noise floor"
    if noisy:
        ratio = words.times_noise(diagnosis, words.chosen(diagnosis, validated)[1])
        most = max(noisy, key=lambda joint: float(ratio[joint - 1]))
        times = float(ratio[most - 1])
        spelled = _TIMES.get(round(times)) if times >= 1.75 else None
        leaves = f"joint {most} leaves {spelled or f'{times:.2g} times'} the noise"
    if refitted is not None:
        leaves = leaves.replace("it leaves", "they leave")
        return (
            f"is within your {100 * float(refitted):.0f} %",
            ": ",
            f"refitted numbers are in model.yaml, {leaves}",
        )
    if noisy:
        return "lacks no effect that the logs could name", ", but ", leaves
    is_known = bool(np.isfinite(diagnosis.gap.noise_floor).all())
    return ("explains the logs: no effect needs to be added", *((", ", leaves) if is_known else ("", "")))


def _noun(findings: Sequence[Finding], count: int) -> str:
    effects = list(dict.fromkeys(f.effect for f in findings))
    if len(effects) > 1:
        return "friction"
    noun = words.traits_of(effects[0]).noun or words.named(effects[0])
    article, _, thing = noun.partition(" ")
    return f"{thing}s" if count > 1 and article in ("a", "an") else noun


def _is_pair(finding: Finding) -> bool:
    return finding.effect in CATALOGUE and CATALOGUE[finding.effect].level == "pair"


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
    return f"all joints but {others[0]}" if len(others) == 1 and n > _WRIST else words.joints_of(joints)
