"""Diagnoses and results of fleets that were made up, for the tests of their pages, files and lines."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Final

import numpy as np

from robodyn.diagnose.result import Diagnosis, Estimate, Finding, Gap, Rival, Series, Tried, Window
from robodyn.draw.scales import DAY
from robodyn.fleet.result import (
    Claim,
    Feature,
    FleetResult,
    Look,
    NotObserved,
    OddLog,
    Reading,
    TypeResult,
    UnitResult,
    Unused,
)
from robodyn.robot import Robot


def series(name: str, n: int, samples: int = 1500) -> Series:
    """A motion with friction that is explained afterwards."""
    t = np.linspace(0, 10, samples)
    q = np.sin(np.outer(t, 1 + 0.1 * np.arange(n)))
    qd = np.gradient(q, t, axis=0)
    noise = 0.1 * np.random.default_rng(1).standard_normal((samples, n))
    load_ = 30 * np.cos(q)
    return Series(name, t, q, qd, -q, load_, load_ + np.sign(qd), np.sign(qd) + noise, noise)


def made(robot: Robot, **changes: Any) -> Diagnosis:
    """A diagnosis that found Coulomb friction."""
    n = robot.n
    size = np.arange(1, n + 1, dtype=np.float64)
    finding = Finding(
        "coulomb_friction", 3, {"level": Estimate(2.9012, 0.0531, "N m")}, 0.97, ("stribeck_friction",),
        "joint 3: a step where the velocity reverses", "slow reversals of joint 3", 812.5, 40.0,
        (Rival("stribeck_friction", 3, 806.25), Rival("viscous_friction", 3, 203.125)),
    )  # fmt: skip
    found = Diagnosis(
        verdict="missing_effect",
        findings=(finding,),
        gap=Gap(4 * size, 1.1 * size, 5 * size, 1.25 * size, size, (10 * size, 10 * size)),
        robot=robot,
        model=robot,
        model_text="name: x\n",
        diff="--- a/model.yaml\n+++ b/model.yaml\n@@ -1 +1 @@\n-old: 1\n+new: 2\n same: 3\n",
        flags=("tau2: 3 rows cut off",),
        left=np.linspace(0.1, 0.5, n),
        words=("a remark",),
        logs=({"name": "one.csv", "sha256": "ab" * 32}, {"name": "two.csv", "sha256": "cd" * 32}),
        rest=np.full(n, 0.01),
        series=(series("train", n), series("validate", n)),
        operations=(80, 83),
    )
    return replace(found, **changes)


def many(n: int) -> tuple[Finding, ...]:
    """Findings of an arm of ``n`` joints, 6 or more, that was described from its drawings; one suspicion."""

    def one(effect: str, joint: int | None, unit: str, sure: float = 0.95, **values: float) -> Finding:
        numbers = {name: Estimate(value, abs(value) / 20, unit) for name, value in values.items()}
        return Finding(effect, joint, numbers, sure, (), f"{effect} shows", None, 90.0, 9.0, (), (9.0, 8.0))

    joints = range(1, n + 1)
    return (
        *(one("coulomb_friction", j, "N m", level=1.0 + j) for j in joints),
        *(one("viscous_friction", j, "N m s/rad", coefficient=2.0 + j) for j in joints),
        *(one("rotor_inertia", j, "kg m^2", inertia=0.1 * j) for j in joints),
        one("motor_coupling", n, "N m", **{"with": n - 1.0, "ratio": 1.0, "coulomb": 1.6}),
        one("torque_ripple", 4, "N m", amplitude=0.5, phase=0.1),
        one("payload", None, "kg", mass=2.0),
        one("spring", 4, "N m/rad", 0.3, stiffness=0.1),
    )


#: A text that would do harm where it is not escaped.
HOSTILE: Final = (
    '<script>alert("1")</script>&amp;\'</title></svg></style>{{ 7 * 7 }}<img src=x onerror="alert(2)">'
)


def hostile(robot: Robot) -> Diagnosis:
    """A diagnosis whose every text is an attack."""
    finding = Finding(
        HOSTILE, None, {HOSTILE: Estimate(HOSTILE, None, HOSTILE)}, 0.9, (HOSTILE,), HOSTILE, HOSTILE,
        1.0, 1.0, (Rival(HOSTILE, 1, 0.5),),
    )  # fmt: skip
    return made(
        replace(robot, title=HOSTILE), findings=(finding,), diff=f"+{HOSTILE}\n-{HOSTILE}\n",
        words=(HOSTILE,), flags=(HOSTILE,), logs=({"name": f"{HOSTILE}.csv", "sha256": HOSTILE},),
        windows=(Window("train", 1.0, 2.0, HOSTILE),), tried=(Tried(HOSTILE, 1, 1.0, 1.0, HOSTILE),),
    )  # fmt: skip


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
                Reading(float(date), float(value), feature.between_logs / 2, 1 + (k + n) % 2)
                for n, (date, value) in enumerate(zip(dates, values, strict=True))
            )
            now[feature.name] = (float(values[-1]), feature.between_logs / 3)
        results.append(
            UnitResult(
                kind, f"{kind[:2].upper()}-{k:04d}", len(dates), first, last, named, readings, now, unusual,
                f"units/x/{k}/report.html" if named and k % 2 else None,
            )
        )  # fmt: skip
    looks = tuple(
        Look(
            unit.type,
            unit.unit,
            f"{unit.claims[0].feature} has changed",
            "check it",
            "Record the same motion again.",
        )
        for unit in results[: min(10, claims)]
    )
    types = tuple(
        TypeResult(name, joints, len(members), sum(u.logs for u in members), 2, own, ())
        for (name, own), (_, joints, _) in zip(kinds, TYPES, strict=True)
        if (members := [u for u in results if u.type == name])
    )
    unused = (Unused("logs/a.csv", TYPES[0][0], "AR-0000", "times go backward"),)
    ordered = tuple(sorted(results, key=lambda u: (u.type, u.unit)))
    unseen = (NotObserved(TYPES[0][0], "AR-0000", 6, "it does not move in 5 of 9 logs", "record it"),)
    odd = (OddLog(TYPES[0][0], "AR-0000", "logs/b.csv", START, "joint1.friction"),)
    return FleetResult("plant", types, ordered, unused, unseen, odd, looks, 0.05)


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
