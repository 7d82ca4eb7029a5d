"""A diagnosis in words: sentences, figures with their errors, and the ten lines for a terminal."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.limits import CLAIM
from robodyn.diagnose.result import Diagnosis, Estimate, Finding
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.traits import Traits

Floats = NDArray[np.float64]

#: Lines on a terminal, parameters in one of them, and joints that stand beside each other.
LINES: Final = 10
_PARAMETERS, _JOINTS = 4, 8
#: An error so many times its value says nothing.
_UNSEEN: Final = 20.0
#: A gap so many times the noise is still one.
_STILL: Final = 1.5
_PEOPLE: Final = ("Coulomb", "Stribeck")
VERDICTS: Final = {
    "missing_effect": "missing effect",
    "consistent": "consistent",
    "unexplained": "unexplained",
}


def title_of(effect: str) -> str:
    """An effect as people call it; the id where the catalogue has no such effect."""
    return CATALOGUE[effect].title if effect in CATALOGUE else effect


def traits_of(effect: str) -> Traits:
    """The traits of an effect; none where the catalogue has no such effect."""
    return CATALOGUE[effect].traits if effect in CATALOGUE else Traits()


def is_contact(effect: str) -> bool:
    """Whether it is reported and never added."""
    return effect in CATALOGUE and CATALOGUE[effect].place == "outside"


def place_of(joint: int | None) -> str:
    """Where an effect is."""
    return "the whole robot" if joint is None else f"joint {joint}"


def formatted(value: float) -> str:
    """A figure of three digits, if there is one."""
    if not math.isfinite(value):
        return "n/a"
    return f"{value:,.0f}" if 999.5 <= abs(value) < 1e6 else f"{value:.3g}"


def with_error(estimate: Estimate, sign: str = "+-") -> str:
    """A parameter with its standard error and unit: the value to the error's second digit. What was chosen
    from a grid has no error, and what the motion does not show has no value."""
    value, error = estimate.value, estimate.stderr
    unit = f" {estimate.unit}" if estimate.unit not in ("", "1") else ""
    if isinstance(value, str):
        return value
    if error is None or error == 0:
        return f"{value:.4g}{unit}"
    if is_unseen(estimate):
        return "not seen by this motion"
    if not (math.isfinite(error) and error > 0 and math.isfinite(value)):
        return f"{formatted(value)} {sign} {formatted(error)}{unit}"
    tens = math.floor(math.log10(error))
    if not -5 < max(tens, math.floor(math.log10(abs(value) or error))) < 6:
        return f"{value:.3e} {sign} {error:.1e}{unit}"
    if error < 1e-6 * abs(value):
        return f"{value:.7g} {sign} {error:.1e}{unit}"
    places = max(0, 1 - tens)
    return f"{value:.{places}f} {sign} {error:.{places}f}{unit}"


def is_unseen(estimate: Estimate) -> bool:
    """Whether the motion says next to nothing of a parameter."""
    value, error = estimate.value, estimate.stderr
    return not isinstance(value, str) and error is not None and 0 < abs(value) * _UNSEEN < error < math.inf


def claims(diagnosis: Diagnosis) -> tuple[Finding, ...]:
    """The findings that are claims."""
    return tuple(finding for finding in diagnosis.findings if finding.confidence >= CLAIM)


def headline(diagnosis: Diagnosis) -> str:
    """The verdict as a sentence."""
    if diagnosis.verdict == "consistent":
        return f"{diagnosis.robot.name} explains the logs: no effect needs to be added."
    if diagnosis.verdict == "unexplained":
        worst = worst_joint(diagnosis.left)
        where = "" if worst is None else f" It is largest at joint {worst}."
        return f"A residual remains that no effect of the catalogue explains.{where}"
    lacking = [f for f in claims(diagnosis) if not is_contact(f.effect)]
    touched = [_touched(f) for f in claims(diagnosis) if is_contact(f.effect)]
    if not lacking and touched:
        return f"{diagnosis.robot.name}: no effect is missing, but {listed(touched)}."
    parts = _by_effect(lacking) or ["an effect"]
    verb = "are" if len(parts) > 1 else "is"
    return (
        f"{diagnosis.robot.name}: {listed(parts)} {verb} missing{'; ' if touched else ''}{listed(touched)}."
    )


def _by_effect(findings: Sequence[Finding]) -> list[str]:
    """Each effect once, with the joints at which it was found."""
    joints: dict[str, list[int]] = {}
    for finding in findings:
        joints.setdefault(finding.effect, []).extend([] if finding.joint is None else [finding.joint])
    return [
        f"{named(effect)} at {joints_of(sorted(places))}" if places else named(effect)
        for effect, places in joints.items()
    ]


def listed(parts: Sequence[str]) -> str:
    """Several things within a sentence."""
    return f"{', '.join(parts[:-1])} and {parts[-1]}" if len(parts) > 1 else "".join(parts)


def _touched(contact: Finding) -> str:
    """A contact within a sentence."""
    place, time = touched_at(contact)
    return f"something touched {place} {time}".rstrip()


def touched_at(contact: Finding) -> tuple[str, str]:
    """Where and when a contact was; what is not known is left out."""
    values = {name: p.value for name, p in contact.parameters.items()}
    link, start, end = (values.get(name) for name in ("link", "start", "end"))
    place = f"link {link:g}" if isinstance(link, float | int) else "the arm"
    if isinstance(start, float | int) and isinstance(end, float | int):
        return place, f"from {start:.2f} to {end:.2f} s"
    return place, ""


def is_touched_only(diagnosis: Diagnosis) -> bool:
    """Whether contact is all that was found."""
    lacking = claims(diagnosis)
    return bool(lacking) and all(is_contact(f.effect) for f in lacking)


def named(effect: str) -> str:
    """An effect within a sentence; people keep their capitals."""
    title = title_of(effect)
    return title if title.startswith(_PEOPLE) else title[:1].lower() + title[1:]


def worst_joint(values: Floats) -> int | None:
    """The joint (from 1) at which ``values`` [n] are largest; None where there are none."""
    known = np.where(np.isfinite(values), values, -np.inf)
    return int(np.argmax(known)) + 1 if len(known) and np.isfinite(known.max()) else None


def closed(before: Floats, after: Floats, floor: Floats) -> float | None:
    """Share of the removable gap that is closed, from RMS [n] before and after; None where there is
    nothing to remove. Removable is what mean squares exceed the noise by, joints weighed by their noise."""
    weight = np.where(floor > 0, floor, np.nan)
    removable = float(np.nansum(np.maximum((before / weight) ** 2 - 1, 0)))
    rest = float(np.nansum(np.maximum((after / weight) ** 2 - 1, 0)))
    return None if removable <= 1e-9 else 1 - math.sqrt(rest / removable)


def experiments(diagnosis: Diagnosis) -> tuple[str, ...]:
    """What is to be recorded next, each thing once."""
    named = [f.experiment for f in diagnosis.findings if f.experiment]
    sure = diagnosis.verdict == "missing_effect" and all(f.confidence >= CLAIM for f in diagnosis.findings)
    return tuple(dict.fromkeys([*named, *([diagnosis.record] if diagnosis.record and not sure else [])]))


# --- the terminal -----------------------------------------------------------------------------------------


def summary(diagnosis: Diagnosis, report: str, *, validated: bool) -> list[str]:
    """The diagnosis in :data:`LINES` lines at most; ``report`` is where the page is, ``validated`` whether
    there was a log that was not fitted."""
    head = [f"{VERDICTS[diagnosis.verdict]}: {headline(diagnosis)}"]
    tail = _gap(diagnosis, validated)
    better = _better(diagnosis, validated)
    if better:
        tail.append(better)
    following = experiments(diagnosis)
    if following:
        more = f" (and {len(following) - 1} more)" if len(following) > 1 else ""
        tail.append(f"record next: {following[0]}{more}")
    notes = f"; {len(diagnosis.flags)} remarks on the data there" if len(diagnosis.flags) > 1 else ""
    notes = "; one remark on the data there" if len(diagnosis.flags) == 1 else notes
    tail.append(f"report: {report}{notes}")
    room = LINES - len(head) - len(tail)
    lines = [_line(k, finding) for k, finding in enumerate(diagnosis.findings, 1)]
    if len(lines) > room:
        lines = [*lines[: room - 1], f"and {len(lines) - room + 1} more in the report"]
    return [_plain(line) for line in (*head, *lines, *tail)]


def _line(k: int, finding: Finding) -> str:
    known = list(finding.parameters.items())
    shown = [f"{name} {with_error(p)}" for name, p in known if not is_unseen(p)][:_PARAMETERS]
    if len(known) > len(shown):
        shown.append(f"{len(known) - len(shown)} more")
    sure = f"{100 * finding.confidence:.0f} % sure"
    if finding.confidence < CLAIM:
        sure = f"a suspicion, {sure}"
    rivals = f"; or {', '.join(finding.confounded_with)}" if finding.confounded_with else ""
    figures = ", ".join(shown) or "no figures"
    return f"{k}. {finding.effect}, {place_of(finding.joint)}: {figures}; {sure}{rivals}"


def _gap(diagnosis: Diagnosis, validated: bool) -> list[str]:
    """Before, after and noise by joint, of long arms where most is there."""
    gap = diagnosis.gap
    before, after = chosen(diagnosis, validated)
    changed = diagnosis.verdict == "missing_effect"
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
    if diagnosis.verdict != "missing_effect":
        return ""
    share = closed(*chosen(diagnosis, validated), diagnosis.gap.noise_floor)
    if is_touched_only(diagnosis):
        return "contact is left out of the fit and not added to the model"
    parts = [] if share is None else [f"{100 * share:.0f} % of the removable gap closed"]
    rest = still(diagnosis, validated)
    if rest:
        parts.append(f"left beyond the noise at {joints_of(rest, diagnosis.robot.n)}")
    old, new = diagnosis.operations
    if old or new:
        more = f" -> {new} operations ({new - old:+d})" if old != new else " operations, as before"
        parts.append(f"inverse dynamics {old}{more}")
    return "; ".join(parts)


def chosen(diagnosis: Diagnosis, validated: bool) -> tuple[Floats, Floats]:
    """RMS [n] before and after, of the log that proves most."""
    gap = diagnosis.gap
    return (gap.validate_before, gap.validate_after) if validated else (gap.train_before, gap.train_after)


def still(diagnosis: Diagnosis, validated: bool) -> list[int]:
    """Joints (from 1) at which a gap is left that stands out of the noise."""
    _, after = chosen(diagnosis, validated)
    with np.errstate(all="ignore"):
        rest = np.nan_to_num(after / diagnosis.gap.noise_floor, nan=0.0, posinf=0.0)
    return (np.flatnonzero(rest > _STILL) + 1).tolist()


def joints_of(joints: Sequence[int], n: int | None = None) -> str:
    """Several joints of ``n`` within a sentence."""
    if n is not None and len(joints) == n > 2:
        return "every joint"
    return f"joint{'s' if len(joints) > 1 else ''} {listed([str(j) for j in joints])}"


def units_of(diagnosis: Diagnosis) -> str:
    """The unit of the joints' torques."""
    kinds = {link.joint.kind for link in diagnosis.robot.links}
    return "N m" if kinds == {"revolute"} else "N" if kinds == {"prismatic"} else "N m or N"


def _plain(line: str) -> str:
    """What a terminal prints as it stands."""
    return "".join(c if c.isprintable() else " " for c in line)
