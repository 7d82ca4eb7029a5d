"""Commands on strange arms and logs: whatever they say, it is no internal error, and nothing undefined looks
like a result."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Final

import numpy as np
import pytest

from robodyn.robot import load
from robodyn_cli.main import main
from robodyn_testing.strange_arms import ARMS, arm_text
from robodyn_testing.strange_logs import LOGS, plain_log, text_of

Capture = pytest.CaptureFixture[str]

#: A number that is none, but for a row's own time in the remark that it is left out.
_UNDEFINED: Final = re.compile(r"(?<![\w.+\-])(?<!t = )-?(?:nan|inf|infinity)\b", re.IGNORECASE)
_CODES: Final = (0, 1, 2, 3, 4)
_OUT: Final = "out"


def write_arm(name: str, seed: int = 0) -> str:
    """The file of an arm in this folder."""
    Path(f"{name}.yaml").write_text(arm_text(name, seed))
    return f"{name}.yaml"


def write_log(arm: str, log: str) -> str:
    """The file of a log of the arm in that file."""
    columns = plain_log(load(arm, warn=lambda _: None))
    with np.errstate(all="ignore"):
        Path(f"{log}.csv").write_text(text_of(LOGS[log](columns)))
    return f"{log}.csv"


def run(capsys: Capture, *words: str) -> tuple[int, str, str]:
    """Run a command; its exit code, standard output and standard error.

    Warnings are errors in tests, and an error that is none of robodyn's is exit code 70.
    """
    code = main(list(words))
    out, err = capsys.readouterr()
    assert code in _CODES, (words, err)
    assert "Traceback" not in err
    assert not _UNDEFINED.search(out), (words, out)
    if code == 2:
        assert err.strip(), words
        assert not Path(_OUT).exists()
    for path in Path(_OUT).rglob("*") if Path(_OUT).exists() else ():
        if path.suffix in (".json", ".yaml", ".csv"):
            assert not _UNDEFINED.search(path.read_text()), (words, path)
    shutil.rmtree(_OUT, ignore_errors=True)
    return code, out, err


def commands_of_arm(arm: str, joints: int) -> list[list[str]]:
    """Quick commands that take an arm alone."""
    q = ",".join(["0.1"] * joints)
    exports = [["export", arm, "--to", to, "-o", f"{_OUT}/arm.{to}"] for to in ("urdf", "mjcf", "sdf")]
    return [
        ["flops", arm, "--json"],
        ["simulate", arm, "-o", f"{_OUT}/log.csv", "--duration", "0.2"],
        *exports,
        ["diff", arm, arm],
        ["diff", arm, "puma560_3dof", "--json"],
        ["ik", arm, "--of", q, "--json"],
        ["ik", arm, "--pose", "0.1,0.2,0.3,0,0,0"],
        ["ik", arm, "--pose", "1e300,0,0,0,0,0"],
        ["schedule", arm, "-p", "2", "--json"],
        ["schedule", arm, "-p", "2", "--cut", "3"],
    ]


def commands_of_log(arm: str, log: str) -> list[list[str]]:
    """Commands that read a log."""
    return [
        ["logs", log, "--robot", arm],
        ["logs", log, "--json"],
        ["identify", arm, log, "-o", _OUT],
        ["diagnose", arm, log, "--output", _OUT, "--no-kernels"],
    ]


def joints_of(name: str) -> int:
    """How many joints an arm has."""
    return len(ARMS[name])
