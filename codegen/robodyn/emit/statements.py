"""A program as statements: named values of the recursion, each with its expression and heading."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from robodyn.emit.concise import LARGE, explained_once, of_angles, often_read, steps_served
from robodyn.ir.program import Input, Label, Program
from robodyn.robot.names import is_reserved

#: What a quantity is, and its unit, for headings.
QUANTITIES: dict[str, str] = {
    "sc": "sines and cosines of the joint angles",
    "w": "angular velocity [rad/s]",
    "alpha": "angular acceleration [rad/s^2]",
    "ww": "products of the angular velocity [1/s^2]",
    "lam": "lambda matrix: takes a position to its acceleration [1/s^2]",
    "a": "acceleration of the frame's origin, gravity taken off [m/s^2]",
    "ac": "acceleration of the centre of mass, gravity taken off [m/s^2]",
    "ao": "acceleration of the frame's origin [m/s^2]",
    "vo": "velocity of the frame's origin [m/s]",
    "pl": "momentum of all that the joint carries, along the axes that its turn starts from [kg m/s]",
    "pa": "its moment about the frame's origin [kg m^2/s]",
    "ke": "kinetic energy of the links up to this one [J]",
    "pe": "potential energy of the links up to this one [J]",
    "hc": "first moment of all that the joint carries, along the axes that its turn starts from [kg m]",
    "hw": "first moment of all that the joint carries, before its turn, times gravity [N m]",
    "g": "gravity along the link's axes [m/s^2]",
    "E": "rotation to the base",
    "pb": "origin of the frame from that of the frame before, along the base's axes [m]",
    "wb": "angular velocity, along the base's axes [rad/s]",
    "alphab": "angular acceleration, along the base's axes [rad/s^2]",
    "ab": "acceleration of the frame's origin, gravity taken off, along the base's axes [m/s^2]",
    "rb": "centre of mass from the frame's origin, along the base's axes [m]",
    "fcb": "force that moves the link, along the base's axes [N]",
    "ncb": "moment that turns the link, along the base's axes [N m]",
    "fb": "force through the joint, along the base's axes [N]",
    "nb": "moment through the joint, about the frame's origin, along the base's axes [N m]",
    "A": "transform to the parent's frame",
    "R": "rotation to the parent's frame",
    "dA": "its derivative by the joint variable",
    "dR": "its derivative by the joint variable",
    "W": "transform to the base",
    "dW": "its derivatives by joint variables",
    "ddW": "its second derivatives by joint variables",
    "Wd": "its first time derivative [1/s]",
    "Wdd": "its second time derivative [1/s^2]",
    "dp": "derivative of the origin by the joint variable",
    "pdd": "acceleration of the frame's origin, along the base's axes [m/s^2]",
    "D": "second moment of position and acceleration of all that the joint carries [N m]",
    "e": "inertia force of all that the joint carries, along the base's axes [N]",
    "v": "coefficients of products of velocities",
    "tg": "gravity torque",
    "r": "centre of mass",
    "pw": "partial angular velocities of the link, joint by joint",
    "pv": "partial velocities of the centre of mass, joint by joint [m, at a prismatic joint 1]",
    "fw": "force through the joint less what the whole mass beyond it takes at the origin [N]",
    "fc": "force that moves the link [N]",
    "nc": "moment that turns the link [N m]",
    "f": "force through the joint [N]",
    "n": "moment through the joint, about the frame's origin [N m]",
    "f0": "force through the joint, along the axes that its turn starts from [N]",
    "n0": "moment through the joint, along the axes that its turn starts from [N m]",
    "tau": "joint torque [N m], at a prismatic joint force [N]",
    "h": "first moment of the composite body, about the frame's origin [kg m]",
    "k": "second moment of the composite body [kg m^2]",
    "fu": "force for a unit acceleration of a joint further out",
    "nu": "moment for a unit acceleration of a joint further out",
    "m": "mass matrix, its row of this joint",
    "ia": "inertia of all that the joint carries, the joints beyond free to move, about the frame's origin",
    "ea": "acceleration of the frame for a push at its origin, all joints free to move",
    "pivot": "factorisation M = U D U^T",
    "y": "forward substitution",
    "qdd": "joint acceleration [rad/s^2], at a prismatic joint [m/s^2]",
}


#: Quantities that stand under the heading of another.
_UNDER: dict[str, str] = {
    **dict.fromkeys(("ipivot", "u", "ud"), "pivot"),
    **dict.fromkeys(("ibx", "iby", "ibz", "im"), "ia"),
    **dict.fromkeys(("ebx", "eby", "ebz", "em"), "ea"),
}


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

    @property
    def arrays(self) -> set[str]:
        """Names of the arrays that are read."""
        return {x.array for x in self.inputs if x.index is not None}

    @property
    def reads_parameters(self) -> bool:
        """Whether a run-time parameter is read; it may be called like an array."""
        return any(x.index is None for x in self.inputs)


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


#: The heading of numbers that have names.
_NUMBERS = "numbers that are read often"
#: Steps written into one statement at most, so that a line can be read.
_LONGEST = 10


def statements(
    program: Program, *, in_order: bool = False, readable: bool = False, concise: bool = False
) -> Body:
    """``program`` as statements: labelled values and values used twice have names, the rest is written
    where it is used. The order and grouping of operations are the program's; ``in_order``: also the order
    in which compilers come upon them, so that more values have names. ``readable``: a value without a label
    is named after the step that it serves (``w2_part1``) and stands under its heading; else it is ``t1``,
    ``t2`` and so on. ``concise``: in a large function long numbers that it reads often have names, and
    headings explain a quantity once."""
    served = steps_served(program) if readable else None
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
    if concise:
        for k, constant in enumerate(often_read(program), 1):
            name = numbers[constant.as_integer_ratio()] = unique(f"k{k}", taken)
            written.append(Statement(name, constant, None if heading else _NUMBERS))
            heading = _NUMBERS
    angular = of_angles(program) if numbers else set()

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
        alone = i in named or steps >= _LONGEST or (following is not None and i not in following)
        if not alone:
            text.append(whole)
            size.append(steps)
            continue
        if label is None and served is not None:
            step = served[i]._replace(axis="", negative=False)
            parts[str(step)] += 1
            name, group = f"{step}_part{parts[str(step)]}", _heading(step)
        else:
            serial += label is None
            name, group = _name(label, serial), _heading(label)
        name = unique(name, taken)
        if group is None and served is not None:
            step = served[i]
            place = f"element {step.link} of " if step.quantity in arrays else f"link {step.link}: "
            group = place + step.quantity
        shown = group if group != heading else None
        if shown is not None and concise:
            shown = explained_once(shown, explained)
        written.append(Statement(name, whole, shown, i in arguments))
        heading = group if group is not None else heading
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
            named.add(i)
        elif op == "atan2":
            named.add(i)
        elif op in ("sign", "select"):  # C writes the argument of a sign twice, and a choice without branches
            named.update(x for x in args if isinstance(x, int))  # where both sides are there
        if label is not None or uses[i] > 1:
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


def _name(label: Label | None, serial: int) -> str:
    return f"t{serial}" if label is None else str(label)


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


def _heading(label: Label | None) -> str | None:
    if label is None:
        return None
    if label.quantity.removesuffix("to").rstrip("0123456789") in ("c", "s", "angle"):
        return QUANTITIES["sc"]
    family = _UNDER.get(label.quantity, label.quantity)
    meaning = QUANTITIES.get(family)
    if meaning is None:
        return None
    return meaning if family == "pivot" else f"link {label.link}: {meaning}"
