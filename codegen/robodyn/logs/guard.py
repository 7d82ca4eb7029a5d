"""Other people's binary files are read in a process of its own, with limits of memory and of time.

A library that takes such a file apart may end its process, ask for all the memory there is, or never come
back. In the guarded process that costs nothing: what asked is told so. The process is kept for the next file.
"""

from __future__ import annotations

import os
import pickle
import subprocess
import threading
import weakref
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

from robodyn.errors import InputError, Place, RobodynError
from robodyn.logs.formats import LogFormat
from robodyn.logs.recording import Groups, Recording, Stream, damaged
from robodyn.logs.windows import Rows
from robodyn.process import bound
from robodyn.toolchain import workers

#: Memory of the process [bytes]; how long an answer takes at most [s], and how many more bytes of a file
#: [1/s] make it longer.
MEMORY, SECONDS, RATE = 6 << 30, 60.0, 4e6
#: Processes that are kept for the next file.
KEPT: Final = 2


class _Reader:
    """A process that reads files, one after the other."""

    def __init__(self) -> None:
        self.owner = os.getpid()
        self.process = workers.started(__name__, stderr=subprocess.DEVNULL)
        self.end = weakref.finalize(self, workers.end, [self.process], at_once=True)

    def ask(self, request: tuple[Any, ...], file: str, seconds: float) -> Any:
        """What the process answers to the ``request``.

        Raises
        ------
        InputError: it has ended, or took longer than ``seconds``; what it says of the file.
        """
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        timer = threading.Timer(seconds, self.process.kill)
        timer.start()
        try:
            pickle.dump(request, self.process.stdin)
            self.process.stdin.flush()
            is_done, answer = pickle.load(self.process.stdout)
        except (EOFError, BrokenPipeError, pickle.UnpicklingError):
            is_late = not timer.is_alive()
            self.end()
            status = self.process.returncode
            ended = f"signal {-status}" if status < 0 else f"exit status {status}"
            what = "the log took too long to read" if is_late else "the log ended the process that read it"
            raise InputError(
                what,
                where=Place(file),
                found=f"more than {seconds:.0f} s" if is_late else ended,
                expected="a file that is not damaged, and fits into memory",
                remedy="take a part of it, or write it again, as CSV or Parquet",
            ) from None
        except BaseException:  # an answer would be left over
            self.end()
            raise
        finally:
            timer.cancel()
        if is_done:
            return answer
        try:
            raise answer
        finally:
            del answer  # which has this frame in its traceback: neither would be let go of soon


#: Processes that wait for the next file.
_waiting: list[_Reader] = []


class _Lease:
    """A process while it reads the ``file`` at ``path``: one that waits, or a new one. It goes back when
    nobody has the lease any more."""

    def __init__(self, path: Path, file: str) -> None:
        files = path.iterdir() if path.is_dir() else [path]
        self.file = file
        self.seconds = SECONDS + sum(each.stat().st_size for each in files) / RATE
        _waiting[:] = (each for each in _waiting if each.owner == os.getpid() and each.process.poll() is None)
        self.reader = _waiting.pop() if _waiting else _Reader()
        weakref.finalize(self, _give_back, self.reader).atexit = False

    def ask(self, *request: Any) -> Any:
        return self.reader.ask(request, self.file, self.seconds)

    def parts(self, stream: Stream, groups: Groups, stamp: str | None) -> Iterator[Rows]:
        """As :data:`~robodyn.logs.recording.Parts` says."""
        key = self.ask("read", stream, groups, stamp)
        try:
            while (rows := self.ask("next", key)) is not None:
                yield rows
        finally:
            if self.reader.process.poll() is None:
                self.ask("close", key)


def _give_back(reader: _Reader) -> None:
    if reader.process.returncode is None and len(_waiting) < KEPT:
        _waiting.append(reader)


def open_guarded(format: LogFormat, path: Path, file: str, gaps: bool) -> Recording:
    """The recording in the file at ``path``, of that ``format``, read by a process with limits.

    Raises
    ------
    InputError: the file is damaged, too large, or takes too long.
    ToolError: a library is missing.
    """
    lease = _Lease(path, file)
    facts = lease.ask("open", format, path.absolute(), file, gaps)
    return Recording(file=file, parts=lease.parts, **facts)


# --- in the process ---------------------------------------------------------------------------------------


def serve() -> None:
    """Read what is asked for, until nothing more is."""
    bound(DATA=MEMORY, CORE=0)  # files that are mapped, and what a library reserves ahead, are no data
    session = _Session()
    workers.answer_requests(lambda kind, *details: getattr(session, kind)(*details), said_of=session.said_of)


class _Session:
    """The file that is open, and what is being read of it; a method for each request."""

    recording: Recording

    def __init__(self) -> None:
        self.parts: list[Iterator[Rows]] = []

    def open(self, format: LogFormat, path: Path, file: str, gaps: bool) -> dict[str, Any]:
        self.format, self.file = format, file
        self.__dict__.pop("recording", None)  # the one before is let go of first
        self.parts.clear()
        self.recording = format.open(path, file, gaps)
        return {name: getattr(self.recording, name) for name in ("format", "streams", "notes", "names")}

    def read(self, *what: Any) -> int:
        self.parts.append(iter(self.recording.parts(*what)))
        return len(self.parts) - 1

    def next(self, key: int) -> Rows | None:
        return next(self.parts[key], None)

    def close(self, key: int) -> None:
        self.parts[key] = iter(())

    def said_of(self, error: Exception) -> Exception:
        """What is said of an ``error``: of ours and of the system, what they say; of a library, that the file
        is damaged."""
        if isinstance(error, MemoryError):
            return MemoryError()
        if isinstance(error, RobodynError) or (isinstance(error, OSError) and error.errno is not None):
            return error
        reason = "values nested too deeply" if isinstance(error, RecursionError) else error
        return damaged(self.file, self.format.title, reason, self.format.remedy or None)
