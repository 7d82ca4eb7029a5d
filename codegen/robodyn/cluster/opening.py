"""From ``here``, ``local:N`` or ``dask://HOST:PORT`` to what works there."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import Final

from robodyn.cluster.cluster import Cluster, ThisProcess
from robodyn.cluster.limits import MOST_PROCESSES
from robodyn.cluster.security import Security
from robodyn.cluster.work import one_thread
from robodyn.errors import InputError
from robodyn.toolchain.program import cores

_EXPECTED: Final = f"here, local, local:N with N from 1 to {MOST_PROCESSES}, or dask://HOST:PORT"
#: [-] The last port that TCP has.
_LAST_PORT: Final = 65535


def check_place(on: str) -> None:
    """Refuse what :func:`open_cluster` would not take, before there is work.

    Raises
    ------
    InputError: ``on`` is no place where work could run.
    """
    local = re.fullmatch(r"local(?::([1-9]\d{0,8}))?", on, re.ASCII)
    remote = re.fullmatch(r"dask://(?:\[[0-9A-Fa-f:.]+\]|[\w.-]+):(\d{1,5})", on)
    if local and int(local[1] or 1) > MOST_PROCESSES:
        raise InputError("too many processes", found=local[1], expected=f"at most {MOST_PROCESSES}")
    if remote and not 1 <= int(remote[1]) <= _LAST_PORT:
        raise InputError("there is no such port", found=remote[1], expected=f"1 to {_LAST_PORT}")
    if on != "here" and not local and not remote:
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
            from robodyn.cluster.local import local_processes

            yield stack.enter_context(local_processes(int(rest) if rest else cores()))
        else:
            from robodyn.cluster.remote import scheduler_at

            yield stack.enter_context(scheduler_at(on.removeprefix("dask://"), security))
