"""Processes of this machine, started and ended by Dask."""

from __future__ import annotations

import logging
import signal
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from tempfile import TemporaryDirectory
from typing import Any, Final

from robodyn.cluster.limits import CONNECT, DEATHS, MEMORY
from robodyn.cluster.scheduler import Scheduler
from robodyn.cluster.work import ONE_THREAD
from robodyn.errors import ToolError
from robodyn.tools.libraries import CRYPTOGRAPHY, DISTRIBUTED

#: What Dask is told of the processes: nothing is written to a disk where memory is short, and nothing waits
#: for memory that nobody will free; a process that needs too much is ended. Of its own variables for
#: processes, MALLOC_TRIM_THRESHOLD_ is left out: with it a third of the time of a digest goes into memory
#: that is handed back to the system and fetched again.
_CONFIG: Final = {
    "distributed.scheduler.allowed-failures": DEATHS,
    "distributed.worker.memory.target": False,
    "distributed.worker.memory.spill": False,
    "distributed.worker.memory.pause": False,
    "distributed.worker.memory.terminate": 0.95,
    "distributed.worker.profile.enabled": False,
    "distributed.nanny.pre-spawn-environ": ONE_THREAD,
    "distributed.logging": {"distributed": "critical"},
}


@contextmanager
def local_processes(count: int) -> Iterator[Scheduler]:
    """``count`` processes of this machine.

    They take work from this process only where ``cryptography`` is installed; where it is not, other users
    of this machine could send them some.

    Raises
    ------
    ToolError: Dask is not installed, or they cannot be started.
    """
    DISTRIBUTED.load(otherwise="take --on here")
    import dask
    from distributed import Client, LocalCluster, Security

    with ExitStack() as stack:
        stack.enter_context(quiet())
        stack.enter_context(dask.config.set(_CONFIG))
        folder = stack.enter_context(TemporaryDirectory(prefix="robodyn-", ignore_cleanup_errors=True))
        try:
            with _deaf_to_interrupts():
                processes = LocalCluster(
                    n_workers=count,
                    threads_per_worker=1,
                    memory_limit=min(MEMORY, _share(count)),
                    dashboard_address="127.0.0.1:0",  # of nobody else; its pages are left out
                    scheduler_kwargs={"dashboard": False},
                    security=Security.temporary() if CRYPTOGRAPHY.present() else None,
                    silence_logs=logging.CRITICAL,
                    local_directory=folder,
                )
        except (OSError, RuntimeError) as error:
            raise ToolError("processes cannot be started", found=str(error)) from None
        stack.callback(processes.close, timeout=CONNECT)
        scheduler = Scheduler(
            lambda: Client(processes, set_as_default=False, timeout=CONNECT), "Dask's scheduler"
        )
        stack.callback(scheduler.close)
        yield scheduler


def _share(count: int) -> int:
    """What of this machine's memory [bytes] is there for each of ``count`` processes."""
    from distributed.system import MEMORY_LIMIT

    return int(MEMORY_LIMIT // count)


@contextmanager
def quiet() -> Iterator[None]:
    """Dask keeps its messages: what matters of them is an error of robodyn's."""
    logger = logging.getLogger("distributed")
    level = logger.level
    logger.setLevel(logging.CRITICAL)
    try:
        yield
    finally:
        logger.setLevel(level)


@contextmanager
def _deaf_to_interrupts() -> Iterator[None]:
    """What is started here does not hear Ctrl-C: it is for the one that asks, and waits until this is over.

    Threads and processes have the mask of signals of what they are started by.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    from multiprocessing.resource_tracker import ensure_running

    ensure_running()  # where it is not yet, the first process lifts the mask of the thread that starts it
    before: Any = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
