"""Arms and programs that a walk is tried on: ordinary ones, and those with little or nothing to rewrite."""

from __future__ import annotations

from typing import Any, Final

import pytest

from records.made import SMOOTH, TOOL, arm, bundled
from robodyn.ir import Program
from robodyn.robot import Robot
from robodyn.search import climb as climbing
from robodyn.search import improve as improving
from robodyn.search.climb import climb
from robodyn_testing.clocks import ticking
from robodyn_testing.random_robots import random_robot

__all__ = ["SPECIAL", "arm", "bundled", "random_arms"]

_LINK: Final = "mass: 2, com: [0.1, 0.2, 0.3], inertia: {xx: 0.1, yy: 0.2, zz: 0.3}"

#: Texts by what is special about them.
TEXTS: Final = {
    "tool": TOOL,
    "smooth": SMOOTH,
    "wheel": "{joint: revolute, inertia: {zz: 2}}",
    "unit": "{joint: revolute, inertia: {zz: 1}}",
    "nothing": "{joint: revolute}",
    "parameter": "{joint: revolute, inertia: {zz: i_zz}}",
    "pendulum": f"{{joint: revolute, alpha: pi/2, {_LINK}}}",
    "slide": f"{{joint: prismatic, alpha: 0.3, {_LINK}}}",
    "twice the same": "{joint: prismatic}\n  - {joint: prismatic, mass: 2}",
    "opposite": "{joint: prismatic}\n  - {joint: prismatic, alpha: pi, mass: 2}",
    "friction alone": "{joint: revolute, friction: {coulomb: 3, viscous: 2}, inertia: {zz: 2}}",
    "massless tip": f"{{joint: revolute, alpha: 0.4, {_LINK}}}\n  - {{joint: revolute, alpha: pi/2, a: 0.3}}",
}


def _described(name: str, text: str) -> Robot:
    if not text.startswith("name"):
        text = f"name: arm_{name.replace(' ', '_')}\nlinks:\n  - {text}\n"
    return arm(text)


SPECIAL: Final = {name: _described(name, text) for name, text in TEXTS.items()}


def random_arms(count: int, *, joints: int) -> list[Robot]:
    """Random arms of up to so many joints: friction, sliding joints, angles that are no right ones."""
    return [
        random_robot(seed, joints=1 + seed % joints, full=bool(seed % 2), friction=0.5, exotic=0.1, aside=0.3)
        for seed in range(count)
    ]


def search_for_a_moment(patch: pytest.MonkeyPatch) -> None:
    """Let walks be short, and a second of them ten thousand steps.

    A search for any algebra takes a second of it otherwise, however short it is.
    """
    ticking(patch, {climbing: 0.1})

    def climbs(programs: Any, *, seconds: float, **more: Any) -> list[Program]:
        return climb(programs, seconds=min(seconds, 0.25), **more)

    patch.setattr(improving, "climb", climbs)
