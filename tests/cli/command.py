"""Commands as users and shells start them, for the tests of this folder."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from robodyn_cli.main import main
from robodyn_testing import require_module

Capture = pytest.CaptureFixture[str]


def run(capsys: Capture, line: str, *words: str, code: int = 0) -> tuple[str, str]:
    """What ``robodyn LINE WORDS`` prints on both streams; it ends with ``code``, and never in a bug."""
    capsys.readouterr()
    assert main([*line.split(), *words]) == code, capsys.readouterr().err
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    assert "internal error" not in err
    return out, err


def run_json(capsys: Capture, line: str, *words: str, code: int = 0) -> Any:
    """What it prints with ``--json``."""
    return json.loads(run(capsys, line, *words, "--json", code=code)[0])


def tree(folder: Path) -> dict[str, str]:
    """Every file under ``folder`` with its text; links and empty folders by name."""
    return {
        path.relative_to(folder).as_posix(): path.read_text("utf-8") if path.is_file() else "a folder"
        for path in sorted(folder.rglob("*"))
        if path.is_file() or not any(path.iterdir())
    }


def environment(**more: str) -> dict[str, str]:
    """The environment of a process that can import what this one can."""
    return {**os.environ, "PYTHONPATH": os.pathsep.join(each for each in sys.path if each), **more}


def heed() -> None:
    """Let a process that begins heed signals, even where the tests run in the background."""
    for number in (signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


def python(*words: str, **variables: str) -> subprocess.CompletedProcess[str]:
    """``python WORDS`` with ``variables`` in its environment."""
    return subprocess.run(
        [sys.executable, *words],
        capture_output=True,
        text=True,
        check=False,
        env=environment(**variables),
        preexec_fn=heed if hasattr(os, "fork") else None,
    )


def on_terminal(line: str) -> tuple[int, bytes]:
    """The exit code of ``robodyn LINE`` and what a terminal gets of its stderr."""
    master, terminal = require_module("pty").openpty()
    words = [sys.executable, "-m", "robodyn", *line.split()]
    with subprocess.Popen(words, env=environment(), stdout=subprocess.DEVNULL, stderr=terminal) as process:
        os.close(terminal)
        text = b""
        with contextlib.suppress(OSError):  # the other end is closed
            while part := os.read(master, 4096):
                text += part
    os.close(master)
    return process.returncode, text
