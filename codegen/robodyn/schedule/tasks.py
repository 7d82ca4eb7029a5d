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


def _before(*numbers: int) -> tuple[tuple[Place, int], ...]:
    return tuple((-1, task_number) for task_number in numbers)


def _own(*numbers: int) -> tuple[tuple[Place, int], ...]:
    return tuple((0, task_number) for task_number in numbers)


def _beyond(*numbers: int) -> tuple[tuple[Place, int], ...]:
    return tuple((1, task_number) for task_number in numbers)


def _forward(
    task_number: int, step: str, layer: int, does: str, after: tuple[tuple[Place, int], ...]
) -> Task:
    return Task(task_number, step, True, layer, does, after)


def _backward(
    task_number: int, step: str, layer: int, does: str, after: tuple[tuple[Place, int], ...]
) -> Task:
    return Task(task_number, step, False, layer, does, after)


_LAMBDA = (9, 10, 11)
_MOMENT = (27, 28, 29, *range(33, 41))

TASKS: Final[tuple[Task, ...]] = (
    _forward(1, "1", 1, "w' = R^T w of the link before, x", _before(1, 2, 3)),
    _forward(2, "1", 1, "w', y", _before(1, 2, 3)),
    _forward(3, "1, 2", 2, "w_z = w'_z + qd; c = (qd w_y, -qd w_x, qdd)", _own(1, 2)),
    _forward(4, "2", 2, "alpha' = R^T alpha of the link before, x", _before(6)),
    _forward(5, "2", 2, "alpha', y", _before(6)),
    _forward(6, "2", 3, "alpha = alpha' + c", _own(3, 4, 5)),
    _forward(7, "2A", 3, "k = (w_y w_z, w_z w_x, w_x w_y)", _own(1, 2, 3)),
    _forward(8, "2A", 3, "w_x^2, w_y^2, w_z^2", _own(1, 2, 3)),
    _forward(9, "2A", 4, "lambda_11, lambda_22, lambda_33 = -(sums of two squares)", _own(8)),
    _forward(10, "2A", 4, "lambda_21, lambda_13, lambda_32 = k + alpha, z, y, x", _own(6, 7)),
    _forward(11, "2A", 4, "lambda_12, lambda_31, lambda_23 = k - alpha, z, y, x", _own(6, 7)),
    _forward(12, "3", 3, "products of lambda p of the link before, x", _before(*_LAMBDA)),
    _forward(13, "3", 3, "products of lambda p of the link before, y", _before(*_LAMBDA)),
    _forward(14, "3", 3, "products of lambda p of the link before, z", _before(*_LAMBDA)),
    _forward(15, "3", 4, "a'' = a of the link before + its lambda p, x", _before(18, 19) + _own(12, 13, 14)),
    _forward(16, "3", 4, "a'', y", _before(18, 19) + _own(12, 13, 14)),
    _forward(17, "3", 4, "a'', z", _before(18, 19) + _own(12, 13, 14)),
    _forward(18, "3", 5, "a = R^T a'', x", _own(15, 16, 17)),
    _forward(19, "3", 5, "a, y", _own(15, 16, 17)),
    _forward(20, "4", 5, "products of lambda s, x", _own(*_LAMBDA)),
    _forward(21, "4", 5, "products of lambda s, y", _own(*_LAMBDA)),
    _forward(22, "4", 5, "products of lambda s, z", _own(*_LAMBDA)),
    _forward(23, "4", 6, "a_c = a + lambda s, x", _own(18, 19, 20, 21, 22)),
    _forward(24, "4", 6, "a_c, y", _own(18, 19, 20, 21, 22)),
    _forward(25, "4", 6, "a_c, z", _own(18, 19, 20, 21, 22)),
    _backward(26, "5", 1, "F = m a_c", _own(23, 24, 25)),
    _backward(27, "6", 1, "N = I alpha + D k, x", _own(6, 7)),
    _backward(28, "6", 1, "N, y", _own(6, 7)),
    _backward(29, "6", 1, "N, z", _own(6, 7)),
    _backward(30, "7", 1, "f' = R f of the link beyond, one of two components", _beyond(32)),
    _backward(31, "7", 1, "f', the other", _beyond(32)),
    _backward(32, "7", 2, "f = F + f'", _own(26, 30, 31)),
    _backward(33, "8", 2, "p x f', x", _own(30, 31)),
    _backward(34, "8", 2, "p x f', y", _own(30, 31)),
    _backward(35, "8", 2, "p x f', z", _own(30, 31)),
    _backward(36, "8", 2, "s x F, x", _own(26)),
    _backward(37, "8", 2, "s x F, y", _own(26)),
    _backward(38, "8", 2, "s x F, z", _own(26)),
    _backward(39, "8", 2, "n' = R n of the link beyond, one of two components", _beyond(41, 42, 43)),
    _backward(40, "8", 2, "n', the other", _beyond(41, 42, 43)),
    _backward(41, "8", 3, "n = N + p x f' + s x F + n', x", _own(*_MOMENT)),
    _backward(42, "8", 3, "n, y", _own(*_MOMENT)),
    _backward(43, "8", 3, "n, z", _own(*_MOMENT)),
)
"""Table 4.1, ``TASKS[row - 1]``."""
