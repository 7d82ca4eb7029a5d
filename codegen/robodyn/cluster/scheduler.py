"""Work that a scheduler of Dask's hands to its workers: nothing is lost, and nothing handed out twice, when
one of them goes."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from queue import Empty, SimpleQueue
from time import monotonic, sleep
from typing import Any

from robodyn.cluster.cluster import Done, Failed
from robodyn.cluster.limits import AHEAD, ATTEMPTS, CONNECT, COUNT, DEATHS, POLL, RECONNECT
from robodyn.cluster.work import WrongWorker, work
from robodyn.errors import ToolError
from robodyn.process import Held
from robodyn.toolchain.sources import own_key

_log = logging.getLogger("robodyn.cluster")
_LOST = ToolError(
    "no result came back",
    found=f"{ATTEMPTS} times, schedulers or workers went before it was fetched",
    remedy="look at the messages of the workers, and run it again",
)


@dataclass(frozen=True, slots=True)
class _Piece:
    """A piece of work: its ``key`` and ``arguments``; how often it was handed to the scheduler before, and
    whether that was on its own, after processes had ended with it."""

    key: Any
    arguments: tuple[Any, ...]
    attempts: int = 0
    alone: bool = False


@dataclass(slots=True)
class _Pieces:
    """The pieces of one call: those that ``wait``, those for when nothing else is under way (``suspects``:
    one of them may have ended the processes that were lost), those ``under_way`` by the key of their future,
    and the keys of those that have ``ended``."""

    wait: Iterator[_Piece]
    again: deque[_Piece] = field(default_factory=deque)
    suspects: deque[_Piece] = field(default_factory=deque)
    under_way: dict[str, tuple[Any, _Piece]] = field(default_factory=dict)
    ended: SimpleQueue[str] = field(default_factory=SimpleQueue)

    def next(self) -> _Piece | None:
        """The piece to submit next, if it is time for one."""
        if self.again:
            return self.again.popleft()
        piece = next(self.wait, None)
        if piece is None and self.suspects and not self.under_way:
            return replace(self.suspects.popleft(), alone=True, attempts=0)
        return piece


class Scheduler:
    """A :class:`~robodyn.cluster.cluster.Cluster`: what ``connect`` reaches, a scheduler with workers.

    ``connect`` raises :class:`ToolError` where nothing answers in time; ``name`` is what messages call the
    scheduler.
    """

    def __init__(self, connect: Callable[[], Any], name: str) -> None:
        self._connect, self._name = connect, name
        self._client = connect()
        self._counted = monotonic()
        self._deserted: float | None = None
        self.count = len(self._client.nthreads())

    def close(self) -> None:
        """Leave the scheduler."""
        self._client.close(timeout=CONNECT)

    def each(
        self, function: Callable[..., Any], tasks: Iterable[tuple[Any, tuple[Any, ...]]]
    ) -> Iterator[tuple[Any, Done | Failed]]:
        """As of :class:`~robodyn.cluster.cluster.Cluster`."""
        pieces = _Pieces(_Piece(key, arguments) for key, arguments in tasks)
        try:
            while True:
                while len(pieces.under_way) < AHEAD * max(self.count, 1) and (piece := pieces.next()):
                    if piece.attempts == ATTEMPTS:
                        yield piece.key, Failed(_LOST)
                        continue
                    try:
                        self._submit(function, piece, pieces)
                    except (OSError, RuntimeError):  # the connection is just being lost
                        self._reach()
                        self._submit(function, piece, pieces)
                if not pieces.under_way:
                    return
                result = self._next(pieces)
                if result is not None:
                    yield result
                if self._client.status != "running":
                    self._reach()
        finally:
            futures = [future for future, _ in pieces.under_way.values()]
            if futures and self._client.status == "running":
                self._client.cancel(futures, force=True)

    # Where Dask's futures begin and end a Ctrl-C waits: an exception there leaves pieces of them, which say
    # so in a traceback that nobody can catch, or is lost.

    def _submit(self, function: Callable[..., Any], piece: _Piece, pieces: _Pieces) -> None:
        """Have the scheduler hand ``piece`` to a worker."""
        with Held():
            future = self._client.submit(work, own_key(), function, piece.arguments, pure=False)
            pieces.under_way[future.key] = future, replace(piece, attempts=piece.attempts + 1)
            future.add_done_callback(lambda future: pieces.ended.put(future.key))
            del future

    def _next(self, pieces: _Pieces) -> tuple[Any, Done | Failed] | None:
        """The key of a piece that has ended and what it has come to; None: of none within
        :data:`~robodyn.cluster.limits.POLL`, or it will be tried again.

        Raises
        ------
        ToolError: a worker is not like this process, or there has been none for too long.
        """
        with Held() as held:
            try:
                future, piece = pieces.under_way.pop(pieces.ended.get(timeout=POLL), (None, None))
            except Empty:
                self._look(pieces)
                return None
            result = None if piece is None else self._result(future, piece, pieces, held)
            del future
            if monotonic() - self._counted > COUNT:
                self._look(pieces)
            return None if piece is None or result is None else (piece.key, result)

    def _result(self, future: Any, piece: _Piece, pieces: _Pieces, held: Held) -> Done | Failed | None:
        """What a ``piece`` has come to; None: to nothing, and it will be tried again.

        Raises
        ------
        ToolError: a worker is not like this process.
        """
        import asyncio
        from concurrent.futures import wait

        from distributed import CancelledError
        from distributed.scheduler import KilledWorker

        value = self._client.gather(future, asynchronous=True)
        fetched = asyncio.run_coroutine_threadsafe(value, self._client.loop.asyncio_loop)
        end = monotonic() + RECONNECT
        while not fetched.done() and not held.has_signal and monotonic() < end:
            wait([fetched], POLL)
        try:
            if fetched.done():
                done, value = fetched.result()
                return Done(value) if done else Failed(value)
        except KilledWorker as error:
            if piece.alone:
                return Failed(_deadly(error.args[1]))
            pieces.suspects.append(piece)
            return None
        except (CancelledError, OSError):
            pass
        except ImportError as error:
            raise not_there(error) from None
        fetched.cancel()
        pieces.again.append(piece)
        return None

    def _look(self, pieces: _Pieces) -> None:
        """See whether the scheduler and its workers are there.

        What was under way when the scheduler went comes back as cancelled, or never: then it is submitted
        again here.

        Raises
        ------
        ToolError: not within :data:`~robodyn.cluster.limits.RECONNECT`.
        """
        lost = [
            key for key, (future, _) in pieces.under_way.items() if future.status in ("lost", "cancelled")
        ]
        pieces.again.extend(pieces.under_way.pop(key)[1] for key in lost)
        now = monotonic()
        if now - self._counted < COUNT or self._client.status != "running":
            return
        try:
            self.count = len(self._client.nthreads())
        except OSError:  # it is just going: seen to at the next look
            return
        self._counted = now
        if self.count:
            self._deserted = None
        elif self._deserted is None:
            self._deserted = now
            _log.warning("%s has no worker: waiting for one, at most %.0f s", self._name, RECONNECT)
        elif now - self._deserted > RECONNECT:
            raise no_worker(self._name, RECONNECT)

    def _reach(self) -> None:
        """Wait until the scheduler answers again: the client tries for a while, then others do.

        Raises
        ------
        ToolError: not within :data:`~robodyn.cluster.limits.RECONNECT`.
        """
        end = monotonic() + RECONNECT
        if self._client.status != "running":
            _log.warning("%s does not answer: waiting for it, at most %.0f s", self._name, RECONNECT)
        while self._client.status != "running":
            if self._client.status in ("closed", "closing"):
                try:
                    self._client = self._connect()
                except WrongWorker:
                    raise
                except ToolError:
                    if monotonic() > end:
                        raise
            elif monotonic() > end:
                raise no_answer(self._name, RECONNECT)
            else:
                sleep(POLL)


def _deadly(worker: Any) -> ToolError:
    """What to say of a piece with which processes end."""
    return ToolError(
        "the process that works on it ends, time and again",
        found=f"{2 * (DEATHS + 1)} processes lost, the last at {getattr(worker, 'address', worker)}",
        remedy="give workers more memory, or look at their messages for what ends them",
    )


def no_answer(name: str, seconds: float) -> ToolError:
    """The error where a scheduler does not answer."""
    return ToolError(
        f"{name} does not answer",
        expected=f"an answer within {seconds:g} s",
        remedy="start it, or check the address, the firewall, and whether both sides use TLS",
    )


def no_worker(name: str, seconds: float) -> ToolError:
    """The error where a scheduler has no workers."""
    return ToolError(
        f"{name} has no worker",
        expected=f"one within {seconds:g} s",
        remedy="start some: dask worker HOST:PORT --nworkers 4 --nthreads 1",
    )


def not_there(error: ImportError) -> WrongWorker:
    """The error where a worker, or the scheduler, lacks a package."""
    return WrongWorker(
        "the scheduler or a worker cannot import what it needs",
        found=str(error),
        remedy="install the same robodyn, with the extra fleet, wherever one runs",
    )
