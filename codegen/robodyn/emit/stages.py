"""Functions that repeat a step: its stages as functions of their own, which only the whole calls.

A stage is straight-line code like any function. The whole calls the first, then the step in a loop that is
bounded and left when the step says that it is done, then the last.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from robodyn.ir.program import STATE, Program
from robodyn.ir.signature import Signature

#: What a step makes of the state, and of several states the one that is stepped.
NEXT, ROW = "next", "row"


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
    def arrays(self) -> dict[str, int]:
        """Local arrays with their sizes."""
        return {STATE: self.size * self.rows, NEXT: self.size}

    @property
    def unread(self) -> list[str]:
        """Inputs that no stage reads, and the run-time parameters, which none does."""
        stages = (self.start, self.step, self.finish)
        read = {name for stage in stages for name, _ in stage.signature.inputs}
        names = [name for name, _ in self.whole.inputs if name not in read]
        return [*names, "p"] if self.whole.parameters else names


def repeated(whole: Signature, program: Program) -> Repeated:
    """The stages of a ``program`` that repeats a step."""
    iteration = program.iteration
    assert iteration is not None
    size, every = iteration.size, iteration.size * iteration.rows
    start, step, finish = program.parts()
    ((_, elements),) = step.outputs
    step = replace(step, outputs=((NEXT, elements),), origin=None)

    def stage(name: str, part: Program, state: int, outputs: Sequence[tuple[str, int]], words: str) -> Stage:
        read = {x.array for x in part.inputs()}
        inputs = tuple(each for each in (*whole.inputs, (STATE, state)) if each[0] in read)
        alias = f"{whole.called}_{name}_"
        signature = replace(whole, alias=alias, inputs=inputs, outputs=tuple(outputs), parameters=())
        return Stage(signature, part, f"{whole.symbol}: {words}")

    return Repeated(
        whole,
        stage("start", start, 0, [(STATE, every)], "the state before the first step"),
        stage("step", step, size, [(NEXT, size)], "a step, from one state to the next"),
        stage("finish", finish, every, whole.outputs, "the results, from the last state"),
        size,
        iteration.rows,
        iteration.most,
    )
