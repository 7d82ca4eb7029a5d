"""The command and its files for the tests of searches."""

from __future__ import annotations

from pathlib import Path

import pytest

from robodyn_cli.main import main

Capture = pytest.CaptureFixture[str]
NAME = "elbow.inverse_dynamics.total.record"


def run(capsys: Capture, *arguments: str, code: int = 0) -> tuple[str, str]:
    assert main(list(arguments)) == code
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    assert "internal error" not in err
    return out, err


def files(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if not path.is_dir()}
