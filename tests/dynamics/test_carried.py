"""Moments carried into the parent's frame in whole numbers: the same as step by step in fractions."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest

from robodyn.dynamics.arm import Symmetric
from robodyn.dynamics.carried import carried
from robodyn.dynamics.lump import Lump
from robodyn.dynamics.regroup import about_axis_x, shifted
from robodyn.ir import Graph


def number(chance: random.Random) -> int | Fraction:
    kind = chance.randrange(4)
    if kind == 0:
        return 0
    return (
        chance.randrange(-3, 4)
        if kind == 1
        else Fraction(chance.randrange(-99, 99), chance.randrange(1, 999))
    )


@pytest.mark.parametrize("seed", range(40))
def test_the_same_numbers(seed: int) -> None:
    chance = random.Random(seed)
    m, x, y, z, *second, p0, p1, p2 = (number(chance) for _ in range(13))
    lump = Lump(m, (x, y, z), Symmetric(*second))
    t = Fraction(chance.randrange(9), chance.randrange(1, 9))
    c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    expected = shifted(about_axis_x(lump, c, s), (p0, p1, p2))
    assert carried(lump, c, s, (p0, p1, p2)) == expected


@pytest.mark.parametrize("other", [0.5, Graph().constant(Fraction(1, 3))])
def test_other_scalars_go_step_by_step(other: Any) -> None:
    lump = Lump(1, (0, 0, other), Symmetric(0, 0, 1, 0, 0, 0))
    assert carried(lump, 1, 0, (0, 0, 0)) is None
