"""Batches: a function on many states at once, as lanes of the processor's vectors.

Three files beside ``NAME.h``: ``NAME_batch.h``, ``NAME_batch.c``, and ``NAME_lanes.h``, the kernels on as
many states as a vector has lanes, which ``NAME_batch.c`` includes once for each width of vectors that it may
meet. Vectors are those of gcc and clang (``vector_size``), which every target has, by instructions or one by
one; other compilers get lanes of one state. Each lane is rounded as the operation alone is.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Final

from robodyn.dynamics.functions import array_named, function_named
from robodyn.emit.c_syntax import c_spelling, c_syntax, prototype, refused
from robodyn.emit.head import head_of
from robodyn.emit.render import environment
from robodyn.emit.spelling import call
from robodyn.emit.statements import Apply, Body, Expression, Statement, statements
from robodyn.emit.trig import builtin_context
from robodyn.emit.unit import Unit
from robodyn.errors import InputError
from robodyn.ir.program import Input, Program
from robodyn.ir.signature import Signature
from robodyn.passes.registers import registers

#: Bytes of the vectors (SSE2 and NEON, AVX2, AVX-512), and of a line of the cache of x86-64 and most ARM, one
#: of the widest: a block of states is as wide as that.
WIDTHS: Final = (16, 32, 64)
LINE: Final = 64

#: Blocks that are copied at once where the array's own are larger. A choice: the tiles of functions of some
#: 200 numbers a state take less than 64 KiB of a thread's stack.
TILE: Final = 4

#: Bytes of results from which on they are written past the caches: half of the 2 MiB that the second level of
#: recent processors holds for each of their cores. Smaller ones are at hand for what comes next.
STREAMED: Final = 1 << 20

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
        raise InputError(
            f"{straight[0][0].symbol} remembers between calls: its states come one after another in time",
            expected="a function without memory",
            remedy="leave out the effects with memory, or call it state by state",
        )
    name = unit.robot.name
    used = {operation.op for _, program in able for operation in program.operations}
    numbers, lanes = (
        builtin_context(
            c_syntax(c_spelling(single=unit.single), real),
            sines=not used.isdisjoint({"sin", "cos"}),
            arctangents="atan2" in used,
        )
        for real in (f"{name}_real", "LANES_VEC")
    )
    context: dict[str, Any] = {
        "name": name,
        "upper": name.upper(),
        "bytes": 4 if unit.single else 8,
        "block": LINE // (4 if unit.single else 8),
        "widths": [width // (4 if unit.single else 8) for width in WIDTHS],
        "suffix": "f" if unit.single else "",
        "functions": [_function(signature, program) for signature, program in able],
        "helpers": [helper for helper in _HELPERS if helper in used],
        **numbers,
        "lanes_trig": lanes["trig"],
        "lanes_arctangent": lanes["arctangent"],
        "refused": refused(numbers),
        "tile": TILE,
        "streamed": STREAMED,
        "chunk": CHUNK,
    }
    calls = _notes(unit)
    notes = {"batch.h": calls, "batch.c": calls, "lanes.h": [_LANES.format(name=name)]}
    return {
        f"{name}_{part}": environment()
        .get_template(f"c/{part}.j2")
        .render(context, head=head_of(unit.robot, lines))
        for part, lines in notes.items()
    }


def _notes(unit: Unit) -> list[str]:
    notes = [
        "Many states in one call, as lanes of the processor's vectors.",
        "Arrays, in SI units:",
        *(f"  {array:4} {array_named(array).text}" for array in unit.arrays),
        "States stand in blocks of `block`: of n elements a state, element j of state k is "
        "[(k/block*n + j)*block + k%block]. 1: states one after another; count or more: the values of each "
        f"element one after another. Blocks of {unit.robot.name.upper()}_BATCH_BLOCK are read and written in "
        f"place, fastest where they begin with a line of the cache ({LINE} bytes); others are copied, a few "
        "states at a time. What is behind the last state is not touched. ..._batch_rows: block is 1.",
        "count may be any number, 0 too. No alignment is asked for. What is written must not overlap what is "
        "read. States do not touch each other: any number of threads may work on parts of a batch, and with "
        f"-fopenmp a batch of more than {CHUNK} states is shared among threads.",
    ]
    if unit.sc:
        notes += ["sc, the sines and cosines:", *(f"  element {k}: {text}" for k, text in enumerate(unit.sc))]
    return notes


def _function(s: Signature, program: Program) -> dict[str, Any]:
    """A function as text for the templates."""
    body = statements(registers(program), in_order=True)
    read = {array: sorted(x.index or 0 for x in body.inputs if x.is_of(array)) for array, _ in s.inputs}
    real = f"{s.robot}_real"

    def arguments(restrict: str) -> list[str]:
        arrays = [f"const {real} *{restrict}{array}" for array, _ in s.inputs]
        arrays += [f"{real} *{restrict}{array}" for array, _ in s.outputs]
        return [*arrays, f"const {s.robot}_params *p"] if s.parameters else arrays

    def head(name: str, first: str, restrict: str) -> str:
        return prototype(f"{name}(", [first, *arguments(restrict)]) + ")"

    lanes = f"static void LANES_NAME({s.called}"
    tiles = "size_t first, size_t last, size_t block, int stream"
    unread = s.parameters and all(x.index is not None for x in body.inputs)
    return {
        "name": s.called,
        "purpose": function_named(s.function).purpose,
        "symbol": s.symbol,
        "batch": head(f"void {s.symbol}_batch", "size_t count, size_t block", ""),
        "rows": head(f"void {s.symbol}_batch_rows", "size_t count", ""),
        "kernel": head(f"{lanes})", "size_t count, size_t step, int stream", "RESTRICT "),
        "tiles": head(f"{lanes}_tiles)", tiles, ""),
        "longest": max(size for _, size in (*s.inputs, *s.outputs)),
        "written": sum(size for _, size in s.outputs),
        "inputs": [{"name": array, "size": size, "read": read[array]} for array, size in s.inputs],
        "outputs": [{"name": array, "size": size} for array, size in s.outputs],
        "arrays": [array for array, _ in (*s.inputs, *s.outputs)],
        "reads": any(read.values()),
        "unused": [array for array, elements in read.items() if not elements] + (["p"] if unread else []),
        "p": ", p" if s.parameters else "",
        "lines": _Lines(s, body).lines,
    }


class _Lines:
    """The statements of a function on vectors."""

    def __init__(self, signature: Signature, body: Body) -> None:
        scalar = c_spelling(single=signature.scalar == "float")
        functions = {op: call(f"LANES_NAME({op})") for op in _HELPERS} | {"atan2": call("LANES_ATAN2")}
        vector = replace(scalar, element=lambda array, j: f"LANES_AT({array}, {j})", functions=functions)
        self._scalar, self._vector = (
            replace(c_syntax(spelling, real), indent=" " * 8)
            for spelling, real in ((scalar, f"{signature.robot}_real"), (vector, "LANES_VEC"))
        )
        #: Names of values that are the same in all states: they come of constants and parameters alone.
        self._uniform: set[str] = set()
        self._angles = {s.name: s.expression for s in body.statements if s.angle}
        #: For each angle, what its sine and its cosine are called.
        self._trig: dict[Expression, dict[str, str]] = {}
        for s in body.statements:
            if isinstance(s.expression, Apply) and s.expression.op in ("sin", "cos"):
                self._trig.setdefault(s.expression.args[0], {})[s.expression.op] = s.name
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
        if isinstance(e, Apply) and e.op in ("sin", "cos"):
            argument = e.args[0]
            e = self._angles.get(argument, argument) if isinstance(argument, str) else argument
        elif not statement.angle:
            return False
        return _only_inputs(e)

    def _statement(self, s: Statement) -> None:
        e = s.expression
        if isinstance(e, Apply) and e.op in ("sin", "cos"):
            self._sine(e.args[0])
        elif self._same(e):
            self._uniform.add(s.name)
            self.lines += self._scalar.statement(Statement(s.name, e))
        else:
            self.lines += self._vector.statement(Statement(s.name, self._lifted(e)))

    def _sine(self, angle: Expression) -> None:
        """Sine and cosine of one angle, at the first of them."""
        key = self._vector.spelling.text(self._lifted(angle))
        if key in self._paired:
            return
        self._paired.add(key)
        pair = self._trig[angle]
        sine, cosine = (pair.get(op, f"{op}_not_used_{len(self._paired)}") for op in ("sin", "cos"))
        if len(pair) < 2:
            self._add(f"LANES_VEC {next(iter(pair.values()))};")
            self._add(f"LANES_VEC {cosine if 'sin' in pair else sine};")
        else:
            self._add(f"LANES_VEC {sine}, {cosine};")
        self._add(f"LANES_SINCOS({self._lanes(angle)}, &{sine}, &{cosine});")

    def _lanes(self, e: Expression) -> str:
        if self._same(e):
            return f"LANES_NAME(all)({self._scalar.spelling.text(e)})"
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


def _only_inputs(e: Expression) -> bool:
    return all(map(_only_inputs, e.args)) if isinstance(e, Apply) else not isinstance(e, str)
