"""Threads for parts of a batch: one pool a process, made when it is first needed."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor

_lock = threading.Lock()
_pool: ThreadPoolExecutor | None = None
_size = 0


def run_all(jobs: Sequence[Callable[[], object]]) -> None:
    """Run all ``jobs``, the first in this thread and the others in threads of the pool, and wait for them.

    They run in parallel as far as they release Python's lock.
    """
    if len(jobs) > 1:
        pool = _pool_of(len(jobs) - 1)
        waiting = [pool.submit(job) for job in jobs[1:]]
        jobs[0]()
        for future in waiting:
            future.result()
    elif jobs:
        jobs[0]()


def _pool_of(size: int) -> ThreadPoolExecutor:
    """The pool, with ``size`` threads at least. A smaller one ends when its work is done."""
    global _pool, _size
    with _lock:
        if _pool is None or _size < size:
            if _pool is not None:
                _pool.shutdown(wait=False)
            _pool, _size = ThreadPoolExecutor(size, thread_name_prefix="robodyn"), size
        return _pool


def _forget() -> None:
    """In a forked child there are no threads: the next batch makes new ones."""
    global _pool, _size, _lock
    _pool, _size, _lock = None, 0, threading.Lock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget)
