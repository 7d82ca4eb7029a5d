"""Arms as plain data: Denavit-Hartenberg numbers, masses, effects; and as the text that robodyn reads.

The reference (:mod:`independent.reference`) takes the data, robodyn the text. Numbers are drawn once from a
seed and rounded, so that none is special; a right angle is one where it is asked for.
"""

from __future__ import annotations

import json
import random
from collections.abc import Mapping
from typing import Any, Final

Arm = dict[str, Any]

CONVENTIONS: Final = ("mdh", "sdh")


def _body(rng: random.Random) -> dict[str, Any]:
    """Mass, centre and inertia about it of five points of mass, along axes that are no principal ones."""
    points = [[rng.uniform(-0.3, 0.3) for _ in range(3)] for _ in range(5)]
    masses = [rng.uniform(0.2, 1.5) for _ in points]
    mass = sum(masses)
    com = [sum(m * x[k] for m, x in zip(masses, points, strict=True)) / mass for k in range(3)]
    second = [
        [
            sum(m * (x[i] - com[i]) * (x[j] - com[j]) for m, x in zip(masses, points, strict=True))
            for j in range(3)
        ]
        for i in range(3)
    ]
    trace = sum(second[k][k] for k in range(3)) + 0.003
    inertia = {"xyz"[i] + "xyz"[i]: round(trace - second[i][i], 5) for i in range(3)}
    for i, j in ((0, 1), (0, 2), (1, 2)):
        inertia["xyz"[i] + "xyz"[j]] = round(-second[i][j], 5)
    return {"mass": round(mass, 3), "com": [round(x, 4) for x in com], "inertia": inertia}


def arm(joints: str, convention: str, seed: int, **more: Any) -> Arm:
    """An arm of ``joints`` (a letter each, R or P), with general numbers; ``more`` are
    keys of the whole description (``base``, ``tool``, ``gravity``, ``torque_side`` ...)."""
    rng = random.Random(seed)
    links = []
    for kind in joints:
        row = {x: round(rng.uniform(0.1, 0.6) * rng.choice((-1, 1)), 3) for x in ("a", "d", "theta")}
        link: Arm = {"joint": "revolute" if kind == "R" else "prismatic", **row}
        link["alpha"] = round(rng.uniform(0.4, 1.3) * rng.choice((-1, 1)), 3)
        link.update(_body(rng))
        link["motor_inertia"] = round(rng.uniform(0.05, 0.6), 3)
        link["gear"] = {
            "ratio": round(rng.uniform(20, 90), 1),
            "torque_constant": round(rng.uniform(0.05, 0.2), 3),
        }
        links.append(link)
    return {
        "name": f"arm_{joints.lower()}_{convention}",
        "convention": convention,
        "gravity": [0.7, -1.3, -9.4],
        "links": links,
        **more,
    }


BASE: Final = {"xyz": [0.3, -0.2, 0.5], "rpy": [0.4, -0.7, 1.1]}
TOOL: Final = {"xyz": [0.05, -0.12, 0.21], "rpy": [-0.6, 0.3, 0.8]}


def placed(joints: str, convention: str, seed: int) -> Arm:
    """The same, on a base and with a tool that are turned and moved."""
    return arm(joints, convention, seed, base=BASE, tool=TOOL)


def text(arm: Mapping[str, Any]) -> str:
    """The description that robodyn reads: JSON is YAML."""
    return json.dumps({key: value for key, value in arm.items() if key != "values"}, indent=1)
