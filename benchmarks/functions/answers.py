"""Ask a tool for functions in a process of its own, which ends when it takes too long over one of them."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any


@dataclass(frozen=True, slots=True)
class Answers:
    """What a tool has made of a function: operations and values of each way to write it; ``why`` there are no
    more."""

    function: str
    ways: tuple[tuple[dict[str, int], list[list[float]]], ...]
    why: str | None = None


def answers_of(tool: str, folder: Path, functions: Sequence[str], seconds: int) -> Iterator[Answers]:
    """The answers to all ``functions``; ``tool`` has ``seconds`` of processor time for each."""
    rest = list(functions)
    while rest:
        for answers in _until_stopped(tool, folder, tuple(rest), seconds):
            rest.remove(answers.function)
            yield answers


def _until_stopped(tool: str, folder: Path, functions: Sequence[str], seconds: int) -> Iterator[Answers]:
    """The answers up to that at which the process has ended."""
    command = [
        sys.executable,
        "-m",
        "benchmarks.functions.worker",
        tool,
        str(folder),
        str(seconds),
        *functions,
    ]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        ways: list[Any] = []
        waiting = iter(functions)
        for line in process.stdout:
            if not line.startswith("{"):  # a tool may say something itself
                continue
            answer = json.loads(line)
            if "count" in answer:
                ways.append((answer["count"], answer["values"]))
            else:
                yield Answers(next(waiting), tuple(ways), answer.get("why"))
                ways = []
    stopped = next(waiting, None)
    if stopped is not None:
        late = process.returncode == -signal.SIGXCPU
        yield Answers(stopped, tuple(ways), f"not done within {seconds} s" if late else "the tool has died")
