"""What a search makes small: operations, multiplications, fused multiply-adds, the longest chain, calls of
sine and cosine, or the cost on a named machine."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, get_args

from robodyn.errors import InputError
from robodyn.ir.program import Program

if TYPE_CHECKING:
    from robodyn.targets import Costs

ObjectiveName = Literal["total", "mul", "fma", "depth", "sincos", "weighted"]


@dataclass(frozen=True)
class Operations:
    """Operations as every search sees them: ``kinds[k]`` is "mul", "add" ... of operation k, ``reads[k]``
    are the operations that it reads (inputs and constants left out), in an order of evaluation; ``results``
    the operations that outputs are."""

    kinds: Sequence[str]
    reads: Sequence[tuple[int, ...]]
    results: tuple[int, ...]

    @cached_property
    def counts(self) -> Mapping[str, int]:
        """How many of each kind."""
        return Counter(self.kinds)

    @property
    def total(self) -> int:
        """``mul + add + div + sqrt``."""
        return sum(self.counts.get(kind, 0) for kind in ("mul", "add", "div", "sqrt"))

    @cached_property
    def fused(self) -> int:
        """How many products fuse with an addition: a product used once, by an addition; one an addition."""
        uses = [0] * len(self.kinds)
        for read in self.reads:
            for k in read:
                uses[k] += 1
        for k in self.results:
            uses[k] += 1
        return sum(
            kind == "add" and any(self.kinds[k] == "mul" and uses[k] == 1 for k in read)
            for kind, read in zip(self.kinds, self.reads, strict=True)
        )

    @cached_property
    def depth(self) -> int:
        """Operations on the longest chain; sines and cosines are inputs."""
        length: list[int] = []
        for kind, read in zip(self.kinds, self.reads, strict=True):
            if kind in ("sin", "cos"):
                length.append(0)
            else:
                length.append(1 + max((length[j] for j in read), default=0))
        return max((length[k] for k in self.results), default=0)


_SAME = {"sub": "add"}


def operations_of(program: Program) -> Operations:
    """The operations of ``program``; a unary minus is none and is left out."""
    kinds: list[str] = []
    reads: list[tuple[int, ...]] = []
    place: list[int | None] = []

    def placed(operands: Sequence[Any]) -> tuple[int, ...]:
        places = (place[x] for x in operands if isinstance(x, int))
        return tuple(k for k in places if k is not None)

    for op, args, _ in program.operations:
        if op == "neg":
            place.append(place[args[0]] if isinstance(args[0], int) else None)
            continue
        kinds.append(_SAME.get(op, op))
        reads.append(placed(args))
        place.append(len(kinds) - 1)
    return Operations(kinds, reads, placed(tuple(program.results())))


@dataclass(frozen=True, slots=True)
class Objective:
    """What to make small; ``target`` names a processor for ``weighted`` (:mod:`robodyn.targets`)."""

    name: ObjectiveName = "total"
    target: str = ""

    def __post_init__(self) -> None:
        if self.name not in get_args(ObjectiveName):
            known = ", ".join(repr(name) for name in get_args(ObjectiveName))
            raise InputError(f"unknown objective {self.name!r}", expected=f"one of {known}")
        if self.name != "weighted" and self.target:
            raise InputError(f"unknown target {self.target!r}", expected=f"{self.name}, and no target")
        if self.name == "weighted":
            from robodyn.targets import target_named

            object.__setattr__(self, "target", target_named(self.target).name)

    @property
    def key(self) -> str:
        """The objective in a word, as records and ``--objective`` have it: ``weighted:cortex-m4f``."""
        return f"{self.name}:{self.target}" if self.target else self.name

    @property
    def costs(self) -> Costs:
        """What operations cost on the target of ``weighted``."""
        from robodyn.targets import TARGETS

        return TARGETS[self.target].costs

    def cost(self, operations: Operations) -> float:
        """The cost; of equals the one with fewer operations costs a little less."""
        total = operations.total
        tie = total / 4096
        counts = operations.counts
        if self.name == "total":
            return float(total)
        if self.name == "mul":
            return counts.get("mul", 0) + counts.get("div", 0) + tie
        if self.name == "fma":
            return total - operations.fused + tie
        if self.name == "depth":
            return operations.depth + tie
        sincos = counts.get("sin", 0) + counts.get("cos", 0)
        if self.name == "sincos":
            return sincos + tie
        costs = self.costs
        mul, add = counts.get("mul", 0), counts.get("add", 0)
        spent = costs.div * counts.get("div", 0) + costs.sqrt * counts.get("sqrt", 0) + costs.sincos * sincos
        if costs.fma is not None:
            mul, add = mul - operations.fused, add - operations.fused
            spent += costs.fma * operations.fused
        return spent + costs.mul * mul + costs.add * add + tie


def parse_objective(text: str) -> Objective:
    """``total``, ``mul`` ... or ``weighted:TARGET``; :class:`InputError` where that is none."""
    name, _, target = text.partition(":")
    return Objective(name, target)  # type: ignore[arg-type]  # checked there
