"""Carries out the examples of a document in a folder, and compares what they print."""

from __future__ import annotations

import contextlib
import doctest
import io
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from documents.blocks import ROOT, Block, Command, commands, matches

#: What the examples find beside them, as in a checkout.
SHIPPED = ("benchmarks", "examples", "robots")
#: Stands after the output of a command, before the code that it ended with.
_END = "\x1e"
#: After so long [s] an example hangs, on however busy a machine.
_SECONDS = 1500


@dataclass(slots=True)
class Reader:
    """Somebody who follows a document in ``folder``, where the names of the Python blocks live on.

    ``path`` has the folders in which programs are sought first.
    """

    folder: Path
    path: tuple[Path, ...] = ()
    environment: Mapping[str, str] = field(default_factory=dict)
    names: dict[str, Any] = field(default_factory=lambda: {"__name__": "__main__"})

    def follow(self, block: Block) -> list[str]:
        """What went otherwise than ``block`` says, a text each."""
        if block.mark == "file":
            (self.folder / block.detail).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / block.detail).write_text(block.text, encoding="utf-8")
        elif block.is_run and block.language == "console":
            return self._console(block)
        elif block.is_run:
            return self._python(block)
        return []

    def outputs(self, block: Block) -> list[tuple[Command, str, int]]:
        """The commands of a console block with what each prints and ends with."""
        lines = list(commands(block))
        script = "exec 2>&1\n" + "".join(
            f"{one.text}\n__code=$?; printf '\\036%s\\n' $__code; (exit $__code)\n" for one in lines
        )
        done = subprocess.run(
            ["bash", "-c", script],
            cwd=self.folder,
            env=self._variables(),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=_SECONDS,
            check=False,
        )
        ended = re.findall(rf"(.*?){_END}(\d+)\n", done.stdout, flags=re.DOTALL)
        assert len(ended) == len(lines), f"the shell stopped after {len(ended)} commands:\n{done.stdout}"
        return [(one, text, int(code)) for one, (text, code) in zip(lines, ended, strict=True)]

    def _console(self, block: Block) -> list[str]:
        faults = []
        outputs = self.outputs(block)
        following = [command.text for command, _, _ in outputs[1:]] + [""]
        for (command, text, code), after in zip(outputs, following, strict=True):
            where = f"line {command.line}: $ {command.text}\n"
            if code and after != "echo $?":
                faults.append(f"{where}ended with exit code {code}\n{text}")
            elif command.output and not matches(command.output, text):
                faults.append(f"{where}shown:\n{command.output}\nprinted:\n{text}")
        return faults

    def _python(self, block: Block) -> list[str]:
        with contextlib.chdir(self.folder):
            if ">>> " not in block.text:
                exec(compile(block.text, f"<line {block.line}>", "exec"), self.names)
                return []
            test = doctest.DocTestParser().get_doctest(
                block.text, self.names, "example", "the document", block.line
            )
            text = io.StringIO()
            options = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
            doctest.DocTestRunner(optionflags=options).run(test, out=text.write, clear_globs=False)
            self.names.update(test.globs)
            return [text.getvalue()] if text.getvalue() else []

    def _variables(self) -> dict[str, str]:
        path = os.pathsep.join([*map(str, self.path), os.environ["PATH"]])
        # unbuffered: results and messages come in their order, as on a terminal
        return {**os.environ, "PYTHONUNBUFFERED": "1", **self.environment, "PATH": path}


def program_folder(folder: Path) -> Path:
    """A folder with ``robodyn`` and ``python`` of this interpreter, whether or not they are installed."""
    folder.mkdir()
    for name, arguments in (("robodyn", "-m robodyn "), ("python", "")):
        program = folder / name
        program.write_text(f'#!/bin/sh\nexec "{sys.executable}" {arguments}"$@"\n', encoding="utf-8")
        program.chmod(0o755)
    return folder


def checkout(folder: Path, *, copy: bool = False) -> Path:
    """A folder that has the benchmarks, examples and robots of a checkout; with ``copy`` they are copies."""
    folder.mkdir()
    for name in SHIPPED:
        if copy:
            shutil.copytree(ROOT / name, folder / name)
        else:
            (folder / name).symlink_to(ROOT / name)
    return folder
