"""What numbers of links change at the motors, beside an arm whose number was changed."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.identify.motor_regressor import lagging_regressor, motor_regressor
from robodyn.identify.twist import behind_motors
from robodyn.kernels.array_dynamics import Model, physical
from robodyn.robot import load
from robodyn.robot.model import Inertia

ARM = load("puma560", warn=lambda _: None)
Q, QD, QDD = np.random.default_rng(3).standard_normal((3, 40, ARM.n))
SIZES = np.ones((ARM.n, 10))


def test_of_a_rigid_arm_it_is_the_regressor() -> None:
    model = Model(ARM)
    slopes = motor_regressor(model, Q, QD, QDD, SIZES)
    np.testing.assert_allclose(slopes, model.regressor(Q, QD, QDD), atol=1e-9)
    some = SIZES.copy()
    some[2, 0] = 0
    assert not motor_regressor(model, Q, QD, QDD, some)[:, :, 2, 0].any()


@pytest.mark.parametrize("bearing", [{"bearing": "radial", "mu_r": 0.01}, {"bearing": "torque", "mu": 0.1}])
def test_bearings_feel_masses(bearing: dict[str, float | str]) -> None:
    loaded = amended(ARM, [Amendment("load_dependent_friction", 3, bearing)])

    def torque(more: float) -> NDArray[np.float64]:
        """With a mass more at the origin of link 3."""
        phi = Model(loaded).standard_parameters()[2]
        phi[0] += more
        mass, x, y, z, *inertia = map(Fraction, physical(phi))
        link = replace(loaded.links[2], mass=mass, com=(x, y, z), inertia=Inertia(*inertia))
        return Model(replace(loaded, links=(*loaded.links[:2], link, *loaded.links[3:]))).torque(Q, QD, QDD)

    expected = (torque(1e-3) - torque(-1e-3)) / 2e-3
    slopes = motor_regressor(Model(loaded), Q, QD, QDD, SIZES)[:, :, 2, 0]
    np.testing.assert_allclose(slopes, expected, atol=1e-3 * np.abs(expected).max())
    pressed = np.abs(slopes - Model(ARM).regressor(Q, QD, QDD)[:, :, 2, 0])[:, 2].max()
    assert (pressed > 0.01) == (bearing["bearing"] == "radial")  # at the axis a mass has no torque


@pytest.mark.parametrize("effect", ["joint_elasticity", "backlash"])
def test_links_behind_their_motors_swing_with_their_own_inertia(effect: str) -> None:
    numbers: dict[str, float | str] = {"stiffness": 3000.0, "damping": 20.0}
    more: dict[str, float | str] = {"gap": 0.002, "transition": 0.2} if effect == "backlash" else {}
    soft = amended(ARM, [Amendment(effect, 2, {**numbers, **more, "encoder": "motor"})])
    t, period = np.arange(3000) * 1e-3, 1e-3
    motion = tuple(
        0.3 * 9.0**k * np.sin(9.0 * t[:, None] + np.arange(ARM.n) + k * np.pi / 2) for k in range(3)
    )

    def torque(more: float) -> NDArray[np.float64]:
        """With more inertia about link 3's axis."""
        link = soft.links[2]
        heavier = replace(link, inertia=replace(link.inertia, zz=link.inertia.zz + Fraction(more)))
        arm = replace(soft, links=(*soft.links[:2], heavier, *soft.links[3:]))
        return behind_motors(Model(arm), motion[0], motion[1], motion[2], period).total

    expected = ((torque(1e-4) - torque(-1e-4)) / 2e-4)[::8]
    slopes = lagging_regressor(Model(soft), (motion[0], motion[1], motion[2]), period, 8)[0][:, :, 2, 6]
    later = slice(200, None)  # a link that begins at rest swings in
    size = np.abs(expected[later]).max()
    np.testing.assert_allclose(slopes[later], expected[later], atol=0.02 * size)
    rigid = Model(ARM).regressor(*(x[::8] for x in motion))[:, :, 2, 6]
    assert np.abs(rigid - expected)[later].max() > 0.1 * size
