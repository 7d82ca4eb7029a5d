"""Motions from CSV files: what comes back, and what is refused where."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from robodyn.errors import InputError
from robodyn.robot import load
from robodyn.robot.model import Robot
from robodyn.simulate.trajectories import Trajectory, fourier, from_file, quintic


def arm() -> Robot:
    return load("puma560", warn=lambda _: None)


def write(path: Path, motion: Trajectory, kinds: tuple[str, ...], order: int = 1) -> Path:
    columns = {"t": motion.t}
    for kind in kinds:
        columns.update({f"{kind}{j + 1}": column for j, column in enumerate(getattr(motion, kind).T)})
    names = list(columns)[::order]
    rows = [",".join(repr(float(x)) for x in row) for row in zip(*(columns[k] for k in names), strict=True)]
    path.write_text("\n".join([",".join(names), *rows]) + "\n", encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("kinds", "velocity", "acceleration"),
    [(("q", "qd", "qdd"), 0, 0), (("q", "qd"), 0, 2e-5), (("q",), 2e-6, 1e-3), (("q", "qdd"), 2e-6, 0)],
)
def test_file_comes_back(
    tmp_path: Path, kinds: tuple[str, ...], velocity: float, acceleration: float
) -> None:
    motion = fourier(arm(), 0.5, period=1e-2)
    read = from_file(write(tmp_path / "motion.csv", motion, kinds, -1), 6)
    np.testing.assert_array_equal(read.q, motion.q)
    np.testing.assert_allclose(read.qd, motion.qd, rtol=0, atol=velocity)
    np.testing.assert_allclose(read.qdd, motion.qdd, rtol=0, atol=acceleration)
    assert read.describe()["file"] == "motion.csv"
    t = np.linspace(0, 2, 777)
    np.testing.assert_allclose(read.at(t)[0], motion.at(t)[0], atol=1e-8)


def test_file_without_the_frills(tmp_path: Path) -> None:
    path = tmp_path / "m.csv"
    rows = "".join(f"{5 + k / 10},{k * k},note\r\n" for k in range(8))
    path.write_bytes(b"\xef\xbb\xbft, q1,remark\r\n" + rows.encode())
    motion = from_file(path)
    assert (motion.n, motion.t[0], motion.describe()["first"]) == (1, 0.0, 5.0)
    np.testing.assert_allclose(motion.qd[:, 0], 20 * np.arange(8), atol=1e-9)
    np.testing.assert_allclose(motion.qdd, 200, atol=1e-7)


def test_file_of_another_arm(tmp_path: Path) -> None:
    path = write(tmp_path / "m.csv", quintic([0, 0, 0], [1, 1, 1], 1.0), ("q",))
    with pytest.raises(InputError, match="another arm; found 3 joints; expected 2"):
        from_file(path, 2)
    with pytest.raises(InputError, match="no column q4"):
        from_file(path, 4)
    with pytest.raises(InputError, match=r"gone\.csv: the file cannot be read; found no such file"):
        from_file(tmp_path / "gone.csv")
    path.write_bytes(b"t,q1\n\xff,1\n")
    with pytest.raises(InputError, match="not UTF-8"):
        from_file(path)
