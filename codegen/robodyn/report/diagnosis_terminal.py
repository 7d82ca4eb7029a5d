"""A diagnosis on a terminal: what is missing, figures, how much better, what to record next."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from robodyn.diagnose.limits import CLAIM
from robodyn.diagnose.result import Diagnosis, Estimate, Finding
from robodyn.report.diagnosis_headline import headline, in_a_line
from robodyn.report.diagnosis_text import (
    VERDICTS,
    chosen,
    experiments,
    is_touched_only,
    is_unseen,
    joints_of,
    place_of,
    still,
    units_of,
    with_interval,
)
from robodyn.report.figures import formatted

#: Lines on a terminal, and the width of the first; parameters in a line, joints that stand beside each other.
LINES, WIDTH = 18, 110
_PARAMETERS, _JOINTS = 3, 8


def summary(diagnosis: Diagnosis, report: str, *, validated: bool) -> list[str]:
    """The diagnosis in :data:`LINES` lines at most; ``report`` is where the page is, ``validated`` whether
    there was a log that was not fitted."""
    head = _head(diagnosis, validated)
    tail = _gap(diagnosis, validated)
    better = _better(diagnosis, validated)
    if better:
        tail.append(better)
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
    verdict = VERDICTS[diagnosis.verdict]
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
    gap = diagnosis.gap
    before, after = chosen(diagnosis, validated)
    changed = diagnosis.verdict == "missing_effect" or "refitted" in diagnosis.extra
    log = "validation log" if validated else "logs that were fitted"
    with np.errstate(all="ignore"):
        size = np.nan_to_num(before / gap.noise_floor, nan=0.0, posinf=0.0)
    shown = sorted(sorted(range(diagnosis.robot.n), key=lambda j: (-float(size[j]), j))[:_JOINTS])
    rows: list[tuple[str, Sequence[str]]] = [
        ("joint", [str(j + 1) for j in shown]),
        ("gap before" if changed else "gap", [formatted(before[j]) for j in shown]),
        ("noise floor", [formatted(gap.noise_floor[j]) for j in shown]),
    ]
    if changed:
        rows.insert(2, ("gap after", [formatted(after[j]) for j in shown]))
    widths = [max(len(cells[k]) for _, cells in rows) for k in range(len(shown))]
    lines = [
        f"{name.ljust(11)}  "
        + "  ".join(cell.rjust(width) for cell, width in zip(cells, widths, strict=True))
        for name, cells in rows
    ]
    most = f", {_JOINTS} of {diagnosis.robot.n} joints" if diagnosis.robot.n > _JOINTS else ""
    lines[0] += f"  ({units_of(diagnosis)}, RMS, {log}{most})"
    return lines


def _better(diagnosis: Diagnosis, validated: bool) -> str:
    """How much of the gap is gone, and what the kernel costs; empty where nothing was added."""
    if diagnosis.verdict != "missing_effect" and "refitted" not in diagnosis.extra:
        return ""
    share = diagnosis.gap.closed(validated=validated)
    if is_touched_only(diagnosis):
        return "contact is left out of the fit and not added to the model"
    parts = [] if share is None else [f"{100 * share:.0f} % of the gap closed"]
    rest = still(diagnosis, validated)
    if rest:
        parts.append(f"left beyond the noise at {joints_of(rest, diagnosis.robot.n)}")
    old, new = diagnosis.operations
    if old or new:
        more = f" -> {new} operations ({new - old:+d})" if old != new else " operations, as before"
        parts.append(f"inverse dynamics {old}{more}")
    return "; ".join(parts)


def _plain(line: str) -> str:
    """What a terminal prints as it stands."""
    return "".join(c if c.isprintable() else " " for c in line)
