"""Gas springs: their torque is that of the strut they stand for, and the slope of their energy."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from robodyn.effects.catalogue import effect
from robodyn.effects.effect import Site
from robodyn.errors import InputError
from robodyn.robot import read_text

GAS = effect("gas_spring")


def torque(q: Any, **p: float) -> Any:
    assert GAS.equation is not None
    return GAS.equation({"dead_center": 0.0, "rise": 0.0, **p}, Site(True, q))


def test_the_strut_of_a_large_arm_in_newtons_and_metres() -> None:
    """A KUKA KR300's, by the numbers of Robot_Identification (Weigand 2021): pivots at 0.8 m and 0.2 m from
    the axis, 0.159 kg of nitrogen at 328 K in 0.96 litres if retracted, a piston of 55 mm on a rod of 30."""
    fixed, crank, volume = 0.8, 0.2, 2 * 0.48e-3
    area = math.pi * (0.055**2 - 0.030**2) / 4
    gas = 1.01 * 296.8 * 328 * 2 * 0.0795  # J: pressure times volume
    q = np.linspace(-0.9, 0.8, 61)
    delta = q - math.radians(-5)
    length = np.sqrt(fixed**2 + crank**2 - 2 * fixed * crank * np.cos(delta))
    pressure = gas / (volume - (length - (fixed - crank)) * area)
    arm = np.sin(delta) * fixed * crank / length
    preload = gas / volume * area * crank
    own = torque(
        q, torque=preload, rise=area * crank / volume, dead_center=math.radians(-5),
        ratio=crank / fixed,
    )  # fmt: skip
    # Gas is a little stiffer than a straight line.
    np.testing.assert_allclose(own, pressure * area * arm, rtol=0.03)
    assert own.min() == pytest.approx(-5440, rel=0.03)


def test_it_holds_the_joint_at_its_dead_centre_and_whether_it_pulls_or_pushes() -> None:
    near = np.array([0.29, 0.31])
    for ratio in (-0.5, 0.0, 0.5):
        below, above = torque(near, torque=2.0, dead_center=0.3, ratio=ratio, rise=0.2)
        assert below < 0 < above


@pytest.mark.parametrize(
    ("joint", "keys", "message"),
    [
        ("prismatic", "torque: 1", "torque needs a crank, and a prismatic joint has none"),
        ("revolute", "torque: 1, ratio: 1", "ratio is so large that pivots nearly meet"),
        ("revolute", "torque: 1, rise: -2", "rise is negative"),
        ("revolute", "torque: 1, dead_center: 2000", "dead_center is so many turns"),
        ("revolute", "torque: -1", "torque is negative"),
    ],
)
def test_what_no_strut_is_is_refused(joint: str, keys: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        read_text(f"name: arm\nlinks: [{{joint: {joint}, effects: [{{effect: gas_spring, {keys}}}]}}]")
