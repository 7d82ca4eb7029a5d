"""What a search makes small: operations, multiplications, fused multiply-adds, the longest chain, calls of
sine and cosine, or the cost on a named machine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal, get_args

from robodyn.errors import InputError
from robodyn.ir.program import Program

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
        found: dict[str, int] = {}
        for kind in self.kinds:
            found[kind] = found.get(kind, 0) + 1
        return found

    @property
    def total(self) -> int:
        """``mul + add + div + sqrt``."""
        return sum(self.counts.get(kind, 0) for kind in ("mul", "add", "div", "sqrt"))

    @cached_property
    def fused(self) -> int:
        """How many products fuse with an addition: a product used once, by an addition; one an addition."""
        return len(self._fused_products)

    @cached_property
    def _fused_products(self) -> set[int]:
        uses = [0] * len(self.kinds)
        for read in self.reads:
            for k in read:
                uses[k] += 1
        for k in self.results:
            uses[k] += 1
        found: set[int] = set()
        for kind, read in zip(self.kinds, self.reads, strict=True):
            if kind == "add":
                for k in read:
                    if self.kinds[k] == "mul" and uses[k] == 1:
                        found.add(k)
                        break
        return found

    @cached_property
    def depth(self) -> int:
        """Operations on the longest chain; sines and cosines are inputs."""
        return self._longest(set())

    @cached_property
    def fused_depth(self) -> int:
        """The same with fused multiply-adds as one."""
        return self._longest(self._fused_products)

    def _longest(self, free: set[int]) -> int:
        length: list[int] = []
        for k, (kind, read) in enumerate(zip(self.kinds, self.reads, strict=True)):
            if kind in ("sin", "cos"):
                length.append(0)
            else:
                own = 0 if k in free or kind == "neg" else 1
                length.append(own + max((length[j] for j in read), default=0))
        return max((length[k] for k in self.results), default=0)


_SAME = {"sub": "add"}


def operations_of(program: Program) -> Operations:
    """The operations of ``program``; a unary minus is none and is left out."""
    kinds: list[str] = []
    reads: list[tuple[int, ...]] = []
    place: list[int | None] = []

    def placed(operands: Sequence[Any]) -> tuple[int, ...]:
        found = (place[x] for x in operands if isinstance(x, int))
        return tuple(k for k in found if k is not None)

    for op, args, _ in program.operations:
        if op == "neg":
            place.append(place[args[0]] if isinstance(args[0], int) else None)
            continue
        kinds.append(_SAME.get(op, op))
        reads.append(placed(args))
        place.append(len(kinds) - 1)
    return Operations(kinds, reads, placed(tuple(program.results())))


@dataclass(frozen=True, slots=True)
class Costs:
    """What operations cost on a machine, in cycles; ``fma`` None where products and sums do not fuse."""

    mul: float = 1.0
    add: float = 1.0
    fma: float | None = None
    div: float = 14.0
    sqrt: float = 14.0
    sincos: float = 46.0


#: Machines by name. On a Cortex-M4 a fused multiply-add takes three cycles, so products and sums stay apart;
#: its sines and cosines and the M7's were measured in instructions, as was software floating
#: point on an M3. A desktop's core does a multiplication, an addition or both fused in one slot.
TARGETS: dict[str, Costs] = {
    "cortex-m3": Costs(60.0, 64.0, None, 190.0, 260.0, 1400.0),
    "cortex-m4": Costs(),
    "cortex-m7": Costs(sincos=47.0, div=30.0, sqrt=30.0),
    "x86-64": Costs(div=4.0, sqrt=5.0, sincos=20.0),
    "x86-64-v3": Costs(fma=1.0, div=4.0, sqrt=5.0, sincos=18.0),
}


@dataclass(frozen=True, slots=True)
class Objective:
    """What to make small; ``target`` names a machine for ``weighted``."""

    name: ObjectiveName = "total"
    target: str = ""

    def __post_init__(self) -> None:
        for what, found, allowed in (
            ("objective", self.name, get_args(ObjectiveName)),
            ("target", self.target, tuple(TARGETS) if self.name == "weighted" else ("",)),
        ):
            if found not in allowed:
                known = ", ".join(repr(name) for name in allowed)
                raise InputError(f"unknown {what} {found!r}", expected=f"one of {known}")

    @property
    def key(self) -> str:
        """The objective in a word, as records and ``--objective`` have it: ``weighted:cortex-m4``."""
        return f"{self.name}:{self.target}" if self.target else self.name

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
        costs = TARGETS[self.target]
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
