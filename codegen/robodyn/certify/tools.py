"""Running the provers within a time."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from robodyn.errors import ToolError
from robodyn.toolchain.running import start
from robodyn.tools import Tool

#: How long Eva, a compiler or cppcheck may take [s].
PATIENCE = 600.0


@dataclass(frozen=True, slots=True)
class Done:
    """How a program ended: ``code`` None where its time was over; ``output`` is stdout and stderr
    together."""

    code: int | None
    output: str
    seconds: float


def run(command: Sequence[str], folder: Path, seconds: float) -> Done:
    """Run ``command`` in ``folder``, with all that it starts, for ``seconds`` at most.

    Raises
    ------
    ToolError: it cannot be started.
    """
    began = time.monotonic()
    try:
        process = start(
            list(command),
            cwd=folder,
            env={**os.environ, "LC_ALL": "C", "PWD": str(folder)},  # Frama-C goes by PWD
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            start_new_session=True,
        )
    except OSError as error:
        raise ToolError(f"{command[0]} cannot be started", found=error.strerror or str(error)) from None
    _running.add(process)
    code: int | None
    try:
        output, _ = process.communicate(timeout=seconds)
        code = process.returncode
    except subprocess.TimeoutExpired:
        _end(process)
        output, code = process.communicate()[0], None
    except BaseException:
        _end(process)
        process.communicate()
        raise
    finally:
        _running.discard(process)
    return Done(code, output, time.monotonic() - began)


#: What runs now, in whatever thread.
_running: set[subprocess.Popen[str]] = set()


def end_all() -> None:
    """End all that :func:`run` has started, in other threads too: nothing is left behind."""
    for process in list(_running):
        _end(process)


def _end(process: subprocess.Popen[str]) -> None:
    """End a process and what it started."""
    if hasattr(os, "killpg"):
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            return
    else:
        process.kill()


def last_lines(output: str, count: int = 3) -> str:
    """The last lines of what a program said, as one."""
    lines = [re.sub(r"\s+", " ", line).strip() for line in output.splitlines() if line.strip()]
    return " | ".join(lines[-count:])[:400] or "nothing"


def version(tool: Tool) -> str:
    """The first line that ``tool`` says about itself."""
    output = run([tool.needed(), *tool.version_arguments], Path.cwd(), 60).output.strip()
    return output.splitlines()[0].strip() if output else "(says no version)"
