"""The gap before and after by joint, drawn on one scale for all joints: in units of each joint's noise."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.result import Diagnosis
from robodyn.report.chart_frames import percent
from robodyn.report.diagnosis_text import chosen, claims, named
from robodyn.report.figures import formatted

Floats = NDArray[np.float64]

#: The scale reaches from below the noise to at least so many times it.
_LOW, _REACH = 0.7, 3.0
_UNITS: Final = {
    "revolute": {"q": "rad", "qd": "rad/s", "qdd": "rad/s²", "tau": "N m"},
    "prismatic": {"q": "m", "qd": "m/s", "qdd": "m/s²", "tau": "N"},
}
#: Effects that a row of a joint names at most.
_NAMED: Final = 3


def units_at(diagnosis: Diagnosis, j: int) -> dict[str, str]:
    """Units at joint ``j`` (from 0)."""
    return _UNITS[diagnosis.robot.links[j].joint.kind]


def ladder(diagnosis: Diagnosis, validated: bool) -> dict[str, Any]:
    """Rows of joints: how many times the noise floor the gap was and is, on a logarithmic scale."""
    gap = diagnosis.gap
    pairs = [chosen(diagnosis, validated)]
    if validated:
        pairs.append((gap.train_before, gap.train_after))
    with np.errstate(all="ignore"):
        times = [tuple(values / gap.noise_floor for values in pair) for pair in pairs]
    known = np.concatenate([values for pair in times for values in pair] or [np.ones(1)])
    known = known[np.isfinite(known)]
    top = max(_REACH, 1.15 * float(known.max(initial=0.0)))

    def at(value: float) -> float:
        return 100 * math.log(min(max(value, _LOW), top) / _LOW) / math.log(top / _LOW)

    before, after = pairs[0]
    rows = []
    for j in range(diagnosis.robot.n):
        drawn = []
        for kind, (a, b) in zip(("proof", "fitted"), times, strict=False):
            if math.isfinite(a[j]) and math.isfinite(b[j]):
                ends = sorted((at(float(a[j])), at(float(b[j]))))
                drawn.append(
                    {
                        "kind": kind,
                        "is_same": bool(a[j] == b[j]),
                        "before": percent(at(float(a[j]))),
                        "after": percent(at(float(b[j]))),
                        "low": percent(ends[0]),
                        "high": percent(ends[1]),
                    }
                )
        rows.append(
            {
                "joint": j + 1,
                "effects": _effects(diagnosis, j + 1),
                "drawn": drawn,
                "before": formatted(before[j]),
                "after": formatted(after[j]),
                "floor": formatted(gap.noise_floor[j]),
                "times": _times(after[j], gap.noise_floor[j]),
                "unit": units_at(diagnosis, j)["tau"],
                "change": change(before[j], after[j]),
                "is_same": bool(before[j] == after[j]),
            }
        )
    wide = math.log10(top / _LOW)
    steps = (1, 2, 3, 4, 6) if wide < 1 else (1, 2, 5) if wide < 1.7 else (1,)
    marks = [m * 10.0**k for k in range(math.ceil(math.log10(top)) + 1) for m in steps]
    ticks = [{"at": percent(at(v)), "label": f"{v:g}×"} for v in marks if v <= top]
    return {"rows": rows, "ticks": ticks[:: -(-len(ticks) // 6) or 1], "noise": percent(at(1.0))}


def _effects(diagnosis: Diagnosis, joint: int) -> str:
    """Claims that a row of a joint names."""
    names = [named(f.effect) for f in claims(diagnosis) if f.joint == joint]
    more = f" and {len(names) - _NAMED} more" if len(names) > _NAMED else ""
    return ", ".join(names[:_NAMED]) + more


def _times(value: float, floor: float) -> str:
    return formatted(value / floor) if floor > 0 else "n/a"


def change(before: float, after: float) -> str:
    """A change in percent."""
    if not before > 0 or not math.isfinite(after / before):
        return "n/a"
    rounded = round(100 * (after / before - 1))
    return f"{rounded:+d} %".replace("-", "−") if rounded else "0 %"


def tables(diagnosis: Diagnosis, validated: bool) -> list[dict[str, Any]]:
    """All figures."""
    gap = diagnosis.gap
    pairs = [("Logs that were fitted", gap.train_before, gap.train_after)]
    if validated:
        pairs.insert(0, ("Validation log, not fitted", gap.validate_before, gap.validate_after))
    return [{"title": title, "rows": _rows(before, after, gap.noise_floor)} for title, before, after in pairs]


def _rows(before: Floats, after: Floats, floor: Floats) -> Sequence[dict[str, Any]]:
    return [
        {
            "joint": j + 1,
            "before": formatted(b),
            "after": formatted(a),
            "floor": formatted(f),
            "change": change(b, a),
        }
        for j, (b, a, f) in enumerate(zip(before.tolist(), after.tolist(), floor.tolist(), strict=True))
    ]
