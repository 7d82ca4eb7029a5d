"""A diagnosis as a page: one HTML file without scripts that needs no network, the same bytes at any time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.result import Diagnosis, Estimate, Finding, Series
from robodyn.report.diagnosis_charts import COLUMNS, DOTS, Chart, joint_bars, over, over_time
from robodyn.report.diagnosis_text import (
    VERDICTS,
    claims,
    closed,
    experiments,
    headline,
    number,
    place_of,
    title_of,
    with_error,
)
from robodyn.resources import data_dir

if TYPE_CHECKING:
    import jinja2

Floats = NDArray[np.float64]

#: Joints that are drawn at most: those of findings, then those where most is left.
MOST_JOINTS: Final = 12
#: Dots and columns of all panels together.
_DOTS, _COLUMNS = 48_000, 12_000
_UNITS: Final = {
    "revolute": {"q": "rad", "qd": "rad/s", "qdd": "rad/s²", "tau": "N m"},
    "prismatic": {"q": "m", "qd": "m/s", "qdd": "m/s²", "tau": "N"},
}
_QUANTITIES: Final = (("velocity", "qd"), ("position", "q"), ("load", "load"), ("acceleration", "qdd"))
#: Half the width of an interval that holds the value in 95 of 100 cases, in standard errors.
_HALF: Final = 1.96
#: An interval is drawn from 0 to this many times the value.
_REACH: Final = 2.0
#: Lines of a difference that are shown at most.
_DIFF_LINES: Final = 2000


def page(found: Diagnosis, *, validated: bool) -> str:
    """The HTML of ``found``; ``validated``: the last of its logs was not fitted.

    Text of files and of the diagnosis is escaped; nothing in it depends on the time or the place.
    """
    from importlib.metadata import version

    gap = found.gap
    before, after = (
        (gap.validate_before, gap.validate_after) if validated else (gap.train_before, gap.train_after)
    )
    share = closed(before, after, gap.noise_floor)
    return _template().render(
        robot=found.robot,
        verdict=found.verdict,
        verdict_words=VERDICTS[found.verdict],
        headline=headline(found),
        words=found.words,
        validated=validated,
        closed=None if share is None or found.verdict != "missing_effect" else f"{100 * share:.0f} %",
        claims=len(claims(found)),
        findings=[_finding(finding) for finding in found.findings],
        experiments=experiments(found),
        gaps=_gaps(found, validated),
        floor=[number(x) for x in gap.noise_floor],
        logs_drawn=_drawn(found, validated),
        left=_left(found.left),
        evidence=[_evidence(finding) for finding in found.findings if finding.rivals],
        diff=_diff(found.diff),
        operations=found.operations,
        flags=found.flags,
        logs=_logs(found, validated),
        version=version("robodyn"),
    )


@cache
def _template() -> jinja2.Template:
    import jinja2

    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(data_dir("templates")),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=True,
    )
    return environment.get_template("report/diagnosis.html.j2")


# --- findings ---------------------------------------------------------------------------------------------


def _finding(finding: Finding) -> dict[str, Any]:
    return {
        "effect": finding.effect,
        "title": title_of(finding.effect),
        "place": place_of(finding.joint),
        "confidence": f"{100 * finding.confidence:.0f} %",
        "sure": _part(finding.confidence),
        "is_claim": finding.confidence >= 0.5,
        "rivals": finding.confounded_with,
        "where": finding.where,
        "experiment": finding.experiment,
        "parameters": [_parameter(name, estimate) for name, estimate in finding.parameters.items()],
    }


def _parameter(name: str, estimate: Estimate) -> dict[str, Any]:
    """A parameter with its interval, which is drawn beside zero: as shares of the value."""
    value, error = estimate.value, estimate.stderr
    drawn = None
    words = ""
    if isinstance(value, float | int) and error is not None and math.isfinite(value) and math.isfinite(error):
        low, high = value - _HALF * error, value + _HALF * error
        words = f"{low:.4g} to {high:.4g}"
        if value:
            scale = 100 / (2 * _REACH)
            half = _HALF * error / abs(value)
            ends = [
                max(0.0, min(100.0, scale * (_REACH + math.copysign(1, value) * (1 + way * half))))
                for way in (-1, 1)
            ]
            drawn = {
                "low": f"{min(ends):.1f}",
                "width": f"{max(abs(ends[1] - ends[0]), 0.6):.1f}",
                "value": f"{scale * (_REACH + math.copysign(1, value)):.1f}",
            }
    return {
        "name": name,
        "text": with_error(estimate, "±").replace("^2", "²"),
        "words": words,
        "drawn": drawn,
    }


def _part(share: float) -> str:
    """A share as the width of a bar, 0 to 100."""
    return f"{100 * min(max(share, 0.0), 1.0):.1f}" if math.isfinite(share) else "0"


def _evidence(finding: Finding) -> dict[str, Any]:
    rows = [
        (finding.effect, finding.joint, finding.gain),
        *((r.effect, r.joint, r.gain) for r in finding.rivals),
    ]
    top = max((gain for _, _, gain in rows if math.isfinite(gain)), default=0.0)
    return {
        "title": title_of(finding.effect),
        "place": place_of(finding.joint),
        "rows": [
            {
                "title": title_of(effect),
                "effect": effect,
                "place": place_of(joint),
                "gain": f"{gain:,.0f}" if 1e3 <= abs(gain) < 1e12 else number(gain),
                "width": _part(gain / top if top > 0 else 0.0),
                "is_named": k == 0,
                "is_open": k > 0 and effect in finding.confounded_with,
            }
            for k, (effect, joint, gain) in enumerate(rows)
        ],
    }


# --- what is left -----------------------------------------------------------------------------------------


def _gaps(found: Diagnosis, validated: bool) -> list[dict[str, Any]]:
    gap = found.gap
    kinds = {link.joint.kind for link in found.robot.links}
    unit = " or ".join(sorted(_UNITS[kind]["tau"] for kind in kinds))
    pairs = [("Logs that were fitted", gap.train_before, gap.train_after)]
    if validated:
        pairs.append(("Validation log, not fitted", gap.validate_before, gap.validate_after))
    return [
        {
            "title": title,
            "unit": unit,
            "chart": joint_bars(title, before, after, gap.noise_floor, unit),
            "rows": [
                {
                    "joint": j + 1,
                    "before": number(b),
                    "after": number(a),
                    "floor": number(f),
                    "change": _change(b, a),
                }
                for j, (b, a, f) in enumerate(
                    zip(before.tolist(), after.tolist(), gap.noise_floor.tolist(), strict=True)
                )
            ],
        }
        for title, before, after in pairs
    ]


def _change(before: float, after: float) -> str:
    if not before > 0 or not math.isfinite(after / before):
        return "n/a"
    percent = round(100 * (after / before - 1))
    return f"{percent:+d} %" if percent else "0 %"


def _left(left: Floats) -> list[dict[str, Any]]:
    return [{"joint": j + 1, "share": number(x), "width": _part(x)} for j, x in enumerate(left.tolist())]


def _drawn(found: Diagnosis, validated: bool) -> list[dict[str, Any]]:
    """The logs as charts: of each the joints, and which of them are shown at once."""
    series = found.series if validated else found.series[:1]
    named = {f.joint - 1 for f in found.findings if f.joint is not None}
    with np.errstate(all="ignore"):
        size = np.nan_to_num(found.gap.train_before / found.gap.noise_floor, nan=0.0, posinf=0.0)
    by_size = sorted(range(found.robot.n), key=lambda j: (j not in named, -float(size[j]), j))
    joints = sorted(by_size[:MOST_JOINTS])
    opened = named or set(by_size[:1])
    panels = max(1, 2 * len(joints) * len(series))
    dots = max(30, min(DOTS, _DOTS // (panels * len(_QUANTITIES))))
    columns = max(60, min(COLUMNS, _COLUMNS // panels))
    return [
        {
            "title": "Validation log" if k else "First log that was fitted",
            "name": one.name,
            "left_out": found.robot.n - len(joints),
            "joints": [
                {
                    "joint": j + 1,
                    "is_open": j in opened and k == 0,
                    "time": over_time(one, j, units["tau"], columns=columns),
                    "over": _over(one, j, units, dots),
                }
                for j in joints
                for units in (_UNITS[found.robot.links[j].joint.kind],)
            ],
        }
        for k, one in enumerate(series)
        if len(one.times)
    ]


def _over(series: Series, j: int, units: dict[str, str], dots: int) -> list[Chart]:
    found = []
    for name, key in _QUANTITIES:
        x: Floats = getattr(series, key)[:, j]
        unit = units["tau"] if key == "load" else units[key]
        found.append(over(series, j, name, x, unit, units["tau"], dots=dots))
    return found


# --- the model and the logs -------------------------------------------------------------------------------


def _diff(text: str) -> list[tuple[str, str]]:
    """Lines of a unified diff with what each is."""
    lines = text.splitlines()
    found = [(_kind(line), line) for line in lines[:_DIFF_LINES]]
    if len(lines) > _DIFF_LINES:
        found.append(("hunk", f"... and {len(lines) - _DIFF_LINES} lines more: model.yaml has them"))
    return found


def _kind(line: str) -> str:
    if line.startswith(("---", "+++", "@@")):
        return "hunk"
    return {"+": "added", "-": "gone"}.get(line[:1], "same")


def _logs(found: Diagnosis, validated: bool) -> Sequence[dict[str, str]]:
    last = len(found.logs) - 1
    return [
        {
            "name": log.get("name", ""),
            "sha256": log.get("sha256", ""),
            "use": "validation" if validated and k == last else "fitted",
        }
        for k, log in enumerate(found.logs)
    ]
