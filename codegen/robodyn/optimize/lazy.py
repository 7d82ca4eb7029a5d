"""Quantities that are worked out when they are asked for, component by component.

A recursion may define more than its arm needs; what nothing asks for is never computed, costs no time and
leaves no trace in a program.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, Final

from robodyn.dynamics.vectors import AXES, Mark, unmarked
from robodyn.ir.program import Label


class Lazy:
    """Values by index, each computed once: ``0 1 2`` of a vector, ``11`` to ``33`` of a matrix."""

    __slots__ = ("_known", "_rule")

    def __init__(self, rule: Callable[[int], Any]) -> None:
        self._rule = rule
        self._known: dict[int, Any] = {}

    def __getitem__(self, index: int) -> Any:
        value = self._known.get(index)
        if value is None:
            value = self._known[index] = self._rule(index)
        return value


#: Anything that has components ``0 1 2``: a tuple, or a vector that is worked out on demand.
Components = Lazy | Sequence[Any]

NOTHING: Final = (0, 0, 0)


def named(u: Components, mark: Mark, link: int, quantity: str) -> Components:
    """``u`` with its components marked as they are worked out."""
    if mark is unmarked:
        return u
    return Lazy(lambda k: mark(u[k], Label(link, quantity, AXES[k])))


def weighted(factors: Sequence[Any], values: Components | Lazy, indices: Sequence[int] = (0, 1, 2)) -> Any:
    """Sum of ``factor * value``; a value whose factor is zero is not asked for."""
    total: Any = 0
    for factor, index in zip(factors, indices):  # noqa: B905 (the innermost loop of a search)
        if factor:
            product = factor * values[index]
            total = total + product if total else product
    return total


def added(*vectors: Components) -> Lazy:
    """Sum of vectors, from left to right."""

    def component(k: int) -> Any:
        total = vectors[0][k]
        for u in vectors[1:]:
            total = total + u[k]
        return total

    return Lazy(component)


def lever(p: Components, f: Components) -> Lazy:
    """``p x f``; components of ``f`` beside a zero of ``p`` are not asked for."""

    def component(k: int) -> Any:
        a, b = (k + 1) % 3, (k + 2) % 3
        total: Any = 0
        if p[a]:
            total = p[a] * f[b]
        if p[b]:
            total = total - p[b] * f[a]
        return total

    return Lazy(component)


def turned(axis: int, c: Any, s: Any, u: Components) -> Components:
    """``u`` turned about an axis (0 to 2) by the angle of cosine ``c`` and sine ``s``."""
    if not s and c == 1:
        return u
    a, b = (axis + 1) % 3, (axis + 2) % 3

    def component(k: int) -> Any:
        if k == axis:
            return u[k]
        if not s:
            return c * u[k]
        if not c:
            return -s * u[b] if k == a else s * u[a]
        return c * u[a] - s * u[b] if k == a else s * u[a] + c * u[b]

    return Lazy(component)


turned_x, turned_z = partial(turned, 0), partial(turned, 2)
