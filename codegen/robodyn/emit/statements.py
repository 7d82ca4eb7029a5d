"""A program as statements: named values of the recursion, each with its expression and heading."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from robodyn.emit.headings import explained_once, heading_of
from robodyn.ir.program import Input, Label, Program
from robodyn.robot.names import is_reserved


class Apply(NamedTuple):
    """An operation in an expression."""

    op: str
    args: tuple[Expression, ...]


#: A name, an input, a constant, or an operation on expressions.
Expression = str | Input | Fraction | Apply


class Statement(NamedTuple):
    """``name = expression``. ``heading`` opens a group of statements; ``angle`` marks the argument of a
    sine and a cosine."""

    name: str
    expression: Expression
    heading: str | None = None
    angle: bool = False


@dataclass(frozen=True, slots=True)
class Body:
    """The statements of a function, its results, one expression an element, array by array, and the inputs
    that these read."""

    statements: tuple[Statement, ...]
    outputs: tuple[tuple[str, tuple[Expression, ...]], ...]
    inputs: frozenset[Input]


def inputs_of(*expressions: Expression) -> list[Input]:
    """The inputs that ``expressions`` read, from left to right."""
    inputs: list[Input] = []
    stack = list(reversed(expressions))
    while stack:
        expression = stack.pop()
        if isinstance(expression, Apply):
            stack += expression.args[::-1]
        elif isinstance(expression, Input):
            inputs.append(expression)
    return inputs


#: Steps written into one statement at most, so that a line can be read.
_LONGEST = 10
#: Operations of a function above which its text is kept short. The derivatives of an arm of seven joints in
#: general position take some 7,000; the cosine of one twist stands in them a hundred times.
LARGE = 1500
#: Characters of a number from which on it has a name where it is read so often, and their heading.
_LONG, _OFTEN, _NUMBERS = 10, 4, "numbers that are read often"


def statements(
    program: Program, *, in_order: bool = False, readable: bool = False, concise: bool = False
) -> Body:
    """``program`` as statements: labelled values and values used twice have names, the rest is written
    where it is used. The order and grouping of operations are the program's; ``in_order``: also the order
    in which compilers come upon them, so that more values have names. ``readable``: a value without a label
    is named after the step that it serves (``w2_part1``) and stands under its heading; else it is ``t1``,
    ``t2`` and so on. ``concise``: in a large function long numbers that it reads often have names, and
    headings explain a quantity once."""
    served = _steps_served(program) if readable else None
    parts: Counter[str] = Counter()
    arrays = {name for name, _ in program.outputs}
    operations = program.operations
    named, arguments = _named(program)
    size: list[int] = []
    text: list[Expression] = []
    written: list[Statement] = []
    taken: set[str] = set()
    heading: str | None = None
    explained: set[str] = set()
    serial = 0
    following = _written_in_order(program) if in_order else None
    concise = concise and len(operations) > LARGE
    numbers: dict[tuple[int, int], str] = {}
    angular = _of_angles(program) if concise else set()
    for k, constant in enumerate(_often_read(program, angular) if concise else (), 1):
        name = numbers[constant.as_integer_ratio()] = unique(f"k{k}", taken)
        written.append(Statement(name, constant, None if heading else _NUMBERS))
        heading = _NUMBERS

    for i, (op, args, label) in enumerate(operations):
        steps = 1
        written_args: list[Expression] = []
        for arg in args:
            if isinstance(arg, int):
                steps += size[arg]
                written_args.append(text[arg])
            elif numbers and type(arg) is Fraction and i not in angular:
                written_args.append(numbers.get(arg.as_integer_ratio(), arg))
            else:
                written_args.append(arg)
        whole = Apply(op, tuple(written_args))
        if i not in named and steps < _LONGEST and (following is None or i in following):
            text.append(whole)
            size.append(steps)
            continue
        step = label if served is None else served[i]
        group = heading_of(step)
        if group is None and served is not None:
            quantity = served[i].quantity
            of = f"element {served[i].link} of " if quantity in arrays else f"link {served[i].link}: "
            group = of + quantity
        if label is not None:
            name = str(label)
        elif step is not None:
            step = step._replace(axis="", negative=False)
            parts[str(step)] += 1
            name = f"{step}_part{parts[str(step)]}"
        else:
            serial += 1
            name = f"t{serial}"
        name = unique(name, taken)
        shown = group if group != heading else None
        if shown is not None and concise:
            shown = explained_once(shown, explained)
        written.append(Statement(name, whole, shown, i in arguments))
        heading = heading if group is None else group
        text.append(name)
        size.append(0)
    outputs = tuple(
        (name, tuple([text[x] if isinstance(x, int) else x for x in elements]))
        for name, elements in program.outputs
    )
    return Body(tuple(written), outputs, frozenset(program.inputs()))


def _named(program: Program) -> tuple[set[int], set[int]]:
    """Operations whose values have names, however short they are, and those of them that are arguments of
    sines and cosines."""
    uses = program.uses()
    arguments: set[int] = set()
    named = {x for x in program.results() if isinstance(x, int)}
    for i, (op, args, label) in enumerate(program.operations):
        if op in ("sin", "cos"):
            arguments.update(x for x in args if isinstance(x, int))
        elif op in ("sign", "select"):  # C writes the argument of a sign twice, and a choice without branches
            named.update(x for x in args if isinstance(x, int))  # where both sides are there
        if label is not None or uses[i] > 1 or op in ("sin", "cos", "atan2"):
            named.add(i)
    return named | arguments, arguments


def _written_in_order(program: Program) -> set[int]:
    """Operations that may be written where they are used: a compiler that reads from left to right comes
    upon them in their place."""
    seen: set[int] = set()
    first: list[int] = []
    for i, (_, args, _) in enumerate(program.operations):
        start = i
        for arg in reversed(args):
            if isinstance(arg, int) and arg == start - 1:  # a constant may be equal, too
                seen.add(arg)
                start = first[arg]
        first.append(start)
    return seen


def unique(name: str, taken: set[str]) -> str:
    """``name``, from now on ``taken``; with a number if it is that already, or a word of a language (a label
    may come from a file)."""
    # Fortran does not tell capitals apart.
    candidate, k = name, 2
    while candidate.lower() in taken or is_reserved(candidate):
        candidate = f"{name}_{k}"
        k += 1
    taken.add(candidate.lower())
    return candidate


def _steps_served(program: Program) -> list[Label]:
    """A label for every operation: its own; else that of the first labelled value that is computed from it;
    else the array that the result goes to, with its element (from 1) for a link."""
    steps = [operation.label for operation in program.operations]
    for array, elements in program.outputs:
        for k, operand in enumerate(elements, 1):
            if isinstance(operand, int) and steps[operand] is None:
                steps[operand] = Label(k, array, "")
    first = [len(steps) if step is None else i for i, step in enumerate(steps)]
    for i in range(len(steps) - 1, -1, -1):  # users stand after what they read
        for arg in program.operations[i].args:
            if isinstance(arg, int) and steps[arg] is None:
                first[arg] = min(first[arg], first[i])
    served = [steps[i] for i in first]  # a program holds nothing that no result needs
    return [step for step in served if step is not None]


def _often_read(program: Program, angular: set[int]) -> list[Fraction]:
    """Long numbers that ``program`` reads often outside the ``angular`` operations, in the order of their
    first use."""
    read: Counter[tuple[int, int]] = Counter()  # two integers are hashed sooner than a Fraction
    for i, operation in enumerate(program.operations):
        if i not in angular:
            read.update([x.as_integer_ratio() for x in operation.args if type(x) is Fraction])
    often = [Fraction(*ratio) for ratio, times in read.items() if times >= _OFTEN]
    return [constant for constant in often if constant > 0 and len(repr(float(constant))) >= _LONG]


def _of_angles(program: Program) -> set[int]:
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
