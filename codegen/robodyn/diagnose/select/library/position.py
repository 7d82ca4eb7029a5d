"""What depends on position or acceleration alone: rotors, springs, ripple."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.library.candidate import Candidate, Context, single, site

Floats = NDArray[np.float64]


def conservative(c: Context, j: int) -> Iterator[Candidate]:
    """What a joint stores and gives back, or what repeats with its position."""
    at = site(c, j)
    one = np.ones_like(at.q)
    yield single("rotor_inertia", j, [at.qdd], (1,), lambda x: {"inertia": float(x[0])}, 1)
    middle = float(np.mean(at.q))

    def read(x: Floats) -> dict[str, float | str]:
        rest = middle - float(x[1] / x[0]) if x[0] else 0.0
        return {"stiffness": float(x[0]), "rest": rest, "cubic": 0.0}

    yield single("spring", j, [at.q - middle, one], (0, 0), read, 3)
    for cycles in c.hints.cycles[j]:
        yield ripple(c, j, {"cycles": cycles})


def ripple(c: Context, j: int, given: Mapping[str, float]) -> Candidate:
    """A wave over the position, of the ``cycles`` a radian given."""
    cycles, q = given["cycles"], c.signals.q[:, j]

    def read(x: Floats) -> dict[str, float | str]:
        return {
            "amplitude": float(np.hypot(x[0], x[1])),
            "cycles_per_rev": cycles,
            "phase": float(np.arctan2(x[1], x[0])),
        }

    return single(
        "torque_ripple", j, [np.sin(cycles * q), np.cos(cycles * q)], (0, 0), read, 4,
        given=given,
    )  # fmt: skip


def cycles_in(c: Context, j: int, count: int = 4) -> list[float]:
    """The numbers of waves a radian that stand out of what the model leaves, over the joint's position."""
    q, s = c.signals.q[:, j], c.signals
    rest = s.tau[:, j] - c.at.total[:, j]
    span = float(np.ptp(q))
    if span < 0.2:
        return []
    # Against slow changes over position and over velocity, which are other effects.
    basis = np.stack([np.ones_like(q), q, q**2, q**3, s.qd[:, j], np.sign(s.qd[:, j]), s.qdd[:, j]], axis=1)
    rest = rest - basis @ np.linalg.lstsq(basis, rest, rcond=None)[0]
    lowest = 2.5 * 2 * np.pi / span
    highest = min(400.0, 0.2 * np.pi / s.period / max(float(np.abs(s.qd[:, j]).max()), 1e-9))
    if highest <= lowest:
        return []
    # Sums over small steps of position, and their spectrum.
    step = np.pi / 4 / highest
    bins = ((q - q.min()) / step).astype(int)
    sums = np.bincount(bins, rest)
    size = 1 << int(np.ceil(np.log2(8 * len(sums))))
    power = np.abs(np.fft.rfft(sums, size)) ** 2
    tried = 2 * np.pi * np.arange(len(power)) / (size * step)
    power[(tried < lowest) | (tried > highest)] = 0.0
    found: list[float] = []
    for k in np.argsort(power)[::-1]:
        if all(abs(tried[k] - other) > 4 / span for other in found):
            found.append(float(tried[k]))
        if len(found) == count:
            break
    return found
