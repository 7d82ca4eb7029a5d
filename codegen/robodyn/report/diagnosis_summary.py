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
from robodyn.draw.tables import aligned
from robodyn.report import diagnosis_text as words
from robodyn.report.diagnosis_findings import next_of
from robodyn.report.diagnosis_headline import headline, in_a_line
from robodyn.report.diagnosis_residual import Localised, Travel
from robodyn.report.figures import capital, formatted, printable

_SWEEP: Final = "Constant speeds from slow to fast, both ways, one joint at a time."
#: What to record when nothing can be named, by the quantity that shows the residual best.
_ADVICE: Final = {
    "a short time": "The same motion again. What comes back at the same place belongs to the arm; what "
    "does not is contact, a cable, temperature or the sensor.",
    "direction": _SWEEP,
    "velocity": _SWEEP,
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
    None: "no single quantity shows it",
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
    old, new = diagnosis.operations
    cost = (f"{old} → {new}", f" ({new - old:+d})") if new != old else (f"{old}", "")
    text = f"operations of one call of the inverse dynamics{cost[1]}"
    return [
        ("What is missing", *_missing(diagnosis, validated)),
        _where(diagnosis, places),
        ("How sure", *_sure(diagnosis)),
        _better(diagnosis, validated, places),
        *([("Cost of the kernel", cost[0], text)] if old or new else []),
        ("What to record next", *_next(diagnosis)),
    ]


def main_joint(diagnosis: Diagnosis, places: Sequence[Localised]) -> Localised:
    """The joint that matters most: where nothing explains it, that of the headline."""
    worst = words.worst_joint(diagnosis.left) if diagnosis.verdict == "unexplained" else None
    return max(places, key=lambda p: p.share) if worst is None else places[worst - 1]


def _missing(diagnosis: Diagnosis, validated: bool) -> tuple[str, str]:
    lacking = words.claims(diagnosis)
    if diagnosis.verdict == "consistent":
        return "Nothing", "no effect is worth adding"
    if words.is_touched_only(diagnosis):
        return "Nothing", "but something outside touched the arm"
    if diagnosis.verdict == "unexplained" and "stands" in diagnosis.extra:
        return "Not observed", "no joint moves in these logs"
    if diagnosis.verdict == "unexplained" or not lacking:
        return "Something", "that no effect of the catalogue explains"
    noisy = words.joints_above_noise(diagnosis, validated)
    where = words.joints_of(noisy, diagnosis.robot.n)
    more = [f"something at {where} that this does not explain"] if noisy else []
    counted = Counter(f.effect for f in lacking)
    if len(counted) > _FEW:
        names = [
            f"{words.named(id)} ({count})" if count > 1 else words.named(id)
            for id, count in counted.most_common()
        ]
        return f"{len(lacking)} effects of {len(counted)} kinds", "; ".join([words.listed(names), *more])
    first, *others = counted
    rest = [*map(words.named, others), *more]
    return words.title_of(first), f"and {words.listed(rest)}" if rest else "and nothing else"


def _where(diagnosis: Diagnosis, places: Sequence[Localised]) -> tuple[str, str, str]:
    top, lacking = main_joint(diagnosis, places), words.claims(diagnosis)
    share = f"{100 * top.share:.0f} % of the excess is at joint {top.joint}"
    if diagnosis.verdict == "consistent":
        return "At which joint", "None", share if top.shown else "no joint stands out of its noise"
    if words.is_touched_only(diagnosis):
        where, when = words.touched_at(lacking[0])
        return "Where and when", capital(where), when or share
    if diagnosis.verdict == "unexplained":
        answer = "not observed" if "stands" in diagnosis.extra else f"joint {top.joint}"
        if math.isfinite(top.left) and top.left > 1:
            share = f"{formatted(top.left)} times what would matter is left there"
    else:
        joints = sorted({f.joint for f in lacking if f.joint is not None})
        whole = ["the whole robot"] if any(f.joint is None for f in lacking) else []
        answer = words.listed([*([words.joints_of(joints)] if joints else []), *whole])
    return "At which joint", capital(answer), f"{share}; {_shown(top.best)}"


def _shown(name: str | None) -> str:
    """What shows a residual best, as a clause."""
    return _CLAUSES.get(name) or f"seen best over the {name}"


def _sure(diagnosis: Diagnosis) -> tuple[str, str]:
    lacking, count, detectable = words.claims(diagnosis), len(diagnosis.findings), diagnosis.detectable
    if diagnosis.verdict == "missing_effect" and lacking:
        rivals = list(dict.fromkeys(words.named(rival) for f in lacking for rival in f.confounded_with))
        text = f"not told from {words.listed(rivals)}" if rivals else "no rival is left"
        several = "the least sure of the names; " if len(lacking) > 1 else ""
        return f"{100 * min(f.confidence for f in lacking):.0f} %", several + text
    if diagnosis.verdict == "unexplained":
        one = "one suspicion, which did not hold" if count else "no name reaches 50 %"
        return "No name", f"{count} suspicions, none held" if count > 1 else one
    if detectable is not None and np.isfinite(detectable).any():
        j = int(np.nanargmax(detectable))
        size = f"{formatted(detectable[j])} {words.units_at(diagnosis, j)['torque']}"
        return f"down to {size}", f"RMS at joint {j + 1}: anything larger would be worth a name"
    return "As far as the motion goes", "what it does not excite it cannot show: see below"


def _better(diagnosis: Diagnosis, validated: bool, places: Sequence[Localised]) -> tuple[str, str, str]:
    before, after = words.chosen(diagnosis, validated)
    # Where most of the gap was, in units of the noise.
    j = main_joint(diagnosis, places).joint - 1
    if diagnosis.verdict != "unexplained":
        size = words.times_noise(diagnosis, before, unknown=-1.0)
        joints = [f.joint - 1 for f in words.claims(diagnosis) if f.joint is not None]
        j = max(joints or range(diagnosis.robot.n), key=lambda j: float(size[j]))
    unit, floor = words.units_at(diagnosis, j)["torque"], diagnosis.gap.noise_floor[j]
    if diagnosis.verdict != "missing_effect" or words.is_touched_only(diagnosis):
        times = before[j] / floor if floor > 0 else math.nan
        touched = "; contact is not added to a model" if diagnosis.verdict == "missing_effect" else ""
        text = f"RMS at joint {j + 1}, {formatted(times)} times its noise{touched}"
        return "How much is left", f"{formatted(before[j])} {unit}", text
    share = diagnosis.gap.closed(validated=validated)
    closed = f"{100 * share:.0f} % of the gap closed; " if share is not None else ""
    log = ", on a log that was not fitted" if validated else ""
    remark = f"{closed}RMS at joint {j + 1}{log}; noise floor {formatted(floor)}"
    question = f"How much better{'' if validated else ' (on the logs fitted)'}"
    return question, f"{formatted(before[j])} → {formatted(after[j])} {unit}", remark


def _next(diagnosis: Diagnosis) -> tuple[str, str]:
    steps = next_of(diagnosis)
    if not steps and diagnosis.verdict == "unexplained":
        return "See below", "a motion that narrows it down"
    if not steps:
        return "Nothing more", "for these names" if words.claims(diagnosis) else "that these logs ask for"
    text = steps[0]["text"]
    text = text.partition(": ")[2] or text
    if len(text) > _SHORT:
        text = f"{text[:_SHORT].rsplit(' ', 1)[0]} …"
    if len(steps) == 1:
        return "One motion", text
    return f"{len(steps)} motions", f"{text} (and {len(steps) - 1} more)"


def advice(
    diagnosis: Diagnosis, places: Sequence[Localised], travels: Sequence[Travel]
) -> list[dict[str, str]]:
    """What to record next where no name asks for it."""
    items = []
    if diagnosis.verdict == "unexplained":
        by_quantity: dict[str | None, list[int]] = {}
        for place in places:
            if place.shown and (place.share > _LOUD or place.left > 1):
                by_quantity.setdefault(place.best, []).append(place.joint)
        for best, joints in by_quantity.items():
            title = f"{words.joints_of(joints)}: {_shown(best)}"
            items.append({"title": capital(title), "text": _ADVICE.get(best or "", _NO_ADVICE)})
    lacks: dict[str, list[int]] = {}
    for travel in travels:
        if travel.wants:
            lacks.setdefault(travel.wants, []).append(travel.joint)
    if lacks and diagnosis.verdict != "missing_effect":
        text = "; ".join(f"{words.joints_of(joints)}: {wants}" for wants, joints in lacks.items())
        items.append(
            {"title": "More motion", "text": f"{capital(text)}. What is not excited cannot be seen."}
        )
    return items


#: Lines on a terminal, and the width of the first; parameters in a line, joints that stand beside each other.
LINES, WIDTH = 18, 110
_PARAMETERS, _JOINTS = 3, 8


def summary(diagnosis: Diagnosis, report: str, *, validated: bool) -> list[str]:
    """The diagnosis in :data:`LINES` lines at most; ``report`` is where the page is, ``validated`` whether
    there was a log that was not fitted."""
    verdict = diagnosis.verdict.replace("_", " ")
    head = [f"{verdict}: {headline(diagnosis, validated=validated)}"]
    if len(head[0]) > WIDTH:  # what does not fit into a line stands beneath it
        line, rest = in_a_line(diagnosis, validated=validated, room=WIDTH - len(verdict) - 2)
        head = [f"{verdict}: {line}", *([rest] if rest else [])]
    tail = [*_gap(diagnosis, validated), *_improvement(diagnosis, validated)]
    if "one_body" in diagnosis.extra:
        tail.append(diagnosis.extra["one_body"])
    steps = [f.experiment for f in diagnosis.findings if f.experiment]
    is_sure = diagnosis.verdict == "missing_effect" and all(f.confidence >= CLAIM for f in diagnosis.findings)
    if diagnosis.record and not is_sure:
        steps.append(diagnosis.record)
    steps = list(dict.fromkeys(steps))
    if steps:
        more = f" (and {len(steps) - 1} more)" if len(steps) > 1 else ""
        tail.append(f"record next: {steps[0]}{more}")
    flags = len(diagnosis.flags)
    remarks = f"{flags} remarks" if flags > 1 else "one remark"
    tail.append(f"report: {report}{f'; {remarks} on the data there' if flags else ''}")
    room = LINES - len(head) - len(tail)
    groups: dict[tuple[bool, str], list[Finding]] = {}  # words.claims first; of one effect together
    for finding in sorted(diagnosis.findings, key=lambda f: f.confidence < CLAIM):
        groups.setdefault((finding.confidence < CLAIM, finding.effect), []).append(finding)
    lines = [f"{k}. {_finding_line(findings)}" for k, findings in enumerate(groups.values(), 1)]
    if len(lines) > room:
        lines = [*lines[: room - 1], f"and {len(lines) - room + 1} more in the report"]
    if any("(" in line and " to " in line for line in lines):
        tail[0] += "; brackets: 95 % intervals"
    return [printable(line) for line in (*head, *lines, *tail)]


def _finding_line(findings: Sequence[Finding]) -> str:
    """One finding with its numbers, or those of one effect at several joints with their first numbers."""
    findings = sorted(findings, key=lambda f: f.joint or 0)
    first = findings[0]
    if len(findings) > 1:
        place = words.joints_of([f.joint for f in findings if f.joint is not None])
        name, estimate = next(iter(first.parameters.items()), ("", Estimate("", None, "")))
        values = [f.parameters[name].value for f in findings if name in f.parameters]
        figures = ", ".join(v if isinstance(v, str) else formatted(v) for v in values)
        unit = f" {estimate.unit}" if estimate.unit not in ("", "1") else ""
        shown = [f"{name} {figures}{unit}"]
    else:
        place = words.place_of(first.joint)
        shown = [
            f"{name} {words.with_interval(p, first.effect, name)}"
            for name, p in words.identified(first).items()
        ]
        shown = shown[:_PARAMETERS]
    rest = len(first.parameters) - len(shown)
    shown += [f"{rest} more"] if rest > 0 else []
    suspicion = "a suspicion, " if first.confidence < CLAIM else ""
    sure = f"{suspicion}{100 * min(f.confidence for f in findings):.0f} % sure"
    rivals = ", ".join(dict.fromkeys(rival for f in findings for rival in f.confounded_with))
    text = f"{first.effect}, {place}: {', '.join(shown) or 'no figures'}; {sure}"
    return f"{text}; or {rivals}" if rivals else text


def _gap(diagnosis: Diagnosis, validated: bool) -> list[str]:
    """Before, after and noise by joint, of long arms where most is there."""
    before, after = words.chosen(diagnosis, validated)
    n, size = diagnosis.robot.n, words.times_noise(diagnosis, before)
    shown = sorted(sorted(range(n), key=lambda j: (-float(size[j]), j))[:_JOINTS])
    rows = {"gap": before}
    if diagnosis.verdict == "missing_effect" or "refitted" in diagnosis.extra:
        rows = {"gap before": before, "gap after": after}
    cells = [[name, *(formatted(values[j]) for j in shown)] for name, values in rows.items()]
    cells.append(["noise floor", *(formatted(diagnosis.gap.noise_floor[j]) for j in shown)])
    lines = aligned([["joint", *(str(j + 1) for j in shown)], *cells], left=(0,))
    most = f", {_JOINTS} of {n} joints" if n > _JOINTS else ""
    log = "validation log" if validated else "logs that were fitted"
    return [f"{lines[0]}  ({words.units_of(diagnosis)}, RMS, {log}{most})", *lines[1:]]


def _improvement(diagnosis: Diagnosis, validated: bool) -> list[str]:
    """How much of the gap is gone, and what the kernel costs, as a line; none where nothing was added."""
    if diagnosis.verdict != "missing_effect" and "refitted" not in diagnosis.extra:
        return []
    if words.is_touched_only(diagnosis):
        return ["contact is left out of the fit and not added to the model"]
    share = diagnosis.gap.closed(validated=validated)
    parts = [] if share is None else [f"{100 * share:.0f} % of the gap closed"]
    noisy = words.joints_above_noise(diagnosis, validated)
    parts += [f"left beyond the noise at {words.joints_of(noisy, diagnosis.robot.n)}"] if noisy else []
    old, new = diagnosis.operations
    if old or new:
        more = f" -> {new} operations ({new - old:+d})" if old != new else " operations, as before"
        parts.append(f"inverse dynamics {old}{more}")
    return ["; ".join(parts)] if parts else []
