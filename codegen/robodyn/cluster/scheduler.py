"""Work that a scheduler of Dask's hands to its workers: nothing is lost, and nothing handed out twice, when
one of them goes."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from queue import Empty, SimpleQueue
from time import monotonic, sleep
from typing import Any, Final

from robodyn.cluster.limits import AHEAD, ATTEMPTS, CONNECT, COUNT, DEATHS, POLL, RECONNECT
from robodyn.cluster.work import Done, Failed, WrongWorker, likeness, work
from robodyn.errors import ToolError

_log = logging.getLogger("robodyn.cluster")
_LOST: Final = ToolError(
    "no result came back",
    found=f"{ATTEMPTS} times, schedulers or workers went before it was fetched",
    remedy="look at the messages of the workers, and run it again",
)
_DEADLY: Final = ToolError(
    "the process that works on it ends, time and again",
    found=f"{2 * (DEATHS + 1)} processes lost",
    remedy="give workers more memory, or look at their messages for what ends them",
)


@dataclass(frozen=True, slots=True)
class _Piece:
    """A piece of work: its ``key`` and ``arguments``; how often it was handed to the scheduler before, and
    whether that was on its own, after processes had ended with it."""

    key: Any
    arguments: tuple[Any, ...]
    attempts: int = 0
    alone: bool = False


class Scheduler:
    """A :class:`~robodyn.cluster.cluster.Cluster`: what ``connect`` reaches, a scheduler with workers.

    ``connect`` raises :class:`ToolError` where nothing answers in time; ``name`` is what messages call the
    scheduler.
    """

    def __init__(self, connect: Callable[[], Any], name: str) -> None:
        self._connect, self._name = connect, name
        self._client = connect()
        self._counted = self._peopled = monotonic()
        self.count = len(self._client.nthreads())

    def close(self) -> None:
        """Leave the scheduler."""
        self._client.close(timeout=CONNECT)

    def each(
        self, function: Callable[..., Any], tasks: Iterable[tuple[Any, tuple[Any, ...]]]
    ) -> Iterator[tuple[Any, Done | Failed]]:
        """As of :class:`~robodyn.cluster.cluster.Cluster`."""
        waiting = (_Piece(key, arguments) for key, arguments in tasks)
        again, suspects = deque[_Piece](), deque[_Piece]()  # these for when nothing else is under way
        under_way: dict[str, tuple[Any, _Piece]] = {}
        ended = SimpleQueue[Any]()
        try:
            while True:
                while len(under_way) < AHEAD * max(self.count, 1):
                    piece = again.popleft() if again else next(waiting, None)
                    if piece is None and suspects and not under_way:
                        piece = replace(suspects.popleft(), alone=True, attempts=0)
                    if piece is None:
                        break
                    if piece.attempts == ATTEMPTS:
                        yield piece.key, Failed(_LOST)
                        continue
                    future = self._submit(function, piece)
                    under_way[future.key] = future, replace(piece, attempts=piece.attempts + 1)
                    future.add_done_callback(ended.put)
                if not under_way:
                    return
                try:
                    future = ended.get(timeout=POLL)
                except Empty:
                    future = None
                if future is not None and future.key in under_way:
                    _, piece = under_way.pop(future.key)
                    result = self._result(future, piece, again, suspects)
                    if result is not None:
                        yield piece.key, result
                self._look()
                # What was under way when a scheduler went comes back as cancelled, or never.
                lost = [key for key, (one, _) in under_way.items() if one.status in ("lost", "cancelled")]
                again.extend(under_way.pop(key)[1] for key in lost)
        finally:
            futures = [future for future, _ in under_way.values()]
            if futures and self._client.status == "running":
                self._client.cancel(futures, force=True)

    def _submit(self, function: Callable[..., Any], piece: _Piece) -> Any:
        """Have the scheduler hand ``piece`` to a worker."""
        try:
            return self._client.submit(work, likeness(), function, piece.arguments, pure=False)
        except (OSError, RuntimeError):  # the connection is just being lost
            self._look()
            return self._client.submit(work, likeness(), function, piece.arguments, pure=False)

    def _result(
        self, future: Any, piece: _Piece, again: deque[_Piece], suspects: deque[_Piece]
    ) -> Done | Failed | None:
        """What a ``piece`` has come to; None: to nothing, and it will be tried again.

        Raises
        ------
        ToolError: a worker is not like this process.
        """
        from distributed import CancelledError
        from distributed.scheduler import KilledWorker

        try:
            result: Done | Failed = future.result(timeout=RECONNECT)
        except KilledWorker:
            if piece.alone:
                return Failed(_DEADLY)
            suspects.append(piece)
            return None
        except (CancelledError, TimeoutError, OSError):
            again.append(piece)
            return None
        except ImportError as error:
            raise WrongWorker(
                "a worker cannot import what it needs",
                found=str(error),
                remedy="install the same robodyn, with the extra fleet, wherever one runs",
            ) from None
        return result

    def _look(self) -> None:
        """Wait until the scheduler answers (the client tries for a while, then others do), and see how many
        workers it has.

        Raises
        ------
        ToolError: there is none of them within :data:`~robodyn.cluster.limits.RECONNECT`.
        """
        end, waiting = monotonic() + RECONNECT, "%s %s: waiting for it, at most %.0f s"
        if self._client.status != "running":
            _log.warning(waiting, self._name, "does not answer", RECONNECT)
        while self._client.status != "running":
            if self._client.status in ("closed", "closing"):
                try:
                    self._client = self._connect()
                except ToolError:
                    if monotonic() > end:
                        raise
            elif monotonic() > end:
                raise no_answer(self._name, RECONNECT)
            else:
                sleep(POLL)
        now = monotonic()
        if now - self._counted < COUNT:
            return
        try:
            before, self.count = self.count, len(self._client.nthreads())
        except OSError:  # it is just going: seen to at the next look
            return
        self._counted = now
        if self.count:
            self._peopled = now
        elif before:
            _log.warning(waiting, self._name, "has no worker", RECONNECT)
        elif now - self._peopled > RECONNECT:
            raise no_worker(self._name, RECONNECT)


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
