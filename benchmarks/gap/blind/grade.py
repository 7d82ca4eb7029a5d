"""What a diagnosis is worth beside what was hidden: names, numbers with their intervals, and contacts."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from benchmarks.blind_arms.logs import Hidden

from robodyn.diagnose.result import Diagnosis, Finding, gap_closed
from robodyn.robot.model import EffectEntry

#: From this confidence on a finding is a claim.
CLAIM = 0.5


def graded(trial: Hidden, diagnosis: Diagnosis) -> dict[str, Any]:
    """Verdict, claims, how right they are, the gap that is closed, and each number beside the true one."""
    hidden = trial.truth.effects
    claims = [f for f in diagnosis.findings if f.confidence >= CLAIM]
    right = [(f, e) for f in claims for e in hidden if same(f, e)]
    return {
        "verdict": diagnosis.verdict,
        "status": status(hidden, claims),
        "hidden": [[e.effect, e.joint] for e in hidden],
        "findings": [
            [f.effect, f.joint, f.confidence, list(f.confounded_with), _numbers(f)]
            for f in diagnosis.findings
        ],
        "values": [value for f, e in right for value in values(f, e)],
        "contacts": [contact(f, e) for f, e in right if "start" in f.parameters],
        "closed": closed(trial, diagnosis),
        "floor_ratio": (diagnosis.gap.validate_after / trial.truth.noise).round(3).tolist(),
    }


def status(hidden: Sequence[EffectEntry], claims: Sequence[Finding]) -> str:
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
        log = f.parameters.get("log")
        if log is None:
            distinct.append(f)
        elif log.value not in logs:
            distinct += [] if logs else [f]
            logs.append(log.value)
        else:
            distinct.append(f)
    return distinct


def same(f: Finding, e: EffectEntry) -> bool:
    """Whether a finding is of the effect that is hidden, at its joint: a coupling's joints are a pair, and a
    push must have been there at that time."""
    if f.effect != e.effect:
        return False
    if "start" in f.parameters:
        start, end = (float(f.parameters[name].value) for name in ("start", "end"))
        return min(end, e.number("end")) > max(start, e.number("start"))
    other = f.parameters.get("with")
    ours = {f.joint} | ({int(float(other.value))} if other is not None else set())
    return ours == {e.joint} | ({int(e["with"])} if "with" in e else set())


def declared(f: Finding, e: EffectEntry) -> bool:
    """Whether a finding declares what is hidden as a rival, at the joint where it is."""
    return e.effect in f.confounded_with and (None in (f.joint, e.joint) or f.joint == e.joint)


def _numbers(f: Finding) -> dict[str, Any]:
    return {name: [p.value, p.stderr] for name, p in f.parameters.items()}


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
    if "mu" in true:
        true["mu_r"] = true["mu"] * true.get("radius", 1.0)
    return true


def values(f: Finding, e: EffectEntry) -> list[list[Any]]:
    """[name, value, standard error, true value, ends of the interval] of each number that has a true one."""
    true = truths(e)
    rows: list[list[Any]] = []
    for name, p in f.parameters.items():
        if isinstance(p.value, str) or name not in true or name in ("with", "link"):
            continue
        wanted = true[name]
        if name == "phase":  # a whole turn apart is the same
            wanted += math.tau * round((p.value - wanted) / math.tau)
        rows.append(
            [f"{f.effect}.{name}", p.value, p.stderr, wanted, *(p.bounds or p.interval or (None, None))]
        )
    return rows


def contact(f: Finding, e: EffectEntry) -> dict[str, float]:
    """How far off a contact's window [s] and force are: angle in degrees, ratio of sizes."""

    def number(name: str) -> float:
        return float(f.parameters[name].value)

    pair = np.array(
        [[number(f"force_{x}"), e.number(f"force_{x}")] for x in "xyz" if f"force_{x}" in f.parameters]
    )
    if len(pair) < 3:
        return {"start": number("start") - e.number("start"), "end": number("end") - e.number("end")}
    ours, true = pair.T
    sizes = float(np.linalg.norm(ours)), float(np.linalg.norm(true))
    cosine = float(ours @ true) / max(sizes[0] * sizes[1], 1e-300)
    return {
        "start": number("start") - e.number("start"),
        "end": number("end") - e.number("end"),
        "angle": math.degrees(math.acos(max(-1.0, min(1.0, cosine)))),
        "ratio": sizes[0] / sizes[1],
    }


def closed(trial: Hidden, diagnosis: Diagnosis) -> float | None:
    """Share of the gap beyond the true noise that the model closes on the validation log; None where there is
    none."""
    gap = diagnosis.gap
    return gap_closed(gap.validate_before, gap.validate_after, trial.truth.noise)
