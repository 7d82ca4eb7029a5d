"""What a diagnosis is worth beside what was hidden: names, numbers with their intervals, and contacts.

Works on ``diagnosis.json`` and ``answer.json`` alone: whatever program wrote the one.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from robodyn.robot.model import EffectEntry

#: From this confidence on a finding is a claim.
CLAIM = 0.5
#: Standard errors to either side of an interval of 95 %.
WIDE = 1.96

Finding = Mapping[str, Any]
Effect = Mapping[str, Any]


def graded(answer: Mapping[str, Any], diagnosis: Mapping[str, Any]) -> dict[str, Any]:
    """Verdict, claims, how right they are, the gap that is closed, and each number beside the true one."""
    hidden = answer["effects"]
    findings = diagnosis["findings"]
    claims = [f for f in findings if f["confidence"] >= CLAIM]
    right = [(f, e) for f in claims for e in hidden if same(f, e)]
    after = np.array(diagnosis["gap"]["validate"]["after"], dtype=float)
    return {
        "verdict": diagnosis["verdict"],
        "status": status(hidden, claims),
        "hidden": [[e["effect"], e["joint"]] for e in hidden],
        "findings": [
            [
                f["effect"],
                f["joint"],
                f["confidence"],
                list(f["confounded_with"]),
                any(same(f, e) for e in hidden),
            ]
            for f in findings
        ],
        "values": [value for f, e in right for value in values(f, e)],
        "contacts": [contact(f, e) for f, e in right if "start" in f["parameters"]],
        "floor_ratio": (after / answer["noise"]).round(3).tolist(),
    }


def status(hidden: Sequence[Effect], claims: Sequence[Finding]) -> str:
    """``right``: each effect is claimed and nothing else; ``extra``: something else as well; ``wrong``: only
    something else, or beside one of several; ``set``: what is hidden is at least declared a rival;
    ``missed``: no claim, or too few; ``silent``: rightly none."""
    false = [f for f in claims if not any(same(f, e) or declared(f, e) for e in hidden)]
    named = all(any(same(f, e) for f in claims) for e in hidden)
    if false:
        return "extra" if hidden and named else "wrong"
    if not hidden:
        return "silent"
    if named:
        return "right" if len(_distinct(claims)) == len(hidden) else "extra"
    return "set" if all(any(same(f, e) or declared(f, e) for f in claims) for e in hidden) else "missed"


def _distinct(claims: Sequence[Finding]) -> list[Finding]:
    """Claims without those of the same push in further logs: each log has its own, at the same time."""
    logs: list[float | str] = []
    distinct = []
    for f in claims:
        log = f["parameters"].get("log")
        if log is None:
            distinct.append(f)
        elif log["value"] not in logs:
            distinct += [] if logs else [f]
            logs.append(log["value"])
        else:
            distinct.append(f)
    return distinct


def same(f: Finding, e: Effect) -> bool:
    """Whether a finding is of the effect that is hidden, at its joint: a coupling's joints are a pair, and a
    push must have been there at that time."""
    if f["effect"] != e["effect"]:
        return False
    if "start" in f["parameters"]:
        start, end = (_number(f, name) for name in ("start", "end"))
        return bool(min(end, e["parameters"]["end"]) > max(start, e["parameters"]["start"]))
    ours = {f["joint"]} | ({int(_number(f, "with"))} if "with" in f["parameters"] else set())
    return ours == {e["joint"]} | ({int(e["parameters"]["with"])} if "with" in e["parameters"] else set())


def declared(f: Finding, e: Effect) -> bool:
    """Whether a finding declares what is hidden as a rival, at the joint where it is."""
    return e["effect"] in f["confounded_with"] and (
        None in (f["joint"], e["joint"]) or f["joint"] == e["joint"]
    )


def _number(f: Finding, name: str) -> float:
    return float(f["parameters"][name]["value"])


def truths(e: EffectEntry) -> dict[str, float]:
    """The numbers of an entry as a finding names them."""
    true: dict[str, float] = {}
    for name, value in e.settings:
        if isinstance(value, tuple) and name == "com":
            for axis, x in zip("xyz", value, strict=True):
                assert isinstance(x, Fraction)
                true[f"com_{axis}"] = float(x)
        elif isinstance(value, (int, Fraction)):
            true[name] = float(value)
    if "mu" in true and "radius" in true:
        true["mu_r"] = true["mu"] * true["radius"]
    return true


def values(f: Finding, e: Effect) -> list[list[Any]]:
    """[name, value, standard error, true value, ends of the interval] of each number, or combination of
    numbers, that has a true one and of which anything is said."""
    true = e["parameters"]
    both = {**f.get("combinations", {}), **f["parameters"]}
    rows: list[list[Any]] = []
    for name, p in both.items():
        wanted = _combined(name, true)
        if isinstance(p["value"], str) or wanted is None or name in ("with", "link"):
            continue
        if name == "phase":  # a whole turn apart is the same
            wanted += math.tau * round((p["value"] - wanted) / math.tau)
        interval = p.get("interval") or (None, None)
        if p.get("stderr") is None and interval == (None, None):
            continue
        rows.append([f"{f['effect']}.{name}", p["value"], p.get("stderr"), wanted, *interval])
    return rows


def _combined(name: str, true: Mapping[str, float]) -> float | None:
    """The true value of a number, or of a product, quotient or sum of numbers by its name."""
    if name in true:
        return true[name]
    for sign, apply in ((" + ", np.add), (" * ", np.multiply), (" / ", np.divide), ("/", np.divide)):
        left, found, right = name.rpartition(sign)
        if found:
            one, other = _combined(left, true), _combined(right, true)
            return None if one is None or other is None else float(apply(one, other))
    return None


def contact(f: Finding, e: Effect) -> dict[str, float]:
    """How far off a contact's window [s] and force are: angle in degrees, ratio of sizes."""
    times = {name: _number(f, name) - e["parameters"][name] for name in ("start", "end")}
    axes = [f"force_{x}" for x in "xyz"]
    if any(axis not in f["parameters"] for axis in axes):
        return times
    ours = np.array([_number(f, axis) for axis in axes])
    true = np.array([e["parameters"].get(axis, 0.0) for axis in axes])
    sizes = float(np.linalg.norm(ours)), float(np.linalg.norm(true))
    cosine = float(ours @ true) / max(sizes[0] * sizes[1], 1e-300)
    angle = math.degrees(math.acos(max(-1.0, min(1.0, cosine))))
    return {**times, "angle": angle, "ratio": sizes[0] / sizes[1]}
