"""From ``here``, ``local:N`` or ``dask://HOST:PORT`` to what works there."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final

from robodyn.cluster.cluster import Cluster, ThisProcess
from robodyn.cluster.limits import MOST_PROCESSES
from robodyn.cluster.security import Security
from robodyn.cluster.work import one_thread
from robodyn.errors import InputError
from robodyn.toolchain.program import cores

_EXPECTED: Final = f"here, local, local:N with N from 1 to {MOST_PROCESSES}, or dask://HOST:PORT"


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
    place, _, rest = on.partition(":")
    one_thread()
    if on == "here":
        yield ThisProcess()
    elif on == "local" or (place == "local" and re.fullmatch(r"[1-9]\d{0,3}", rest)):
        count = int(rest) if rest else cores()
        if count > MOST_PROCESSES:
            raise InputError("too many processes", found=str(count), expected=str(MOST_PROCESSES))
        from robodyn.cluster.local import local_processes

        with local_processes(count) as cluster:
            yield cluster
    elif re.fullmatch(r"dask://(\[[0-9A-Fa-f:.]+\]|[\w.-]+):\d{1,5}", on):
        from robodyn.cluster.remote import scheduler_at

        with scheduler_at(on.removeprefix("dask://"), security) as cluster:
            yield cluster
    else:
        raise InputError("no place where work could run", found=repr(on), expected=_EXPECTED)
