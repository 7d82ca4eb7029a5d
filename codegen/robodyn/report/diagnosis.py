"""A diagnosis as a page: one HTML file without scripts that needs no network, the same bytes at any time. It
has the gap before and after joint by joint, and many findings in order, as a table and as cards."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np

from robodyn.diagnose.limits import CLAIM
from robodyn.diagnose.result import Diagnosis, Finding, Series, Window
from robodyn.draw.markup import markup_template
from robodyn.report import diagnosis_residual as residual
from robodyn.report import diagnosis_text as words
from robodyn.report.chart_frames import percent
from robodyn.report.diagnosis_findings import MOST_CARDS, across, cards, looks, next_of, part
from robodyn.report.diagnosis_headline import in_a_line
from robodyn.report.diagnosis_summary import advice, main_joint, tiles
from robodyn.report.figures import capital, formatted, several
from robodyn.version import VERSION

#: Joints that are drawn at most: those of findings, then those where most is left.
MOST_JOINTS: Final = 12
#: Dots and columns of all panels together.
_DOTS, _COLUMNS = 24_000, 10_000
_OVER: Final = ("velocity", "position", "load", "acceleration")
#: Lines of a difference, flags and candidates that are shown at most.
_DIFF_LINES, _FLAGS, _TRIED = 2000, 200, 40
_LOGS: Final = {"validate": "Validation log, not fitted", "train": "First log that was fitted"}
#: Kinds of operations, as people call them.
_KINDS: Final = {
    "mul": "multiplications", "add": "additions", "div": "divisions", "sqrt": "square roots",
    "neg": "negations", "sincos": "sines and cosines",
}  # fmt: skip


def page(diagnosis: Diagnosis, *, validated: bool) -> str:
    """The HTML of ``diagnosis``; ``validated``: the last of its logs was not fitted.

    Text of files and of the diagnosis is escaped; nothing in it depends on the time or the place.
    """
    places = residual.localised(diagnosis)
    travels = residual.travelled(diagnosis.robot, diagnosis.series[0]) if diagnosis.series else []
    windows = _windows(diagnosis)
    trained = [window for window in windows if window.name == "train"]
    finding_cards = cards(diagnosis, places, trained)
    line, lead = in_a_line(diagnosis, validated=validated)
    tables = [(_LOGS["validate"], *words.chosen(diagnosis, True))] if validated else []
    is_unexplained = diagnosis.verdict == "unexplained"
    series = diagnosis.series[::-1] if validated else diagnosis.series[:1]
    drawn = [one for one in series if len(one.times)]  # what proves most first
    shown = ("verdict", "robot", "words", "operations", "counts", "flags", "logs", "detectable")
    return markup_template("diagnosis.html.j2").render(
        **{name: getattr(diagnosis, name) for name in shown},
        verdict_words=diagnosis.verdict.replace("_", " "),
        headline=line,
        lead=lead,
        validated=validated,
        tiles=tiles(diagnosis, validated, places),
        torques=_torques(diagnosis, drawn[0], windows) if drawn else None,
        kinds=table_of_kinds(diagnosis),
        groups=by_joint(diagnosis, finding_cards, validated=validated),
        findings=finding_cards,
        more_findings=max(0, len(diagnosis.findings) - MOST_CARDS),
        looks=looks(diagnosis, main_joint(diagnosis, places), trained) if is_unexplained else [],
        is_changed=diagnosis.verdict == "missing_effect" and not words.is_touched_only(diagnosis),
        experiments=[*next_of(diagnosis), *advice(diagnosis, places, travels)],
        ladder=ladder(diagnosis, validated),
        tables=[*tables, ("Logs that were fitted", *words.chosen(diagnosis, False))],
        floor=diagnosis.gap.noise_floor,
        unit=words.units_of(diagnosis),
        places=places if any(place.shown for place in places) else [],
        quantities=residual.QUANTITIES,
        logs_drawn=_drawn(diagnosis, drawn, windows),
        tried=diagnosis.tried[:_TRIED],
        diff=_diff(diagnosis.diff),
        kinds_of_operations=_KINDS,
        travels=travels,
        units_at=lambda joint: words.units_at(diagnosis, joint - 1),
        within_limits=_within_limits,
        most_flags=_FLAGS,
        version=VERSION,
        change=change,
        formatted=formatted,
        part=part,
        place_of=words.place_of,
        title_of=words.title_of,
    )


def _windows(diagnosis: Diagnosis) -> list[Window]:
    """What is shaded: the given windows, else those of contacts that were found."""
    if diagnosis.windows:
        return list(diagnosis.windows)
    windows = []
    for f in diagnosis.findings:
        start, end = (f.parameters[k].value if k in f.parameters else None for k in ("start", "end"))
        if (
            words.is_contact(f.effect)
            and not isinstance(start, str | None)
            and not isinstance(end, str | None)
        ):
            windows.append(Window("train", start, end, "contact"))
    return windows


def _shown_joints(diagnosis: Diagnosis) -> list[int]:
    """Joints (from 0) that are drawn: those of findings, then those where most is left."""
    of_findings = {f.joint - 1 for f in diagnosis.findings if f.joint is not None}
    size = words.times_noise(diagnosis, diagnosis.gap.train_before)
    by_size = sorted(range(diagnosis.robot.n), key=lambda j: (j not in of_findings, -float(size[j]), j))
    return sorted(by_size[:MOST_JOINTS])


def _torques(diagnosis: Diagnosis, series: Series, windows: Sequence[Window]) -> dict[str, Any]:
    """Torques as logged and of the models, of the log that proves most."""
    joints = _shown_joints(diagnosis)
    own = [window for window in windows if window.name == series.name]
    columns = max(60, min(residual.COLUMNS, _COLUMNS // len(joints)))
    units = {j: words.units_at(diagnosis, j)["torque"] for j in joints}
    panels = [(j + 1, residual.torques(series, j, unit, own, columns=columns)) for j, unit in units.items()]
    return {"log": _LOGS.get(series.name, _LOGS["train"]).lower(), "panels": panels}


def _drawn(diagnosis: Diagnosis, drawn: Sequence[Series], windows: Sequence[Window]) -> list[dict[str, Any]]:
    """The logs as charts, the one that was not fitted first."""
    joints = _shown_joints(diagnosis)
    panels = max(1, 2 * len(joints) * len(drawn))
    dots = max(30, min(residual.DOTS, _DOTS // (panels * len(_OVER))))
    columns = max(60, min(residual.COLUMNS, _COLUMNS // panels))
    logs = []
    for series in drawn:
        own = [window for window in windows if window.name == series.name]
        rows = []
        for j in joints:
            units, floor = words.units_at(diagnosis, j), float(diagnosis.gap.noise_floor[j])
            unit, abscissas = units["torque"], [across(series, j, name, units) for name in _OVER]
            rows.append(
                {
                    "joint": j + 1,
                    "told": residual.range_text(series, j, unit),
                    "time": residual.over_time(series, j, unit, floor, own, columns=columns),
                    "over": [residual.over(series, j, x, unit, floor, dots=dots) for x in abscissas],
                }
            )
        logs.append(
            {
                "title": _LOGS.get(series.name, _LOGS["train"]),
                "left_out": diagnosis.robot.n - len(joints),
                "joints": rows,
                "shaded": sorted({window.what for window in own}),
            }
        )
    return logs


def _diff(text: str) -> list[tuple[str, str]]:
    """Lines of a unified diff with what each is."""
    lines, kinds = text.splitlines(), {"+": "added", "-": "gone"}
    shown = [
        ("hunk" if line.startswith(("---", "+++", "@@")) else kinds.get(line[:1], "same"), line)
        for line in lines[:_DIFF_LINES]
    ]
    if len(lines) > _DIFF_LINES:
        shown.append(("hunk", f"... and {len(lines) - _DIFF_LINES} lines more: model.yaml has them"))
    return shown


def _within_limits(travel: residual.Travel) -> tuple[str, str] | None:
    """Where in its limits a joint was: from what share on, and how much of them; None without any."""
    if travel.limits is None:
        return None
    low, high = min(travel.limits[0], travel.low), max(travel.limits[1], travel.high)
    wide = (high - low) or 1.0
    return part((travel.low - low) / wide), part((travel.high - travel.low) / wide)


# --- joint by joint ---------------------------------------------------------------------------------------

#: The scale reaches from below the noise to at least so many times it.
_LOW, _REACH = 0.7, 3.0
#: Effects that a row of a joint names at most.
_NAMED: Final = 3


def ladder(diagnosis: Diagnosis, validated: bool) -> dict[str, Any]:
    """Rows of joints: how many times the noise floor the gap was and is, on a logarithmic scale."""
    floor, (before, after) = diagnosis.gap.noise_floor, words.chosen(diagnosis, validated)
    logs = {"proof": (before, after)} | ({"fitted": words.chosen(diagnosis, False)} if validated else {})
    with np.errstate(all="ignore"):
        times = {kind: tuple(values / floor for values in pair) for kind, pair in logs.items()}
    every = np.concatenate([values for pair in times.values() for values in pair])
    top = max(_REACH, 1.15 * float(every[np.isfinite(every)].max(initial=0.0)))

    def at(value: float) -> float:
        return 100 * math.log(min(max(value, _LOW), top) / _LOW) / math.log(top / _LOW)

    rows = []
    for j in range(diagnosis.robot.n):
        drawn = []
        for kind, (a, b) in times.items():
            if math.isfinite(a[j]) and math.isfinite(b[j]):
                old, new = at(float(a[j])), at(float(b[j]))
                drawn.append(
                    {
                        "kind": kind, "is_same": bool(a[j] == b[j]), "before": percent(old),
                        "after": percent(new), "low": percent(min(old, new)), "high": percent(max(old, new)),
                    }
                )  # fmt: skip
        names = [words.named(f.effect) for f in words.claims(diagnosis) if f.joint == j + 1]
        more = f" and {len(names) - _NAMED} more" if len(names) > _NAMED else ""
        figures = {"before": before[j], "after": after[j], "floor": floor[j]}
        effects, unit = ", ".join(names[:_NAMED]) + more, words.units_at(diagnosis, j)["torque"]
        rows.append({"effects": effects, "drawn": drawn, "unit": unit, **figures})
    wide = math.log10(top / _LOW)
    steps = (1, 2, 3, 4, 6) if wide < 1 else (1, 2, 5) if wide < 1.7 else (1,)
    marks = [m * 10.0**k for k in range(math.ceil(math.log10(top)) + 1) for m in steps]
    ticks = [{"at": percent(at(v)), "label": f"{v:g}×"} for v in marks if v <= top]
    return {"rows": rows, "ticks": ticks[:: -(-len(ticks) // 6) or 1], "noise": percent(at(1.0))}


def change(before: float, after: float) -> str:
    """A change in percent."""
    if not before > 0 or not math.isfinite(after / before):
        return "n/a"
    rounded = round(100 * (after / before - 1))
    return f"{rounded:+d} %".replace("-", "−") if rounded else "0 %"


#: So many claims stand one below the other, open; more are folded, by joint, below a table of all findings.
FEW: Final = 3


def table_of_kinds(diagnosis: Diagnosis) -> dict[str, Any] | None:
    """Joints down, kinds of effects and effects across, with the first number of each finding; None of a few
    claims."""
    findings = diagnosis.findings
    if len(words.claims(diagnosis)) <= FEW:
        return None
    kinds = [
        list(dict.fromkeys(f.effect for f in some))
        for some in sorted(words.by_kind(findings), key=lambda some: -len(some))
    ]
    return {
        "kinds": [
            {"title": words.kind_of(ids[0]), "effects": list(map(words.title_of, ids))}
            if len(ids) > 1
            else {"title": words.title_of(ids[0]), "effects": []}
            for ids in kinds
        ],
        "is_deep": any(len(ids) > 1 for ids in kinds),
        "rows": [
            {
                "place": capital(words.place_of(joint)),
                "id": _anchor(joint),
                "cells": [
                    {
                        "label": words.title_of(effect),
                        "entries": [_entry(f) for f in findings if (f.joint, f.effect) == (joint, effect)],
                    }
                    for ids in kinds
                    for effect in ids
                ],
            }
            for joint in _joints(findings)
        ],
    }


def by_joint(
    diagnosis: Diagnosis, cards: Sequence[Mapping[str, Any]], *, validated: bool
) -> list[dict[str, Any]]:
    """The ``cards`` of each joint together, from the base to the tip, those of the whole robot last; empty of
    a few claims."""
    if len(words.claims(diagnosis)) <= FEW:
        return []
    before, after = words.chosen(diagnosis, validated)
    groups = []
    for joint in _joints(diagnosis.findings):
        group = [card for card in cards if card["joint"] == joint]
        if group:
            remark = several(len(group), "finding")
            if joint is not None:
                unit = words.units_at(diagnosis, joint - 1)["torque"]
                figures = f"{formatted(before[joint - 1])} → {formatted(after[joint - 1])} {unit}"
                remark = f"{remark}; RMS of the residual {figures}"
            title = capital(words.place_of(joint))
            groups.append({"id": _anchor(joint), "title": title, "remark": remark, "cards": group})
    return groups


def _anchor(joint: int | None) -> str:
    """Where on the page the findings of a joint are."""
    return "robot" if joint is None else f"joint-{joint}"


def _joints(findings: Sequence[Finding]) -> list[int | None]:
    return sorted({f.joint for f in findings}, key=lambda joint: math.inf if joint is None else joint)


def _entry(finding: Finding) -> dict[str, Any]:
    """A finding in a cell: its first number that was fitted, how sure it is."""
    seen = words.identified(finding)
    fitted = {name: p for name, p in seen.items() if p.stderr or p.bounds} or seen
    texts = [words.value_text(p, finding.effect, name) for name, p in fitted.items()]
    text = [*texts, "not identifiable"][0]
    if words.is_contact(finding.effect):
        text = " ".join(words.touched_at(finding)).strip()
    sure = f"{100 * finding.confidence:.0f} %"
    return {"text": text.replace("^2", "²"), "is_claim": finding.confidence >= CLAIM, "sure": sure}
