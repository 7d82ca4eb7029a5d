"""Golden files: command lines and all that they print and write; ``pytest --update -n0`` writes them anew.

A file has sessions. Each begins with ``=== what it shows`` and runs in a folder of its own, which has the
files of ``files/`` beside the golden file. Its lines::

    $ robodyn gen nosuch        a command of robodyn, or else of the shell
    what it prints on standard output
    ! what it prints on standard error
    + out/arm.c                 a file that it has written; ~ of one that it has changed, - removed
    exit 2                      its exit code, unless that is 0
"""

from __future__ import annotations

import shlex
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import pytest

from robodyn_cli.main import main
from robodyn_testing.wanted import require_tool

_HEAD: Final = "=== "
_COMMAND: Final = "$ "


@dataclass(frozen=True, slots=True)
class Session:
    """A session of the golden file ``path``, ``text`` from its head on."""

    path: Path
    text: str

    @property
    def name(self) -> str:
        """The file and what the session shows."""
        return f"{self.path.stem}: {self.text.partition(chr(10))[0].removeprefix(_HEAD)}"

    def check(self, folder: Path, capsys: pytest.CaptureFixture[str], *, update: bool) -> None:
        """Run the session in ``folder``, the working folder, and compare it; or ``update`` the file."""
        shutil.copytree(self.path.parent / "files", folder, dirs_exist_ok=True)
        head, *lines = self.text.splitlines(keepends=True)
        commands = [line for line in lines if line.startswith(_COMMAND)]
        text = head + "".join(line + _run(line.removeprefix(_COMMAND), folder, capsys) for line in commands)
        text = text.replace(str(folder), "HERE")
        if update:
            whole = self.path.read_text(encoding="utf-8")
            self.path.write_text(whole.replace(self.text.rstrip("\n"), text.rstrip("\n")), encoding="utf-8")
        else:
            assert text.rstrip("\n") == self.text.rstrip("\n"), f"{self.name} (or pytest --update)"


def sessions(folder: Path) -> list[Session]:
    """All sessions of the golden files in ``folder``."""
    return [
        Session(path, _HEAD + text)
        for path in sorted(folder.glob("*.txt"))
        for text in f"\n{path.read_text(encoding='utf-8')}".split(f"\n{_HEAD}")[1:]
    ]


def _run(line: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> str:
    """What the command ``line`` prints, writes and exits with."""
    program, *words = shlex.split(line)
    if program != "robodyn":
        require_tool(program)
        return subprocess.run(["sh", "-c", line], check=True, capture_output=True, text=True).stdout
    before = _files(folder)
    capsys.readouterr()
    code = main(words)
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    assert "internal error" not in err
    after = _files(folder)
    signs = {name: "-" if name not in after else "~" if name in before else "+" for name in before | after}
    return "".join(
        [
            out + "\n" * (not out.endswith("\n") and out != ""),
            *(f"! {text}\n" for text in err.splitlines()),
            *(f"{signs[name]} {name}\n" for name in sorted(signs) if before.get(name) != after.get(name)),
            f"exit {code}\n" * (code != 0),
        ]
    )


def _files(folder: Path) -> dict[str, bytes]:
    """The contents of all files below ``folder``, but for robodyn's own lists of them."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file() and path.name != ".robodyn.sha256"
    }
