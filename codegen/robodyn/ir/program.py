"""Straight-line programs: a list of single operations, each labelled with what it is part of."""

from __future__ import annotations

import contextlib
import gc
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial
from typing import Any, NamedTuple

from robodyn.errors import InputError


class Input(NamedTuple):
    """An input: element ``index`` (from 0) of an array, or a run-time parameter (``index`` None)."""

    array: str
    index: int | None  # type: ignore[assignment]  # hides tuple.index, which nobody wants

    def __str__(self) -> str:
        return self.array if self.index is None else f"{self.array}{self.index + 1}"

    def is_of(self, *arrays: str) -> bool:
        """Whether it is an element of one of ``arrays``; a run-time parameter may have an array's name."""
        return self.index is not None and self.array in arrays


class Label(NamedTuple):
    """What an operation completes: link (from 1; 0 the base), quantity, component.

    ``Label(3, "w", "x")`` is the angular velocity of link 3 along its x axis; with ``negative`` the
    operation gives minus that.
    """

    link: int
    quantity: str
    axis: str
    negative: bool = False

    def __str__(self) -> str:
        text = f"{self.quantity}{self.link}" + (f"_{self.axis}" if self.axis else "")
        return f"neg_{text}" if self.negative else text

    def flipped(self) -> Label:
        """The label of minus the value."""
        return self._replace(negative=not self.negative)


#: The value of an earlier operation (its position), an input, or a constant.
Operand = int | Input | Fraction

#: Operations with one operand, two and three. ``atan2`` is of y and x: the angle of the point (x, y) [rad],
#: within [-pi, pi], 0 of two zeros. ``select`` is its second operand where the first is more than 0, else (so
#: also where that is no number) the third; both are computed.
UNARY = ("neg", "sqrt", "sin", "cos", "tanh", "sign", "abs", "exp")
BINARY = ("add", "sub", "mul", "div", "pow", "atan2")
TERNARY = ("select",)
#: How many operands each operation has.
ARITY = {op: n for n, ops in enumerate((UNARY, BINARY, TERNARY), 1) for op in ops}


class Operation(NamedTuple):
    """``op`` applied to ``args``; what it is part of stands in ``label``."""

    op: str
    args: tuple[Operand, ...]
    label: Label | None = None


#: The array that an iteration works on.
STATE = "x"


#: An :class:`Operation` of its three fields as a tuple, in half the time; there are many.
operation_of: Callable[[tuple[str, tuple[Operand, ...], Label | None]], Operation]
operation_of = partial(tuple.__new__, Operation)


@dataclass(frozen=True, slots=True)
class Program:
    """Assignments in an order in which each uses only what stands before it.

    ``outputs`` are ``(array name, elements)`` in the order of the signature.
    """

    operations: tuple[Operation, ...]
    outputs: tuple[tuple[str, tuple[Operand, ...]], ...]
    #: The graph that the program was written out from, with its outputs there: passes start from it
    #: instead of building it again. Whoever has it reads it only.
    origin: Any = field(default=None, compare=False, repr=False)
    #: What is repeated before the operations, which read what it leaves.
    iteration: Iteration | None = None

    def parts(self) -> tuple[Program, ...]:
        """The straight-line programs that it consists of, in the order in which they run first."""
        if self.iteration is None:
            return (self,)
        return (self.iteration.start, self.iteration.step, replace(self, iteration=None))

    def straight(self, what: str) -> Program:
        """The program itself, where it repeats nothing.

        Raises
        ------
        InputError: it does; ``what`` is only of straight-line code.
        """
        if self.iteration is not None:
            raise InputError(
                f"{what} only of straight-line code",
                found=f"a step that is repeated {self.iteration.most} times at most",
                expected="a function that the arm has in closed form",
            )
        return self

    def changed(self, change: Callable[[Program], Program]) -> Program:
        """The program with ``change`` applied to each of its :meth:`parts`."""
        if self.iteration is None:
            return change(self)
        start, step, finish = map(change, self.parts())
        return replace(finish, iteration=replace(self.iteration, start=start, step=step))

    def results(self) -> tuple[Operand, ...]:
        """All elements of all outputs, one after another."""
        return tuple(operand for _, elements in self.outputs for operand in elements)

    def inputs(self) -> tuple[Input, ...]:
        """The inputs that are read, in the order of their first use."""
        if self.iteration is not None:
            of_parts = dict.fromkeys(x for part in self.parts() for x in part.inputs())
            return tuple(x for x in of_parts if not x.is_of(STATE))
        seen: dict[Input, None] = {}
        for operation in self.operations:
            for arg in operation.args:
                if isinstance(arg, Input):
                    seen[arg] = None
        for operand in self.results():
            if isinstance(operand, Input):
                seen[operand] = None
        return tuple(seen)

    def uses(self) -> list[int]:
        """How often each operation's value is read, by operations and outputs."""
        count = [0] * len(self.operations)
        for operation in self.operations:
            for arg in operation.args:
                if isinstance(arg, int):
                    count[arg] += 1
        for operand in self.results():
            if isinstance(operand, int):
                count[operand] += 1
        return count

    def zeros(self) -> dict[str, tuple[int, ...]]:
        """By output the elements (from 0) that are 0 whatever the inputs; not outputs without any."""
        places = {
            name: tuple([i for i, x in enumerate(elements) if type(x) is Fraction and not x])
            for name, elements in self.outputs
        }
        return {name: zeros for name, zeros in places.items() if zeros}

    def dump(self) -> str:
        """A readable listing, one operation a line."""

        def listed(operands: tuple[Operand, ...]) -> str:
            return ", ".join(f"%{x}" if isinstance(x, int) else str(x) for x in operands)

        lines = [
            f"%{i} = {op} {listed(args)}" + (f"   # {label}" if label else "")
            for i, (op, args, label) in enumerate(self.operations)
        ]
        return "\n".join([*lines, *(f"{name} = [{listed(elements)}]" for name, elements in self.outputs)])


@dataclass(frozen=True, slots=True)
class Iteration:
    """A step that is repeated a bounded number of times, on each of several rows of numbers.

    ``start`` gives the rows one after another in the array :data:`STATE`. ``step`` takes one as the input of
    that name, beside the inputs of all, and gives what it becomes, until its last number is more than 0, and
    ``most`` times at most.
    """

    start: Program
    step: Program
    most: int

    @property
    def size(self) -> int:
        """Numbers in a row."""
        return len(self.step.results())

    @property
    def rows(self) -> int:
        """How many rows there are."""
        return len(self.start.results()) // self.size


#: Programs are many small objects, and no garbage but what goes by itself: objects that are new before Python
#: looks at the youngest of them, and how often it does that before it looks at older ones.
RARELY = (10_000_000, 20, 20)


@contextlib.contextmanager
def rarely_collected() -> Iterator[None]:
    """Python looks for garbage rarely here, and afterwards as before: a quarter of a generation goes into it
    otherwise. Who has switched it off, or has it look more rarely still, is left alone. As a decorator it
    holds for each call."""
    before = gc.get_threshold()
    if not 0 < before[0] < RARELY[0]:
        yield
        return
    gc.set_threshold(*RARELY)
    try:
        yield
    finally:
        gc.set_threshold(*before)
