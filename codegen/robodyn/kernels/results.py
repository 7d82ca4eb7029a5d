"""What functions hand back: one array, or several with names; truths as bools, counts as integers."""

from __future__ import annotations

import collections
import functools
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final, NamedTuple

import numpy as np

from robodyn.kernels.arrays import Array

#: Results as Python has them, by what their numbers say.
CONVERTED: Final[Mapping[str, Callable[[Array], Array]]] = {
    "number": lambda x: x,
    "truth": lambda x: np.asarray(x > 0),
    "count": lambda x: np.where(x > 0, x, 0).astype(np.int64),
}


class _Rows:
    """What all branches of a pose share. Flags are bools or, in arrays that the caller gave, numbers."""

    __slots__ = ()
    solutions: Array
    exists: Array
    within: Array

    @property
    def reached(self) -> Array | list[Array]:
        """The rows that reach the whole pose, [k, n]; of N poses a list of N such arrays."""
        return self._chosen(self.exists > 0)

    @property
    def allowed(self) -> Array | list[Array]:
        """The same within the joints' limits."""
        return self._chosen((self.exists > 0) & (self.within > 0))

    def _chosen(self, chosen: Array) -> Array | list[Array]:
        if self.solutions.ndim == 2:
            return self.solutions[chosen]
        return [rows[which] for rows, which in zip(self.solutions, chosen, strict=True)]


class _Solutions(NamedTuple):
    solutions: Array
    exists: Array
    within: Array
    singular: Array
    solution_count: Array


class Solutions(_Solutions, _Rows):
    """All branches of a pose, or of N poses: then every array has N in front.

    ``solutions`` [b, n] (rad or m), a row for each branch; ``exists``, ``within``, ``singular`` [b], bools:
    whether a row reaches the pose, is within the joints' limits, is where branches meet or a joint is free. A
    row that does not exist is the nearest that its branch comes. ``solution_count`` [], how many exist.
    """

    __slots__ = ()


class _TaskSolutions(NamedTuple):
    solutions: Array
    exists: Array
    within: Array
    singular: Array
    solution_count: Array
    placed: Array
    off: Array


class TaskSolutions(_TaskSolutions, _Rows):
    """The same of an arm of four or five joints, which can do less than a pose asks for: ``placed`` [b],
    bools, says whether a row reaches the tool's place, ``off`` [b] by what angle it misses its
    rotation [rad].
    """

    __slots__ = ()


class NearestSolution(NamedTuple):
    """The branch nearest to the reference of a pose, or of N poses: then every array has N in front.

    ``solution`` [n] (rad or m); ``solution_exists``, ``solution_within``, ``solution_singular`` [], bools as
    in :class:`Solutions`; ``branch`` [], its place among all branches, from 0.
    """

    solution: Array
    solution_exists: Array
    solution_within: Array
    solution_singular: Array
    branch: Array


@functools.cache
def named_results(names: tuple[str, ...]) -> type[tuple[Array, ...]]:
    """The tuple that the results called ``names`` are handed back in."""
    for kind in (Solutions, TaskSolutions, NearestSolution):
        if names == kind._fields:
            return kind

    def reduced(self: tuple[Array, ...]) -> tuple[Any, ...]:
        return handed_back, (names, tuple(self))  # pickle does not find a class that is made here

    namedtuple: Any = collections.namedtuple  # of names that are known when this runs
    made = namedtuple("Results", names, rename=True)
    made.__reduce__ = reduced
    results: type[tuple[Array, ...]] = made
    return results


def handed_back(names: tuple[str, ...], results: Sequence[Array]) -> Array | tuple[Array, ...]:
    """The results called ``names``: one array as it is, several as a tuple with these names."""
    return results[0] if len(results) == 1 else named_results(names)._make(results)  # type: ignore[attr-defined]
