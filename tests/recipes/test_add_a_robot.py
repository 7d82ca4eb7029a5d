"""The recipe "Add a robot" of CONTRIBUTING.md, carried out in a copy of the package."""

from __future__ import annotations

import numpy as np
import pytest

import robodyn
from recipes.copies import Copy, commands_in_recipe, source_in_recipe

TITLE = "Add a robot"
FILE = "robots/scara.yaml"


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Copy:
    return Copy(tmp_path_factory.mktemp("robot"), {FILE: source_in_recipe(TITLE, "robots/NAME.yaml")})


def test_every_command_of_the_recipe_works(copy: Copy) -> None:
    commands = commands_in_recipe(TITLE)
    assert [command[0] for command in commands] == ["robots", "gen", "verify", "flops"]
    for command in commands:
        copy.robodyn(*command)


def test_the_numbers_are_right(copy: Copy) -> None:
    """One torque by hand: what the stroke carries. The recipe itself verifies the rest."""
    arm = robodyn.load(str(copy.folder / FILE)).at({"m_load": 0.5})
    torques = robodyn.compile(arm, functions=["gravity"]).gravity([0.3, -0.4, 0.1, 0.2])
    np.testing.assert_allclose(torques, [0, 0, -(1.1 + 0.4 + 0.5) * 9.81, 0], atol=1e-12)
