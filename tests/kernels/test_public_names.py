"""The names of the package: each takes a robot, a path or a name."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import robodyn
from robodyn.robot import bundled_names, bundled_text
from robodyn_testing import sampled

NAME = "stanford_3dof"


def test_a_name_a_path_and_a_robot_are_one(tmp_path: Path) -> None:
    robot = robodyn.load(NAME)
    path = tmp_path / "arm.yaml"
    path.write_text(bundled_text(NAME))
    options = robodyn.Options(functions=("gravity",))
    wanted = robodyn.generate(robot, options)
    for spec in (NAME, path, str(path)):
        assert robodyn.generate(spec, options).files() == wanted.files()
        assert robodyn.count(spec, "gravity") == wanted.counts["gravity"]
        assert robodyn.program(spec, "gravity") == robodyn.program(robot, "gravity")
    assert robodyn.symbolic(NAME).results == robodyn.symbolic(robot).results
    assert robodyn.count(NAME) == robodyn.generate(NAME).counts["inverse_dynamics"]
    with pytest.raises(robodyn.InputError, match="neither a file nor a bundled robot"):
        robodyn.count("stanfrod")


def test_a_name_is_compiled_and_simulated() -> None:
    kernel = robodyn.compile(NAME, functions=("gravity",))
    q = np.array([0.1, 0.4, 0.3])
    assert np.shape(kernel.gravity(q)) == (3,)
    run = robodyn.simulate(NAME, start=q, duration=0.01)
    assert run.q.shape[1] == 3
    again = robodyn.simulate(robodyn.load(NAME), start=q, duration=0.01)
    assert np.array_equal(run.q, again.q)


def test_a_motion_is_designed_and_a_log_refused_by_name(tmp_path: Path) -> None:
    tell = [("viscous_friction", 1), ("coulomb_friction", 1)]
    design = robodyn.excite(NAME, tell, duration=1.0, tries=1, period=0.02)
    assert design.trajectory.q.shape[1] == 3
    with pytest.raises(robodyn.InputError, match=r"none\.csv"):
        robodyn.diagnose(NAME, [tmp_path / "none.csv"])


@pytest.mark.parametrize("name", ["simulate", "diagnose"])
def test_a_package_imported_first_can_be_called(name: str) -> None:
    code = f"import robodyn.{name}.limits, robodyn; assert callable(robodyn.{name}); robodyn.{name}.limits"
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("name", sampled(bundled_names(), every=12))
def test_a_robot_fits_on_a_screen(name: str) -> None:
    robot = robodyn.load(name)
    lines = repr(robot).splitlines()
    assert len(lines) == 1 + robot.n
    assert all(len(line) <= 100 for line in lines)
    assert name in lines[0]
    many = repr(replace(robot, links=robot.links * 12)).splitlines()
    assert len(many) == 22
    assert many[-1] == f"  and {robot.n * 12 - 20} more>"
