"""A joint that is flipped or exchanged is said to be, with the map that mends it, whatever else is wrong."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from benchmarks.blind_arms.arms import perturbed

from gate.gated import GIVEN, WRONG, arm
from robodyn.errors import InputError
from robodyn.gate.gate import inspect
from robodyn.logs.log import Log, read_log
from robodyn.logs.mapping import map_of_text
from robodyn.simulate.trajectories import fourier
from robodyn.verify.reference import Reference

#: Inertial numbers 30 % off; the log has friction and a load that the model knows nothing of.
WORSE = perturbed(GIVEN, 0.3, 5)


def test_a_wrong_model_is_no_flipped_joint(log: Log) -> None:
    assert not {flag.kind for flag in inspect(log, WORSE).flags} & WRONG


@pytest.mark.parametrize("joint", [1, 2, 3])
@pytest.mark.parametrize("group", ["q", "tau"])
def test_the_remedy_is_a_map_that_mends_it(log: Log, group: str, joint: int, tmp_path: Path) -> None:
    sign = np.where(np.arange(3) == joint - 1, -1.0, 1.0)
    flipped = replace(log, qd=None, **{group: getattr(log, group) * sign})
    with pytest.raises(InputError, match=f"^{group}{joint}: the sign") as caught:
        inspect(flipped, WORSE)
    remedy = str(caught.value.remedy)
    line = re.search(rf"in a file: ({group}: {{.*?}})\)", remedy)
    assert line, remedy
    path = tmp_path / "log.csv"
    path.write_text(flipped.csv())
    mended = read_log(path, 3, mapping=map_of_text(line[1]))
    np.testing.assert_array_equal(getattr(mended, group), getattr(log, group))
    assert not {flag.kind for flag in inspect(mended, WORSE).flags} & WRONG


def test_joints_numbered_from_the_tip(tmp_path: Path) -> None:
    robot = arm("ur10")
    motion = fourier(robot, 0.2, 5, seed=6, period=5e-3)
    tau = Reference(robot).inverse_dynamics(motion.q, motion.qd, motion.qdd)
    tau += 5 * np.tanh(motion.qd / 0.02) + 0.05 * np.random.default_rng(0).standard_normal(tau.shape)
    turned = Log(motion.t, motion.q[:, ::-1], None, None, tau[:, ::-1])
    worse = perturbed(robot, 0.3, 1)
    with pytest.raises(InputError, match="the joints are in the reverse order") as caught:
        inspect(turned, worse)
    lines = re.search(r"in a file: (q: .*?}) and (tau: .*?})\)", str(caught.value.remedy))
    assert lines
    path = tmp_path / "log.csv"
    path.write_text(turned.csv())
    mended = read_log(path, 6, mapping=map_of_text("\n".join(lines.groups())))
    np.testing.assert_array_equal(mended.tau, tau)
    assert not {flag.kind for flag in inspect(mended, worse).flags} & WRONG
