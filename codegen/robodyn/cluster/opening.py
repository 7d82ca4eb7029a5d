"""From ``here``, ``local:N`` or ``dask://HOST:PORT`` to what works there."""

from __future__ import annotations

import logging
import re
import signal
import ssl
import warnings
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, closing, contextmanager
from tempfile import TemporaryDirectory
from typing import Any, Final

from robodyn.cluster.cluster import Cluster, Security, ThisProcess
from robodyn.cluster.limits import CONNECT, DEATHS, MEMORY, MOST_PROCESSES
from robodyn.cluster.scheduler import Scheduler, no_answer, no_worker, not_there
from robodyn.cluster.work import ONE_THREAD, WrongWorker, likeness, one_thread, worker_likeness
from robodyn.errors import InputError, ToolError
from robodyn.toolchain.program import cores
from robodyn.tools.libraries import CRYPTOGRAPHY, DISTRIBUTED

#: [-] The last port that TCP has.
_LAST_PORT: Final = 65535
_EXPECTED: Final = f"here, local, local:N (N up to {MOST_PROCESSES}) or dask://HOST:PORT (up to {_LAST_PORT})"


def check_place(on: str) -> None:
    """Refuse what :func:`open_cluster` would not take, before there is work.

    Raises
    ------
    InputError: ``on`` is no place where work could run.
    """
    local = re.fullmatch(r"local(?::([1-9]\d{0,8}))?", on, re.ASCII)
    remote = re.fullmatch(r"dask://(?:\[[0-9A-Fa-f:.]+\]|[\w.-]+):(\d{1,5})", on)
    is_local = local and int(local[1] or 1) <= MOST_PROCESSES
    is_remote = remote and 1 <= int(remote[1]) <= _LAST_PORT
    if not (on == "here" or is_local or is_remote):
        raise InputError("no place where work could run", found=repr(on), expected=_EXPECTED)


@contextmanager
def open_cluster(on: str, *, security: Security | None = None) -> Iterator[Cluster]:
    """What works ``on``: ``here`` (this process), ``local`` (as many processes as cores), ``local:N``, or
    ``dask://HOST:PORT``, a scheduler of Dask's with its workers.

    A scheduler is asked through TLS if there is a ``security``, here or in Dask's own configuration.

    Raises
    ------
    InputError: ``on`` is none of these, or a file of ``security`` cannot be used.
    ToolError: Dask is not installed, the scheduler does not answer, or its workers are not like this process.
    """
    check_place(on)
    place, _, rest = on.partition(":")
    with ExitStack() as stack:
        stack.enter_context(one_thread())
        if on == "here":
            yield ThisProcess()
        elif place == "local":
            yield stack.enter_context(local_processes(int(rest) if rest else cores()))
        else:
            yield stack.enter_context(scheduler_at(on.removeprefix("dask://"), security))


# --- processes of this machine ----------------------------------------------------------------------------


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
    from distributed.system import MEMORY_LIMIT

    with ExitStack() as stack:
        stack.enter_context(quiet())
        stack.enter_context(dask.config.set(_CONFIG))
        folder = stack.enter_context(TemporaryDirectory(prefix="robodyn-", ignore_cleanup_errors=True))
        try:
            with _deaf_to_interrupts():
                processes = LocalCluster(
                    n_workers=count,
                    threads_per_worker=1,
                    memory_limit=min(MEMORY, int(MEMORY_LIMIT // count)),
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
        yield stack.enter_context(closing(scheduler))


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


# --- a scheduler that others have started -----------------------------------------------------------------


@contextmanager
def scheduler_at(address: str, security: Security | None) -> Iterator[Scheduler]:
    """The scheduler at ``address`` (HOST:PORT), asked through TLS where ``security`` or Dask's configuration
    has certificates.

    Raises
    ------
    InputError: a certificate cannot be used.
    ToolError: Dask is not installed, the scheduler does not answer or has no workers, or they are not like
        this process.
    """
    DISTRIBUTED.load(otherwise="take --on here")
    name = f"the scheduler dask://{address}"
    keys = _keys(security)
    scheme = "tls" if keys.require_encryption or keys.tls_client_cert else "tcp"
    with quiet(), closing(Scheduler(lambda: _client(f"{scheme}://{address}", keys, name), name)) as scheduler:
        yield scheduler


def _keys(security: Security | None) -> Any:
    """``security`` as Dask has it.

    Raises
    ------
    InputError: a file of it cannot be used.
    """
    import distributed

    if security is None:
        keys = distributed.Security()
    else:
        keys = distributed.Security(
            require_encryption=True,
            tls_ca_file=security.authority,
            tls_client_cert=security.certificate,
            tls_client_key=security.key or None,
        )
    try:
        keys.get_connection_args("client")
    except (OSError, ssl.SSLError) as error:
        files = (keys.tls_ca_file, keys.tls_client_cert, keys.tls_client_key)
        raise InputError(
            "a certificate or its key cannot be used",
            found=f"{error.strerror or error} ({', '.join(str(file) for file in files if file)})",
            expected="files in PEM: the authority's certificate, one's own, and its key",
        ) from None
    return keys


def _client(address: str, keys: Any, name: str) -> Any:
    """A client of the scheduler at ``address``, whose workers are like this process.

    Raises
    ------
    ToolError: see :func:`scheduler_at`.
    """
    from distributed import Client

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # other versions: an error of ours, below
            client = Client(address, security=keys, set_as_default=False, timeout=CONNECT)
    except (OSError, TimeoutError):
        raise no_answer(name, CONNECT) from None
    except ImportError as error:
        raise not_there(error) from None
    with ExitStack() as stack:
        stack.callback(client.close, timeout=CONNECT)
        try:
            client.wait_for_workers(1, timeout=CONNECT)
        except TimeoutError:
            raise no_worker(name, CONNECT) from None
        try:
            compare("the scheduler", client.run_on_scheduler(likeness))
            for worker, theirs in client.run(worker_likeness).items():
                compare(f"the worker {worker}", theirs)
        except ImportError as error:
            raise not_there(error) from None
        stack.pop_all()
    return client


def compare(who: str, theirs: Mapping[str, str]) -> None:
    """Hold a process to be like this one.

    Raises
    ------
    WrongWorker: it is not.
    """
    ours = {**likeness(), "threads": "1"}
    differ = [name for name in theirs if theirs[name] != ours[name]]
    if "threads" in differ:
        raise WrongWorker(
            f"linear algebra of {who} uses more threads than one",
            remedy="start it with OMP_NUM_THREADS=1, or as dask worker does, with its nanny",
        )
    if differ:
        raise WrongWorker(
            f"{who} has other versions: numbers could differ",
            found=", ".join(f"{name} {theirs[name]}" for name in differ),
            expected=", ".join(f"{name} {ours[name]}" for name in differ),
            remedy="install the same there",
        )
