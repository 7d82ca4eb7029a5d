"""A diagnosis in words: names, places, and figures with their intervals.

Findings of one kind are one thing: whatever rubs is friction, unless a single law is all there is of it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.limits import CLAIM
from robodyn.diagnose.result import Bounds, Diagnosis, Estimate, Finding
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.traits import Traits
from robodyn.report.figures import UNITS

#: An error so many times its value says nothing; of a size, as many.
_UNSEEN, _UNSEEN_SIZE = 20.0, 1.0
#: A gap so many times the noise is still one.
_STILL: Final = 1.5
_PEOPLE: Final = ("Coulomb", "Stribeck")

# --- names and places -------------------------------------------------------------------------------------


def title_of(effect: str) -> str:
    """An effect as people call it; the id where the catalogue has no such effect."""
    return CATALOGUE[effect].title if effect in CATALOGUE else effect


def named(effect: str) -> str:
    """An effect within a sentence; people keep their capitals."""
    title = title_of(effect)
    return title if title.startswith(_PEOPLE) else title[:1].lower() + title[1:]


def traits_of(effect: str) -> Traits:
    """The traits of an effect; none where the catalogue has no such effect."""
    return CATALOGUE[effect].traits if effect in CATALOGUE else Traits()


def is_contact(effect: str) -> bool:
    """Whether it is reported and never added."""
    return effect in CATALOGUE and CATALOGUE[effect].place == "outside"


def place_of(joint: int | None) -> str:
    """Where an effect is."""
    return "the whole robot" if joint is None else f"joint {joint}"


def listed(parts: Sequence[str]) -> str:
    """Several things within a sentence."""
    return f"{', '.join(parts[:-1])} and {parts[-1]}" if len(parts) > 1 else "".join(parts)


def joints_of(joints: Sequence[int], n: int | None = None) -> str:
    """Several joints of ``n`` within a sentence."""
    if n is not None and len(joints) == n > 2:
        return "every joint"
    if len(joints) > 2 and list(joints) == list(range(joints[0], joints[0] + len(joints))):
        return f"joints {joints[0]} to {joints[-1]}"
    return f"joint{'s' if len(joints) > 1 else ''} {listed([str(j) for j in joints])}"


def more_text(count: int) -> str:
    """How many things are not named."""
    return "one more" if count == 1 else f"{count} more"


def units_at(diagnosis: Diagnosis, j: int) -> Mapping[str, str]:
    """Units at joint ``j`` (from 0)."""
    return UNITS[diagnosis.robot.links[j].joint.kind]


def units_of(diagnosis: Diagnosis) -> str:
    """The unit of the joints' torques."""
    kinds = {link.joint.kind for link in diagnosis.robot.links}
    return "N m" if kinds == {"revolute"} else "N" if kinds == {"prismatic"} else "N m or N"


# --- figures ----------------------------------------------------------------------------------------------


def is_unseen(estimate: Estimate, effect: str = "", name: str = "") -> bool:
    """Whether the motion says next to nothing of a parameter: its interval is open on both sides, its error
    is many times its value or, of what cannot be negative, no smaller than it."""
    value, error = estimate.value, estimate.stderr
    if estimate.bounds is not None:
        return estimate.bounds == (None, None)
    if isinstance(value, str) or error is None or error == 0:
        return False
    if not math.isfinite(error):
        return True
    parameters = CATALOGUE[effect].parameters if effect in CATALOGUE else ()
    is_size = any(p.name == name and p.sign != "any" for p in parameters)
    return error > (_UNSEEN_SIZE if is_size else _UNSEEN) * abs(value) > 0


def identified(finding: Finding) -> dict[str, Estimate]:
    """The parameters of a finding that the motion shows, and products or ratios of others that it shows."""
    seen = {name: p for name, p in finding.parameters.items() if not is_unseen(p, finding.effect, name)}
    return {**seen, **finding.together}


def value_text(estimate: Estimate, effect: str = "", name: str = "") -> str:
    """A parameter with its unit, digits as far as its interval lets them count; what the motion does not show
    is not identifiable. ``effect`` and ``name`` say whose it is."""
    value, interval = estimate.value, estimate.interval
    if isinstance(value, str):
        return value
    if is_unseen(estimate, effect, name):
        return "not identifiable"
    if not math.isfinite(value):
        return "n/a"
    unit = f" {estimate.unit}" if estimate.unit not in ("", "1") else ""
    return _significant(value, 4 if interval is None else _digits(value, interval)) + unit


def with_interval(estimate: Estimate, effect: str = "", name: str = "") -> str:
    """A parameter as :func:`value_text` has it and, in brackets, its 95 % interval."""
    text, value, interval = value_text(estimate, effect, name), estimate.value, estimate.interval
    if interval is None or isinstance(value, str) or text in ("n/a", "not identifiable"):
        return text
    return f"{text} ({interval_text(value, interval)})"


def interval_text(value: float, interval: Bounds) -> str:
    """An interval of a ``value`` in words, of which one side may be open."""
    low, high = (None if end is None else _significant(end, _digits(value, interval)) for end in interval)
    if low is None or high is None:
        return f"at most {high}" if low is None else f"at least {low}"
    return f"{low} to {high}"


def _significant(value: float, digits: int) -> str:
    """A figure of so many digits, without a power of ten below a million."""
    text = f"{value:.{digits}g}"
    return f"{float(text):.0f}" if "e+" in text and abs(value) < 1e6 else text


def _digits(value: float, interval: Bounds) -> int:
    """Significant digits of a value that is known to within an interval: two of those are uncertain."""
    ends = [end for end in interval if end is not None]
    half = (ends[1] - ends[0]) / 2 if len(ends) == 2 else abs(value - ends[0])
    if half <= 0 or value == 0:
        return 3
    return max(2, min(7, 2 + math.ceil(math.log10(max(abs(value), half) / half))))


# --- what a diagnosis says --------------------------------------------------------------------------------


def claims(diagnosis: Diagnosis) -> list[Finding]:
    """The findings that are claims."""
    return [finding for finding in diagnosis.findings if finding.confidence >= CLAIM]


def is_touched_only(diagnosis: Diagnosis) -> bool:
    """Whether contact is all that was found."""
    lacking = claims(diagnosis)
    return bool(lacking) and all(is_contact(f.effect) for f in lacking)


def touched_at(contact: Finding) -> tuple[str, str]:
    """Where and when a contact was; what is not known is left out."""
    values = {name: p.value for name, p in contact.parameters.items() if not isinstance(p.value, str)}
    place = f"link {values['link']:g}" if "link" in values else "the arm"
    return place, "from {start:.2f} to {end:.2f} s".format(**values) if {"start", "end"} <= set(
        values
    ) else ""


def chosen(diagnosis: Diagnosis, validated: bool) -> tuple[Floats, Floats]:
    """RMS [n] before and after, of the log that proves most."""
    gap = diagnosis.gap
    return (gap.validate_before, gap.validate_after) if validated else (gap.train_before, gap.train_after)


def times_noise(diagnosis: Diagnosis, rms: Floats, unknown: float = 0.0) -> Floats:
    """How many times the noise floor ``rms`` [n] is; ``unknown`` where either is not known, and 0 where there
    is no noise."""
    with np.errstate(all="ignore"):
        return np.nan_to_num(rms / diagnosis.gap.noise_floor, nan=unknown, posinf=0.0)


def joints_above_noise(diagnosis: Diagnosis, validated: bool) -> list[int]:
    """Joints (from 1) at which a gap is left that stands out of the noise."""
    _, after = chosen(diagnosis, validated)
    return (np.flatnonzero(times_noise(diagnosis, after) > _STILL) + 1).tolist()


def worst_joint(values: Floats) -> int | None:
    """The joint (from 1) at which ``values`` [n] are largest; None where there are none."""
    finite = np.where(np.isfinite(values), values, -np.inf)
    return int(np.argmax(finite)) + 1 if len(finite) and np.isfinite(finite.max()) else None


def by_kind(lacking: Iterable[Finding]) -> list[list[Finding]]:
    """Findings of one kind together, kinds and findings in the order given."""
    kinds: dict[str, list[Finding]] = {}
    for finding in lacking:
        kinds.setdefault(kind_of(finding.effect), []).append(finding)
    return list(kinds.values())


def kind_of(effect: str) -> str:
    """What ``effect`` is an instance of: findings of one kind are one thing in a sentence."""
    entry = CATALOGUE.get(effect)
    return "friction" if entry is not None and entry.level == "joint" and entry.dissipative else effect
