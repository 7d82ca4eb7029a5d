"""Work on several processors: functions of this library run in other processes of the same Python.

The processes are started afresh and import nothing of the program that asks (no guard around its main
module is needed), and share nothing with it.
"""

from __future__ import annotations

import gc
import os
import pickle
import signal
import subprocess
import sys
from collections.abc import Callable, Sequence
from types import TracebackType
from typing import Any


class Workers:
    """``count`` processes; with one, the work is done in this process."""

    def __init__(self, count: int) -> None:
        self.count = count
        self._processes: list[subprocess.Popen[bytes]] = []

    def __enter__(self) -> Workers:
        if self.count > 1:
            environment = dict(os.environ, PYTHONPATH=os.pathsep.join(path for path in sys.path if path))
            command = [sys.executable, "-c", "from robodyn.search.workers import serve; serve()"]
            pipe = subprocess.PIPE
            self._processes = [
                subprocess.Popen(command, stdin=pipe, stdout=pipe, env=environment) for _ in range(self.count)
            ]
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        for process in self._processes:
            if kind is not None:
                process.kill()
            for stream in (process.stdin, process.stdout):
                if stream is not None:
                    stream.close()
            process.wait()

    def run(self, function: Callable[..., Any], tasks: Sequence[tuple[Any, ...]]) -> list[Any]:
        """``function`` of each task's arguments; at most ``count`` tasks, one a process."""
        if not self._processes:
            return [function(*task) for task in tasks]
        busy = []
        for process, task in zip(self._processes, tasks, strict=False):
            assert process.stdin is not None
            pickle.dump((function, task), process.stdin)
            process.stdin.flush()
            busy.append(process)
        results = []
        for process in busy:
            assert process.stdout is not None
            done, result = pickle.load(process.stdout)
            if not done:
                raise result
            results.append(result)
        return results


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
