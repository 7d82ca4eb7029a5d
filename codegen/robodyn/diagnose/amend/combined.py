"""Two effects of one kind at one place as a single one: springs, payloads, ripples, bearings."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.diagnose.limits import AMENDED_DIGITS, WORKED_OUT
from robodyn.effects.traits import Combination
from robodyn.robot import numbers
from robodyn.robot.model import AXES, Inertia, Vector
from robodyn.robot.values import Value

Settings = Mapping[str, Any]


def significant(x: float, digits: int = AMENDED_DIGITS) -> Fraction:
    """``x`` rounded to so many significant digits.

    Raises
    ------
    ValueError, OverflowError: ``x`` is not finite.
    """
    return Fraction(f"{float(x):.{digits}g}") if math.isfinite(x) else numbers.shortest(x)


def total(one: Value, other: Value) -> Value:
    """The sum; without names in it, a decimal of at most 17 digits."""
    value = one + other
    return numbers.rounded(value) if isinstance(value, Fraction) else value


@dataclass(frozen=True, slots=True)
class Body:
    """A mass [kg], its centre [m], and its inertia about the centre [kg m^2]."""

    mass: Value
    com: Vector
    inertia: Inertia


def joined(one: Body, other: Body) -> Body | None:
    """The body that two bodies make, fixed to each other; None where run-time names stand in the way.

    Two of no mass together stay where the first one is.
    """
    tensor = _plus(one.inertia, other.inertia)
    mass = total(one.mass, other.mass)
    if one.com == other.com or other.mass == 0 or mass == 0:
        return Body(mass, one.com, tensor)
    if one.mass == 0:
        return Body(mass, other.com, tensor)
    if not isinstance(one.mass, Fraction) or not isinstance(other.mass, Fraction):
        return None
    assert isinstance(mass, Fraction)
    a = [x for x in one.com if isinstance(x, Fraction)]
    b = [x for x in other.com if isinstance(x, Fraction)]
    if len(a) < 3 or len(b) < 3:
        return None
    x, y, z = (
        significant(float((one.mass * p + other.mass * q) / mass), WORKED_OUT)
        for p, q in zip(a, b, strict=True)
    )
    reduced = one.mass * other.mass / mass
    d, e, f = (p - q for p, q in zip(a, b, strict=True))
    apart = (e * e + f * f, d * d + f * f, d * d + e * e, -d * e, -d * f, -e * f)
    added = Inertia(*(significant(float(reduced * part), WORKED_OUT) for part in apart))
    return Body(mass, (x, y, z), _plus(tensor, added))


def _plus(one: Inertia, other: Inertia) -> Inertia:
    return Inertia(*(total(getattr(one, axes), getattr(other, axes)) for axes in AXES))


def springs(old: Settings, new: Settings, remarks: list[str]) -> dict[str, Any]:
    """Two springs side by side: ``k = k1 + k2``, at rest where their torques cancel."""
    k1, r1, c1 = old["stiffness"], old["rest"], old["cubic"]
    k2, r2, c2 = new["stiffness"], new["rest"], new["cubic"]
    k, c = total(k1, k2), total(c1, c2)
    merged = {**old, "stiffness": k, "cubic": c}
    if r1 == r2 or (k2 == 0 and c2 == 0):
        return merged
    if k1 == 0 and c1 == 0:
        return {**merged, "rest": r2}
    if k == 0 or not all(isinstance(x, Fraction) for x in (k1, r1, k2, r2, c)):
        remarks.append("the rest of the spring that was there is kept: the sum is near, not exact")
        return merged
    if c != 0:
        remarks.append("springs with a cubic part and unlike rests: the sum is near, not exact")
    return {**merged, "rest": numbers.rounded((k1 * r1 + k2 * r2) / (k1 + k2))}


def waves(old: Settings, new: Settings, remarks: list[str]) -> dict[str, Any] | None:
    """The sum of two waves of one length; None where they are of two, or a name stands in the way."""
    if old["cycles_per_rev"] != new["cycles_per_rev"]:
        return None
    if old["phase"] == new["phase"]:
        size = total(old["amplitude"], new["amplitude"])
        if not isinstance(size, Fraction) or size >= 0:
            return {**old, "amplitude": size}
    if not isinstance(old["amplitude"], Fraction):
        return None
    waves = (cmath.rect(float(p["amplitude"]), float(p["phase"])) for p in (old, new))
    size, phase = (significant(x, WORKED_OUT) for x in cmath.polar(sum(waves)))
    return {**old, "amplitude": size, "phase": phase}


def bearings(old: Settings, new: Settings, remarks: list[str]) -> dict[str, Any] | None:
    """The sum of the friction in two bearings of one kind and size; None where they are not."""
    if _kind(old) != _kind(new) or any(old.get(x) != new.get(x) for x in ("span", "variant")):
        return None
    added = dict(new)
    if "mu_r" in new and "mu_r" not in old:
        if not isinstance(old["radius"], Fraction):
            return None
        added = {"mu": significant(float(new["mu_r"] / old["radius"]), WORKED_OUT), "radius": old["radius"]}
    elif "mu_r" in old and "mu_r" not in new:
        added = {"mu_r": significant(float(new["mu"] * new["radius"]), WORKED_OUT)}
    if old.get("radius") != added.get("radius"):
        return None
    name = "mu_r" if "mu_r" in added else "mu"
    return {**old, name: total(old[name], added[name])}


def balancers(old: Settings, new: Settings, remarks: list[str]) -> dict[str, Any] | None:
    """The sum of two spring balancers of one shape; None where they differ in it."""
    if any(old[name] != new[name] for name in ("dead_center", "ratio", "rise")):
        return None
    return {**old, "torque": total(old["torque"], new["torque"])}


#: Two entries of one effect as one, by what they are; ``remarks`` say where the sum is not exact.
COMBINED: Mapping[Combination, Callable[[Settings, Settings, list[str]], dict[str, Any] | None]] = {
    "springs": springs,
    "waves": waves,
    "bearings": bearings,
    "balancers": balancers,
}


def _kind(settings: Settings) -> str:
    """A journal without a span is a radial bearing."""
    kind: str = settings["bearing"]
    return "radial" if kind == "journal" and "span" not in settings else kind
