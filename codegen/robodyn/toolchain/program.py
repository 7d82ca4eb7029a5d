"""Compile a program of emitted files and run it once."""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

from robodyn.errors import ToolError
from robodyn.toolchain.compiler import find_c
from robodyn.toolchain.running import run

#: Flags of programs with threads: the arithmetic is that of kernels, whose bits they are set against.
THREADED_FLAGS = ("-std=c11", "-O2", "-ffp-contract=off", "-pthread")


def run_program(
    files: Mapping[str, str],
    arguments: Sequence[str] = (),
    *,
    cc: str | None = None,
    flags: Sequence[str] = THREADED_FLAGS,
    seconds: float = 120.0,
) -> tuple[int, str]:
    """Compile the C sources among ``files`` ({path: text}) together and run them: exit code and stdout.

    Raises
    ------
    ToolError: no compiler, it refuses the files, this system has no POSIX threads, or the program takes
        longer than ``seconds``.
    """
    with built(files, cc=cc, flags=flags) as path:
        return _run([str(path), *arguments], seconds)


@contextmanager
def built(
    files: Mapping[str, str], *, cc: str | None = None, flags: Sequence[str] = THREADED_FLAGS
) -> Iterator[Path]:
    """The program of the C sources among ``files`` ({path: text}), for as long as the context lasts.

    Raises
    ------
    ToolError: no compiler, it refuses the files, or this system has no POSIX threads.
    """
    if sys.platform == "win32":
        raise ToolError("parallel C needs POSIX threads", remedy="run it under Linux, macOS or WSL")
    compiler = find_c(cc)
    with tempfile.TemporaryDirectory(prefix="robodyn-") as name:
        folder = Path(name)
        for path, text in files.items():
            (folder / path).write_text(text, encoding="utf-8", newline="\n")
        sources = [path for path in files if path.endswith(".c")]
        compiler.run([*flags, *sources, "-lm", "-o", "program"], folder=folder, doing=", ".join(sources))
        yield folder / "program"


def _run(command: Sequence[str], seconds: float) -> tuple[int, str]:
    try:
        done = run(command, seconds=seconds, listen="stdout")
    except OSError as error:
        raise ToolError("the compiled program cannot be started", found=error.strerror) from None
    if done.code is None:
        raise ToolError("the compiled program does not come to an end", expected=f"{seconds:g} s at most")
    return done.code, done.output


def cores() -> int:
    """Cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
