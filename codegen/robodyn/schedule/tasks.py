"""The 43 three-flop tasks that one link of the modified Newton-Euler recursion is cut into.

Source: Dhanaraj 1990, Table 4.1, with its slips mended: T10 and T11 by Eq 2.27 (x and z of T10 are printed
the wrong way round), T4 and T5 after T6 of the link before, T20 to T22 with the centre of mass, T41 to T43
after T33 to T40. It is meant for arms whose angles alpha are multiples of 90 degrees: then two components of
a turned vector take three flops each, and the third is there already. What each task computes, in one line:
:mod:`robodyn.schedule.arithmetic` does it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

FLOPS_PER_TASK: Final = 3

#: The link of a predecessor, seen from the task's own: the one before it, its own, the one after it.
Place = Literal[-1, 0, 1]


@dataclass(frozen=True, slots=True)
class Task:
    """A task of Table 4.1.

    ``after``: the tasks whose results it needs, ``(place, row)``. ``layer``: its layer among those of its
    own link, 1 to 6 in the forward pass, 1 to 3 in the backward pass.
    """

    row: int
    step: str
    forward: bool
    layer: int
    does: str
    after: tuple[tuple[Place, int], ...]


#: Step, layer, words, and the tasks that are waited for, by their place.
_Row = tuple[str, int, str, dict[Place, tuple[int, ...]]]
_LAMBDA = (9, 10, 11)
_MOMENT = (27, 28, 29, *range(33, 41))

_ROWS: Final[tuple[_Row, ...]] = (
    ("1", 1, "w' = R^T w of the link before, x", {-1: (1, 2, 3)}),
    ("1", 1, "w', y", {-1: (1, 2, 3)}),
    ("1, 2", 2, "w_z = w'_z + qd; c = (qd w_y, -qd w_x, qdd)", {0: (1, 2)}),
    ("2", 2, "alpha' = R^T alpha of the link before, x", {-1: (6,)}),
    ("2", 2, "alpha', y", {-1: (6,)}),
    ("2", 3, "alpha = alpha' + c", {0: (3, 4, 5)}),
    ("2A", 3, "k = (w_y w_z, w_z w_x, w_x w_y)", {0: (1, 2, 3)}),
    ("2A", 3, "w_x^2, w_y^2, w_z^2", {0: (1, 2, 3)}),
    ("2A", 4, "lambda_11, lambda_22, lambda_33 = -(sums of two squares)", {0: (8,)}),
    ("2A", 4, "lambda_21, lambda_13, lambda_32 = k + alpha, z, y, x", {0: (6, 7)}),
    ("2A", 4, "lambda_12, lambda_31, lambda_23 = k - alpha, z, y, x", {0: (6, 7)}),
    ("3", 3, "products of lambda p of the link before, x", {-1: _LAMBDA}),
    ("3", 3, "products of lambda p of the link before, y", {-1: _LAMBDA}),
    ("3", 3, "products of lambda p of the link before, z", {-1: _LAMBDA}),
    ("3", 4, "a'' = a of the link before + its lambda p, x", {-1: (18, 19), 0: (12, 13, 14)}),
    ("3", 4, "a'', y", {-1: (18, 19), 0: (12, 13, 14)}),
    ("3", 4, "a'', z", {-1: (18, 19), 0: (12, 13, 14)}),
    ("3", 5, "a = R^T a'', x", {0: (15, 16, 17)}),
    ("3", 5, "a, y", {0: (15, 16, 17)}),
    ("4", 5, "products of lambda s, x", {0: _LAMBDA}),
    ("4", 5, "products of lambda s, y", {0: _LAMBDA}),
    ("4", 5, "products of lambda s, z", {0: _LAMBDA}),
    ("4", 6, "a_c = a + lambda s, x", {0: (18, 19, 20, 21, 22)}),
    ("4", 6, "a_c, y", {0: (18, 19, 20, 21, 22)}),
    ("4", 6, "a_c, z", {0: (18, 19, 20, 21, 22)}),
    ("5", 1, "F = m a_c", {0: (23, 24, 25)}),
    ("6", 1, "N = I alpha + D k, x", {0: (6, 7)}),
    ("6", 1, "N, y", {0: (6, 7)}),
    ("6", 1, "N, z", {0: (6, 7)}),
    ("7", 1, "f' = R f of the link beyond, one of two components", {1: (32,)}),
    ("7", 1, "f', the other", {1: (32,)}),
    ("7", 2, "f = F + f'", {0: (26, 30, 31)}),
    ("8", 2, "p x f', x", {0: (30, 31)}),
    ("8", 2, "p x f', y", {0: (30, 31)}),
    ("8", 2, "p x f', z", {0: (30, 31)}),
    ("8", 2, "s x F, x", {0: (26,)}),
    ("8", 2, "s x F, y", {0: (26,)}),
    ("8", 2, "s x F, z", {0: (26,)}),
    ("8", 2, "n' = R n of the link beyond, one of two components", {1: (41, 42, 43)}),
    ("8", 2, "n', the other", {1: (41, 42, 43)}),
    ("8", 3, "n = N + p x f' + s x F + n', x", {0: _MOMENT}),
    ("8", 3, "n, y", {0: _MOMENT}),
    ("8", 3, "n, z", {0: _MOMENT}),
)

TASKS: Final[tuple[Task, ...]] = tuple(
    Task(row, step, row <= 25, layer, does, tuple((place, k) for place in after for k in after[place]))
    for row, (step, layer, does, after) in enumerate(_ROWS, 1)
)
"""Table 4.1, ``TASKS[row - 1]``: the forward pass, then from 26 on the backward pass."""
