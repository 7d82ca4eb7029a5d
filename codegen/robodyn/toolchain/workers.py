"""Work on several processors: functions of this library run in other processes of the same Python.

The processes are started afresh and import nothing of the program that asks (no guard around its main
module is needed), and share nothing with it.
"""

from __future__ import annotations

import contextlib
import gc
import os
import pickle
import selectors
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any

from robodyn.errors import ToolError

#: What a process runs. It ends without a word, however it ends: the one that asks says what is to be said.
_SERVE = """\
import os
try:
    from robodyn.toolchain.workers import serve
    serve()
finally:
    os._exit(1)
"""


class Workers:
    """``count`` processes; with one, the work is done in this process."""

    def __init__(self, count: int) -> None:
        self.count = count
        self._processes: list[subprocess.Popen[bytes]] = []

    def __enter__(self) -> Workers:
        if self.count > 1:
            imports = os.pathsep.join(path or str(Path.cwd()) for path in sys.path)
            environment = dict(os.environ, PYTHONPATH=imports)
            pipe = subprocess.PIPE
            try:
                for _ in range(self.count):  # in a group of their own: Ctrl-C is for the one that asks
                    process = subprocess.Popen(
                        [sys.executable, "-P", "-c", _SERVE],
                        stdin=pipe,
                        stdout=pipe,
                        env=environment,
                        start_new_session=True,
                    )
                    self._processes.append(process)
            except BaseException:
                self._end(at_once=True)
                raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._end(at_once=kind is not None)

    def _end(self, *, at_once: bool) -> None:
        for process in self._processes:
            if at_once:
                process.kill()
            for stream in (process.stdin, process.stdout):
                if stream is not None:
                    with contextlib.suppress(OSError):  # what it was to do next: it is dead already
                        stream.close()
        for process in self._processes:
            process.wait()

    def run(self, function: Callable[..., Any], tasks: Sequence[tuple[Any, ...]]) -> list[Any]:
        """``function`` of each task's arguments; at most ``count`` tasks, one a process.

        Raises
        ------
        ToolError: a process has ended before its work was done.
        """
        if not self._processes:
            return [function(*task) for task in tasks]
        busy = [process for process, _ in zip(self._processes, tasks, strict=False)]
        for process, task in zip(busy, tasks, strict=True):
            _ask(process, function, task)
        return [_answer(process) for process in busy]

    def each(
        self,
        function: Callable[..., Any],
        tasks: Sequence[tuple[Any, ...]],
        begun: Callable[[int], None] = lambda k: None,
    ) -> Iterator[tuple[int, Any]]:
        """``function`` of each task's arguments, of as many tasks as there may be, one after the other in
        whatever process is free: the index and the result of each when it is done. ``begun`` is told the
        index of each that begins.

        Raises
        ------
        ToolError: a process has ended before its work was done.
        """
        if not self._processes:
            for k, task in enumerate(tasks):
                begun(k)
                yield k, function(*task)
            return
        with selectors.DefaultSelector() as busy:
            free, waiting = list(self._processes), list(enumerate(tasks))[::-1]
            while waiting or busy.get_map():
                while free and waiting:
                    process, (k, task) = free.pop(), waiting.pop()
                    begun(k)
                    _ask(process, function, task)
                    assert process.stdout is not None
                    busy.register(process.stdout, selectors.EVENT_READ, (k, process))
                for ready, _ in busy.select():
                    k, process = ready.data
                    busy.unregister(ready.fileobj)
                    result = _answer(process)
                    free.append(process)
                    yield k, result


def _ask(process: subprocess.Popen[bytes], function: Callable[..., Any], task: tuple[Any, ...]) -> None:
    """Have ``process`` begin with ``function`` of the arguments ``task``."""
    assert process.stdin is not None
    try:
        pickle.dump((function, task), process.stdin)
        process.stdin.flush()
    except BrokenPipeError:
        raise _lost(process) from None


def _answer(process: subprocess.Popen[bytes]) -> Any:
    """What ``process`` comes to; its exceptions are raised here."""
    assert process.stdout is not None
    try:
        done, result = pickle.load(process.stdout)
    except (EOFError, pickle.UnpicklingError):
        raise _lost(process) from None
    if not done:
        raise result
    return result


def _lost(process: subprocess.Popen[bytes]) -> ToolError:
    """What to say of a process that has ended on its own."""
    try:
        code = process.wait(1)
        cause = f"signal {-code}" if code < 0 else f"exit status {code}"
    except subprocess.TimeoutExpired:
        cause = "no answer"
    return ToolError(
        "a process that helps has ended before its work was done",
        found=cause,
        remedy="run it again; if memory is short, with fewer other programs running",
    )


def serve() -> None:
    """Work on what comes in, until nothing more does."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the one that asks sees to the end
    gc.freeze()
    gc.set_threshold(100_000, 20, 20)  # a search makes much that lives for a millisecond
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    sys.stdout = sys.stderr
    while True:
        try:
            function, task = pickle.load(sys.stdin.buffer)
        except EOFError:
            return
        try:
            answer = (True, function(*task))
        except Exception as error:
            answer = (False, error)
        pickle.dump(answer, answers)
        answers.flush()
