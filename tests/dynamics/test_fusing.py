"""Several functions in one: the same results, no more operations than apart; refused where senseless."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest

from ir.programs import Point, exactly
from robodyn import Options, compile, load, program
from robodyn.counts import count
from robodyn.dynamics.functions import function_named, fusing
from robodyn.errors import InputError
from robodyn.kernels.proof import Unequal
from robodyn.verify.check import verify
from robodyn_testing import representative

FAST = Options(optimize="fast")
TOGETHER = "bias_and_mass_matrix"


@pytest.mark.parametrize("robot", representative(["puma560", "stanford", "ur10", "tx40"], "stanford", "tx40"))
@pytest.mark.parametrize("options", [Options(), FAST], ids=["record", "fast"])
def test_the_results_are_those_of_the_parts(robot: str, options: Options) -> None:
    arm, at = load(robot, warn=lambda _: None), Point(5)
    together = program(arm, TOGETHER, options)
    apart = [program(arm, name, options) for name in ("bias", "mass_matrix")]
    if robot != "tx40":  # friction of its drives has no exact value
        assert exactly(together, at) == {**exactly(apart[0], at), **exactly(apart[1], at)}
    assert count(together).total <= sum(count(part).total for part in apart)
    sines = Counter(op.op for op in together.operations)["sin"]
    assert sines <= max(Counter(op.op for op in part.operations)["sin"] for part in apart) + 2


def test_it_is_compiled_and_compared_with_the_references() -> None:
    robot = load("puma560_3dof")
    kernel = compile(robot, functions=[TOGETHER, "bias", "mass_matrix"])
    q, qd = np.random.default_rng(1).uniform(-2, 2, (2, 5, 3))
    tau, M = kernel.bias_and_mass_matrix(q, qd)
    np.testing.assert_allclose(tau, kernel.bias(q, qd), rtol=1e-12)
    np.testing.assert_allclose(M, kernel.mass_matrix(q), rtol=1e-12)
    report = verify(robot, kernel, states=20)
    assert report.passed
    assert {c.against for c in report.comparisons if c.function == TOGETHER} == {
        "reference",
        "exact",
        "lagrangian",
    }


def test_a_wrong_part_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    room = "robodyn.kernels.rigid_programs"
    monkeypatch.setattr(
        f"{room}.one_after_another", lambda writings, _: lambda at: writings[1](at) + writings[1](at)[:3]
    )
    monkeypatch.setattr(f"{room}.side_by_side", lambda function, programs: programs[1])
    with pytest.raises(Unequal, match="bias_and_mass_matrix of"):
        program(load("puma560_3dof"), TOGETHER, Options(optimize="fast"))


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("bias_and_gravity", "bias and gravity cannot be fused; found both give tau; leave one of them out"),
        (
            "bias_and_mass_matri",
            r"unknown function 'mass_matri'; expected one of .*did you mean 'mass_matrix'\?",
        ),
        ("bias_and_bias", "bias and bias cannot be fused"),
        ("bias_and_forward_dynamics", "found tau is a result of one and an input of the other"),
    ],
)
def test_what_cannot_be_fused(name: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        function_named(name)
    with pytest.raises(InputError, match="one function alone cannot be fused"):
        fusing.fused([function_named("bias")])
