"""Where a residual is: at which joint, over which quantity; and what motion a log went through."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.limits import ABOVE_NOISE
from robodyn.diagnose.result import Diagnosis, Series
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]

#: What a residual may follow, the simplest first.
QUANTITIES: Final = (
    "constant", "direction", "velocity", "position", "acceleration", "load", "load, each way", "a short time",
)  # fmt: skip
#: A quantity that is not as simple must show so much more; below the last figure none shows it.
_MORE, _SHOWS = 0.04, 0.3
_BINS: Final = 16
#: Of the fastest motion: below it a joint counts as standing; it turns where it passes it both ways.
_STILL: Final = 0.02
#: A short time, as a share of the log.
_MOMENT: Final = 1 / 8


@dataclass(frozen=True, slots=True, eq=False)
class Localised:
    """A joint (from 1): its ``share`` of what exceeds the noise, over all joints; ``shown``: how much of its
    own excess a curve over each quantity explains, empty where there is no excess; ``best``: the quantity
    that shows it best, None where none does; ``left``: what is left beside what would matter."""

    joint: int
    share: float
    shown: tuple[float, ...]
    best: str | None
    left: float


def localised(diagnosis: Diagnosis) -> list[Localised]:
    """Every joint, from the first log that was fitted."""
    before, floor = diagnosis.gap.train_before, diagnosis.gap.noise_floor
    with np.errstate(all="ignore"):
        excess = np.nan_to_num(np.maximum((before / floor) ** 2 - 1, 0.0), nan=0.0, posinf=0.0)
    total = float(excess.sum()) or 1.0
    rows = []
    for j in range(diagnosis.robot.n):
        shown: tuple[float, ...] = ()
        if diagnosis.series and len(diagnosis.series[0].times) > 4 * _BINS and excess[j] > ABOVE_NOISE**2 - 1:
            most = float(excess[j] / (excess[j] + 1))
            shown = tuple(min(x / most, 1.0) for x in shown_over(diagnosis.series[0], j))
        left = float(diagnosis.left[j]) if j < len(diagnosis.left) else np.nan
        rows.append(Localised(j + 1, float(excess[j]) / total, shown, best_of(shown), left))
    return rows


def shown_over(series: Series, j: int) -> tuple[float, ...]:
    """Share of the mean square at joint ``j`` (from 0) that a curve over each quantity explains, what is
    constant apart; and that is of a short time."""
    y = series.before[:, j]
    parts = (series.qd, series.q, series.qdd, series.load)
    known = np.isfinite(y) & np.isfinite(series.times)
    for part in parts:
        known &= np.isfinite(part[:, j])
    y = y[known]
    qd, q, qdd, load = (part[known, j] for part in parts)
    energy = float(np.mean(y**2)) if len(y) > 4 * _BINS else 0.0
    if not energy > 0:
        return (0.0,) * len(QUANTITIES)
    way = (qd > 0).astype(np.intp)
    places = [
        way, _place(qd), _place(q), _place(qdd), _place(load), 2 * _place(load) + way,
    ]  # fmt: skip
    steady = float(np.mean(y)) ** 2 / energy
    return (steady, *(_explained(place, y) / energy for place in places), _burst(y))


def _burst(y: Floats) -> float:
    """Share of the energy of ``y`` within the loudest short time, beyond what any has."""
    total = np.concatenate([[0.0], np.cumsum(y**2)])
    wide = max(1, round(_MOMENT * len(y)))
    loudest = float((total[wide:] - total[:-wide]).max() / total[-1])
    return max(0.0, (loudest - _MOMENT) / (1 - _MOMENT))


def _place(x: Floats) -> NDArray[np.intp]:
    """Bins of about as many samples each."""
    edges = np.unique(np.quantile(x, np.linspace(0, 1, _BINS + 1)[1:-1]))
    return np.asarray(np.searchsorted(edges, x, "right"), dtype=np.intp)


def _explained(place: NDArray[np.intp], y: Floats) -> float:
    """Variance of ``y`` that the means of bins explain, less what chance would."""
    count = np.bincount(place)
    mean = np.bincount(place, y) / np.maximum(count, 1)
    used, total = int((count > 0).sum()), float(np.var(y))
    within = float(np.mean((y - mean[place]) ** 2)) * (len(y) - 1) / max(len(y) - used, 1)
    return max(total - within, 0.0)


def best_of(shown: Sequence[float]) -> str | None:
    """The simplest quantity that shows a residual about as well as any."""
    if not shown or max(shown) < _SHOWS:
        return None
    limit = max(shown) - _MORE
    return next(name for name, value in zip(QUANTITIES, shown, strict=True) if value >= limit)


# --- what a log went through ------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Travel:
    """What a joint (from 1) went through: lowest and highest position, its ``limits`` if they are known,
    highest speed, reversals, lowest and highest load."""

    joint: int
    low: float
    high: float
    limits: tuple[float, float] | None
    speed: float
    top: float | None
    reversals: int
    load: tuple[float, float]

    @property
    def wants(self) -> str:
        """What the log lacks at this joint, in words; empty where it lacks nothing."""
        if not self.speed > 0:
            return "does not move"
        if self.reversals < 4:
            return "hardly reverses"
        return "the load keeps its sign" if self.load[0] * self.load[1] > 0 else ""


def travelled(robot: Robot, series: Series) -> list[Travel]:
    """Every joint's travel."""
    rows = []
    for j, link in enumerate(robot.links):
        q, qd, load = (x[:, j][np.isfinite(x[:, j])] for x in (series.q, series.qd, series.load))
        if not (len(q) and len(qd) and len(load)):
            continue
        speed = float(np.abs(qd).max())
        signs = np.sign(qd[np.abs(qd) > _STILL * speed])
        position, top = link.joint.limits.position, link.joint.limits.velocity
        rows.append(
            Travel(
                j + 1, float(q.min()), float(q.max()),
                None if position is None else (float(position[0]), float(position[1])),
                speed, None if top is None else float(top),
                int(np.count_nonzero(np.diff(signs))), (float(load.min()), float(load.max())),
            )
        )  # fmt: skip
    return rows
