"""Real logs: plain least squares leave what the table says, and models are scored like them."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn.robot import load
from robodyn.robot.model import EffectEntry, Robot
from robodyn_testing import representative, require_module

require_module("pinocchio")

from benchmarks.gap import split  # noqa: E402
from benchmarks.gap.least_squares import fit  # noqa: E402
from benchmarks.gap.recordings import Floats, Motion, Recording, blocks, motion, read, shares  # noqa: E402
from benchmarks.gap.robots import ARMS  # noqa: E402
from benchmarks.gap.score import residual, score  # noqa: E402

REAL = Path(__file__).parents[2] / "examples" / "real"
README = (REAL / "README.md").read_text(encoding="utf-8")


def table() -> dict[str, list[float]]:
    """By folder: cut-off, and the held-out shares."""
    (text,) = re.findall(r"<!-- held out -->\n(.*?)<!-- end -->", README, flags=re.DOTALL)
    rows = re.findall(r"^\| `(\w+)` \|(.*)\|$", text, flags=re.MULTILINE)
    return {name: [float(x) for x in cells.split("|") if x.strip()] for name, cells in rows}


@pytest.mark.parametrize("name", representative(sorted(table()), "panda_bag", "servo"))
def test_least_squares_leave_what_the_readme_says(name: str) -> None:
    cutoff, *wanted = table()[name]
    arm = ARMS[name]
    assert arm.cutoff == cutoff
    motions = arm.motions()
    left = fit(arm.robot(), motions).residuals
    held_out = [r[m.held_out] for r, m in zip(left, motions, strict=True)]
    assert shares(held_out, [m.tau[m.held_out] for m in motions]) == pytest.approx(wanted, abs=0.06)


def test_all_shipped_logs_have_an_arm_and_their_licence_beside_them() -> None:
    folders = {path.name for path in REAL.iterdir() if path.is_dir()}
    assert folders == set(table()) == {name for name, arm in ARMS.items() if REAL in arm.folder.parents}
    for folder in folders:
        assert (REAL / folder / "LICENSE").is_file()
        assert f"## `{folder}`" in README


def test_the_regressor_is_that_of_the_described_arm() -> None:
    from benchmarks.gap.arm import base_columns, pinocchio_model, regressor

    robot = load("stanford", warn=lambda _: None)
    model = pinocchio_model(robot)
    rng = np.random.default_rng(1)
    q, qd, qdd = (rng.uniform(-1, 1, (5, robot.n)) for _ in range(3))
    numbers = np.concatenate([model.inertias[j + 1].toDynamicParameters() for j in range(robot.n)])
    rotors = [float(link.joint.motor_inertia) for link in robot.links]  # type: ignore[arg-type]
    tau = regressor(model, q, qd, qdd) @ numbers + rotors * qdd
    m = Motion("", np.arange(5.0), q, qd, qdd, tau, np.ones(5, bool), np.ones(5, bool))
    assert np.abs(residual(robot, m)).max() < 1e-9 * np.abs(tau).max()
    # Gravity along the first axis: nine parameters of link 1 and more are never seen.
    assert len(base_columns(model)) < 10 * robot.n - 9


def test_uneven_samples_need_a_raster() -> None:
    log = read(REAL / "servo" / "xl330_kp400_lift_and_drop.csv")
    with pytest.raises(ValueError, match="need a raster"):
        motion(log, 15.0)
    assert np.diff(motion(log, 15.0, 0.005).t) == pytest.approx(0.005)


def test_pieces_of_a_log_are_rows_of_it(tmp_path: Path) -> None:
    path = REAL / "panda_bag" / "panda_bag.csv"
    whole = path.read_text(encoding="utf-8").splitlines()
    pieces = [piece.read_text(encoding="utf-8").splitlines() for piece in split.split(path, tmp_path)]
    fitted, held_out = blocks(len(whole) - 1)
    for piece, mask in zip(pieces, (fitted, held_out), strict=True):
        assert piece == [whole[0], *(row for row, kept in zip(whole[1:], mask, strict=True) if kept)]


def synthetic(robot: Robot) -> Motion:
    """A motion of ``robot`` whose torques are its own, without effects of sensors."""
    t = np.arange(3000) / 500
    q = np.column_stack([0.5 * np.sin((1 + 0.3 * j) * t + j) for j in range(robot.n)])
    m = motion(Recording("", t, q, np.zeros_like(q)), 20.0)
    return replace(m, tau=-residual(robot, m))


def entry(id: str, joint: int | None, **settings: Any) -> EffectEntry:
    return EffectEntry(id, joint, tuple(settings.items()))


def test_the_right_model_leaves_nothing_and_a_wrong_one_does() -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    m = synthetic(robot)
    right = score(robot, [m])
    assert right.rms.max() < 1e-9
    # Least squares take what was generated from it, too.
    assert right.plain_share.max() < 1e-3
    wrong = score(load("puma560_3dof_d12", warn=lambda _: None), [m], robot)
    assert wrong.rms.max() > 0.1
    assert wrong.before_share is not None
    assert wrong.before_share.max() < 1e-6


@pytest.mark.parametrize(
    ("effect", "shown"),
    [
        (entry("torque_bias", 2, bias=3.0), lambda tau: tau + np.array([0, 3, 0])),
        (entry("torque_gain", None, gain=0.1), lambda tau: 1.1 * tau),
        (entry("time_delay", 3, delay=0.02), lambda tau: np.column_stack([tau[10:, :2], tau[:-10, 2]])),
        (entry("torque_saturation", 2, limit=20.0, clips="sensor"), lambda tau: tau.clip(*np.array(
            [[-1e9, -20, -1e9], [1e9, 20, 1e9]]))),
    ],
    ids=lambda x: getattr(x, "effect", ""),
)  # fmt: skip
def test_sensors_act_on_what_the_model_predicts(
    effect: EffectEntry, shown: Callable[[Floats], Floats]
) -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    m = synthetic(robot)
    expected = shown(m.tau)
    predicted = m.tau - residual(replace(robot, effects=(effect,)), m)
    assert np.abs(predicted[-len(expected) :] - expected).max() < 1e-9
    assert np.abs(predicted - m.tau).max() > 0.5
