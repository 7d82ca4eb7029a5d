"""Logs that are broken as files are: what the command line refuses, and what must change nothing."""

from __future__ import annotations

import gzip
import re
import subprocess
import sys
import tracemalloc
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from robodyn.diagnose.run import diagnose
from robodyn.gate.gate import inspect
from robodyn.logs.log import Log, read_log
from robodyn.robot import load, read_text
from robodyn.robot.model import Robot
from robodyn.simulate.trajectories import fourier
from robodyn.verify.reference import Reference
from robodyn_cli.main import main
from robodyn_testing import require_module

ARM = """\
name: arm
links:
  - {joint: revolute, alpha: -pi/2, mass: 4, com: [0.2, 0, 0.1], inertia: {xx: 0.1, yy: 0.1, zz: 0.1},
     limits: {position: [-2, 2], velocity: 2, acceleration: 8, torque: 60}}
  - {joint: revolute, a: 0.4, mass: 2, com: [0.2, 0, 0], inertia: {xx: 0.03, yy: 0.03, zz: 0.03},
     limits: {position: [-2, 2], velocity: 2, acceleration: 8, torque: 60}}
"""


def recorded(robot: Robot, rate: float = 500.0, duration: float = 8.0) -> Log:
    """The motion of ``robot`` with 2 N m of friction at joint 2 that its model lacks, and noise."""
    motion = fourier(robot, 1 / duration, 6, seed=3, period=1 / rate)
    tau = Reference(robot).inverse_dynamics(motion.q, motion.qd, motion.qdd)
    tau[:, 1] += 2 * np.tanh(motion.qd[:, 1] / 0.01)
    tau += 0.05 * np.random.default_rng(0).standard_normal(tau.shape)
    return Log(motion.t, motion.q, None, None, tau)


@pytest.fixture(scope="module")
def arm() -> Robot:
    return read_text(ARM)


@pytest.fixture(scope="module")
def log(arm: Robot) -> Log:
    return recorded(arm)


@pytest.fixture(scope="module")
def lines(log: Log) -> list[str]:
    return log.csv().splitlines()


def joined(lines: list[str]) -> bytes:
    return "\n".join([*lines, ""]).encode()


def cell(lines: list[str], line: int, position: int, value: str) -> bytes:
    cells = lines[line].split(",")
    cells[position] = value
    return joined([*lines[:line], ",".join(cells), *lines[line + 1 :]])


def put(lines: list[str], line: int, text: str) -> bytes:
    return joined([*lines[:line], text, *lines[line:]])


Break = Callable[[list[str]], bytes]

BROKEN: dict[str, tuple[Break, str]] = {
    "empty": (lambda x: b"", "the file is empty"),
    "header only": (lambda x: joined(x[:1]), "no samples"),
    "no header": (lambda x: joined(x[1:]), "write a first line"),
    "gzip": (lambda x: gzip.compress(joined(x)), "packed; found gzip; unpack it"),
    "zip": (lambda x: b"PK\x03\x04" + bytes(range(200)), "packed; found zip"),
    "zeros": (lambda x: bytes(5000), "not text; found a zero byte"),
    "old Mac": (lambda x: joined(x).replace(b"\n", b"\r"), "carriage returns alone"),
    "joints from 0": (lambda x: joined(["t,q0,q1,tau0,tau1", *x[1:]]), "number the joints from 1"),
    "capitals": (lambda x: joined([x[0].upper(), *x[1:]]), "small letters"),
    "header again": (lambda x: put(x, 500, x[0]), "log.csv:501:1: .*delete the line: nothing in it"),
    "a comment": (lambda x: put(x, 500, "# pause"), "log.csv:501: .*found 1; expected 5; delete the line"),
    "cut off": (lambda x: joined(x)[:-25], "cut off there"),
    "a cell more": (lambda x: put(x, 9, "0,0,0,0,0,0"), "log.csv:10: .*found 6; expected 5; delete the line"),
    "comma at the end": (lambda x: put(x, 9, "0,0,0,0,0,"), "log.csv:10: .*comma at the end of the line"),
    "a word": (lambda x: cell(x, 1000, 2, "ERR"), "log.csv:1001:.*not a number; found 'ERR'.*write nan"),
    "no cell": (lambda x: cell(x, 1000, 2, ""), "log.csv:1001:.*found nothing.*write nan"),
    "a date": (lambda x: cell(x, 7, 0, "2024-01-01T00:00:00"), "log.csv:8:1:.*write times in seconds"),
    "quotes": (lambda x: put(x, 1, ",".join(['"0.5"'] * 5)), "log.csv:2:1:.*numbers without quotes"),
    "10 rows": (lambda x: joined(x[:11]), "too short to diagnose; found 10 rows"),
    "dead sensor": (
        lambda x: joined([x[0], *(line.rsplit(",", 1)[0] + ",0" for line in x[1:])]),
        "tau2: the same throughout; found 0 in all rows",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", BROKEN)
def test_the_command_refuses_it_and_writes_nothing(
    name: str,
    lines: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    spoil, says = BROKEN[name]
    monkeypatch.chdir(tmp_path)
    Path("arm.yaml").write_text(ARM)
    Path("log.csv").write_bytes(spoil(lines))
    assert main(["diagnose", "arm.yaml", "log.csv", "-o", "out"]) == 2
    error = capsys.readouterr().err
    assert "Traceback" not in error
    (line,) = [line for line in error.splitlines() if line.startswith("robodyn: error: ")]
    assert line.startswith("robodyn: error: log.csv:")
    assert re.search(says, line), line
    assert not Path("out").exists()


def test_order_line_ends_and_format_change_nothing(log: Log, lines: list[str], tmp_path: Path) -> None:
    require_module("pyarrow")
    rows = [[*line.split(","), "7"] for line in lines]
    rows[0][-1] = "load"
    turned = "\r\n".join(",".join(row[k] for k in (3, 5, 1, 4, 0, 2)) for row in rows)
    for name, content in (
        ("turned.csv", b"\xef\xbb\xbf" + turned.encode() + b"\r\n\r\n"),
        ("same.parquet", log.parquet()),
        ("bare.csv", joined(lines)[:-1]),
    ):
        (tmp_path / name).write_bytes(content)
        read = read_log(tmp_path / name, 2)
        assert read.ignored == (("load",) if name == "turned.csv" else ())
        for group in ("t", "q", "tau"):
            np.testing.assert_array_equal(getattr(read, group), getattr(log, group))


def test_columns_that_are_not_read_are_named(arm: Robot, log: Log) -> None:
    (flag,) = inspect(replace(log, ignored=("q3", "tau3", "load")), arm).flags_of("ignored")
    assert str(flag) == "q3, tau3, load: 3 columns not read: arm has 2 joints"
    assert not inspect(log, arm).flags_of("ignored")


@pytest.mark.slow
def test_rate_and_names_change_no_name(arm: Robot, log: Log) -> None:
    other = read_text(ARM.replace("{joint", "{name: hip, joint", 1))
    for robot, each in ((arm, log), (other, log), (arm, recorded(arm, rate=250)), (arm, recorded(arm, 800))):
        diagnosis = diagnose(robot, [each])
        assert [(one.effect, one.joint) for one in diagnosis.findings] == [("coulomb_friction", 2)]


def test_a_long_log_takes_little_memory_beside_its_own(arm: Robot) -> None:
    samples = 1_000_000
    t = np.asarray(1e-3 * np.arange(samples), np.float64)
    q = np.stack([np.sin(0.7 * t), np.sin(1.1 * t)], axis=1)
    tau = np.random.default_rng(0).standard_normal((samples, 2)) + 40 * q
    t[700_000], q[300_000, 1] = 2.7e154, np.nan
    long = Log(t, q, None, None, tau)
    tracemalloc.start()
    gate = inspect(long, arm)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert gate.log.samples == 200_000
    assert [span.first for flag in gate.flags_of("garbage") for span in flag.spans] == [700_001, 300_001]
    assert peak < 100 * samples, peak


@pytest.mark.slow
def test_ten_million_rows_of_text_fit_into_little_memory(tmp_path: Path) -> None:
    robot = load("puma560", warn=lambda _: None)
    motion = fourier(robot, 0.1, 5, seed=1, period=1e-3)
    tau = Reference(robot).inverse_dynamics(motion.q, motion.qd, motion.qdd)
    rows = Log(motion.t, motion.q, None, None, tau + 0.1).csv().splitlines()
    ends = [row.split(",", 1)[1] for row in rows[1:10_001]]
    path = tmp_path / "long.csv"
    with path.open("w") as file:
        file.write(rows[0] + "\n")
        for start in range(0, 10_000_000, 10_000):
            file.write("".join(f"{(start + k) / 1000:.3f},{end}\n" for k, end in enumerate(ends)))
    code = (
        "import resource, sys; from robodyn.gate.gate import inspect; from robodyn.robot import load;"
        "from robodyn.logs.log import read_log;"
        "log = read_log(sys.argv[1], 6); inspect(log, load('puma560', warn=lambda _: None));"
        "print(log.samples, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)"
    )
    run = subprocess.run([sys.executable, "-c", code, str(path)], capture_output=True, text=True, check=True)
    samples, peak = (int(word) for word in run.stdout.split())
    assert samples == 10_000_000
    assert peak < 2e6  # KiB
