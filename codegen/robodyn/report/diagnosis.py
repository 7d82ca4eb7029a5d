"""A diagnosis as a page: one HTML file without scripts that needs no network, the same bytes at any time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

from robodyn.diagnose.result import Diagnosis, Series, Window
from robodyn.draw.markup import markup_template
from robodyn.report.diagnosis_charts import COLUMNS, DOTS, over, over_time, range_text, torques
from robodyn.report.diagnosis_findings import MOST_CARDS, across, cards, looks, next_of, part
from robodyn.report.diagnosis_headline import in_a_line
from robodyn.report.diagnosis_joints import by_joint, change, ladder, table_of_kinds, tables, units_at
from robodyn.report.diagnosis_summary import advice, main_joint, tiles
from robodyn.report.diagnosis_text import (
    is_contact,
    is_touched_only,
    place_of,
    times_noise,
    title_of,
    units_of,
)
from robodyn.report.diagnosis_where import QUANTITIES, Travel, localised, travelled
from robodyn.report.figures import formatted

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
    from importlib.metadata import version

    places = localised(diagnosis)
    travels = travelled(diagnosis.robot, diagnosis.series[0]) if diagnosis.series else []
    windows = _windows(diagnosis)
    trained = [window for window in windows if window.name == "train"]
    experiments, finding_cards = next_of(diagnosis), cards(diagnosis, places, trained)
    line, lead = in_a_line(diagnosis, validated=validated)
    return markup_template("diagnosis.html.j2").render(
        robot=diagnosis.robot,
        verdict=diagnosis.verdict,
        verdict_words=diagnosis.verdict.replace("_", " "),
        headline=line,
        lead=lead,
        words=diagnosis.words,
        validated=validated,
        tiles=tiles(diagnosis, validated, places),
        torques=_torques(diagnosis, validated, windows),
        kinds=table_of_kinds(diagnosis),
        groups=by_joint(diagnosis, finding_cards, validated=validated),
        findings=finding_cards,
        more_findings=max(0, len(diagnosis.findings) - MOST_CARDS),
        looks=looks(diagnosis, main_joint(diagnosis, places), trained)
        if diagnosis.verdict == "unexplained"
        else [],
        is_changed=diagnosis.verdict == "missing_effect" and not is_touched_only(diagnosis),
        experiments=[*experiments, *advice(diagnosis, places, travels)],
        ladder=ladder(diagnosis, validated),
        tables=tables(diagnosis, validated),
        floor=diagnosis.gap.noise_floor,
        unit=units_of(diagnosis),
        places=places if any(place.shown for place in places) else [],
        quantities=QUANTITIES,
        logs_drawn=_drawn(diagnosis, validated, windows),
        tried=diagnosis.tried[:_TRIED],
        diff=_diff(diagnosis.diff),
        operations=diagnosis.operations,
        counts=diagnosis.counts,
        kinds_of_operations=_KINDS,
        travels=[_travel(diagnosis, travel) for travel in travels],
        detectable=diagnosis.detectable is not None,
        flags=diagnosis.flags[:_FLAGS],
        more_flags=max(0, len(diagnosis.flags) - _FLAGS),
        logs=diagnosis.logs,
        version=version("robodyn"),
        change=change,
        formatted=formatted,
        part=part,
        place_of=place_of,
        title_of=title_of,
    )


def _windows(diagnosis: Diagnosis) -> list[Window]:
    """What is shaded: the given windows, else those of contacts that were found."""
    if diagnosis.windows:
        return list(diagnosis.windows)
    windows = []
    for f in diagnosis.findings:
        start, end = (f.parameters[k].value if k in f.parameters else None for k in ("start", "end"))
        if is_contact(f.effect) and not isinstance(start, str | None) and not isinstance(end, str | None):
            windows.append(Window("train", start, end, "contact"))
    return windows


# --- the residual -----------------------------------------------------------------------------------------


def _drawn(diagnosis: Diagnosis, validated: bool, windows: Sequence[Window]) -> list[dict[str, Any]]:
    """The logs as charts, the one that was not fitted first."""
    series, joints = _series(diagnosis, validated), _shown_joints(diagnosis)
    panels = max(1, 2 * len(joints) * len(series))
    dots = max(30, min(DOTS, _DOTS // (panels * len(_OVER))))
    columns = max(60, min(COLUMNS, _COLUMNS // panels))
    return [
        {
            "title": _LOGS.get(one.name, _LOGS["train"]),
            "is_open": k == 0,
            "left_out": diagnosis.robot.n - len(joints),
            "joints": [
                _joint(diagnosis, one, j, [w for w in windows if w.name == one.name], dots, columns)
                for j in joints
            ],
            "shaded": sorted({w.what for w in windows if w.name == one.name}),
        }
        for k, one in enumerate(series)
    ]


def _series(diagnosis: Diagnosis, validated: bool) -> list[Series]:
    """The logs that are drawn, the one that proves most first."""
    series = diagnosis.series[::-1] if validated else diagnosis.series[:1]
    return [one for one in series if len(one.times)]


def _shown_joints(diagnosis: Diagnosis) -> list[int]:
    """Joints (from 0) that are drawn: those of findings, then those where most is left."""
    named = {f.joint - 1 for f in diagnosis.findings if f.joint is not None}
    size = times_noise(diagnosis, diagnosis.gap.train_before)
    by_size = sorted(range(diagnosis.robot.n), key=lambda j: (j not in named, -float(size[j]), j))
    return sorted(by_size[:MOST_JOINTS])


def _torques(diagnosis: Diagnosis, validated: bool, windows: Sequence[Window]) -> dict[str, Any] | None:
    """Torques as logged and of the models, of the log that proves most."""
    drawn = _series(diagnosis, validated)[:1]
    if not drawn:
        return None
    (one,) = drawn
    joints = _shown_joints(diagnosis)
    own = [w for w in windows if w.name == one.name]
    columns = max(60, min(COLUMNS, _COLUMNS // len(joints)))
    return {
        "log": _LOGS.get(one.name, _LOGS["train"]).lower(),
        "panels": [
            (j + 1, torques(one, j, units_at(diagnosis, j)["torque"], own, columns=columns)) for j in joints
        ],
    }


def _joint(
    diagnosis: Diagnosis, one: Series, j: int, windows: Sequence[Window], dots: int, columns: int
) -> dict[str, Any]:
    units, floor = units_at(diagnosis, j), float(diagnosis.gap.noise_floor[j])
    return {
        "joint": j + 1,
        "told": range_text(one, j, units["torque"]),
        "time": over_time(one, j, units["torque"], floor, windows, columns=columns),
        "over": [
            over(one, j, across(one, j, name, units), units["torque"], floor, dots=dots) for name in _OVER
        ],
    }


# --- the model and the logs -------------------------------------------------------------------------------


def _diff(text: str) -> list[tuple[str, str]]:
    """Lines of a unified diff with what each is."""
    lines = text.splitlines()
    shown = [(_kind(line), line) for line in lines[:_DIFF_LINES]]
    if len(lines) > _DIFF_LINES:
        shown.append(("hunk", f"... and {len(lines) - _DIFF_LINES} lines more: model.yaml has them"))
    return shown


def _kind(line: str) -> str:
    if line.startswith(("---", "+++", "@@")):
        return "hunk"
    return {"+": "added", "-": "gone"}.get(line[:1], "same")


def _travel(diagnosis: Diagnosis, travel: Travel) -> dict[str, Any]:
    units = units_at(diagnosis, travel.joint - 1)
    low, high = travel.limits or (travel.low, travel.high)
    low, high = min(low, travel.low), max(high, travel.high)
    wide = (high - low) or 1.0
    detectable = diagnosis.detectable
    return {
        "joint": travel.joint,
        "q": f"{formatted(travel.low)} to {formatted(travel.high)} {units['position']}",
        "has_limits": travel.limits is not None,
        "at": part((travel.low - low) / wide),
        "width": part((travel.high - travel.low) / wide),
        "speed": f"{formatted(travel.speed)} {units['velocity']}",
        "of_top": f"{100 * travel.speed / travel.top:.0f} %" if travel.top else "",
        "reversals": travel.reversals,
        "load": f"{formatted(travel.load[0])} to {formatted(travel.load[1])} {units['torque']}",
        "wants": travel.wants,
        "seen": f"{formatted(detectable[travel.joint - 1])} {units['torque']}"
        if detectable is not None
        else "",
    }
