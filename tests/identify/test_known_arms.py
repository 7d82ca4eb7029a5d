"""Identification of logs by another engine, and of real arms."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import robodyn
from peers.numbers import number
from robodyn.robot import load
from robodyn_testing import require_module

EXAMPLES = Path(__file__).parents[2] / "examples"
NONE = Fraction(0)


@pytest.mark.parametrize(
    ("arm", "logs"),
    [
        ("tx40/tx40.yaml", ["tx40/tx40.csv"]),
        ("real/ur10_bag/ur10_bag.yaml", ["real/ur10_bag/ur10_bag.csv"]),
        ("real/panda_bag/panda_bag.yaml", ["real/panda_bag/panda_bag.csv"]),
        pytest.param(
            "real/kr300/kr300.yaml", [f"real/kr300/kr300_{x}.csv" for x in "ABC"], marks=pytest.mark.thorough
        ),
    ],
    ids=lambda x: x.partition("/")[0] if isinstance(x, str) else "",
)
@pytest.mark.thorough
def test_real_arms_are_possible_and_as_near_as_plain_least_squares(
    arm: str, logs: list[str], tmp_path: Path
) -> None:
    outcome = robodyn.identify(EXAMPLES / arm, [EXAMPLES / log for log in logs])
    residual = outcome.residual
    assert np.all(residual.validate_after < 1.1 * residual.validate_plain)
    assert np.mean(residual.validate_after / residual.validate_before) < 0.8
    path = tmp_path / "identified.yaml"
    path.write_text(outcome.model_text, encoding="utf-8")
    assert load(path, strict=True) == outcome.model


def test_friction_of_the_ur10_is_what_its_owners_published() -> None:
    """Half of the jump at zero velocity, in N m (inverse-dynamics-solver, commit 41e196d)."""
    published = (13.9, 17.2, 9.4, 2.6, 2.8, 3.5)
    folder = EXAMPLES / "real" / "ur10_bag"
    outcome = robodyn.identify(folder / "ur10_bag.yaml", [folder / "ur10_bag.csv"])
    for j, level in enumerate(published, 1):
        value = outcome.parameters[f"joint{j}.coulomb_friction.level"].value
        assert value == pytest.approx(level, rel=0.3), j


@pytest.mark.thorough
def test_errors_are_those_of_logs_by_another_engine() -> None:
    """MuJoCo moves the arm: what is seen lies within four standard errors, and most of it within two."""
    require_module("mujoco")
    from benchmarks.blind_arms.logs import effect, hidden_log

    friction = [
        effect(id, j, **{name: size * j})
        for j in (1, 2, 3)
        for id, name, size in (
            ("viscous_friction", "coefficient", 1.5),
            ("coulomb_friction", "level", 2.0),
        )
    ]
    hidden = hidden_log("puma560_3dof", friction, seed=3, rate=500.0, inertia_error=0.1, validation=False)
    links = tuple(replace(link, joint=replace(link.joint, motor_inertia=NONE)) for link in hidden.given.links)
    outcome = robodyn.identify(replace(hidden.given, links=links), [hidden.train])
    z = []
    for j, link in enumerate(hidden.truth.robot.links, 1):
        for name, value in (
            ("viscous_friction.coefficient", link.joint.viscous),
            ("coulomb_friction.level", link.joint.coulomb),
            ("rotor_inertia.inertia", link.joint.motor_inertia),
        ):
            one = outcome.parameters[f"joint{j}.{name}"]
            assert one.stderr is not None
            z.append(abs(one.value - number(value)) / one.stderr)
    assert max(z) < 4
    assert np.median(z) < 2
    assert np.all(outcome.residual.validate_after < 1.02 * outcome.residual.validate_plain)
