"""What the data gate says: flags with the places they are about, and refusals."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NoReturn

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.errors import InputError
from robodyn.gate import limits
from robodyn.robot.model import Robot

Rows = NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class Span:
    """Rows ``first`` to ``last`` of a log, counted from 1 without the header, ``start`` to ``end`` [s]."""

    first: int
    last: int
    start: float
    end: float

    def __str__(self) -> str:
        if self.first == self.last:
            return f"row {self.first} (t = {self.start:.6g} s)"
        return f"rows {self.first} to {self.last} (t = {self.start:.6g} to {self.end:.6g} s)"


@dataclass(frozen=True, slots=True)
class Flag:
    """Something to know of a log that can be used: ``kind`` is a word for programs, ``where`` the columns,
    ``text`` says it; ``joints`` count from 1, none where it is about all of them."""

    kind: str
    where: str
    spans: tuple[Span, ...]
    text: str
    joints: tuple[int, ...] = ()

    def __str__(self) -> str:
        shown = [str(span) for span in self.spans[:3]]
        more = [f"{len(self.spans) - 3} more"] if len(self.spans) > 3 else []
        return ", ".join([f"{self.where}: {self.text}", *shown, *more])


def spans_of(rows: Sequence[int] | Rows, t: Floats) -> tuple[Span, ...]:
    """The ``rows`` (from 0, rising) of a log with the times ``t`` [K] (s), runs of them as one span."""
    index = np.asarray(rows, dtype=np.intp)
    if not len(index):
        return ()
    cuts = np.flatnonzero(np.diff(index) > 1)[: limits.MOST_SPANS - 1] + 1
    # Beyond the last span that is listed nothing is.
    begins = [0, *cuts.tolist()]
    ends = [*cuts.tolist(), len(index)]
    if len(cuts) == limits.MOST_SPANS - 1:
        later = np.flatnonzero(np.diff(index[cuts[-1] :]) > 1)
        if len(later):
            ends[-1] = int(cuts[-1] + later[0] + 1)
    return tuple(span(int(index[a]), int(index[b - 1]), t) for a, b in zip(begins, ends, strict=True))


def span(first: int, last: int, t: Floats) -> Span:
    """The rows ``first`` to ``last`` (from 0)."""
    return Span(first + 1, last + 1, float(t[first]), float(t[last]))


def refuse(what: str, *, found: str, expected: str, remedy: str) -> NoReturn:
    """Refuse the log; :func:`robodyn.gate.gate.inspect` says which it is.

    Raises
    ------
    InputError: always.
    """
    raise InputError(what, found=found, expected=expected, remedy=remedy)


def named(group: str, joints: Sequence[int]) -> str:
    """The columns of ``group`` of the ``joints`` (from 1): ``q1, q3``."""
    return ", ".join(f"{group}{j}" for j in joints)


def count(amount: int, thing: str = "row") -> str:
    """So many of a ``thing``: ``1 row``, ``2 rows``."""
    return f"{amount} {thing}" if amount == 1 else f"{amount} {thing}s"


def chunks(samples: int) -> Iterator[slice]:
    """``samples`` rows in pieces, so that what is made of one is small beside a log."""
    for start in range(0, samples, limits.CHUNK):
        yield slice(start, min(start + limits.CHUNK, samples))


def long_runs(mask: NDArray[np.bool_], least: int) -> NDArray[np.bool_]:
    """Runs of the ``mask`` [K] of ``least`` samples or more."""
    edges = np.flatnonzero(np.diff(np.r_[0, mask.astype(np.int8), 0]))
    result = np.zeros(len(mask), dtype=bool)
    for a, b in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        result[a:b] = b - a >= least
    return result


def motions(robot: Robot, angle: float) -> Floats:
    """What says as much of each joint [n] as an ``angle`` [rad, per s...] of a revolute one."""
    revolute = [link.joint.kind == "revolute" for link in robot.links]
    return np.where(revolute, angle, limits.LEVER * angle)
