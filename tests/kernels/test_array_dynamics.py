"""The dynamics on arrays of samples are those of the reference, whatever the drives have."""

from __future__ import annotations

import numpy as np
import pytest

from robodyn.errors import InputError
from robodyn.kernels.array_dynamics import Model
from robodyn.verify import Reference
from robodyn_testing.effect_arms import arm


@pytest.mark.parametrize(
    ("name", "values"), [("rubbing", {"f_s": 5.5, "m_load": 2.8}), ("sliding", {"c_1": 3.25})]
)
def test_torques_regressor_and_mass_matrix_are_those_of_the_reference(
    name: str, values: dict[str, float]
) -> None:
    robot = arm(name)
    q, qd, qdd = np.random.default_rng(0).uniform(-1, 1, (3, 200, robot.n))
    model, reference = Model(robot, values), Reference(robot, values)
    torques = model.evaluate(q, qd, qdd)
    expected = reference.inverse_dynamics(q, qd, qdd)
    np.testing.assert_allclose(torques.total, expected, rtol=0, atol=1e-12 * np.abs(expected).max())
    rigid = np.einsum("knlp,lp->kn", model.regressor(q, qd, qdd), model.standard_parameters())
    np.testing.assert_allclose(rigid, torques.rigid, rtol=0, atol=1e-12 * np.abs(rigid).max())
    matrices = reference.mass_matrix(q)
    np.testing.assert_allclose(model.mass_matrix(q), matrices, rtol=0, atol=1e-12 * np.abs(matrices).max())


def test_a_run_time_parameter_without_a_value_is_refused() -> None:
    with pytest.raises(InputError, match=r"--param f_s=VALUE"):
        Model(arm("rubbing"), {"m_load": 2.8})
