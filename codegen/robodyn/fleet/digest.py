"""What a log says of an arm, in a form that adds up: square roots of normal equations, joint by joint.

The torque of a joint is linear in the inertial numbers of the links beyond it and in what its drive adds
(:class:`robodyn.identify.normal.Layout`). Of rows ``A x = tau``, filtered and thinned, the upper triangle
``R`` of a QR decomposition of ``[A tau]`` keeps all that any least squares over any of the numbers need
(Golub and Van Loan 2013, ch. 5); two of them stacked give that of both.

Only samples in which the joint moves count: at rest dry friction is a set and no value (Karnopp 1985), and a
few seconds at rest would outweigh a minute of motion. Which program the arm ran is told by its path alone:
the cells of a grid in joint space that it goes through.

A log's digest depends on nothing but its bytes and the description of its type: it is worked out once.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.diagnose.select.library.context import context_of
from robodyn.errors import InputError
from robodyn.fleet.limits import AFTER_TURN, CELL, LEAST_ROWS, MOST_CELLS, MOVES, RIDGE
from robodyn.fleet.sources.fleet import ArmType
from robodyn.gate.gate import Gate, inspect
from robodyn.identify.intervals import likeness
from robodyn.identify.normal import Layout, columns_of, layout_of
from robodyn.identify.predict import offsets
from robodyn.identify.rows import Rows, bare, rows_of
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.logs.signals import Signals, signals_of
from robodyn.robot.model import Robot
from robodyn.robot.reader import read_text

#: Digests of another version are not mixed with these.
DIGEST_VERSION: Final = "3"
_BY_JOINT: Final = ("rows", "alike", "bursts", "struck", "speed", "acceleration", "torque")


@dataclass(frozen=True, slots=True, eq=False)
class Digest:
    """A log of ``duration`` [s] with a sample each ``period`` [s].

    By joint: the triangle ``roots`` [p_j + 1, p_j + 1] of its columns (those of the ``layout``) and torque;
    how many samples move (``rows`` [n]) and how many of them say the same (``alike`` [n], at least 1); by how
    much more of the torque is left after the load has changed sign (``bursts`` [n], a logarithm; nan: not
    known), in how many samples that was (``struck`` [n]); RMS ``speed`` [n] (rad/s or m/s), ``acceleration``
    [n] and ``torque`` [n] of what moves. ``path`` [m, n]: a point in each cell of a grid of the size ``cell``
    (rad or m) that the arm went through; ``conditions`` by name that were logged."""

    layout: Layout
    duration: float
    period: float
    roots: tuple[Floats, ...]
    rows: Floats
    alike: Floats
    bursts: Floats
    struck: Floats
    speed: Floats
    acceleration: Floats
    torque: Floats
    path: Floats
    cell: float
    conditions: Mapping[str, float]

    def to_bytes(self) -> bytes:
        """A line of JSON and single-precision numbers: the same bytes for the same digest."""
        triangles = [R[np.triu_indices(len(R))] for R in self.roots]
        head = {
            "version": DIGEST_VERSION,
            "joints": self.layout.n,
            "own": self.layout.own,
            "duration": self.duration,
            "period": self.period,
            "cell": self.cell,
            **{name: _finite_or_none(getattr(self, name)) for name in _BY_JOINT},
            "conditions": dict(sorted(self.conditions.items())),
        }
        numbers = np.concatenate([*triangles, self.path.ravel()]).astype("<f4")
        return json.dumps(head).encode() + b"\n" + numbers.tobytes()

    @classmethod
    def from_bytes(cls, data: bytes) -> Digest:
        """The digest that :meth:`to_bytes` wrote."""
        line, _, rest = data.partition(b"\n")
        head = json.loads(line)
        layout = Layout(head["joints"], tuple(head["own"]))
        numbers = np.frombuffer(rest, "<f4").astype(np.float64)
        roots, place = [], 0
        for j in range(layout.n):
            size = len(layout.columns(j)) + 1
            R = np.zeros((size, size))
            entries = size * (size + 1) // 2
            R[np.triu_indices(size)] = numbers[place : place + entries]
            roots.append(R)
            place += entries
        by_joint: dict[str, Any] = {name: np.array(head[name], np.float64) for name in _BY_JOINT}
        others: dict[str, Any] = {name: head[name] for name in ("duration", "period", "cell", "conditions")}
        path = numbers[place:].reshape(-1, layout.n)
        return cls(layout=layout, roots=tuple(roots), path=path, **by_joint, **others)


def digest_of(arm: ArmType, pieces: Iterable[Log], conditions: Mapping[str, float] | None = None) -> Digest:
    """The digest of a log of ``arm`` that comes in ``pieces``, in memory for one of them.

    Raises
    ------
    InputError: the log cannot be used, or the description cannot be read.
    """
    robot, model = _read_description(arm.text, arm.spec)
    sums = _Sums(layout_of(robot.n, rotors=robot.torque_side == "motor", offsets=True))
    for piece in pieces:
        gate = inspect(piece, robot, is_one_of_many=True)
        for signals, rows in _segments(robot, gate):
            sums.add(model, signals, rows)
        sums.duration += float(piece.t[-1] - piece.t[0])
        sums.samples += piece.samples - 1
    return sums.digest(conditions or {})


@lru_cache(maxsize=16)
def _read_description(text: str, spec: str) -> tuple[Robot, Model]:
    robot = read_text(text, spec, warn=lambda _: None)
    return robot, Model(bare(robot))


def _segments(robot: Robot, gate: Gate) -> Iterator[tuple[Signals, Rows]]:
    """Signals and rows of each even part of a log that is long enough."""
    rest = iter(rows_of(robot, gate, 0))
    for part in gate.segments:
        log = gate.log
        signals = signals_of(Log(log.t[part], log.q[part] - offsets(robot), None, None, log.tau[part]))
        if not len(signals.thinned(signals.t)):
            continue
        rows = next(rest)
        if len(rows.q) >= LEAST_ROWS:
            yield signals, rows


class _Sums:
    """The digest of a log in the making."""

    def __init__(self, layout: Layout) -> None:
        n = layout.n
        self.layout, self.duration, self.samples = layout, 0.0, 0
        self.roots = [np.zeros((0, len(layout.columns(j)) + 1)) for j in range(n)]
        self.rows, self.alike, self.motion = np.zeros(n), np.zeros(n), np.zeros((3, n))
        self.bursts = np.zeros((n, 2, 2))  # after reversals of the load and otherwise: squares, samples
        self.path, self.cell = np.zeros((0, n)), CELL

    def add(self, model: Model, signals: Signals, rows: Rows) -> None:
        """Add the rows of a segment."""
        loads = signals.thinned(signals.filtered(context_of(model, signals).at.passed))
        columns = columns_of(model.arm, self.layout, rows, slice(None))
        band = max(1.0, 0.5 / (rows.cutoff * rows.step))
        for j, A in enumerate(columns):
            moves = rows.used[:, j] & moving(rows.qd[:, j], float(rows.signals.speed_noise[j]))
            count = int(moves.sum())
            if count < LEAST_ROWS + len(A):
                continue
            root = _triangle(np.vstack([A, rows.tau[:, j]])[:, moves].T)
            left = np.where(moves, rows.tau[:, j] - _fitted(root) @ A, 0.0)
            self.roots[j] = _triangle(np.vstack([self.roots[j], root]))
            self.rows[j] += count
            self.alike[j] += count * max(band, float(likeness([left[moves][:, None]], 1)[0]))
            self.motion[:, j] += [float(moves @ x[:, j] ** 2) for x in (rows.qd, rows.qdd, rows.tau)]
            self.bursts[j] += _squares_by_load(left, moves, rows.qd[:, j], loads[:, j], rows.step)
        self.path, self.cell = _cells(np.vstack([self.path, rows.q]), self.cell)

    def digest(self, conditions: Mapping[str, float]) -> Digest:
        """The digest of all that was added.

        Raises
        ------
        InputError: no joint moved.
        """
        if not self.rows.any():
            raise InputError(
                "the log has no motion that is long enough",
                expected=f"pieces of more than {LEAST_ROWS} samples of what moves",
                remedy="record a longer motion",
            )
        roots = []
        for R in self.roots:
            square = np.zeros((R.shape[1], R.shape[1]))
            square[: len(R)] = R
            roots.append(square)
        count = np.maximum(self.rows, 1)
        speed, acceleration, torque = np.sqrt(self.motion / count)
        with np.errstate(all="ignore"):
            squares = self.bursts[:, :, 0] / self.bursts[:, :, 1]
            bursts = 0.5 * np.log(squares[:, 0] / squares[:, 1])
        known = np.isfinite(bursts) & (self.bursts[:, :, 1].min(axis=1) >= LEAST_ROWS // 2)
        return Digest(
            self.layout, self.duration, self.duration / max(self.samples, 1), tuple(roots), self.rows,
            np.maximum(self.alike / count, 1.0), np.where(known, bursts, np.nan), self.bursts[:, 0, 1],
            speed, acceleration, torque, self.path, self.cell, conditions,
        )  # fmt: skip


def _finite_or_none(values: Floats) -> list[float | None]:
    return [x if np.isfinite(x) else None for x in values.tolist()]


def moving(speed: Floats, noise: float) -> NDArray[np.bool_]:
    """Which samples [M] of a joint's ``speed`` (rad/s or m/s) move: faster than a share of its RMS speed, and
    than the encoder's ``noise`` lets rest be told from motion."""
    return np.asarray(np.abs(speed) > max(MOVES * float(np.sqrt(np.mean(speed**2))), 3 * noise))


def _triangle(A: Floats) -> Floats:
    """``R`` of ``A = Q R``."""
    R: Floats = np.linalg.qr(A, mode="r")  # type: ignore[assignment]  # an array in this mode
    return R


def _fitted(root: Floats) -> Floats:
    """The least squares of a triangle [p + 1, p + 1] of columns and torque: the shortest of them [p], columns
    in units of their own size."""
    size = np.maximum(np.sqrt((root[:, :-1] ** 2).sum(axis=0)), 1e-300)
    return np.asarray(np.linalg.lstsq(root[:, :-1] / size, root[:, -1], rcond=RIDGE)[0] / size)


def _cells(points: Floats, cell: float) -> tuple[Floats, float]:
    """A point of those [M, n] in each cell that has any, and the size of cells with which there are not too
    many. It is independent of how long a path is, how fast and how often it is gone through."""
    while True:
        _, first = np.unique(np.round(points / cell).astype(np.int64), axis=0, return_index=True)
        if len(first) <= MOST_CELLS:
            return points[np.sort(first)], cell
        cell *= 1.5


def _squares_by_load(
    left: Floats, moves: NDArray[np.bool_], speed: Floats, load: Floats, step: float
) -> Floats:
    """The sum of squares and the number of samples of what is ``left`` [M] of a joint's torque, shortly after
    its ``load`` [M] has changed sign and otherwise [2, 2].

    A joint with play passes its load from one flank of the teeth to the other where the load changes sign,
    and the link strikes (Nordin and Gutman 2002); friction, springs and sensors know nothing of the load's
    sign. Where the joint turns round, its friction does what no column says: left out."""
    reach = max(1, round(AFTER_TURN / step))
    onward = moves & ~_near(np.diff(np.signbit(speed)), reach, reach)
    struck = _near(np.diff(np.signbit(load)), 0, reach)
    parts = (onward & struck, onward & ~struck)
    return np.array([[float(left[part] @ left[part]), float(part.sum())] for part in parts])


def _near(events: NDArray[np.bool_], before: int, after: int) -> NDArray[np.bool_]:
    """Which samples [M] are within so many of an event between two of them [M - 1]."""
    near = np.zeros(len(events) + 1, dtype=bool)
    for k in np.flatnonzero(events).tolist():
        near[max(0, k - before) : k + after + 1] = True
    return near
