"""A diagnosis in words: names, places, and figures with their intervals."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.limits import CLAIM
from robodyn.diagnose.result import Bounds, Diagnosis, Estimate, Finding
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.traits import Traits

Floats = NDArray[np.float64]

#: An error so many times its value says nothing; of a size, as many.
_UNSEEN: Final = 20.0
_UNSEEN_SIZE: Final = 1.0
#: A gap so many times the noise is still one.
_STILL: Final = 1.5
_PEOPLE: Final = ("Coulomb", "Stribeck")


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


def with_interval(estimate: Estimate, effect: str = "", name: str = "") -> str:
    """A parameter with its unit and, in brackets, its 95 % interval; what the motion does not show is not
    identifiable. ``effect`` and ``name`` say whose it is."""
    text = value_text(estimate, effect, name)
    interval = None if is_unseen(estimate, effect, name) else estimate.interval
    if interval is None or isinstance(estimate.value, str) or not math.isfinite(estimate.value):
        return text
    return f"{text} ({interval_text(estimate.value, interval)})"


def interval_text(value: float, interval: Bounds) -> str:
    """An interval of a ``value`` in words, of which one side may be open."""
    digits = _digits(value, _half(value, interval))
    low, high = (None if end is None else _significant(end, digits) for end in interval)
    if low is None or high is None:
        return f"at most {high}" if low is None else f"at least {low}"
    return f"{low} to {high}"


def _half(value: float, interval: Bounds) -> float:
    """Half the width of an interval about a ``value``; by its one end, where it is open."""
    low, high = interval
    if low is None or high is None:
        return abs(value - (high if low is None else low))  # type: ignore[operator]  # one is known
    return (high - low) / 2


def value_text(estimate: Estimate, effect: str = "", name: str = "") -> str:
    """A parameter with its unit, digits as far as its interval lets them count."""
    value, interval = estimate.value, estimate.interval
    unit = f" {estimate.unit}" if estimate.unit not in ("", "1") else ""
    if isinstance(value, str):
        return value
    if is_unseen(estimate, effect, name):
        return "not identifiable"
    if not math.isfinite(value):
        return "n/a"
    digits = 4 if interval is None else _digits(value, _half(value, interval))
    return f"{_significant(value, digits)}{unit}"


def _significant(value: float, digits: int) -> str:
    """A figure of so many digits, without a power of ten below a million."""
    text = f"{value:.{digits}g}"
    return f"{float(text):.0f}" if "e+" in text and abs(value) < 1e6 else text


def _digits(value: float, half: float) -> int:
    """Significant digits of a value that is known to within ``half``: two of those are uncertain."""
    if half <= 0 or value == 0:
        return 3
    return max(2, min(7, 2 + math.ceil(math.log10(max(abs(value), half) / half))))


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
    known = CATALOGUE[effect].parameters if effect in CATALOGUE else ()
    is_size = any(p.name == name and p.sign != "any" for p in known)
    return error > (_UNSEEN_SIZE if is_size else _UNSEEN) * abs(value) > 0


def claims(diagnosis: Diagnosis) -> tuple[Finding, ...]:
    """The findings that are claims."""
    return tuple(finding for finding in diagnosis.findings if finding.confidence >= CLAIM)


def listed(parts: Sequence[str]) -> str:
    """Several things within a sentence."""
    return f"{', '.join(parts[:-1])} and {parts[-1]}" if len(parts) > 1 else "".join(parts)


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


def experiments(diagnosis: Diagnosis) -> tuple[str, ...]:
    """What is to be recorded next, each thing once."""
    named = [f.experiment for f in diagnosis.findings if f.experiment]
    sure = diagnosis.verdict == "missing_effect" and all(f.confidence >= CLAIM for f in diagnosis.findings)
    return tuple(dict.fromkeys([*named, *([diagnosis.record] if diagnosis.record and not sure else [])]))


def chosen(diagnosis: Diagnosis, validated: bool) -> tuple[Floats, Floats]:
    """RMS [n] before and after, of the log that proves most."""
    gap = diagnosis.gap
    return (gap.validate_before, gap.validate_after) if validated else (gap.train_before, gap.train_after)


def still(diagnosis: Diagnosis, validated: bool) -> list[int]:
    """Joints (from 1) at which a gap is left that stands out of the noise."""
    _, after = chosen(diagnosis, validated)
    return (np.flatnonzero(times_noise(diagnosis, after) > _STILL) + 1).tolist()


def times_noise(diagnosis: Diagnosis, rms: Floats, unknown: float = 0.0) -> Floats:
    """How many times the noise floor ``rms`` [n] is; ``unknown`` where either is not known, and 0 where there
    is no noise."""
    with np.errstate(all="ignore"):
        return np.nan_to_num(rms / diagnosis.gap.noise_floor, nan=unknown, posinf=0.0)


def joints_of(joints: Sequence[int], n: int | None = None) -> str:
    """Several joints of ``n`` within a sentence."""
    if n is not None and len(joints) == n > 2:
        return "every joint"
    if len(joints) > 2 and list(joints) == list(range(joints[0], joints[0] + len(joints))):
        return f"joints {joints[0]} to {joints[-1]}"
    return f"joint{'s' if len(joints) > 1 else ''} {listed([str(j) for j in joints])}"


def units_of(diagnosis: Diagnosis) -> str:
    """The unit of the joints' torques."""
    kinds = {link.joint.kind for link in diagnosis.robot.links}
    return "N m" if kinds == {"revolute"} else "N" if kinds == {"prismatic"} else "N m or N"
