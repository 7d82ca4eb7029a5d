"""What functions of poses hand back in Python: tuples of arrays, by name and by what is true of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from robodyn.kernels.arrays import Array


class Solutions(NamedTuple):
    """All branches of a pose, or of N poses: then every array has N in front.

    ``solutions`` [b, n] (rad or m), a row for each branch; ``exists``, ``within``, ``singular`` [b], 1 or 0
    in the kernel's type: whether a row reaches the pose, is within the joints' limits, is where branches meet
    or a joint is free. A row that does not exist is the nearest that its branch comes. ``solution_count`` [],
    how many exist.
    """

    solutions: Array
    exists: Array
    within: Array
    singular: Array
    solution_count: Array

    @property
    def reached(self) -> Array | list[Array]:
        """The rows that reach the pose, [k, n]; of N poses a list of N such arrays."""
        return _rows(self.solutions, self.exists > 0)

    @property
    def allowed(self) -> Array | list[Array]:
        """The same within the joints' limits."""
        return _rows(self.solutions, (self.exists > 0) & (self.within > 0))


class NearestSolution(NamedTuple):
    """The branch nearest to the reference of a pose, or of N poses: then every array has N in front.

    ``solution`` [n] (rad or m); ``solution_exists``, ``solution_within``, ``solution_singular`` [], 1 or 0 as
    in :class:`Solutions`; ``branch`` [], its place among all branches, from 0.
    """

    solution: Array
    solution_exists: Array
    solution_within: Array
    solution_singular: Array
    branch: Array


_BY_NAMES: dict[tuple[str, ...], type[Solutions] | type[NearestSolution]] = {
    kind._fields: kind for kind in (Solutions, NearestSolution)
}


def handed_back(names: tuple[str, ...], results: Sequence[Array]) -> Array | tuple[Array, ...]:
    """The results called ``names``: one array as it is, several as a tuple, with names where it has such."""
    if len(results) == 1:
        return results[0]
    kind = _BY_NAMES.get(names)
    return tuple(results) if kind is None else kind(*results)


def _rows(solutions: Array, chosen: Array) -> Array | list[Array]:
    if solutions.ndim == 2:
        return solutions[chosen]
    return [rows[which] for rows, which in zip(solutions, chosen, strict=True)]
