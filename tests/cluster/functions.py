"""What the processes of these tests work on: they import it by its name."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path

from robodyn.errors import InputError


def square(x: int) -> int:
    return x * x


def picky(x: int) -> int:
    if x == 3:
        raise InputError("three cannot be used", found="3")
    return x


def deadly(x: int) -> int:
    """Its process ends with 3."""
    if x == 3:
        os.kill(os.getpid(), signal.SIGKILL)
    return x


def note(folder: str, x: int, seconds: float = 0.0) -> int:
    """Leave a line with the process for each time it is carried out."""
    with (Path(folder) / str(x)).open("a") as file:
        file.write(f"{os.getpid()}\n")
    time.sleep(seconds)
    return x
