"""A scheduler of Dask's that others have started, here or on another machine."""

from __future__ import annotations

import ssl
import warnings
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from robodyn.cluster.limits import CONNECT
from robodyn.cluster.local import quiet
from robodyn.cluster.scheduler import Scheduler, no_answer, no_worker, not_there
from robodyn.cluster.security import Security
from robodyn.cluster.work import WrongWorker, likeness, worker_likeness
from robodyn.errors import InputError
from robodyn.tools.libraries import DISTRIBUTED


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
    with quiet():
        scheduler = Scheduler(lambda: _client(f"{scheme}://{address}", keys, name), name)
        try:
            yield scheduler
        finally:
            scheduler.close()


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
    try:
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
    except BaseException:
        client.close(timeout=CONNECT)
        raise
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
