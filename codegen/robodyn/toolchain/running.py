"""Run other programs: within a time, with all that they start, and leave none of it behind."""

from __future__ import annotations

import atexit
import contextlib
import os
import signal
import subprocess
import threading
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from time import monotonic
from typing import IO, Any, Final, Literal

from robodyn.process import Held

#: What a program may take unless told otherwise [s]: far more than any compiler here has needed.
SECONDS: Final = 600.0
#: Of what a program says so much is kept [bytes].
MOST_OUTPUT: Final = 1 << 22
#: How long is waited for the end of what a program says, or of the program, where it has been ended [s].
_LAST: Final = 2.0


@dataclass(frozen=True, slots=True)
class Finished:
    """How a program ended: its exit ``code``, negative where a signal ended it, None where its time was over;
    and what it ``output``, the beginning of it if that was very much."""

    code: int | None
    output: str


def run(
    command: Sequence[str],
    *,
    folder: Path | None = None,
    seconds: float = SECONDS,
    listen: Literal["both", "stdout", "stderr"] = "both",
) -> Finished:
    """Run ``command`` in ``folder``, messages in English, and return what it says on the streams ``listen``.

    It gets a group of processes of its own, which is ended as a whole when its time is over or an exception
    (Ctrl-C) comes in between. What it leaves running behind its back is not waited for.

    Raises
    ------
    OSError: it cannot be started.
    """
    pipe, nowhere = subprocess.PIPE, subprocess.DEVNULL
    environment = {**os.environ, "LC_ALL": "C"}
    if folder is not None:  # Frama-C goes by it
        environment["PWD"] = str(folder)
    process: subprocess.Popen[bytes] = start(
        list(command),
        cwd=folder,
        env=environment,
        stdin=nowhere,
        stdout=nowhere if listen == "stderr" else pipe,
        stderr=subprocess.STDOUT if listen == "both" else pipe if listen == "stderr" else nowhere,
        start_new_session=True,
    )
    stream = process.stderr if listen == "stderr" else process.stdout
    assert stream is not None
    output = bytearray()
    reader = threading.Thread(target=_listen, args=(stream, output), daemon=True)
    try:
        reader.start()
        end = monotonic() + seconds
        while process.poll() is None and (left := end - monotonic()) > 0:
            reader.join(min(left, 0.1))
            if not reader.is_alive():  # nothing more is said: it has ended, or is about to
                _wait(process, min(left, 0.1))
        code = process.returncode
        if code is None:
            _end(process)
        reader.join(_LAST)
    except BaseException:
        _end(process)
        raise
    finally:
        _running.discard(process)
    return Finished(code, bytes(output).decode("utf-8", "replace"))


def start(command: Sequence[str], **how: Any) -> subprocess.Popen[Any]:
    """``subprocess.Popen``, of which a signal that comes meanwhile makes no orphan."""
    with Held():
        process: subprocess.Popen[Any] = subprocess.Popen(command, **how)
        _running.add(process)
    return process


def end_all() -> None:
    """End all that :func:`start` has started, in whatever thread, and that runs still."""
    for process in list(_running):
        _end(process)


#: What runs now, in whatever thread; a daemon thread may leave it behind when the interpreter ends.
_running: set[subprocess.Popen[Any]] = set()
atexit.register(end_all)


def _listen(stream: IO[bytes], output: bytearray) -> None:
    """Keep the beginning of what comes, and let the rest pass, so that nobody waits to be heard."""
    with stream:
        while data := os.read(stream.fileno(), 1 << 16):
            output += data[: max(0, MOST_OUTPUT - len(output))]


def _end(process: subprocess.Popen[Any]) -> None:
    """End a process and what it started."""
    if process.returncode is None:
        if hasattr(os, "killpg"):
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(process.pid, signal.SIGKILL)
        else:
            process.kill()
        _wait(process, _LAST)


def _wait(process: subprocess.Popen[Any], seconds: float) -> None:
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(seconds)
