"""A diagnosis at a glance, on its page and on a terminal: what is missing, where, how sure, how much better,
what to record next."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from typing import Final

import numpy as np

from robodyn.diagnose.limits import CLAIM
from robodyn.diagnose.result import Diagnosis, Estimate, Finding
from robodyn.report.diagnosis_findings import next_of
from robodyn.report.diagnosis_headline import headline, in_a_line
from robodyn.report.diagnosis_joints import units_at
from robodyn.report.diagnosis_text import (
    chosen,
    claims,
    experiments,
    is_touched_only,
    is_unseen,
    joints_of,
    listed,
    named,
    place_of,
    still,
    times_noise,
    title_of,
    touched_at,
    units_of,
    with_interval,
    worst_joint,
)
from robodyn.report.diagnosis_where import Localised, Travel
from robodyn.report.figures import aligned, capital, formatted

#: What to record when nothing can be named, by the quantity that shows the residual best.
_ADVICE: Final = {
    "a short time": "The same motion again. What comes back at the same place belongs to the arm; what "
    "does not is contact, a cable, temperature or the sensor.",
    "direction": "Constant speeds from slow to fast, both ways, one joint at a time.",
    "velocity": "Constant speeds from slow to fast, both ways, one joint at a time.",
    "position": "A slow sweep of the joint through its whole travel and back, at two speeds.",
    "acceleration": "The same path at full and at half speed: what is of inertia falls to a quarter.",
    "load": "The same motion with a known payload and without.",
    "load, each way": "The same motion with a known payload and without, lifting and lowering.",
    "constant": "Standstill with brakes on and drive off: what remains is the sensor's.",
}
_NO_ADVICE: Final = (
    "The same motion again, at the full rate and unfiltered, and some seconds of standstill: what repeats "
    "belongs to the arm, what does not to its surroundings or its sensors."
)
_CLAUSES: Final = {
    "constant": "it is constant",
    "direction": "seen best over the direction of motion",
    "load, each way": "seen best over the load, each direction of motion apart",
    "a short time": "most of it is in a short time",
}
_SHORT: Final = 120
#: More kinds of effects are counted.
_FEW: Final = 3
#: A joint with so large a share of the excess is told about.
_LOUD: Final = 0.05


def tiles(diagnosis: Diagnosis, validated: bool, places: Sequence[Localised]) -> list[tuple[str, str, str]]:
    """Question, answer, and a remark on it."""
    summary = [
        _missing(diagnosis, validated),
        _where(diagnosis, places),
        _sure(diagnosis),
        _better(diagnosis, validated, places),
    ]
    old, new = diagnosis.operations
    if old or new:
        more = f" ({new - old:+d})" if new != old else ""
        text = f"operations of one call of the inverse dynamics{more}"
        summary.append(("Cost of the kernel", f"{old} → {new}" if new != old else f"{old}", text))
    return [*summary, _next(diagnosis)]


def main_joint(diagnosis: Diagnosis, places: Sequence[Localised]) -> Localised:
    """The joint that matters most: where nothing explains it, that of the headline."""
    worst = worst_joint(diagnosis.left) if diagnosis.verdict == "unexplained" else None
    return max(places, key=lambda p: p.share) if worst is None else places[worst - 1]


def _worst(diagnosis: Diagnosis, validated: bool, places: Sequence[Localised]) -> int:
    """The joint (from 1) whose gap is told: where most of it was, in units of the noise."""
    if diagnosis.verdict == "unexplained":
        return main_joint(diagnosis, places).joint
    before, _ = chosen(diagnosis, validated)
    size = times_noise(diagnosis, before, unknown=-1.0)
    joints = [f.joint - 1 for f in claims(diagnosis) if f.joint is not None] or list(range(diagnosis.robot.n))
    return max(joints, key=lambda j: float(size[j])) + 1


def _missing(diagnosis: Diagnosis, validated: bool) -> tuple[str, str, str]:
    if diagnosis.verdict == "consistent":
        return "What is missing", "Nothing", "no effect is worth adding"
    lacking = claims(diagnosis)
    if is_touched_only(diagnosis):
        return "What is missing", "Nothing", "but something outside touched the arm"
    if diagnosis.verdict == "unexplained" or not lacking:
        return "What is missing", "Something", "that no effect of the catalogue explains"
    rest = still(diagnosis, validated)
    more = [f"something at {joints_of(rest, diagnosis.robot.n)} that this does not explain"] if rest else []
    counted = Counter(f.effect for f in lacking)
    if len(counted) > _FEW:
        names = [f"{named(id)} ({count})" if count > 1 else named(id) for id, count in counted.most_common()]
        several = f"{len(lacking)} effects of {len(counted)} kinds"
        return "What is missing", several, "; ".join([listed(names), *more])
    others = [named(id) for id in counted if id != lacking[0].effect]
    remark = f"and {listed([*others, *more])}" if others or more else "and nothing else"
    return "What is missing", title_of(lacking[0].effect), remark


def _where(diagnosis: Diagnosis, places: Sequence[Localised]) -> tuple[str, str, str]:
    top = main_joint(diagnosis, places)
    over = _shown(top.best)
    share = f"{100 * top.share:.0f} % of the excess is at joint {top.joint}"
    if diagnosis.verdict == "consistent":
        return "At which joint", "None", "no joint stands out of its noise" if not top.shown else share
    if is_touched_only(diagnosis):
        where, when = touched_at(claims(diagnosis)[0])
        return "Where and when", capital(where), when or share
    if diagnosis.verdict == "unexplained":
        if math.isfinite(top.left) and top.left > 1:
            share = f"{formatted(top.left)} times what would matter is left there"
        return "At which joint", f"Joint {top.joint}", f"{share}; {over}"
    joints = sorted({f.joint for f in claims(diagnosis) if f.joint is not None})
    whole = ["the whole robot"] if any(f.joint is None for f in claims(diagnosis)) else []
    answer = listed([*([joints_of(joints)] if joints else []), *whole])
    return "At which joint", capital(answer), f"{share}; {over}"


def _shown(name: str | None) -> str:
    """What shows a residual best, as a clause."""
    if name is None:
        return "no single quantity shows it"
    return _CLAUSES.get(name) or f"seen best over the {name}"


def _sure(diagnosis: Diagnosis) -> tuple[str, str, str]:
    lacking = claims(diagnosis)
    question = "How sure"
    if diagnosis.verdict == "missing_effect" and lacking:
        open_ = list(dict.fromkeys(named(r) for f in lacking for r in f.confounded_with))
        least = min(f.confidence for f in lacking)
        rivals = f"not told from {listed(open_)}" if open_ else "no rival is left"
        several = "the least sure of the names; " if len(lacking) > 1 else ""
        return question, f"{100 * least:.0f} %", several + rivals
    if diagnosis.verdict == "unexplained":
        some = f"{len(diagnosis.findings)} suspicions, none held" if len(diagnosis.findings) > 1 else ""
        some = "one suspicion, which did not hold" if len(diagnosis.findings) == 1 else some
        return question, "No name", some or "no name reaches 50 %"
    if diagnosis.detectable is not None and np.isfinite(diagnosis.detectable).any():
        j = int(np.nanargmax(diagnosis.detectable))
        size = f"{formatted(diagnosis.detectable[j])} {units_at(diagnosis, j)['torque']}"
        return question, f"down to {size}", f"RMS at joint {j + 1}: anything larger would be worth a name"
    return question, "As far as the motion goes", "what it does not excite it cannot show: see below"


def _better(diagnosis: Diagnosis, validated: bool, places: Sequence[Localised]) -> tuple[str, str, str]:
    question = f"How much better{'' if validated else ' (on the logs fitted)'}"
    before, after = chosen(diagnosis, validated)
    j = _worst(diagnosis, validated, places) - 1
    unit, floor = units_at(diagnosis, j)["torque"], diagnosis.gap.noise_floor[j]
    noise = f"noise floor {formatted(floor)}"
    if diagnosis.verdict != "missing_effect" or is_touched_only(diagnosis):
        times = before[j] / floor if floor > 0 else math.nan
        stays = f"RMS at joint {j + 1}, {formatted(times)} times its noise"
        touched = "; contact is not added to a model" if diagnosis.verdict == "missing_effect" else ""
        return "How much is left", f"{formatted(before[j])} {unit}", stays + touched
    share = diagnosis.gap.closed(validated=validated)
    gone = f"{100 * share:.0f} % of the gap closed; " if share is not None else ""
    where = f"RMS at joint {j + 1}{', on a log that was not fitted' if validated else ''}; {noise}"
    return question, f"{formatted(before[j])} → {formatted(after[j])} {unit}", gone + where


def _next(diagnosis: Diagnosis) -> tuple[str, str, str]:
    following = next_of(diagnosis)
    question = "What to record next"
    if not following:
        if diagnosis.verdict == "unexplained":
            return question, "See below", "a motion that narrows it down"
        return question, "Nothing more", "for these names" if claims(diagnosis) else "that these logs ask for"
    text = following[0]["text"]
    text = text.partition(": ")[2] or text
    if len(text) > _SHORT:
        text = f"{text[:_SHORT].rsplit(' ', 1)[0]} …"
    more = f" (and {len(following) - 1} more)" if len(following) > 1 else ""
    one = len(following) == 1
    return question, "One motion" if one else f"{len(following)} motions", text + more


def advice(
    diagnosis: Diagnosis, places: Sequence[Localised], travels: Sequence[Travel]
) -> list[dict[str, str]]:
    """What to record next where no name asks for it."""
    items = []
    if diagnosis.verdict == "unexplained":
        by_text: dict[str, list[int]] = {}
        for place in places:
            if place.shown and (place.share > _LOUD or place.left > 1):
                by_text.setdefault(place.best or "", []).append(place.joint)
        for best, joints in by_text.items():
            title = f"{joints_of(joints)}: {_shown(best or None)}"
            items.append({"title": capital(title), "text": _ADVICE.get(best, _NO_ADVICE)})
    lame = [t for t in travels if t.wants]
    if lame and diagnosis.verdict != "missing_effect":
        lacks: dict[str, list[int]] = {}
        for travel in lame:
            lacks.setdefault(travel.wants, []).append(travel.joint)
        text = "; ".join(f"{joints_of(joints)}: {wants}" for wants, joints in lacks.items())
        text = f"{capital(text)}. What is not excited cannot be seen."
        items.append({"title": "More motion", "text": text})
    return items


#: Lines on a terminal, and the width of the first; parameters in a line, joints that stand beside each other.
LINES, WIDTH = 18, 110
_PARAMETERS, _JOINTS = 3, 8


def summary(diagnosis: Diagnosis, report: str, *, validated: bool) -> list[str]:
    """The diagnosis in :data:`LINES` lines at most; ``report`` is where the page is, ``validated`` whether
    there was a log that was not fitted."""
    head = _head(diagnosis, validated)
    tail = _gap(diagnosis, validated)
    tail += _improvement(diagnosis, validated)
    if "one_body" in diagnosis.extra:
        tail.append(diagnosis.extra["one_body"])
    following = experiments(diagnosis)
    if following:
        more = f" (and {len(following) - 1} more)" if len(following) > 1 else ""
        tail.append(f"record next: {following[0]}{more}")
    notes = f"; {len(diagnosis.flags)} remarks on the data there" if len(diagnosis.flags) > 1 else ""
    notes = "; one remark on the data there" if len(diagnosis.flags) == 1 else notes
    tail.append(f"report: {report}{notes}")
    room = LINES - len(head) - len(tail)
    lines = [_line(k, findings) for k, findings in enumerate(_together(diagnosis), 1)]
    if len(lines) > room:
        lines = [*lines[: room - 1], f"and {len(lines) - room + 1} more in the report"]
    if any("(" in line and " to " in line for line in lines):
        tail[0] += "; brackets: 95 % intervals"
    return [_plain(line) for line in (*head, *lines, *tail)]


def _head(diagnosis: Diagnosis, validated: bool) -> list[str]:
    """The verdict: a line, and what does not fit into it beneath."""
    verdict = diagnosis.verdict.replace("_", " ")
    whole = f"{verdict}: {headline(diagnosis, validated=validated)}"
    if len(whole) <= WIDTH:
        return [whole]
    line, rest = in_a_line(diagnosis, validated=validated, room=WIDTH - len(verdict) - 2)
    return [f"{verdict}: {line}", *([rest] if rest else [])]


def _together(diagnosis: Diagnosis) -> list[list[Finding]]:
    """The findings, claims first; those of one effect at several joints together."""
    groups: dict[tuple[bool, str], list[Finding]] = {}
    for finding in sorted(diagnosis.findings, key=lambda f: f.confidence < CLAIM):
        groups.setdefault((finding.confidence < CLAIM, finding.effect), []).append(finding)
    return [sorted(group, key=lambda f: f.joint or 0) for group in groups.values()]


def _line(k: int, findings: Sequence[Finding]) -> str:
    """One finding with its numbers, or those of one effect at several joints with their first numbers."""
    first = findings[0]
    known = list(first.parameters.items())
    if len(findings) > 1:
        joints = [f.joint for f in findings if f.joint is not None]
        place = joints_of(joints)
        name, estimate = known[0] if known else ("", Estimate("", None, ""))
        values = [f.parameters[name].value for f in findings if name in f.parameters]
        figures = ", ".join(v if isinstance(v, str) else formatted(v) for v in values)
        unit = f" {estimate.unit}" if estimate.unit not in ("", "1") else ""
        shown, rest = [f"{name} {figures}{unit}"], len(known) - 1
    else:
        place = place_of(first.joint)
        identified = [(name, p) for name, p in known if not is_unseen(p, first.effect, name)]
        shown = [f"{name} {with_interval(p, first.effect, name)}" for name, p in identified][:_PARAMETERS]
        rest = len(known) - len(shown)
    if rest > 0:
        shown.append(f"{rest} more")
    least = min(f.confidence for f in findings)
    sure = f"{100 * least:.0f} % sure"
    if first.confidence < CLAIM:
        sure = f"a suspicion, {sure}"
    others = list(dict.fromkeys(rival for f in findings for rival in f.confounded_with))
    rivals = f"; or {', '.join(others)}" if others else ""
    return f"{k}. {first.effect}, {place}: {', '.join(shown) or 'no figures'}; {sure}{rivals}"


def _gap(diagnosis: Diagnosis, validated: bool) -> list[str]:
    """Before, after and noise by joint, of long arms where most is there."""
    before, after = chosen(diagnosis, validated)
    changed = diagnosis.verdict == "missing_effect" or "refitted" in diagnosis.extra
    log = "validation log" if validated else "logs that were fitted"
    size = times_noise(diagnosis, before)
    shown = sorted(sorted(range(diagnosis.robot.n), key=lambda j: (-float(size[j]), j))[:_JOINTS])
    rows = [("gap before" if changed else "gap", before), ("noise floor", diagnosis.gap.noise_floor)]
    if changed:
        rows.insert(1, ("gap after", after))
    cells = [[name, *(formatted(values[j]) for j in shown)] for name, values in rows]
    lines = aligned([["joint", *(str(j + 1) for j in shown)], *cells], left=(0,))
    most = f", {_JOINTS} of {diagnosis.robot.n} joints" if diagnosis.robot.n > _JOINTS else ""
    lines[0] += f"  ({units_of(diagnosis)}, RMS, {log}{most})"
    return lines


def _improvement(diagnosis: Diagnosis, validated: bool) -> list[str]:
    """How much of the gap is gone, and what the kernel costs, as a line; none where nothing was added."""
    if diagnosis.verdict != "missing_effect" and "refitted" not in diagnosis.extra:
        return []
    share = diagnosis.gap.closed(validated=validated)
    if is_touched_only(diagnosis):
        return ["contact is left out of the fit and not added to the model"]
    parts = [] if share is None else [f"{100 * share:.0f} % of the gap closed"]
    rest = still(diagnosis, validated)
    if rest:
        parts.append(f"left beyond the noise at {joints_of(rest, diagnosis.robot.n)}")
    old, new = diagnosis.operations
    if old or new:
        more = f" -> {new} operations ({new - old:+d})" if old != new else " operations, as before"
        parts.append(f"inverse dynamics {old}{more}")
    return ["; ".join(parts)] if parts else []


def _plain(line: str) -> str:
    """What a terminal prints as it stands."""
    return "".join(c if c.isprintable() else " " for c in line)
