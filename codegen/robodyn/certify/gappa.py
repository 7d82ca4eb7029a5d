"""Gappa: scripts with every torque as it is computed beside what it should be, statement by statement;
running them, and reading the bounds."""

from __future__ import annotations

import math
import re
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, field, replace
from fractions import Fraction
from pathlib import Path

from robodyn.certify.forward import Forward, as_scalar, enclosed
from robodyn.certify.plan import last_lines, run
from robodyn.emit.spelling import Spelling
from robodyn.emit.statements import Apply, Expression, Statement, statements
from robodyn.errors import ToolError
from robodyn.ir.program import Input, Program
from robodyn.toolchain.running import Finished, end_all

_FORMAT = {"float": "ieee_32", "double": "ieee_64"}


@dataclass(slots=True)
class _Script:
    """What stands in one script, by its parts; ``literals`` names the constants."""

    inputs: dict[str, None] = field(default_factory=dict)
    literals: dict[Fraction, str] = field(default_factory=dict)
    computed: list[str] = field(default_factory=list)
    exact: list[str] = field(default_factory=list)
    hypotheses: list[str] = field(default_factory=list)


class Scripts:
    """Scripts for the outputs of ``program``; ``bounds`` are those of its operations, ranges and all.

    In a script ``x`` is the value that C computes, rounded after every operation by ``rnd=``, and ``E_x`` the
    same in real numbers, from the robot's exact numbers and the exact sine and cosine.
    """

    def __init__(self, program: Program, bounds: Forward) -> None:
        self.program, self.bounds = program, bounds
        self.body = statements(program)
        turning = iter([i for i, op in enumerate(program.operations) if op.op in ("sin", "cos")])
        self._statements = {s.name: s for s in self.body.statements}
        #: Sines and cosines always have names, and stand in the order of their operations.
        self._trig = {s.name: next(turning) for s in self.body.statements if _is_trig(s.expression)}

    def of(self, output: Expression, title: str) -> str:
        """The script for one element of an output; its last line asks for its range and its error."""
        script = _Script()
        live = set(self._live([output]))
        for name, statement in self._statements.items():
            if name in live:
                self._state(script, statement)
        result = self._text(output, script, exact=False)
        script.computed.append(f"result rnd= {result};")
        script.exact.append(f"E_result = {self._text(output, script, exact=True)};")
        for text in script.inputs:
            low, high = self._range(text)
            script.hypotheses.append(f"{text} in [{low},{high}]")
        constants = []
        for value, name in script.literals.items():
            rounded = as_scalar(value, self.bounds.scalar)
            constants.append(f"{name} = {rounded.hex()}; E_{name} = {_ratio(value)};  # {rounded!r}")
        rounding = f"@rnd = float<{_FORMAT[self.bounds.scalar]},ne>;"
        lines = [*(f"# {line}" for line in title.splitlines()), rounding]
        lines += ["# numbers: as C reads them, and exact", *constants]
        lines += ["# inputs are numbers of the type", *(f"{x} = rnd({x}_);" for x in script.inputs)]
        lines += ["# what C computes", *script.computed, "# what it should be", *script.exact]
        wanted = "result in ? /\\ result - E_result in ?"
        hypotheses = " /\\\n  ".join(script.hypotheses)
        return "\n".join([*lines, "{ " + hypotheses + ("\n  -> " if hypotheses else "") + wanted + " }", ""])

    def _state(self, script: _Script, statement: Statement) -> None:
        expression, name = statement.expression, statement.name
        if name in self._trig:
            error = self.bounds.values[self._trig[name]].error
            script.computed.append(f"{name} = rnd({name}_);  # {_spoken(expression)}")
            script.hypotheses += [f"E_{name} in [-1,1]", f"{name} - E_{name} in [-{error!r},{error!r}]"]
            return
        script.computed.append(f"{name} rnd= {self._text(expression, script, exact=False)};")
        script.exact.append(f"E_{name} = {self._text(expression, script, exact=True)};")

    def _live(self, wanted: list[Expression]) -> Iterator[str]:
        seen: set[str] = set()
        stack = [x for expression in wanted for x in _leaves(expression)]
        while stack:
            leaf = stack.pop()
            if isinstance(leaf, str) and leaf not in seen:
                seen.add(leaf)
                yield leaf
                if leaf not in self._trig:
                    stack.extend(_leaves(self._statements[leaf].expression))

    def _text(self, expression: Expression, script: _Script, *, exact: bool) -> str:
        def element(array: str, i: int) -> str:
            script.inputs[f"{array}{i + 1}"] = None
            return f"{array}{i + 1}"

        def known(expression: Expression) -> Expression:
            """The expression with names of constants and, if exact, of exact values."""
            if isinstance(expression, Fraction):
                name = script.literals.setdefault(expression, f"k{len(script.literals) + 1}")
                return f"E_{name}" if exact else name
            if isinstance(expression, str):
                return f"E_{expression}" if exact else expression
            if isinstance(expression, Apply) and expression.op == "sign":  # of an input: exact, shared
                (argument,) = expression.args
                assert isinstance(argument, Input)
                script.inputs[f"sign_{argument}"] = None
                return f"sign_{argument}"
            if isinstance(expression, Apply):
                return Apply(expression.op, tuple(map(known, expression.args)))
            return expression

        spelling = Spelling(
            literal=str, element=element, member=str, functions=_FUNCTIONS, single=False, continuation=""
        )
        return spelling.text(known(expression))

    def _range(self, text: str) -> tuple[str, str]:
        if text.startswith("sign_"):
            return "-1", "1"
        match = re.fullmatch(r"([a-z]+)([0-9]+)", text)
        assert match is not None
        low, high = self.bounds.ranges[Input(match[1], int(match[2]) - 1)]
        return _outwards(low, -1), _outwards(high, 1)


_FUNCTIONS = {"abs": lambda x: f"|{x}|"}


def _leaves(expression: Expression) -> Iterator[Expression]:
    if isinstance(expression, Apply):
        for arg in expression.args:
            yield from _leaves(arg)
    else:
        yield expression


def _is_trig(expression: Expression) -> bool:
    return isinstance(expression, Apply) and expression.op in ("sin", "cos")


def _spoken(expression: Expression) -> str:
    """A sine or cosine for a remark."""
    assert isinstance(expression, Apply)
    return f"{expression.op} {' '.join(map(str, _leaves(expression)))}"


def _ratio(value: Fraction) -> str:
    return str(value) if value.denominator == 1 else f"({value.numerator}/{value.denominator})"


def _outwards(value: Fraction, side: int) -> str:
    """A decimal of 20 digits at or beyond ``value``."""
    scale = 10**20
    whole = math.floor(value * scale) if side < 0 else math.ceil(value * scale)
    sign = "-" if whole < 0 else ""
    return f"{sign}{abs(whole) // scale}.{abs(whole) % scale:020d}".rstrip("0").rstrip(".")


#: Gappa's enclosure: ``[low, high]``, each a dyadic number, and decimals in braces for people.
_ENCLOSURE = r"\[(\S+)(?: \{[^}]*\})?, (\S+?)(?: \{[^}]*\})?\]"
_DYADIC = re.compile(r"(-?[0-9]+)(?:b(-?[0-9]+))?\Z")


@dataclass(frozen=True, slots=True)
class Proven:
    """What Gappa says of one script: where the computed value lies, and how far from the exact one at most.

    ``error`` None: no bound, and ``reason`` says why.
    """

    low: float | None = None
    high: float | None = None
    error: float | None = None
    reason: str = ""
    seconds: float = 0.0


def prove(
    gappa: str,
    folder: Path,
    scripts: Sequence[str],
    *,
    seconds: float,
    workers: int,
    progress: Callable[[int], None],
) -> list[Proven]:
    """Run Gappa on ``scripts`` (files in ``folder``), ``workers`` at a time, ``seconds`` each at most;
    ``progress`` is told how many are done."""

    def bound(name: str) -> Proven:
        began = time.monotonic()
        proven = read(run([gappa, name], folder, seconds), seconds)
        return replace(proven, seconds=time.monotonic() - began)

    with ThreadPoolExecutor(workers) as pool:
        jobs = [pool.submit(bound, name) for name in scripts]
        try:
            for done, job in enumerate(as_completed(jobs), 1):
                job.result()
                progress(done)
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            while not all(job.done() for job in jobs):  # one may just be starting
                end_all()
                time.sleep(0.02)
            raise
    return [job.result() for job in jobs]


def read(done: Finished, seconds: float) -> Proven:
    """Gappa's answer, which it had ``seconds`` for, read."""
    if done.code is None:
        return Proven(reason=f"not finished after {seconds:g} s")
    value = re.search(rf"^\s*result in {_ENCLOSURE}", done.output, re.M)
    error = re.search(rf"^\s*result - E_result in {_ENCLOSURE}", done.output, re.M)
    # What is exact is told as a single number.
    none = re.search(r"^\s*result - E_result in \[0, 0\]", done.output, re.M)
    if done.code != 0 or value is None or (error is None and none is None):
        return Proven(reason=f"no bound found: {last_lines(done.output)}")
    low, high = (_number(text) for text in value.groups())
    sizes = [abs(_number(text)) for text in error.groups()] if error else [Fraction(0)]
    return Proven(enclosed(low)[0], enclosed(high)[1], enclosed(max(sizes))[1])


def _number(text: str) -> Fraction:
    match = _DYADIC.match(text)
    if match is None:
        raise ToolError("Gappa's answer cannot be read", found=text, expected="a number such as 12b-3")
    return Fraction(match[1]) * Fraction(2) ** int(match[2] or 0)
