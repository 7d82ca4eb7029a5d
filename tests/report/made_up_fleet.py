"""A fleet's result that was made up, for the tests of its page, its files and its lines."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np

from robodyn.draw.scales import DAY
from robodyn.fleet.result import Claim, Feature, FleetResult, Look, Reading, TypeResult, UnitResult, Unused

START: Final = 1_735_689_600.0  # 2025-01-01
#: Effects of a feature, its unit at a revolute and at a prismatic joint, its mean.
_KINDS: Final = (
    ("friction", ("coulomb_friction", "viscous_friction"), "N m", "N", 4.0),
    ("backlash", ("backlash",), "rad", "m", 2e-4),
    ("bias", ("torque_bias",), "N m", "N", 0.1),
)
#: Name, joints, the prismatic one.
TYPES: Final = (("arm<6>", 6, None), ("scara", 4, 3), ("seven", 7, None))
EVERY: Final = 16


def features(joints: int, slide: int | None, logs: int) -> tuple[Feature, ...]:
    at_joints = [
        Feature(
            f"joint{j}.{name}", effects, j, straight if j == slide else turning, mean * (1 + 0.1 * j),
            0.1 * mean, 0.05 * mean, {"temperature": -0.01 * mean} if name == "friction" else {}, logs,
        )
        for j in range(1, joints + 1)
        for name, effects, turning, straight, mean in _KINDS
    ]  # fmt: skip
    return (*at_joints, Feature("payload.mass", ("payload",), None, "kg", 0.0, 0.05, 0.1, {}, logs))


def claim(feature: Feature, k: int, first: float, last: float) -> Claim:
    """A drift, a step or what has always been so, in turn."""
    shape = ("drift", "step", "always")[k % 3]
    since = None if shape == "always" else first + (0.3 + 0.4 * (k % 7) / 7) * (last - first)
    size = feature.mean * 0.25 if feature.mean else 2.0
    return Claim(
        feature.effects, feature.joint, feature.name, shape, since,  # type: ignore[arg-type]
        None if since is None else (since - 12 * DAY, since + 9 * DAY),
        since + 60 * DAY if since is not None and k % 6 == 0 and since + 60 * DAY < last else None,
        size, size / 12, feature.unit,
        0.25 if feature.mean else None, 1e-9 * (k + 1), 1e-7 * (k + 1),
    )  # fmt: skip


def fleet(units: int = 1000, claims: int = 60) -> FleetResult:
    """Units of three types with 5 to 16 logs over a year, the first ``claims`` of which are peculiar."""
    rng = np.random.default_rng(31)
    kinds = [(name, features(joints, slide, units)) for name, joints, slide in TYPES]
    results = []
    for k in range(units):
        kind, own = kinds[k % 3]
        dates = START + np.sort(rng.uniform(0, 364 * DAY, int(rng.integers(5, EVERY + 1))))
        first, last = float(dates[0]), float(dates[-1])
        named = () if k >= claims else (claim(own[(7 * k) % len(own)], k, first, last),)
        readings, now, unusual = {}, {}, {}
        for feature in own:
            offset = rng.normal(0, feature.between_units)
            values = feature.mean + offset + rng.normal(0, feature.between_logs, len(dates))
            unusual[feature.name] = offset / feature.between_units
            for one in named:
                if one.feature == feature.name:
                    values += one.size * (dates >= (one.since or 0.0))
                    unusual[feature.name] = 9.5
            readings[feature.name] = tuple(
                Reading(float(date), float(value), feature.between_logs / 2)
                for date, value in zip(dates, values, strict=True)
            )
            now[feature.name] = (float(values[-1]), feature.between_logs / 3)
        results.append(
            UnitResult(
                kind, f"{kind[:2].upper()}-{k:04d}", len(dates), first, last, named, readings, now, unusual,
                f"units/x/{k}/report.html" if named and k % 2 else None,
            )
        )  # fmt: skip
    looks = tuple(
        Look(unit.type, unit.unit, f"{unit.claims[0].feature} has changed", "Record the same motion again.")
        for unit in results[: min(10, claims)]
    )
    types = tuple(
        TypeResult(name, joints, len(members), sum(u.logs for u in members), own, ())
        for (name, own), (_, joints, _) in zip(kinds, TYPES, strict=True)
        if (members := [u for u in results if u.type == name])
    )
    unused = (Unused("logs/a.csv", TYPES[0][0], "AR-0000", "times go backward"),)
    ordered = tuple(sorted(results, key=lambda u: (u.type, u.unit)))
    return FleetResult("plant", types, ordered, unused, looks, 0.05)


def of_one() -> FleetResult:
    """One unit with one log, nothing that could be said of it, and no value at all of one feature."""
    whole = fleet(1, 0)
    (unit,) = whole.units
    single = {name: several[:1] for name, several in unit.readings.items()}
    name = next(iter(single))
    single[name] = ()
    unit = replace(
        unit, logs=1, last=unit.first, readings=single, now={k: v for k, v in unit.now.items() if k != name},
        unusual={**unit.unusual, name: float("nan")},
    )  # fmt: skip
    alone = replace(whole.types[0], logs=1, units=1)
    return replace(whole, types=(alone,), units=(unit,), unused=())
