"""What a log says of an arm, in a form that adds up: square roots of normal equations, joint by joint.

The torque of a joint is linear in the inertial numbers of the links beyond it and in what its drive adds
(:class:`robodyn.identify.normal.Layout`). Of rows ``A x = tau``, filtered, thinned and weighted by what noise
and correlation leave them worth, the upper triangle ``R`` of a QR decomposition of ``[A tau]`` keeps all that
any least squares over any of the numbers need (Golub and Van Loan 2013, ch. 5); two of them stacked give that
of both. What such columns do not explain is kept as its size, and whether it comes in bursts.

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

from robodyn.diagnose.select.library.context import context_of
from robodyn.errors import InputError
from robodyn.fleet.limits import BURST, FIT_ROUNDS, KNEE, LEAST_BURSTS, LEAST_ROWS, RIDGE, SLOW_SHARE, TURNING
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

Floats = NDArray[np.float64]
#: Digests of another version are not mixed with these.
DIGEST_VERSION: Final = "2"
_MOTION: Final = ("struck", "speed", "acceleration", "torque", "count")


@dataclass(frozen=True, slots=True, eq=False)
class Digest:
    """A log of ``duration`` [s]: by joint the triangle ``roots`` [p_j + 1, p_j + 1] of its weighted columns
    and torque (the columns of ``layout``); RMS of what they leave while the joint moves on (``left`` [n], N m
    or N; nan: not known), by how much that is larger where the load has changed its sign (``bursts`` [n], a
    logarithm; nan: not known) and in how many samples that was (``struck`` [n]); RMS of ``speed`` [n] (rad/s
    or m/s), ``acceleration`` [n] and ``torque`` [n]; how many samples say something of their own (``count``
    [n]; 0: nothing is known of the joint); the ``cutoff`` [Hz] of the filter; ``conditions`` by name that
    were logged."""

    layout: Layout
    duration: float
    roots: tuple[Floats, ...]
    left: Floats
    bursts: Floats
    struck: Floats
    speed: Floats
    acceleration: Floats
    torque: Floats
    count: Floats
    cutoff: float
    conditions: Mapping[str, float]

    def to_bytes(self) -> bytes:
        """A line of JSON and single-precision numbers: the same bytes for the same digest."""
        triangles = [R[np.triu_indices(len(R))] for R in self.roots]
        head = {
            "version": DIGEST_VERSION,
            "joints": self.layout.n,
            "own": self.layout.own,
            "duration": self.duration,
            **{name: _or_none(getattr(self, name)) for name in ("left", "bursts")},
            **{name: getattr(self, name).tolist() for name in _MOTION},
            "cutoff": self.cutoff,
            "conditions": dict(sorted(self.conditions.items())),
        }
        numbers = np.concatenate(triangles).astype("<f4")
        return json.dumps(head).encode() + b"\n" + numbers.tobytes()

    @classmethod
    def from_bytes(cls, data: bytes) -> Digest:
        """What :meth:`to_bytes` wrote."""
        line, _, rest = data.partition(b"\n")
        head = json.loads(line)
        layout = Layout(head["joints"], tuple(head["own"]))
        numbers = np.frombuffer(rest, "<f4").astype(np.float64)
        roots, at = [], 0
        for j in range(layout.n):
            size = len(layout.columns(j)) + 1
            R = np.zeros((size, size))
            entries = size * (size + 1) // 2
            R[np.triu_indices(size)] = numbers[at : at + entries]
            roots.append(R)
            at += entries
        more: dict[str, Any] = {
            name: np.array(head[name], np.float64) for name in ("left", "bursts", *_MOTION)
        }
        more |= {name: head[name] for name in ("duration", "cutoff", "conditions")}
        return cls(layout=layout, roots=tuple(roots), **more)


def digest_of(arm: ArmType, pieces: Iterable[Log], conditions: Mapping[str, float] | None = None) -> Digest:
    """The digest of a log of ``arm`` that comes in ``pieces``, in memory for one of them.

    Raises
    ------
    InputError: the log cannot be used, or the description cannot be read.
    """
    robot, model = _described(arm.text, arm.spec)
    layout = layout_of(robot.n, rotors=robot.torque_side == "motor", offsets=True)
    sums = _Sums(layout)
    for piece in pieces:
        gate = inspect(piece, robot, is_one_of_many=True)
        for signals, rows in _segments(robot, gate):
            left = sums.add(model, rows)
            sums.bursts += squares_on_the_way(model, signals, rows, left)
        sums.duration += float(piece.t[-1] - piece.t[0])
    return sums.digest(conditions or {})


@lru_cache(maxsize=16)
def _described(text: str, spec: str) -> tuple[Robot, Model]:
    robot = read_text(text, spec, warn=lambda _: None)
    return robot, Model(bare(robot))


def _segments(robot: Robot, gate: Gate) -> Iterator[tuple[Signals, Rows]]:
    """Signals and rows of each even part of a log that says something."""
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
        self.layout, self.duration = layout, 0.0
        self.roots = [np.zeros((0, len(layout.columns(j)) + 1)) for j in range(n)]
        self.rows, self.count = np.zeros(n), np.zeros(n)
        self.motion = np.zeros((3, n))
        self.cutoff = 0.0
        self.bursts = np.zeros((n, 2, 2))

    def add(self, model: Model, rows: Rows) -> list[Floats | None]:
        """Rows of a piece; what is left [M] of each joint's torque."""
        residuals: list[Floats | None] = [None] * self.layout.n
        columns = columns_of(model.arm, self.layout, rows, slice(None))
        band = max(1.0, 0.5 / (rows.cutoff * rows.step))
        for j, A in enumerate(columns):
            used = rows.used[:, j].astype(np.float64)
            if used.sum() < LEAST_ROWS:
                continue
            weight, left, rank = _robust(A, rows.tau[:, j], used)
            alike = max(band, float(likeness([(left * np.sqrt(weight))[:, None]], 1)[0]))
            squares = float(weight @ left**2)
            worth = float(weight.sum()) / alike - rank  # samples beyond those that numbers take
            if worth < LEAST_ROWS:
                continue
            variance = max(squares / float(weight.sum()) * (worth + rank) / worth, 1e-300)
            scaled = np.vstack([A, rows.tau[:, j]]) * np.sqrt(weight / (variance * alike))
            residuals[j] = left
            self.roots[j] = _triangle(np.vstack([self.roots[j], scaled.T]))
            self.rows[j] += float(used.sum())
            self.count[j] += float(weight.sum()) / alike
            self.motion[:, j] += [float(used @ x[:, j] ** 2) for x in (rows.qd, rows.qdd, rows.tau)]
        self.cutoff = max(self.cutoff, rows.cutoff)
        return residuals

    def digest(self, conditions: Mapping[str, float]) -> Digest:
        """What has been added.

        Raises
        ------
        InputError: nothing has.
        """
        if not self.rows.any():
            raise InputError(
                "the log has no motion that is long enough",
                expected=f"pieces of more than {LEAST_ROWS} samples of what moves",
                remedy="record a longer motion",
            )
        count = np.maximum(self.rows, 1e-300)
        roots = []
        for R in self.roots:
            square = np.zeros((R.shape[1], R.shape[1]))
            square[: len(R)] = R
            roots.append(square)
        speed, acceleration, torque = np.sqrt(self.motion / count)
        return Digest(
            self.layout, self.duration, tuple(roots), left_of(self.bursts), excess(self.bursts),
            self.bursts[:, 0, 1], speed, acceleration, torque, self.count, self.cutoff, conditions,
        )  # fmt: skip


def _or_none(values: Floats) -> list[float | None]:
    return [x if np.isfinite(x) else None for x in values.tolist()]


def _triangle(A: Floats) -> Floats:
    """``R`` of ``A = Q R``."""
    R: Floats = np.linalg.qr(A, mode="r")  # type: ignore[assignment]  # an array in this mode
    return R


def _robust(A: Floats, tau: Floats, used: Floats) -> tuple[Floats, Floats, int]:
    """Of rows ``A.T x = tau`` with weights ``used`` [M]: weights [M] by Huber's function of what least
    squares leave, that itself [M], and the rank of the columns."""
    weight, left, rank = used, tau, 0
    for k in range(FIT_ROUNDS):
        gram = (A * weight) @ A.T
        size = np.sqrt(np.maximum(np.diag(gram), 1e-300))
        values, vectors = np.linalg.eigh(gram / np.outer(size, size))
        independent = values > RIDGE * values[-1]
        basis = vectors[:, independent] / np.sqrt(values[independent]) / size[:, None]
        left = tau - (basis @ (basis.T @ (A @ (weight * tau)))) @ A
        rank = int(independent.sum())
        if k < FIT_ROUNDS - 1:
            rms = float(np.sqrt(weight @ left**2 / weight.sum()))
            weight = used * np.minimum(1.0, KNEE * rms / np.maximum(np.abs(left), 1e-300))
    return weight, left, rank


# --- after the load has changed sign ----------------------------------------------------------------------
# Where a joint turns round, its friction does what no column says. Elsewhere little is left, and a joint with
# play shows: it passes its load from one flank of the teeth to the other where the load changes sign, and the
# link strikes (Nordin and Gutman 2002); friction, springs and sensors know nothing of the load's sign.


def squares_on_the_way(model: Model, signals: Signals, rows: Rows, left: list[Floats | None]) -> Floats:
    """Of what is ``left`` [M] of each joint's torque (None: nothing was fitted) the sum of squares and the
    number of samples, shortly after the load of the joint has changed its sign and otherwise, where the joint
    does not turn round: [n, 2, 2]."""
    context = context_of(model, signals)
    loads = signals.thinned(signals.filtered(context.at.passed))
    sums = np.zeros((model.robot.n, 2, 2))
    for j, each in enumerate(left):
        if each is None:
            continue
        speed = np.abs(rows.qd[:, j])
        turns = np.diff(np.signbit(rows.qd[:, j]))
        moves_on = speed > SLOW_SHARE * np.sqrt(np.mean(speed**2))
        reach = round(TURNING / rows.step)
        moves_on &= ~_near(turns, reach, reach)
        struck = _near(np.diff(np.signbit(loads[:, j])), 0, max(1, round(BURST / rows.step)))
        for k, which in enumerate((moves_on & struck, moves_on & ~struck)):
            sums[j, k] = float(each[which] @ each[which]), float(which.sum())
    return sums


def _near(events: NDArray[np.bool_], before: int, after: int) -> NDArray[np.bool_]:
    """Which samples [M] are within so many of an event between two of them [M - 1]."""
    near = np.zeros(len(events) + 1, dtype=bool)
    for k in np.flatnonzero(events).tolist():
        near[max(0, k - before) : k + after + 1] = True
    return near


def left_of(sums: Floats) -> Floats:
    """By joint [n] the RMS of what is left; nan where there were too few samples."""
    squares, count = sums[:, :, 0].sum(axis=1), sums[:, :, 1].sum(axis=1)
    return np.where(count >= LEAST_BURSTS, np.sqrt(squares / np.maximum(count, 1)), np.nan)


def excess(sums: Floats) -> Floats:
    """By joint [n] how many times larger, as a logarithm, the RMS is after reversals of the load than
    otherwise; nan where there were too few of either."""
    with np.errstate(all="ignore"):
        squares = sums[:, :, 0] / sums[:, :, 1]
        ratio = 0.5 * np.log(squares[:, 0] / squares[:, 1])
    return np.where(np.isfinite(ratio) & (sums[:, :, 1].min(axis=1) >= LEAST_BURSTS), ratio, np.nan)
