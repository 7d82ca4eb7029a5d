"""What numbers of links change at the motors, beside an arm whose number was changed."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.identify.felt import felt
from robodyn.identify.rigid import Model, physical
from robodyn.robot import load
from robodyn.robot.model import Inertia

ARM = load("puma560", warn=lambda _: None)
Q, QD, QDD = np.random.default_rng(3).standard_normal((3, 40, ARM.n))
SIZES = np.ones((ARM.n, 10))


def test_of_a_rigid_arm_it_is_the_regressor() -> None:
    model = Model(ARM)
    slopes = felt(model, Q, QD, QDD, SIZES)
    np.testing.assert_allclose(slopes, model.regressor(Q, QD, QDD), atol=1e-9)
    some = SIZES.copy()
    some[2, 0] = 0
    assert not felt(model, Q, QD, QDD, some)[:, :, 2, 0].any()


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
    slopes = felt(Model(loaded), Q, QD, QDD, SIZES)[:, :, 2, 0]
    np.testing.assert_allclose(slopes, expected, atol=1e-3 * np.abs(expected).max())
    pressed = np.abs(slopes - Model(ARM).regressor(Q, QD, QDD)[:, :, 2, 0])[:, 2].max()
    assert (pressed > 0.01) == (bearing["bearing"] == "radial")  # at the axis a mass has no torque
