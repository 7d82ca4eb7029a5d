"""Functions that repeat a step: its stages as functions of their own, which only the whole calls.

A stage is straight-line code like any function. The whole calls the first, then the step in a loop that is
bounded and left when the step says that it is done, then the last.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from robodyn.ir.program import STATE, Program
from robodyn.ir.signature import Signature

#: What a step makes of the state.
NEXT = "next"
#: Of several states the one that is stepped.
ROW = "row"


@dataclass(frozen=True, slots=True)
class Stage:
    """A function that only the whole calls, in words; its program."""

    signature: Signature
    program: Program
    words: str

    def call(self, **places: str) -> str:
        """The call of it, as languages without references write it: with all its arrays under their own
        names, or those of ``places``."""
        arrays = (name for name, _ in (*self.signature.inputs, *self.signature.outputs))
        return f"{self.signature.symbol}({', '.join(places.get(array, array) for array in arrays)})"


@dataclass(frozen=True, slots=True)
class Repeated:
    """The function ``whole``, of stages; states of ``size`` numbers, one for each of ``rows``, are stepped
    ``most`` times at most."""

    whole: Signature
    start: Stage
    step: Stage
    finish: Stage
    size: int
    rows: int
    most: int

    @property
    def stages(self) -> tuple[Stage, ...]:
        """In the order in which they run."""
        return self.start, self.step, self.finish

    @property
    def unread(self) -> list[str]:
        """Inputs that no stage reads, and the run-time parameters, which none does."""
        read = {name for stage in self.stages for name, _ in stage.signature.inputs}
        names = [name for name, _ in self.whole.inputs if name not in read]
        return [*names, "p"] if self.whole.parameters else names


def repeated(whole: Signature, program: Program) -> Repeated:
    """The stages of a ``program`` that repeats a step."""
    iteration = program.iteration
    assert iteration is not None
    every = iteration.size * iteration.rows
    start, step, finish = program.parts()

    def stage(name: str, part: Program, state: int, outputs: Sequence[tuple[str, int]], words: str) -> Stage:
        read = {x.array for x in part.inputs()}
        inputs = [(array, size) for array, size in (*whole.inputs, (STATE, state)) if array in read]
        own = replace(
            whole,
            alias=f"{whole.called}_{name}_",
            inputs=tuple(inputs),
            outputs=tuple(outputs),
            parameters=(),
        )
        return Stage(own, part, f"{whole.symbol}: {words}")

    return Repeated(
        whole,
        stage("start", start, 0, [(STATE, every)], "the state before the first step"),
        stage(
            "step",
            part_writing(step, NEXT),
            iteration.size,
            [(NEXT, iteration.size)],
            "a step, from one state to the next",
        ),
        stage("finish", finish, every, whole.outputs, "the results, from the last state"),
        iteration.size,
        iteration.rows,
        iteration.most,
    )


def part_writing(program: Program, array: str) -> Program:
    """``program`` with its only output called ``array``."""
    ((_, elements),) = program.outputs
    return replace(program, outputs=((array, elements),), origin=None)
