"""A diagnosis in words: sentences, figures with their errors, and the ten lines for a terminal."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.result import CLAIM, Diagnosis, Estimate, Finding
from robodyn.effects.catalogue import CATALOGUE

Floats = NDArray[np.float64]

#: Lines on a terminal, and parameters in one of them.
LINES: Final = 10
_PARAMETERS: Final = 4
_PEOPLE: Final = ("Coulomb", "Stribeck")
VERDICTS: Final = {
    "missing_effect": "missing effect",
    "consistent": "consistent",
    "unexplained": "unexplained",
}


def title_of(effect: str) -> str:
    """An effect as people call it; the id where the catalogue has no such effect."""
    return CATALOGUE[effect].title if effect in CATALOGUE else effect


def place_of(joint: int | None) -> str:
    """Where an effect is."""
    return "the whole robot" if joint is None else f"joint {joint}"


def number(value: float) -> str:
    """A figure of three digits, if there is one."""
    return f"{value:.3g}" if math.isfinite(value) else "n/a"


def with_error(estimate: Estimate, sign: str = "+-") -> str:
    """A parameter with its standard error and unit: the value to the error's second digit."""
    value, error = estimate.value, estimate.stderr
    unit = f" {estimate.unit}" if estimate.unit not in ("", "1") else ""
    if isinstance(value, str):
        return value
    if error is None:
        return f"{value:.4g}{unit}"
    if not (math.isfinite(error) and error > 0 and math.isfinite(value)):
        return f"{number(value)} {sign} {number(error)}{unit}"
    tens = math.floor(math.log10(error))
    if not -5 < max(tens, math.floor(math.log10(abs(value) or error))) < 6:
        return f"{value:.3e} {sign} {error:.1e}{unit}"
    places = max(0, 1 - tens)
    return f"{value:.{places}f} {sign} {error:.{places}f}{unit}"


def claims(found: Diagnosis) -> tuple[Finding, ...]:
    """The findings that are claims."""
    return tuple(finding for finding in found.findings if finding.confidence >= CLAIM)


def headline(found: Diagnosis) -> str:
    """The verdict as a sentence."""
    if found.verdict == "consistent":
        return f"{found.robot.name} explains the logs: nothing is worth adding."
    if found.verdict == "unexplained":
        worst = worst_joint(found.left)
        where = "" if worst is None else f" It shows most at joint {worst}."
        return f"Something is there that no effect of the catalogue explains.{where}"
    parts = [f"{_named(f.effect)} ({place_of(f.joint)})" for f in claims(found)]
    listed = (
        parts[0] if len(parts) == 1 else f"{', '.join(parts[:-1])} and {parts[-1]}" if parts else "an effect"
    )
    return f"{found.robot.name} lacks {listed}."


def _named(effect: str) -> str:
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


def experiments(found: Diagnosis) -> tuple[str, ...]:
    """What is to be recorded next, each thing once."""
    return tuple(dict.fromkeys(f.experiment for f in found.findings if f.experiment))


# --- the terminal -----------------------------------------------------------------------------------------


def summary(found: Diagnosis, report: str, *, validated: bool) -> list[str]:
    """The diagnosis in :data:`LINES` lines at most; ``report`` is where the page is, ``validated`` whether
    there was a log that was not fitted."""
    head = [f"{VERDICTS[found.verdict]}: {headline(found)}"]
    tail = _gap(found, validated)
    following = experiments(found)
    if following:
        more = f" (and {len(following) - 1} more)" if len(following) > 1 else ""
        tail.append(f"record next: {following[0]}{more}")
    notes = f"; {len(found.flags)} remarks on the data there" if len(found.flags) > 1 else ""
    notes = "; one remark on the data there" if len(found.flags) == 1 else notes
    tail.append(f"report: {report}{notes}")
    room = LINES - len(head) - len(tail)
    lines = [_line(k, finding) for k, finding in enumerate(found.findings, 1)]
    if len(lines) > room:
        lines = [*lines[: room - 1], f"and {len(lines) - room + 1} more in the report"]
    return [_plain(line) for line in (*head, *lines, *tail)]


def _line(k: int, finding: Finding) -> str:
    known = list(finding.parameters.items())
    shown = [f"{name} {with_error(estimate)}" for name, estimate in known[:_PARAMETERS]]
    if len(known) > _PARAMETERS:
        shown.append(f"{len(known) - _PARAMETERS} more")
    sure = "confidence" if finding.confidence >= CLAIM else "not a claim, confidence"
    rivals = f"; or {', '.join(finding.confounded_with)}" if finding.confounded_with else ""
    return (
        f"{k}. {finding.effect}, {place_of(finding.joint)}: {', '.join(shown) or 'no figures'}; "
        f"{sure} {finding.confidence:.2f}{rivals}"
    )


def _gap(found: Diagnosis, validated: bool) -> list[str]:
    gap = found.gap
    before, after = (
        (gap.validate_before, gap.validate_after) if validated else (gap.train_before, gap.train_after)
    )
    log = "on the validation log" if validated else "on the logs that were fitted"
    rows: Sequence[tuple[str, Sequence[str]]] = (
        ("joint", [str(j + 1) for j in range(found.robot.n)]),
        ("gap before", [number(x) for x in before]),
        ("gap after", [number(x) for x in after]),
        ("noise floor", [number(x) for x in gap.noise_floor]),
    )
    widths = [max(len(cells[j]) for _, cells in rows) for j in range(found.robot.n)]
    lines = [
        f"{name.ljust(11)}  "
        + "  ".join(cell.rjust(width) for cell, width in zip(cells, widths, strict=True))
        for name, cells in rows
    ]
    lines[0] += f"  ({_units(found)}, RMS {log})"
    return lines


def _units(found: Diagnosis) -> str:
    kinds = {link.joint.kind for link in found.robot.links}
    return "N m" if kinds == {"revolute"} else "N" if kinds == {"prismatic"} else "N m or N"


def _plain(line: str) -> str:
    """What a terminal prints as it stands."""
    return "".join(c if c.isprintable() else " " for c in line)
