"""A diagnosis as a page: one HTML file without scripts that needs no network, the same bytes at any time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

from robodyn.diagnose.result import Diagnosis, Series, Window
from robodyn.draw.markup import markup_template
from robodyn.report import diagnosis_residual as residual
from robodyn.report import diagnosis_text as words
from robodyn.report.diagnosis_findings import MOST_CARDS, across, cards, looks, next_of, part
from robodyn.report.diagnosis_headline import in_a_line
from robodyn.report.diagnosis_joints import by_joint, change, ladder, table_of_kinds
from robodyn.report.diagnosis_summary import advice, main_joint, tiles
from robodyn.report.figures import formatted
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
