"""Functions that are too large for any compiler are refused before they take all memory."""

import pytest

from robodyn import InputError, Options
from robodyn.ir import graph
from robodyn.kernels.generate import generate
from robodyn.optimize import merging
from robodyn.robot import load


@pytest.fixture
def small_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    """More than the torques of three joints take, and less than their derivatives."""
    for module in (graph, merging):
        monkeypatch.setattr(module, "MOST_POSITIONS", 400)


@pytest.mark.usefixtures("small_limit")
def test_a_function_that_is_too_large_is_refused_by_its_name() -> None:
    with pytest.raises(InputError) as refused:
        generate(load("puma560_3dof"), Options(("inverse_dynamics", "forward_dynamics_derivatives")))
    assert "forward_dynamics_derivatives" in refused.value.what
    assert (refused.value.found or "").startswith("3 joints, more than ")
    assert refused.value.remedy


@pytest.mark.usefixtures("small_limit")
def test_of_all_functions_those_that_are_too_large_are_left_out() -> None:
    generated = generate(load("puma560_3dof"), Options(("all",), optimize="fast"))
    assert "inverse_dynamics" in generated.counts
    assert "3 joints" in generated.left_out["forward_dynamics_derivatives"]
