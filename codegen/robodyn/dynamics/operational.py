"""What the joints weigh at the tool, over any scalar: ``J M^-1 J^T``, in few operations.

The mass matrix is factored once, from tip to base, ``M = U D U^T``. Each row of the Jacobian is solved
half way, ``y = U^-1 J_r``, and an entry is ``y_r^T D^-1 y_s``. Rows that are zero in the last joints, as
those of the tool's velocity are where three axes meet there, stay zero in them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.jacobians import columns
from robodyn.dynamics.mass_matrix import Factored
from robodyn.dynamics.state import Dynamics
from robodyn.effects.scalars import is_zero
from robodyn.ir.program import Label

#: Rows of the Jacobian: three linear, three angular.
_ROWS = 6


def lambda_inverse(at: Dynamics) -> list[list[Any]]:
    """``J M^-1 J^T`` [6][6] along the world's axes; each entry and its mirror image are one."""
    rows = list(zip(*((*v, *w) for v, w in columns(at)), strict=True))
    factored = Factored(at.mass_matrix(), at.mark)
    halves = [factored.halved(row) for row in rows]
    scaled = [factored.divided(half) for half in halves]
    result: list[list[Any]] = [[0] * _ROWS for _ in range(_ROWS)]
    for r in range(_ROWS):
        for s in range(r, _ROWS):
            entry: Any = 0
            for x, y in zip(scaled[r], halves[s], strict=True):
                if not is_zero(x) and not is_zero(y):
                    entry = entry + x * y
            result[r][s] = result[s][r] = at.mark(entry, Label(r + 1, "linv", str(s + 1)))
    return result


def by_elimination(matrix: Sequence[Sequence[Any]], right: Sequence[Sequence[Any]]) -> list[list[Any]]:
    """``X`` [n][m] with ``matrix X = right``, the matrix [n][n] positive definite; plain elimination, which
    shares nothing with what is emitted."""
    n = len(matrix)
    rows = [[*row, *more] for row, more in zip(matrix, right, strict=True)]
    for k in range(n):
        for i in range(k + 1, n):
            share = rows[i][k] / rows[k][k]
            rows[i] = [x - share * y for x, y in zip(rows[i], rows[k], strict=True)]
    for k in reversed(range(n)):
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(k):
            rows[i] = [x - rows[i][k] * y for x, y in zip(rows[i], rows[k], strict=True)]
    return [row[n:] for row in rows]
