"""Names and headings of intermediate results: which step of the recursion each operation serves, and what
keeps the text of a large function short.

The derivatives of an arm of seven joints in general position take some 7,000 operations; the cosine of one
twist stands in them a hundred times, with sixteen digits each. Such numbers get names, and a quantity is
explained once.
"""

from __future__ import annotations

import re
from collections import Counter
from fractions import Fraction

from robodyn.ir.program import Label, Program


def steps_served(program: Program) -> list[Label]:
    """A label for every operation: its own; else that of the first labelled value that is computed from it;
    else the array that the result goes to, with its element (from 1) for a link."""
    steps: list[Label | None] = [operation.label for operation in program.operations]
    for array, elements in program.outputs:
        for k, operand in enumerate(elements, 1):
            if isinstance(operand, int) and steps[operand] is None:
                steps[operand] = Label(k, array, "")
    first: list[int | None] = [None if step is None else i for i, step in enumerate(steps)]
    for i in range(len(steps) - 1, -1, -1):  # users stand after what they read
        reached = first[i]
        for arg in program.operations[i].args:
            if not isinstance(arg, int) or steps[arg] is not None or reached is None:
                continue
            known = first[arg]
            first[arg] = reached if known is None else min(known, reached)
    served: list[Label] = []
    for i, at in enumerate(first):
        label = None if at is None else steps[at]
        if label is None:
            raise ValueError(f"operation {i} serves no result: a program holds nothing that is not used")
        served.append(label)
    return served


#: Operations of a function above which its text is kept short.
LARGE = 1500
#: Characters of a number from which on it has a name where it is read so often.
_LONG, _OFTEN = 10, 4
#: Where the explanation of a quantity begins, behind its name.
_EXPLANATION = re.compile(r": |, | \[")


def often_read(program: Program) -> list[Fraction]:
    """Long numbers that ``program`` reads often outside the arguments of sines, in the order of their first
    use."""
    angular = of_angles(program)
    read: Counter[tuple[int, int]] = Counter()  # two integers are hashed sooner than a Fraction
    for i, operation in enumerate(program.operations):
        if i not in angular:
            read.update([x.as_integer_ratio() for x in operation.args if type(x) is Fraction])
    often = [Fraction(*ratio) for ratio, times in read.items() if times >= _OFTEN]
    return [constant for constant in often if constant > 0 and len(repr(float(constant))) >= _LONG]


def of_angles(program: Program) -> set[int]:
    """The operations that arguments of sines and cosines are made of."""
    operations = program.operations
    stack = [x for op in operations if op.op in ("sin", "cos") for x in op.args if isinstance(x, int)]
    angular: set[int] = set()
    while stack:
        i = stack.pop()
        if i not in angular:
            angular.add(i)
            stack.extend(x for x in operations[i].args if isinstance(x, int))
    return angular


def explained_once(heading: str, explained: set[str]) -> str:
    """``heading`` (``link 3: what it is, of which, in which unit``) in full where the quantity is not among
    those ``explained`` yet, else by its name."""
    place, colon, meaning = heading.partition(": ")
    if not place.startswith("link ") or not colon:
        place, colon, meaning = "", "", heading
    if meaning not in explained:
        explained.add(meaning)
        return heading
    return f"{place}{colon}{_EXPLANATION.split(meaning)[0]}"
