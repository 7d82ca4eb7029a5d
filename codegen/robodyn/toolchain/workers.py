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

#: What a process runs, of a module. It ends without a word, however it ends: the one that asks says what is
#: to be said.
_SERVE = """\
import os
try:
    from {} import serve
    serve()
finally:
    os._exit(1)
"""


def started(module: str, **streams: Any) -> subprocess.Popen[bytes]:
    """A process that runs ``serve`` of a ``module``, in a group of its own: Ctrl-C is for the one that asks.
    ``streams`` go to ``Popen``."""
    imports = os.pathsep.join(path or str(Path.cwd()) for path in sys.path)
    return subprocess.Popen(
        [sys.executable, "-P", "-c", _SERVE.format(module)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
        env=dict(os.environ, PYTHONPATH=imports), start_new_session=True, **streams,
    )  # fmt: skip


def end(processes: Sequence[subprocess.Popen[bytes]], *, at_once: bool) -> None:
    """Let go of ``processes``, which end when they have answered, or ``at_once``; wait for that."""
    for process in processes:
        if at_once:
            process.kill()
        for stream in (process.stdin, process.stdout):
            if stream is not None:
                with contextlib.suppress(OSError):  # what it was to do next: it is dead already
                    stream.close()
    for process in processes:
        process.wait()


class Workers:
    """``count`` processes; with one, the work is done in this process."""

    def __init__(self, count: int) -> None:
        self.count = count
        self._processes: list[subprocess.Popen[bytes]] = []

    def __enter__(self) -> Workers:
        if self.count > 1:
            try:
                for _ in range(self.count):
                    self._processes.append(started(__name__))
            except BaseException:
                end(self._processes, at_once=True)
                raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        end(self._processes, at_once=kind is not None)

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


def answer_requests(
    answer: Callable[..., Any], said_of: Callable[[Exception], Exception] = lambda error: error
) -> None:
    """In the process: ``answer`` what is asked, until nothing more is; of an exception what is ``said_of`` it
    is raised in the one that asks."""
    questions, answers = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # a library that prints does not answer
    while True:
        try:
            request = pickle.load(questions)
        except EOFError:
            return
        try:
            result = True, answer(*request)
        except Exception as error:
            result = False, said_of(error)
        pickle.dump(result, answers, protocol=pickle.HIGHEST_PROTOCOL)
        answers.flush()


def serve() -> None:
    """Work on what comes in, until nothing more does."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the one that asks sees to the end
    gc.freeze()
    gc.set_threshold(100_000, 20, 20)  # a search makes much that lives for a millisecond
    answer_requests(lambda function, task: function(*task))
