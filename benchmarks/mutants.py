"""What the tests notice: changes of one operator or number in the rooms that carry the numbers.

    python benchmarks/mutants.py                    30 mutants, drawn with seed 1
    python benchmarks/mutants.py --count 300 --seed 7 --limit 600 -o build/mutants.json

A mutant is one change of the source: + becomes -, * becomes /, a minus sign goes, < becomes <=, a number is
one more. It is made in a copy of the commit that is checked out, and tests run there until one fails: first
those that import the module, then those of its room, then those that import the room. A test that fails must
pass without the change, or the mutant is not counted as killed. Survivors are to be read: some change
nothing.
"""

from __future__ import annotations

import argparse
import ast
import json
import os
import random
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Final

ROOT: Final = Path(__file__).parents[1]
ROOMS: Final = (
    *("ir", "effects", "dynamics", "drives", "passes"),
    *("optimize", "kernels", "emit", "simulate", "identify"),
)
_BINARY: Final = {ast.Add: ("+", "-"), ast.Sub: ("-", "+"), ast.Mult: ("*", "/"), ast.Div: ("/", "*")}
_ORDER: Final = {ast.Lt: ("<", "<="), ast.LtE: ("<=", "<"), ast.Gt: (">", ">="), ast.GtE: (">=", ">")}
_EQUAL: Final = {ast.Eq: ("==", "!="), ast.NotEq: ("!=", "==")}
_FAILED: Final = re.compile(r"^(?:FAILED|ERROR) (\S+::.*?|\S+)(?: - .*)?$", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class Mutant:
    """A change of ``before`` at byte ``start`` of a ``file`` of the checkout to ``after``."""

    file: str
    line: int
    start: int
    before: str
    after: str

    def made_in(self, source: bytes) -> bytes:
        """``source`` with the change."""
        end = self.start + len(self.before.encode())
        return source[: self.start] + self.after.encode() + source[end:]


@dataclass(frozen=True, slots=True)
class Verdict:
    """What became of a mutant: ``killed`` by ``test``, ``survived``, or ``undecided``: time ran out, or the
    test fails without the mutant too."""

    mutant: Mutant
    verdict: str
    test: str | None
    seconds: float


def mutants_of(path: Path, file: str) -> Iterator[Mutant]:
    """All mutants of a module."""
    source = path.read_bytes()
    starts = [0]
    for line in source.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))

    def begin(node: ast.expr) -> int:
        return starts[node.lineno - 1] + node.col_offset

    def end(node: ast.expr) -> int:
        return starts[(node.end_lineno or node.lineno) - 1] + (node.end_col_offset or 0)

    def between(left: ast.expr, right: ast.expr, change: tuple[str, str]) -> Iterator[Mutant]:
        at = source.find(change[0].encode(), end(left), begin(right))
        if at >= 0:
            yield Mutant(file, left.lineno, at, *change)

    for node in outside_of_texts(ast.parse(source)):
        if isinstance(node, ast.BinOp) and type(node.op) in _BINARY:
            if not any(isinstance(side, ast.JoinedStr) or is_text(side) for side in (node.left, node.right)):
                yield from between(node.left, node.right, _BINARY[type(node.op)])
        elif isinstance(node, ast.Compare):
            for left, op, right in zip(
                [node.left, *node.comparators], node.ops, node.comparators, strict=False
            ):
                if change := {**_ORDER, **_EQUAL}.get(type(op)):
                    yield from between(left, right, change)
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            yield Mutant(file, node.lineno, begin(node), "-", "+")
        elif isinstance(node, ast.Constant) and type(node.value) in (int, float):
            text = source[begin(node) : end(node)].decode()
            yield Mutant(file, node.lineno, begin(node), text, f"({text} + 1)")


def outside_of_texts(node: ast.AST) -> Iterator[ast.AST]:
    """All nodes but those in f-strings, whose places Python 3.11 does not know."""
    for child in ast.iter_child_nodes(node):
        if not isinstance(child, ast.JoinedStr):
            yield child
            yield from outside_of_texts(child)


def is_text(node: ast.expr) -> bool:
    """Whether an expression is a string that is written out."""
    return isinstance(node, ast.Constant) and isinstance(node.value, str)


def tests_of(file: str) -> list[list[str]]:
    """The modules of tests that may kill a mutant of ``file``, in groups, the likeliest first."""
    module = ".".join(Path(file).with_suffix("").parts[1:])
    room = ".".join(module.split(".")[:2])
    groups: list[list[str]] = [[], [], []]
    for path in sorted((ROOT / "tests").rglob("test_*.py")):
        text, name = path.read_text(encoding="utf-8"), path.relative_to(ROOT).as_posix()
        if re.search(rf"\b{re.escape(module)}\b", text):
            groups[0].append(name)
        elif name.startswith(f"tests/{room.rpartition('.')[2]}/"):
            groups[1].append(name)
        elif re.search(rf"\b{re.escape(room)}\b", text):
            groups[2].append(name)
    return [group for group in groups if group]


class Bench:
    """A copy of the checkout in a ``folder``, in which tests run."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        subprocess.run(["git", "clone", "--quiet", ROOT, folder], check=True)

    def failure(self, tests: list[str], seconds: float) -> str | None:
        """The first of ``tests`` that fails; None if none does. Raises ``TimeoutExpired``."""
        with tempfile.TemporaryDirectory() as cache:
            places = os.pathsep.join(str(self.folder / top) for top in ("codegen", "cli"))
            environment = {**os.environ, "PYTHONPATH": places, "ROBODYN_CACHE": cache}
            command = [sys.executable, "-m", "pytest", "-q", "-x", "-n0", "-rfE", "-p", "no:cacheprovider"]
            process = subprocess.Popen(
                [*command, *tests],
                cwd=self.folder,
                env=environment,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                start_new_session=True,
            )
            try:
                output, _ = process.communicate(timeout=seconds)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)  # what tests have started as well
                process.communicate()
                raise
        if process.returncode in (0, 5):  # 5: all were left out by their marks
            return None
        match = _FAILED.search(output)
        if match is None:
            raise RuntimeError(f"pytest ended with {process.returncode}:\n{output[-2000:]}")
        return match.group(1)

    def verdict(self, mutant: Mutant, limit: float) -> Verdict:
        """Make the ``mutant``, run tests for ``limit`` seconds at most, and undo it."""
        path, began = self.folder / mutant.file, time.monotonic()
        source = path.read_bytes()
        path.write_bytes(mutant.made_in(source))
        test = None
        try:
            for tests in tests_of(mutant.file):
                test = self.failure(tests, max(limit - (time.monotonic() - began), 1.0))
                if test is not None:
                    break
        except subprocess.TimeoutExpired:
            return Verdict(mutant, "undecided", None, time.monotonic() - began)
        finally:
            path.write_bytes(source)
        took = time.monotonic() - began
        if test is None:
            return Verdict(mutant, "survived", None, took)
        fails_anyway = self.failure([test], limit) is not None
        return Verdict(mutant, "undecided" if fails_anyway else "killed", test, took)


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--count", type=int, default=30, help="how many mutants (default 30)")
    parser.add_argument("--seed", type=int, default=1, help="which of them (default 1)")
    parser.add_argument("--limit", type=float, default=300.0, help="seconds of tests a mutant (default 300)")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "build" / "mutants.json")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(Path(folder) / "robodyn")
        files = [
            path.relative_to(bench.folder).as_posix()
            for room in ROOMS
            for path in sorted((bench.folder / "codegen" / "robodyn" / room).rglob("*.py"))
        ]
        possible = [mutant for file in files for mutant in mutants_of(bench.folder / file, file)]
        verdicts = []
        for mutant in random.Random(options.seed).sample(possible, options.count):
            verdicts.append(verdict := bench.verdict(mutant, options.limit))
            change = f"{mutant.file}:{mutant.line}: {mutant.before} to {mutant.after}"
            print(f"{verdict.verdict:9} {change} {verdict.test or ''}", flush=True)
    tally = Counter(verdict.verdict for verdict in verdicts)
    print(f"{tally['killed']} of {len(verdicts)} killed, {tally['undecided']} undecided; of {len(possible)}")
    options.output.parent.mkdir(parents=True, exist_ok=True)
    rows = [asdict(verdict) for verdict in verdicts]
    record = {"seed": options.seed, "limit": options.limit, **tally, "mutants": rows}
    options.output.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
