"""What runs in a process that works: one piece at a time, after a look whether it is the same robodyn."""

from __future__ import annotations

import os
import pickle
import socket
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Final

from robodyn.errors import ToolError
from robodyn.toolchain.sources import own_key
from robodyn.version import VERSION

#: How many threads the libraries of linear algebra use. With one, sums do not depend on how many there are,
#: and as many processes as cores do not get in each other's way.
ONE_THREAD: Final = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}

#: A worker of Dask's may have several threads; numbers are not promised to be the same with them.
_ONE_AT_A_TIME: Final = threading.Lock()


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
    from importlib.metadata import PackageNotFoundError, version

    versions = {"robodyn": f"{VERSION} ({own_key()[:8]})", "Python": "{}.{}".format(*sys.version_info)}
    for package in ("numpy", "scipy", "distributed"):
        try:
            versions[package] = version(package)
        except PackageNotFoundError:
            versions[package] = "none"
    return versions


def worker_likeness() -> dict[str, str]:
    """:func:`likeness` of a process that works, with the ``threads`` of its linear algebra."""
    threads = [os.environ[name] for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS") if name in os.environ]
    return {**likeness(), "threads": threads[0] if threads else "any"}


def work(key: str, function: Callable[..., Any], arguments: tuple[Any, ...]) -> tuple[bool, Any]:
    """:func:`outcome`, in a process whose robodyn has the ``key`` of the one that asks.

    Raises
    ------
    WrongWorker: it is another robodyn.
    """
    if key != own_key():
        raise WrongWorker(
            f"a worker on {socket.gethostname()} has another robodyn",
            found=f"{VERSION} ({own_key()[:8]})",
            expected=f"the sources {key[:8]} of the robodyn that asks",
            remedy="install the same there, and start the worker again",
        )
    with _ONE_AT_A_TIME:
        return outcome(function, arguments)


def outcome(function: Callable[..., Any], arguments: tuple[Any, ...]) -> tuple[bool, Any]:
    """True and what ``function`` of the ``arguments`` comes to, or False and what it raises."""
    try:
        return True, function(*arguments)
    except Exception as error:
        return False, _portable(error)


def _portable(error: Exception) -> Exception:
    """``error`` without what led to it, so that it may leave its process."""
    error.__traceback__ = error.__cause__ = error.__context__ = None
    try:
        pickle.loads(pickle.dumps(error))
    except Exception:
        return ToolError(f"{type(error).__name__}: {error}")
    return error
