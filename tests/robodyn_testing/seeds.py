"""Seeds that turn with the commit: a test over many random arms tries others after each change, yet the same
ones everywhere at one commit."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, Final

import pytest

__all__ = ["REPEAT", "commit_seeds", "seed_counts"]

#: The environment variable whose number takes the place of the commit's.
REPEAT: Final = "ROBODYN_SEED"
#: The first seed where there is no git, as in a source distribution.
WITHOUT_GIT: Final = 38


def commit_seeds(count: int) -> Iterator[int]:
    """Yield `count` seeds in turn, and print each before the test uses it: pytest shows what a failed test
    printed, and the last line names the seed that failed.

    The seeds follow one another, and the first is drawn from the commit that is checked out. With
    ``ROBODYN_SEED=N`` in the environment the first is N, so that a failure is repeated at once.
    """
    first = int(os.environ.get(REPEAT) or _of_commit())
    for seed in range(first, first + count):
        print(f"seed {seed} ({REPEAT}={seed} starts with it)")
        yield seed


def seed_counts(few: int, many: int) -> list[Any]:
    """How many seeds a test loops over, for ``pytest.mark.parametrize``: a `few`, and in ``make prove-all``
    `many`."""
    return [
        pytest.param(few, id=f"{few}_seeds"),
        pytest.param(many, id=f"{many}_seeds", marks=pytest.mark.slow),
    ]


@cache
def _of_commit() -> int:
    command = ["git", "rev-parse", "HEAD"]
    try:
        done = subprocess.run(command, cwd=Path(__file__).parent, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return WITHOUT_GIT
    return int(done.stdout[:7], 16)
