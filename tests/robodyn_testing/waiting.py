"""Waiting for what other processes and threads do sooner or later."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Final

__all__ = ["eventually", "runs"]

_HANGS: Final = 300.0
"""After so many seconds what is waited for hangs: so that the tests end, and no promise of robodyn's."""


def eventually(condition: Callable[[], object]) -> bool:
    """Whether `condition` comes true; waits for it as long as it takes, unless it hangs."""
    end = time.monotonic() + _HANGS
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.01)
    return True


def runs(process: int) -> bool:
    """Whether the process of that id runs; one that has ended and was not yet waited for does not."""
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    state = Path(f"/proc/{process}/stat")
    return not state.exists() or state.read_text().rpartition(")")[2].split()[0] != "Z"
