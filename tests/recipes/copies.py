"""A copy of the package that a recipe of CONTRIBUTING.md is carried out in, and the recipe's own text."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import textwrap
from collections.abc import Mapping
from pathlib import Path

ROOT = Path(__file__).parents[2]
_PARTS = ("codegen", "cli", "templates", "robots")


def _section(title: str) -> str:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    section = re.search(rf"^## {re.escape(title)}\n(.*?)(?=^## |\Z)", text, re.S | re.M)
    assert section, f"CONTRIBUTING.md has no section {title!r}"
    return section[1]


def source_in_recipe(title: str, file: str) -> str:
    """The source that the section ``title`` of CONTRIBUTING.md gives for the path ``file``."""
    block = re.search(rf"`{re.escape(file)}`.*?\n( *)```\w+\n(.*?)\n\1```", _section(title), re.S)
    assert block, f"the recipe {title!r} has no source for {file}"
    return textwrap.dedent(block[2]) + "\n"


def commands_in_recipe(title: str) -> list[list[str]]:
    """The commands of robodyn in the console block of the section ``title``, without ``robodyn`` itself."""
    (block,) = re.findall(r"```console\n(.*?) *```", _section(title), re.S)
    commands = [line.removeprefix("$ ").split() for line in textwrap.dedent(block).splitlines()]
    assert {command[0] for command in commands} == {"robodyn"}
    return [command[1:] for command in commands]


class Copy:
    """A copy of the package in ``folder``, with more ``files`` by path, run in processes of its own."""

    def __init__(self, folder: Path, files: Mapping[str, str]) -> None:
        self.folder = folder
        self.work = folder / "work"
        self.work.mkdir(parents=True)
        for part in _PARTS:
            shutil.copytree(ROOT / part, folder / part, ignore=shutil.ignore_patterns("__pycache__"))
        for path, text in files.items():
            assert not (folder / path).exists(), f"{path} is there already"
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(text, encoding="utf-8")

    def python(self, *arguments: str, code: int = 0) -> str:
        """What Python with this copy says to ``arguments``; it must end with ``code``."""
        places = os.pathsep.join(str(self.folder / part) for part in ("codegen", "cli"))
        environment = {**os.environ, "PYTHONPATH": places, "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run(
            [sys.executable, *arguments], cwd=self.work, env=environment, capture_output=True, text=True
        )
        assert done.returncode == code, done.stdout + done.stderr
        return done.stdout + done.stderr

    def robodyn(self, *arguments: str, code: int = 0) -> str:
        """What the command line says; it must end with ``code``."""
        return self.python("-m", "robodyn", *arguments, code=code)
