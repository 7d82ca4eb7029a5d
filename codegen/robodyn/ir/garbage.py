"""How often Python looks for garbage while programs are built."""

from __future__ import annotations

import contextlib
import gc
from collections.abc import Iterator

#: Programs are many small objects, and no garbage but what goes by itself: objects that are new before Python
#: looks at the youngest of them, and how often it does that before it looks at older ones.
RARELY = (10_000_000, 20, 20)


@contextlib.contextmanager
def rarely_collected() -> Iterator[None]:
    """Python looks for garbage rarely here, and afterwards as before: a quarter of a generation goes into it
    otherwise. Who has switched it off, or has it look more rarely still, is left alone. As a decorator it
    holds for each call."""
    before = gc.get_threshold()
    if not 0 < before[0] < RARELY[0]:
        yield
        return
    gc.set_threshold(*RARELY)
    try:
        yield
    finally:
        gc.set_threshold(*before)
