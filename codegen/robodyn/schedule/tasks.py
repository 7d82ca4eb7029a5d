"""The 43 three-flop tasks that one link of the modified Newton-Euler recursion is cut into.

Source: Dhanaraj 1990, Table 4.1, with its slips mended: T10 and T11 by Eq 2.27 (x and z of T10 are printed
the wrong way round), T4 and T5 after T6 of the link before, T20 to T22 with the centre of mass, T41 to T43
after T33 to T40. It is meant for arms whose angles alpha are multiples of 90 degrees: then two components of
a turned vector take three flops each, and the third is there already. What each task computes, in one line:
:mod:`robodyn.schedule.arithmetic` does it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import count
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


_LAMBDA = (9, 10, 11)
_MOMENT = (27, 28, 29, *range(33, 41))
#: Step, layer and the tasks that are waited for, by their place; of each task that has these what it does.
_ROWS: Final[tuple[tuple[str, int, dict[Place, tuple[int, ...]], list[str]], ...]] = (
    ("1", 1, {-1: (1, 2, 3)}, ["w' = R^T w of the link before, x", "w', y"]),
    ("1, 2", 2, {0: (1, 2)}, ["w_z = w'_z + qd; c = (qd w_y, -qd w_x, qdd)"]),
    ("2", 2, {-1: (6,)}, ["alpha' = R^T alpha of the link before, x", "alpha', y"]),
    ("2", 3, {0: (3, 4, 5)}, ["alpha = alpha' + c"]),
    ("2A", 3, {0: (1, 2, 3)}, ["k = (w_y w_z, w_z w_x, w_x w_y)", "w_x^2, w_y^2, w_z^2"]),
    ("2A", 4, {0: (8,)}, ["lambda_11, lambda_22, lambda_33 = -(sums of two squares)"]),
    ("2A", 4, {0: (6, 7)}, [
        "lambda_21, lambda_13, lambda_32 = k + alpha, z, y, x",
        "lambda_12, lambda_31, lambda_23 = k - alpha, z, y, x",
    ]),
    ("3", 3, {-1: _LAMBDA}, [f"products of lambda p of the link before, {axis}" for axis in "xyz"]),
    ("3", 4, {-1: (18, 19), 0: (12, 13, 14)}, [
        "a'' = a of the link before + its lambda p, x", "a'', y", "a'', z",
    ]),
    ("3", 5, {0: (15, 16, 17)}, ["a = R^T a'', x", "a, y"]),
    ("4", 5, {0: _LAMBDA}, [f"products of lambda s, {axis}" for axis in "xyz"]),
    ("4", 6, {0: (18, 19, 20, 21, 22)}, ["a_c = a + lambda s, x", "a_c, y", "a_c, z"]),
    ("5", 1, {0: (23, 24, 25)}, ["F = m a_c"]),
    ("6", 1, {0: (6, 7)}, ["N = I alpha + D k, x", "N, y", "N, z"]),
    ("7", 1, {1: (32,)}, ["f' = R f of the link beyond, one of two components", "f', the other"]),
    ("7", 2, {0: (26, 30, 31)}, ["f = F + f'"]),
    ("8", 2, {0: (30, 31)}, ["p x f', x", "p x f', y", "p x f', z"]),
    ("8", 2, {0: (26,)}, ["s x F, x", "s x F, y", "s x F, z"]),
    ("8", 2, {1: (41, 42, 43)}, ["n' = R n of the link beyond, one of two components", "n', the other"]),
    ("8", 3, {0: _MOMENT}, ["n = N + p x f' + s x F + n', x", "n, y", "n, z"]),
)  # fmt: skip


def _tasks() -> Iterator[Task]:
    row = count(1)
    for step, layer, after, words in _ROWS:
        waits = tuple((place, k) for place in after for k in after[place])
        for does in words:
            k = next(row)
            yield Task(k, step, k <= 25, layer, does, waits)


TASKS: Final = tuple(_tasks())
"""Table 4.1, ``TASKS[row - 1]``: the forward pass, then from 26 on the backward pass."""
