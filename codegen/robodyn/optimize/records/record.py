"""A record as text, one operation a line, constants as exact fractions.

    robodyn record 1
    robot puma560_d2
    identity 0123456789abcdef0123456789abcdef
    function inverse_dynamics
    objective total
    found search, seed 1
    computes 89abcdef0123456789abcdef01234567
    program
    %0 = sin q[1]
    %1 = mul 9/10 %0 : 2 w x
    tau = %1 -%0 0

After a colon stands what the operation completes: link, quantity, axis, and ``-`` for minus that.
``computes`` is the key of the function (:mod:`robodyn.optimize.records.record`), by which a robot in
other frames finds the record; it may be missing.

The text may come from anywhere, so that nothing in it may take long or much room later: not a number of many
digits, not a power of powers, not a sine of a thousandfold angle.

What a program computes is a short text too (:func:`function_key`): the same for all programs of one function,
however they are written. It is no proof: the point is fixed, so that a program can be written for it. What is
found by it is compared afterwards in fields that nobody chooses (:mod:`robodyn.optimize.records.validation`).
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.ir.field import Field
from robodyn.ir.fingerprint import digest, fingerprint, in_drawn_field
from robodyn.ir.program import ARITY, Input, Label, Operand, Operation, Program
from robodyn.robot.values import circle_point

_TITLE = "robodyn record 1"
#: The fields of the header, and the attributes that hold them.
_FIELDS = {
    "robot": "robot",
    "identity": "identity",
    "function": "function",
    "objective": "objective",
    "found": "origin",
}
_KEY = "computes"
#: Far above what any arm needs; a file with more is not a record.
_MOST_LINES, _LONGEST_LINE = 100_000, 20_000
#: So many digits has a constant's numerator or denominator at the most; so many factors a product; so many
#: angles and operations the argument of a sine.
_MOST_DIGITS, _MOST_FACTORS, _MOST_ANGLES = 1000, 1000, 300

_NAME = r"[A-Za-z][A-Za-z0-9_]{0,62}"
_OPERAND = re.compile(rf"(?:%(\d{{1,6}})|({_NAME})\[(\d{{1,4}})\]|\$({_NAME})|-?(\d+)(?:/(\d+))?)\Z", re.A)
_LABEL = re.compile(r"(\d{1,4}) ([A-Za-z][A-Za-z0-9]{0,15})(?: ([A-Za-z0-9_]{0,9}))?( -)?\Z", re.A)


@dataclass(frozen=True, slots=True)
class Record:
    """The best program known of a function of the robot with this ``identity``.

    ``objective`` says best at what; ``origin`` is one line on how it was found; ``file`` is where it was
    read.
    """

    robot: str
    identity: str
    function: str
    objective: str
    origin: str
    program: Program
    file: str | None = field(default=None, compare=False)

    def text(self) -> str:
        """The record as it is kept in a file."""
        lines = [_TITLE, *(f"{name} {getattr(self, attribute)}" for name, attribute in _FIELDS.items())]
        if (key := function_key(self.program)) is not None:
            lines.append(f"{_KEY} {key}")
        lines.append("program")
        for i, (op, args, label) in enumerate(self.program.operations):
            line = f"%{i} = {op} {' '.join(map(_operand, args))}"
            if label is not None:
                words = (str(label.link), label.quantity, label.axis, "-" * label.negative)
                line += f" : {' '.join(word for word in words if word)}"
            lines.append(line)
        for name, elements in self.program.outputs:
            lines.append(f"{name} = {' '.join(map(_operand, elements))}")
        return "\n".join(lines) + "\n"


def header(text: str) -> dict[str, str]:
    """The fields of a record without its program; empty where ``text`` is none."""
    lines = text.split("\n", len(_FIELDS) + 2)
    if lines[0] != _TITLE:
        return {}
    for names in ((*_FIELDS, _KEY), tuple(_FIELDS)):
        fields = dict(line.partition(" ")[::2] for line in lines[1 : len(names) + 1])
        if tuple(fields) == names:
            return fields
    return {}


def parse_record(text: str, file: str) -> Record:
    """The record in ``text``; ``file`` names it in errors.

    Raises
    ------
    InputError: the text is no record: place and line are told.
    """
    fields = header(text)
    if not fields:
        raise _fault(file, 1, "not a record of robodyn", f"the line {_TITLE!r} and {len(_FIELDS)} fields")
    lines = text.split("\n")
    if len(lines) > _MOST_LINES or any(len(line) > _LONGEST_LINE for line in lines):
        raise _fault(file, 1, "too large for a record", f"at most {_MOST_LINES} lines")
    at = len(fields) + 1
    if lines[at : at + 1] != ["program"]:
        raise _fault(file, at + 1, "the record has no program", "the line 'program'")
    operations: list[Operation] = []
    outputs: list[tuple[str, tuple[Operand, ...]]] = []
    sizes: list[_Size] = []
    for line_number, line in _numbered(lines, at + 1):
        name, separator, right = line.partition(" = ")
        if not separator:
            raise _fault(file, line_number, "not a line of a program", "%N = op operands, or name = operands")
        body, colon, note = right.partition(" : ")
        words = body.split()
        if name == f"%{len(operations)}" and not outputs and words:
            op, *rest = words
            if len(rest) != ARITY.get(op):
                raise _fault(file, line_number, "not an operation", f"one of {', '.join(ARITY)}")
            args = tuple(_parsed(word, len(operations), file, line_number) for word in rest)
            sizes.append(_size(op, args, sizes, file, line_number))
            operations.append(Operation(op, args, _label(note, file, line_number) if colon else None))
        elif re.fullmatch(_NAME, name) and not colon:
            if name in (known for known, _ in outputs):
                raise _fault(file, line_number, f"a second output {name!r}", "each output once")
            outputs.append((name, tuple(_parsed(word, len(operations), file, line_number) for word in words)))
        else:
            raise _fault(file, line_number, "not the next line of the program", f"%{len(operations)} = ...")
    if not outputs:
        raise _fault(file, len(lines), "the program has no outputs", "name = operands")
    return Record(
        **{attribute: fields[name] for name, attribute in _FIELDS.items()},
        program=Program(tuple(operations), tuple(outputs)),
        file=file,
    )


def _numbered(lines: list[str], first: int) -> Iterator[tuple[int, str]]:
    for line_number, line in enumerate(lines[first:], first + 1):
        if line or line_number < len(lines):
            yield line_number, line


def _operand(operand: Operand) -> str:
    if isinstance(operand, int):
        return f"%{operand}"
    if isinstance(operand, Input):
        return f"${operand.array}" if operand.index is None else f"{operand.array}[{operand.index}]"
    return str(operand)


def _parsed(word: str, before: int, file: str, line: int) -> Operand:
    match = _OPERAND.match(word)
    if match:
        position, array, index, parameter, numerator, denominator = match.groups()
        if position is not None and int(position) < before:
            return int(position)
        if array is not None:
            return Input(array, int(index))
        if parameter is not None:
            return Input(parameter, None)
        short = numerator is not None and max(map(len, (numerator, denominator or "1"))) <= _MOST_DIGITS
        if short and (denominator or "1").strip("0"):
            return Fraction(word)
    expected = "%N of a line above, q[N], $name or a fraction"
    raise _fault(file, line, f"not an operand: {word[:40]!r}", expected)


@dataclass(frozen=True, slots=True)
class _Size:
    """How large a value may be: ``factors`` of its largest product; ``angles`` and operations in its sum,
    None where it is no sum of whole multiples of inputs."""

    factors: int = 1
    angles: int | None = 1


def _size(op: str, args: tuple[Operand, ...], before: list[_Size], file: str, line: int) -> _Size:
    """The size of an operation's value; refused where later steps could not bear it."""
    if all(isinstance(arg, Fraction) for arg in args):
        raise _fault(file, line, "an operation on numbers alone", "the number that it gives")
    of = [before[arg] if isinstance(arg, int) else _Size() for arg in args]
    factors = [x.factors for x in of]
    angles = [x.angles for x in of if x.angles is not None]
    if op in ("sin", "cos"):
        if not angles or angles[0] > _MOST_ANGLES:
            raise _fault(file, line, f"{op} of what is no angle", "sums and whole multiples of few inputs")
        return _Size(1, None)
    if op in ("mul", "div"):
        if sum(factors) > _MOST_FACTORS:
            raise _fault(file, line, "a product of too many factors", f"at most {_MOST_FACTORS}")
        k = args[0]
        if op == "mul" and isinstance(k, Fraction) and k.denominator == 1 and len(angles) == 2:
            return _Size(sum(factors), 1 + abs(k.numerator) * angles[1])
        return _Size(sum(factors), None)
    if op in ("add", "sub", "neg"):
        return _Size(max(factors), 1 + sum(angles) if len(angles) == len(of) else None)
    return _Size(1, None)


def _label(note: str, file: str, line: int) -> Label:
    match = _LABEL.match(note)
    if not match:
        raise _fault(file, line, f"not a label: {note[:40]!r}", "link, quantity, axis")
    link, quantity, axis, negative = match.groups()
    return Label(int(link), quantity, axis or "", negative is not None)


def _fault(file: str, line: int, what: str, expected: str) -> InputError:
    return InputError(
        what,
        where=Place(file, line),
        expected=expected,
        remedy="make the record anew: robodyn gen --optimize full",
    )


#: Field and point are drawn from this; other words make all keys in files worthless.
_SEED: Final = "robodyn record 1"


def function_key(program: Program, less: Program | None = None) -> str | None:
    """A hash of what ``program``, ``less`` another one with the same outputs, gives at one random point of a
    finite field: 32 hexadecimal digits.

    None where it has no value there: a divisor or a constant vanishes.
    """
    field = Field(_SEED)
    try:
        values = fingerprint(program, field, circle_point)
        if less is not None:
            other = fingerprint(less, field, circle_point)
            values = tuple((x - y) % field.prime for x, y in zip(values, other, strict=True))
    except (ValueError, ArithmeticError):
        return None
    outputs = " ".join(f"{name} {len(elements)}" for name, elements in program.outputs)
    return hashlib.sha256(f"{outputs}: {values}".encode()).hexdigest()[:32]


def labelled(program: Program, recursion: Program) -> Program:
    """``program`` with the labels that ``recursion`` has for the same values, each once; its own go."""
    result: Program = in_drawn_field(
        lambda field: _labelled(program, recursion, field), digest(program), digest(recursion)
    )
    return result


def _labelled(program: Program, recursion: Program, field: Field) -> Program:
    names: dict[int, Label] = {}
    for value, operation in zip(values_in(recursion, field), recursion.operations, strict=True):
        if operation.label is not None:
            names.setdefault(value, operation.label)
    used: set[Label] = set()
    operations = []
    for value, operation in zip(values_in(program, field), program.operations, strict=True):
        label = names.get(value)
        if label is None and value and (opposite := names.get(field.prime - value)) is not None:
            label = opposite.flipped()
        if label is not None and label._replace(negative=False) in used:
            label = None
        if label is not None:
            used.add(label._replace(negative=False))
        operations.append(operation._replace(label=label))
    return replace(program, operations=tuple(operations), origin=None)


def values_in(program: Program, field: Field) -> tuple[int, ...]:
    """The value of each operation at a random point of ``field``."""
    everything = replace(program, outputs=(("all", tuple(range(len(program.operations)))),), origin=None)
    return fingerprint(everything, field, circle_point)
