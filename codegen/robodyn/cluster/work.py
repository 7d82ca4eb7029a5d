"""What runs in a process that works: one piece at a time, after a look whether it is the same robodyn."""

from __future__ import annotations

import os
import pickle
import socket
import sys
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Final

from robodyn.errors import ToolError
from robodyn.toolchain.sources import own_key
from robodyn.version import VERSION

#: How many threads the libraries of linear algebra use. With one, sums do not depend on how many there are,
#: and as many processes as cores do not get in each other's way.
ONE_THREAD: Final = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}
_THREADS: Final = "threads of linear algebra"
#: A worker of Dask's may have several threads; numbers are not promised to be the same with them.
_ONE_AT_A_TIME: Final = threading.Lock()


@dataclass(frozen=True, slots=True)
class Done:
    """A piece of work has come to ``value``."""

    value: Any


@dataclass(frozen=True, slots=True)
class Failed:
    """A piece of work has come to nothing: ``error`` is what its function raised, or why it was given up."""

    error: Exception


class WrongWorker(ToolError):
    """A process that works is not like the one that asks."""


@contextmanager
def one_thread() -> Iterator[None]:
    """Linear algebra uses one thread while the context lasts, in this process and in those that it starts."""
    from threadpoolctl import threadpool_limits

    before = {name: os.environ.get(name) for name in ONE_THREAD}
    os.environ.update(ONE_THREAD)  # what is loaded or started from now on
    try:
        with threadpool_limits(limits=1):  # what is loaded
            yield
    finally:
        for name, value in before.items():
            if value is None:
                os.environ.pop(name, None)
            else:
                os.environ[name] = value


def likeness() -> dict[str, str]:
    """By what a process must be like another to come to the same numbers, by its name."""
    import numpy
    import scipy

    threads = os.environ.get("OPENBLAS_NUM_THREADS", os.environ.get("OMP_NUM_THREADS", "any"))
    return {
        "robodyn": f"{VERSION} ({own_key()[:8]})",
        "Python": "{}.{}".format(*sys.version_info),
        "numpy": numpy.__version__,
        "scipy": scipy.__version__,
        _THREADS: threads,
    }


def work(ours: Mapping[str, str], function: Callable[..., Any], arguments: tuple[Any, ...]) -> Done | Failed:
    """:func:`outcome`, in a process that has the :func:`likeness` of the one that asks.

    Raises
    ------
    WrongWorker: it is another.
    """
    theirs = likeness()
    differ = [name for name in ours if theirs.get(name) != ours[name]]
    if differ:
        remedy = "install the same there, and start the worker again"
        if differ == [_THREADS]:
            remedy = "start it with OMP_NUM_THREADS=1, or as dask worker does, with its nanny"
        raise WrongWorker(
            f"a worker on {socket.gethostname()} is not like this process: numbers could differ",
            found=", ".join(f"{name} {theirs.get(name)}" for name in differ),
            expected=", ".join(f"{name} {ours[name]}" for name in differ),
            remedy=remedy,
        )
    with _ONE_AT_A_TIME:
        return outcome(function, arguments)


def outcome(function: Callable[..., Any], arguments: tuple[Any, ...]) -> Done | Failed:
    """What ``function`` of the ``arguments`` comes to, or what it raises."""
    try:
        return Done(function(*arguments))
    except Exception as error:
        return Failed(_portable(error))


def _portable(error: Exception) -> Exception:
    """``error`` without what led to it, so that it may leave its process."""
    error.__traceback__ = error.__cause__ = error.__context__ = None
    try:
        pickle.loads(pickle.dumps(error))
    except Exception:
        return ToolError(f"{type(error).__name__}: {error}")
    return error
