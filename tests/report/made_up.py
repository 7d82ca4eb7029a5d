"""Diagnoses that were made up, for the tests of their page and their lines."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from robodyn.diagnose.result import Diagnosis, Estimate, Finding, Gap, Rival, Series
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
