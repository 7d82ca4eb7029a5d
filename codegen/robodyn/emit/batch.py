"""Batches: a function on many states at once, as lanes of the processor's vectors.

Three files beside ``NAME.h``: ``NAME_batch.h``, ``NAME_batch.c``, and ``NAME_lanes.h``, the kernels on as
many states as a vector has lanes, which ``NAME_batch.c`` includes once for each width of vectors that it may
meet. Vectors are those of gcc and clang (``vector_size``), which every target has, by instructions or one by
one; other compilers get lanes of one state. Each lane is rounded as the operation alone is.
"""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from robodyn.dynamics.functions import array_named, function_named
from robodyn.emit.c_syntax import c_builtin, c_spelling, c_syntax
from robodyn.emit.lines import head_of
from robodyn.emit.render import Unit, environment
from robodyn.emit.spelling import WIDTH, Spelling
from robodyn.emit.statements import Apply, Body, Expression, Statement, statements
from robodyn.emit.syntax import Syntax
from robodyn.errors import InputError
from robodyn.ir.program import Input
from robodyn.ir.signature import Signature
from robodyn.passes.registers import registers

#: States that one call of a kernel on rows turns into columns: enough for the widest vectors, few enough for
#: the stack of a thread.
TILE = 32

#: States that OpenMP hands to a thread at least.
CHUNK = 1024

#: What is done lane by lane or with masks, in the order in which the functions stand in the file.
_HELPERS = ("sign", "abs", "sqrt", "tanh", "exp", "pow", "select")

_LANES = (
    "The kernels on as many states at once as a vector of LANES_BYTES bytes has lanes (0: one). A part of "
    "{name}_batch.c, which includes it once a width; of no use alone. No include guard."
)


def batch_files(unit: Unit) -> dict[str, str]:
    """``NAME_batch.h``, ``NAME_batch.c`` and ``NAME_lanes.h``: text by file name.

    Functions that remember between calls, or repeat a step, are left out.

    Raises
    ------
    InputError: all of them do, or a number does not fit.
    """
    straight = [each for each in unit.functions if each[1].iteration is None]
    if not straight:
        unit.functions[0][1].straight("batches on vectors are")
    able = [(signature, program) for signature, program in straight if not signature.states]
    if not able:
        signature = unit.functions[0][0]
        raise InputError(
            f"{signature.symbol} remembers between calls: its states come one after another in time",
            expected="a function without memory",
            remedy="leave out the effects with memory, or call it state by state",
        )
    name = unit.robot.name
    single = able[0][0].scalar == "float"
    functions = [
        _Function(signature, statements(registers(program), in_order=True)) for signature, program in able
    ]
    used = {op for function in functions for op in _operations(function.body)}
    context: dict[str, Any] = {
        "name": name,
        "upper": name.upper(),
        "bytes": 4 if single else 8,
        "single": single,
        "suffix": "f" if single else "",
        "functions": [function.context() for function in functions],
        "helpers": [helper for helper in _HELPERS if helper in used],
        **c_builtin(name, single=single, sines="sin" in used or "cos" in used, arctangents="atan2" in used),
        "tile": TILE,
        "chunk": CHUNK,
    }
    calls = _notes(able[0][0], unit)
    notes = {"batch.h": calls, "batch.c": calls, "lanes.h": [_LANES.format(name=name)]}
    return {
        f"{name}_{part}": environment()
        .get_template(f"c/{part}.j2")
        .render(context, head=head_of(unit.robot, lines))
        for part, lines in notes.items()
    }


def _notes(signature: Signature, unit: Unit) -> list[str]:
    real = f"{signature.robot}_real"
    arrays = dict.fromkeys(a for s, _ in unit.functions for a, _ in (*s.inputs, *s.outputs))
    notes = [
        "Many states in one call, as lanes of the processor's vectors.",
        "Arrays, in SI units:",
        *(f"  {array:4} {array_named(array).text}" for array in arrays),
        f"..._batch: element j of state k is [j*stride + k], stride >= count: every joint's values stand one "
        f"after another. ..._batch_rows: it is [k*n + j], n the elements of a state ({real} each).",
        "count may be any number, 0 too. No alignment is asked for. What is written must not overlap what is "
        "read. States do not touch each other: any number of threads may work on parts of a batch, and with "
        f"-fopenmp a batch of more than {CHUNK} states is shared among threads.",
    ]
    if unit.sc:
        notes += ["sc, the sines and cosines:", *(f"  element {k}: {text}" for k, text in enumerate(unit.sc))]
    return notes


@dataclass(frozen=True, slots=True)
class _Function:
    """A function as text for the templates."""

    signature: Signature
    body: Body

    def context(self) -> dict[str, Any]:
        """What the templates ask for."""
        s = self.signature
        real = f"{s.robot}_real"
        read = _read(self.body)
        arguments = [f"const {real} *{array}" for array, _ in s.inputs]
        arguments += [f"{real} *{array}" for array, _ in s.outputs]
        parameter = [f"const {s.robot}_params *p"] if s.parameters else []
        own = [f"const {real} *RESTRICT {array}" for array, _ in s.inputs]
        own += [f"{real} *RESTRICT {array}" for array, _ in s.outputs]
        reads_parameters = any(j is None for _, j in read)
        inputs = [array for array, _ in s.inputs]
        return {
            "name": s.called,
            "purpose": function_named(s.function).purpose,
            "columns": _prototype(
                f"void {s.symbol}_batch(", ["size_t count, size_t stride", *arguments, *parameter]
            ),
            "rows": _prototype(f"void {s.symbol}_batch_rows(", ["size_t count", *arguments, *parameter]),
            "kernel": _prototype(
                f"static void LANES_NAME({s.called})(", ["size_t count, size_t stride", *own, *parameter]
            ),
            "kernel_rows": _prototype(
                f"static void LANES_NAME({s.called}_rows)(", ["size_t count", *own, *parameter]
            ),
            "kernel_columns": _prototype(
                f"static void LANES_NAME({s.called}_columns)(",
                ["size_t count, size_t stride", *own, *parameter],
            ),
            "inputs": [
                {"name": a, "size": n, "read": [j for j in range(n) if (a, j) in read]} for a, n in s.inputs
            ],
            "outputs": [{"name": a, "size": n} for a, n in s.outputs],
            "arrays": [*inputs, *(array for array, _ in s.outputs)],
            "reads": any(j is not None for _, j in read),
            "unused": [array for array in inputs if not any(a == array and j is not None for a, j in read)]
            + (["p"] if s.parameters and not reads_parameters else []),
            "p": ", p" if s.parameters else "",
            "lines": _Lines(s, self.body).lines,
        }


class _Lines:
    """The statements of a function on vectors."""

    def __init__(self, signature: Signature, body: Body) -> None:
        single = signature.scalar == "float"
        scalar = c_spelling(single=single)
        self._scalar = _indented(c_syntax(scalar, f"{signature.robot}_real", libm=False))
        self._vector = _indented(c_syntax(_on_lanes(scalar), "LANES_VEC", libm=False))
        #: Names of values that are the same in all states: they come of constants and parameters alone.
        self._uniform: set[str] = set()
        self._angles = {s.name: s.expression for s in body.statements if s.angle}
        self._trig = _trig_of(body)
        self._paired: set[str] = set()
        self.lines: list[str] = []
        # Sines first, where the inputs give them: they need many registers, the rest of the kernel has them
        # to itself then.
        for s in body.statements:
            if self._from_inputs(s):
                self._statement(s)
        # Results as soon as they are there: what is written needs no register any more.
        due: dict[Expression, list[tuple[str, int]]] = {}
        for array, elements in body.outputs:
            for j, e in enumerate(elements):
                due.setdefault(e, []).append((array, j))
        for s in body.statements:
            if not self._from_inputs(s):
                self._statement(s)
                self._results(s.name, due.pop(s.name, []))
        for e, places in due.items():
            self._results(e, places)

    def _results(self, e: Expression, places: list[tuple[str, int]]) -> None:
        for array, j in places:
            self._add(f"LANES_PUT({array}, {j}, {self._lanes(e)});")

    def _from_inputs(self, statement: Statement) -> bool:
        e = statement.expression
        if statement.angle:
            return _only_inputs(e)
        if isinstance(e, Apply) and e.op in ("sin", "cos"):
            argument = e.args[0]
            return _only_inputs(
                self._angles.get(argument, argument) if isinstance(argument, str) else argument
            )
        return False

    def _statement(self, s: Statement) -> None:
        e = s.expression
        if isinstance(e, Apply) and e.op in ("sin", "cos"):
            self._sine(e)
            return
        if self._same(e):
            self._uniform.add(s.name)
            self.lines += self._scalar.statement(Statement(s.name, e))
            return
        self.lines += self._vector.statement(Statement(s.name, self._lifted(e)))

    def _sine(self, e: Apply) -> None:
        """Sine and cosine of one angle, at the first of them."""
        key = self._text(e.args[0])
        if key in self._paired:
            return
        self._paired.add(key)
        pair = self._trig[e.args[0]]
        sine, cosine = (pair.get(op, f"{op}_not_used") for op in ("sin", "cos"))
        opened = len(pair) < 2  # the other one gets a name of its own, in a block's shadow
        if opened:
            self._add(f"LANES_VEC {next(iter(pair.values()))};")
            unused = sine if "sin" not in pair else cosine
            self._add(f"LANES_VEC {unused}_{len(self._paired)};")
            sine, cosine = (
                f"{name}_{len(self._paired)}" if name == unused else name for name in (sine, cosine)
            )
        else:
            self._add(f"LANES_VEC {sine}, {cosine};")
        self._add(f"LANES_SINCOS({self._lanes(e.args[0])}, &{sine}, &{cosine});")

    def _lanes(self, e: Expression) -> str:
        if self._same(e):
            return f"LANES_NAME(all)({self._scalar.spelling.text(e)})"
        return self._text(e)

    def _text(self, e: Expression) -> str:
        return self._vector.spelling.text(self._lifted(e))

    def _lifted(self, e: Expression) -> Expression:
        """``e`` with numbers that are the same in all states made vectors where a function wants vectors;
        operators mix the two by themselves."""
        if not isinstance(e, Apply):
            return e
        if e.op not in _HELPERS and e.op != "atan2":
            return Apply(e.op, tuple(map(self._lifted, e.args)))
        if self._same(e):
            return self._scalar.spelling.text(e)
        return Apply(e.op, tuple(map(self._lanes, e.args)))

    def _same(self, e: Expression) -> bool:
        if isinstance(e, str):
            return e in self._uniform
        if isinstance(e, Input):
            return e.index is None
        if isinstance(e, Apply):  # our own arctangent is there for vectors alone
            return e.op != "atan2" and all(map(self._same, e.args))
        return True

    def _add(self, text: str) -> None:
        self.lines += self._vector.line(text)


def _indented(syntax: Syntax) -> Syntax:
    return replace(syntax, indent=" " * 8)


def _on_lanes(scalar: Spelling) -> Spelling:
    def call(op: str) -> Callable[..., str]:
        return lambda *args: f"LANES_NAME({op})({', '.join(args)})"

    functions = {op: call(op) for op in _HELPERS} | {"atan2": lambda y, x: f"LANES_ATAN2({y}, {x})"}
    return replace(scalar, element=lambda array, j: f"LANES_AT({array}, {j})", functions=functions)


def _trig_of(body: Body) -> dict[Expression, dict[str, str]]:
    """For each angle, what its sine and its cosine are called."""
    angles: dict[Expression, dict[str, str]] = {}
    for s in body.statements:
        if isinstance(s.expression, Apply) and s.expression.op in ("sin", "cos"):
            angles.setdefault(s.expression.args[0], {})[s.expression.op] = s.name
    return angles


def _only_inputs(e: Expression) -> bool:
    if isinstance(e, str):
        return False
    return all(map(_only_inputs, e.args)) if isinstance(e, Apply) else True


def _nodes(body: Body) -> list[Expression]:
    nodes: list[Expression] = []
    stack: list[Expression] = [s.expression for s in body.statements]
    stack += [e for _, elements in body.outputs for e in elements]
    while stack:
        e = stack.pop()
        nodes.append(e)
        if isinstance(e, Apply):
            stack.extend(e.args)
    return nodes


def _operations(body: Body) -> set[str]:
    return {e.op for e in _nodes(body) if isinstance(e, Apply)}


def _read(body: Body) -> set[tuple[str, int | None]]:
    """Inputs that are read, as (array, index)."""
    return {(e.array, e.index) for e in _nodes(body) if isinstance(e, Input)}


def _prototype(head: str, arguments: list[str]) -> str:
    """``head`` with its arguments and a closing parenthesis, in lines of moderate length."""
    line = head + ", ".join(arguments) + ")"
    if len(line) < WIDTH:
        return line
    return head + "\n" + textwrap.indent(",\n".join(arguments), "    ") + ")"
