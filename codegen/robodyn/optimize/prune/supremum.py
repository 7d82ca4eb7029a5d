"""The largest value of a sum of sizes of trigonometric polynomials: found from below, proven from above.

For ``F(q) = sum_m |P_m(q)|``: if F is largest at q*, then ``F(q* + u) >= F(q*) cos(max_k |k.u|)`` as long as
that angle is below pi/2, with k the waves in the P_m. (Choosing the phase of every P_m at q* makes one real
sum of waves p <= F with p(q*) = F(q*); along a line it is of exponential type max |k.u|, and so nowhere below
that cosine: Duffin and Schaeffer 1938.) So a cell whose centre is lower than that cannot hold the largest
value, and what is left after halving the cells again and again is as close a bound as one likes.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: Cells to a wave of the highest degree, in the first level.
_FINE = 6
#: Share of all terms that may be bounded by their sizes, if that saves an angle.
_SMALL = 0.01
#: Share of all terms under which a polynomial is bounded by their sizes.
_WEAK = 2e-4
#: Numbers computed in one level of a proof, at most.
_WORK = 60_000_000
#: Size of a product of matrices: larger ones OpenBLAS gives to all processors, at a loss.
_AT_ONCE = 250_000
#: Rounding of a sum of waves, as a share of the sum of their sizes: far above what it is.
_ROUND = 1e-11

#: Terms of F: c by (k, m).
Terms = dict[tuple[tuple[int, ...], int], complex]


@dataclass(frozen=True, slots=True)
class Waves:
    """``F(q) = sum_m |Re sum_k a_mk exp(i k.q)| + sum_m |sum_k b_mk exp(i k.q)| + rest``.

    ``index`` [K, D] are the distinct k; ``real`` [M, K] and ``other`` [L, K] the complex factors; ``size`` is
    a bound of F.
    """

    index: Floats
    real: Any
    other: Any
    degree: tuple[int, ...]
    rest: float
    size: float

    @property
    def constant(self) -> bool:
        """Whether F is the same everywhere."""
        return not self.index.size

    @property
    def work(self) -> int:
        """Numbers computed for one state."""
        return int(self.index.shape[0] * (len(self.real) + len(self.other)))

    def at(self, q: Floats) -> Floats:
        """F at angles ``q`` [D, N]."""
        import numpy as np

        total: Floats = np.empty(q.shape[1])
        (a, b), (c, d) = ((m.real.copy(), m.imag.copy()) for m in (self.real, self.other))
        step = max(16, min(1024, _AT_ONCE // max(1, self.work)))
        for start in range(0, q.shape[1], step):
            phase = self.index @ q[:, start : start + step]
            cosine, sine = np.cos(phase), np.sin(phase)
            part = np.abs(a @ cosine - b @ sine).sum(axis=0)
            if len(c):
                part += np.sqrt((c @ cosine - d @ sine) ** 2 + (c @ sine + d @ cosine) ** 2).sum(axis=0)
            total[start : start + step] = part
        return total + self.rest


def waves_of(terms: Terms, angles: int) -> Waves:
    """F of ``terms``, which come in pairs: c at (k, m) and its conjugate at (-k, m).

    Of the angles the ``angles`` that matter most are kept; a term in others is a polynomial of its own, as
    large everywhere in those.
    """
    import numpy as np

    size = math.fsum(map(abs, terms.values()))
    count = len(next(iter(terms))[0]) if terms else 0
    weight = [math.fsum(abs(c) for (k, _), c in terms.items() if k[i]) for i in range(count)]
    chosen = sorted(range(count), key=lambda i: (-weight[i], i))[:angles]
    chosen = sorted(i for i in chosen if weight[i] > _SMALL * size)
    others = [i for i in range(count) if i not in chosen]
    none = (0,) * len(others)
    groups: dict[bool, dict[Any, dict[tuple[int, ...], complex]]] = {True: {}, False: {}}
    for (k, m), c in terms.items():
        first = next((x for x in k if x), 0)
        if first < 0:
            continue  # the other of its pair stands for both
        beside = tuple(k[i] for i in others)
        group = groups[beside == none].setdefault((m, beside), {})
        column = tuple(k[i] for i in chosen)
        group[column] = group.get(column, 0) + (2 * c if first else c)
    rest = 0.0
    index: dict[tuple[int, ...], int] = {}
    for real, family in groups.items():
        for name in list(family):
            group = family[name]
            weak = math.fsum(map(abs, group.values())) < _WEAK * size
            if weak or (len(group) == 1 and not (real and any(next(iter(group))))):  # as large everywhere
                rest += math.fsum(map(abs, group.values()))
                del family[name]
            else:
                for column in group:
                    index.setdefault(column, len(index))
    matrices = []
    for real in (True, False):
        matrix = np.zeros((len(groups[real]), len(index)), dtype=complex)
        for row, group in enumerate(groups[real].values()):
            for column, c in group.items():
                matrix[row, index[column]] = c
        matrices.append(matrix)
    k_of = np.array(list(index), dtype=float).reshape(len(index), len(chosen))
    degree = tuple(int(d) for d in np.abs(k_of).max(axis=0)) if len(k_of) else (0,) * len(chosen)
    return Waves(k_of, matrices[0], matrices[1], degree, rest + _ROUND * size, size)


def _cells(waves: Waves) -> tuple[Floats, list[float]]:
    """The centres of the first cells [D, N] and their half widths."""
    import numpy as np

    counts = [max(1, _FINE * d) for d in waves.degree]
    axes = [2 * math.pi * np.arange(n) / n for n in counts]
    grid = np.meshgrid(*axes, indexing="ij")
    return np.array([g.ravel() for g in grid]), [math.pi / n for n in counts]


def _share(waves: Waves, half: list[float]) -> float:
    """How much of the largest value the centre of its cell has at least."""
    import numpy as np

    turn = float((np.abs(waves.index) @ np.array(half)).max()) * (1 + 1e-12)
    return math.cos(turn) * (1 - 1e-12) if turn < math.pi / 2 else 0.0


def _halved(centres: Floats, half: list[float], degree: tuple[int, ...]) -> tuple[Floats, list[float]]:
    import numpy as np

    for i, d in enumerate(degree):
        if d:
            step = np.zeros((len(half), 1))
            step[i] = half[i] / 2
            centres = np.concatenate([centres - step, centres + step], axis=1)
    return centres, [h / 2 if d else h for h, d in zip(half, degree, strict=True)]


def proven(waves: Waves, threshold: float = 0.0, work: int = _WORK, close: float = 1.01) -> float:
    """An upper bound of the largest F: as close as ``work`` allows, or at most ``threshold``.

    Where F is found to be above ``threshold`` the bound is no longer made close.
    """
    if waves.constant:
        return waves.rest
    centres, half = _cells(waves)
    best, bound = 0.0, waves.size
    while centres.shape[1] * waves.work <= work:
        values = waves.at(centres)
        best = max(best, float(values.max()))
        share = _share(waves, half)
        # Of F - rest the share holds, and F - rest >= share * (S - rest).
        if share > 0:
            bound = min(bound, (float(values.max()) - waves.rest) / share + waves.rest)
        if bound <= threshold or best > threshold > 0 or bound <= best * close:
            break
        kept = values - waves.rest >= (best - waves.rest) * share * (1 - 1e-9) - _ROUND * waves.size
        centres, half = _halved(centres[:, kept], half, waves.degree)
    return bound * (1 + 1e-12)
