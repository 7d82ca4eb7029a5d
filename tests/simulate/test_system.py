"""Arms that cannot be simulated are refused before anything is compiled."""

from __future__ import annotations

from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn.robot import Robot, load
from robodyn.simulate.system import system_of

ARM = """\
name: arm
links:
- {joint: revolute, mass: 1, com: [0.1, 0, 0]}
- {joint: revolute, a: 0.3%s}
"""


def arm(folder: Path, last: str) -> Robot:
    """The arm, with ``last`` at its second link."""
    file = folder / "arm.yaml"
    file.write_text(ARM % last)
    return load(file, warn=lambda _: None)


@pytest.mark.parametrize("last", ["", ", mass: 1", ", motor_inertia: 1e-320"])
def test_a_joint_that_moves_without_inertia_is_named(last: str, tmp_path: Path) -> None:
    """Without a mass, with one on its axis, with a rotor too small to count."""
    with pytest.raises(InputError, match="nothing resists the acceleration of joint 2"):
        system_of(arm(tmp_path, last))


@pytest.mark.parametrize(
    "last", [", motor_inertia: 1e-9", ", mass: 1, com: [0.001, 0, 0]", ", mass: m, com: [1, 0, 0]"]
)
def test_a_little_inertia_is_enough(last: str, tmp_path: Path) -> None:
    assert system_of(arm(tmp_path, last)).coordinates == 2
