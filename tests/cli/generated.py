"""Robots and folders for the tests of ``robodyn gen``."""

from __future__ import annotations

from pathlib import Path

import pytest

from robodyn_cli.main import main

Capture = pytest.CaptureFixture[str]
FILES = {"stanford_3dof.h", "stanford_3dof.c", "stanford_3dof.f90"}
TOOL = """\
name: tool
links:
  - {joint: revolute, alpha: pi/2, mass: 2, com: [0.1, 0.2, 0], inertia: {zz: 1}}
  - {joint: revolute, a: 0.4, mass: m_tool, com: [0.3, 0, 0.1], friction: {coulomb: c_2}, motor_inertia: 1}
"""


def gen(capsys: Capture, *arguments: str, code: int = 0) -> tuple[str, str]:
    """Standard output and the lines on standard error that are not doubts about the robot."""
    assert main(["gen", *arguments]) == code
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    lines = [line for line in err.splitlines() if not line.startswith("robodyn: warning: ")]
    return out, "\n".join(lines)


def tree(folder: Path) -> dict[str, str]:
    """Every file under ``folder`` with its text; links and folders by name."""
    return {
        path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8")
        if path.is_file()
        else "a folder"
        for path in sorted(folder.rglob("*"))
        if path.is_file() or not any(path.iterdir())
    }
