"""Budgets: the most operations that a kernel may have, for a CI job to hold."""

from __future__ import annotations

from dataclasses import dataclass

from robodyn.counts.count import Count
from robodyn.errors import InputError

KINDS = ("mul", "add", "div", "sqrt", "neg", "sincos", "other", "total")


@dataclass(frozen=True, slots=True)
class Budget:
    """Upper limits by kind, e.g. ``{"mul": 208, "total": 360}``."""

    limits: tuple[tuple[str, int], ...]

    def exceeded(self, count: Count) -> list[str]:
        """What of ``count`` is over its limit, in words; empty where the budget holds."""
        numbers = count.to_dict()
        return [
            f"{kind} {numbers[kind]} is {numbers[kind] - limit} over the budget of {limit}"
            for kind, limit in self.limits
            if numbers[kind] > limit
        ]


def parse_budget(text: str) -> Budget:
    """A budget from ``mul=208,add=152,total=360``; :class:`InputError` if it is not one."""
    limits: dict[str, int] = {}
    for part in text.split(","):
        kind, separator, digits = (piece.strip() for piece in part.partition("="))
        if (
            not separator
            or kind not in KINDS
            or not (digits.isascii() and digits.isdigit())
            or len(digits) > 9
        ):
            raise InputError(
                "not a budget",
                found=repr(part),
                expected=f"KIND=NUMBER with KIND one of {', '.join(KINDS)}",
                remedy="write it like mul=208,add=152,total=360",
            )
        if kind in limits:
            raise InputError(f"budget for {kind} given twice", found=repr(text), remedy="give each kind once")
        limits[kind] = int(digits)
    return Budget(tuple(limits.items()))
