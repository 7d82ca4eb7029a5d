"""The walk of the C code in the folder ``c``, compiled on first use, over a program's network."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from fractions import Fraction
from importlib.resources import files
from pathlib import Path
from typing import Any

from robodyn.ir.graph import Graph, Scalar
from robodyn.ir.lowering import lower
from robodyn.ir.program import Program
from robodyn.passes.replay import grouped
from robodyn.search.network import (
    ADD,
    BELOW,
    FURTHER,
    LEAF,
    OFFSET,
    POINTS,
    SCALE,
    STATES,
    Network,
    NoWalk,
    Row,
    fraction,
    network,
)  # fmt: skip

_DECLARED = """
typedef struct walk walk;
walk *walk_new(int, int, int, int, int, const int *, const int *, const uint64_t *, const double *,
               const double *, const int *, int, double, uint64_t);
void walk_free(walk *);
int walk_run(walk *, long, double);
int walk_cost(const walk *);
double walk_error(const walk *);
long walk_count(const walk *, int);
int walk_best(const walk *, int *, int *, uint64_t *);
"""
_FLAGS = ("-std=gnu11", "-O3")
_SLOTS = 4096
#: So many primes tell the constants of a program from all others.
_FEW = 3

#: What a walk makes small besides weights: nothing; fused multiply-adds as one; the longest chain.
SUM, FUSED, CHAIN = range(3)

#: How far single precision may be off the truth, in the largest torque: well within what `verify` allows.
TOLERANCE = 2e-6


class Walk:
    """A random walk from ``programs[0]``; the others lend it their values.

    ``weights`` are what an addition and a multiplication cost. Runs of several walks in threads go side by
    side: the C code holds no lock.

    Raises
    ------
    ToolError: there is no C compiler, or it refuses.
    NoWalk: there is nothing to rewrite.
    """

    def __init__(
        self,
        programs: Sequence[Program],
        *,
        seed: int,
        objective: int = SUM,
        weights: tuple[int, int] = (1, 1),
        tolerance: float = TOLERANCE,
    ) -> None:
        self._ffi, self._library = library()
        self._network: Network = network(programs, seed=seed)
        new = self._ffi.new
        rows = self._network.rows
        leaves = len(self._network.leaves)
        targets = self._network.targets
        if not targets:
            raise NoWalk("there is nothing to rewrite")
        add, mul = weights
        handle = self._library.walk_new(
            leaves,
            len(rows) - leaves,
            len(targets),
            self._network.primes,
            STATES,
            new("int[]", [x for row in rows for x in (row.op, row.a, row.b, row.sign)]),
            new("int[]", targets),
            new("uint64_t[]", [x for values in self._network.residues for x in values]),
            new("double[]", [high for values in self._network.truth for high, _ in values]),
            new("double[]", [low for values in self._network.truth for _, low in values]),
            new("int[]", [0, add, mul, mul, add]),
            objective,
            tolerance,
            seed,
        )
        if handle == self._ffi.NULL:
            raise NoWalk("too large, or out of memory")
        self._walk = self._ffi.gc(handle, self._library.walk_free)

    def run(self, steps: int, temperature: float) -> int:
        """Take ``steps`` steps; the least cost so far. At temperature t a step that costs x more than before
        is taken with a probability of exp(-x / t)."""
        return int(self._library.walk_run(self._walk, steps, temperature))

    @property
    def error(self) -> float:
        """How far single precision is off the truth at the sample states, in the largest torque."""
        return float(self._library.walk_error(self._walk))

    @property
    def counts(self) -> dict[str, int]:
        """Steps tried and taken, steps refused for their rounding, and identities that held by chance."""
        names = ("steps", "taken", "refused", "false")
        return {name: int(self._library.walk_count(self._walk, k)) for k, name in enumerate(names)}

    def best(self) -> Program:
        """The program of the least cost.

        Raises
        ------
        NoWalk: one of its constants is too large a fraction to be recovered.
        """
        width = len(self._network.residues[0])
        ids, ops = self._ffi.new("int[]", _SLOTS), self._ffi.new("int[]", 4 * _SLOTS)
        residues = self._ffi.new("uint64_t[]", _SLOTS * width)
        n = self._library.walk_best(self._walk, ids, ops, residues)
        rows = [Row(*ops[4 * i : 4 * i + 4]) for i in range(n)]
        values = self._ffi.unpack(residues, n * width)
        outputs = [values[i * width : (i + 1) * width] for i in range(n)]
        return rebuilt(self._network, self._ffi.unpack(ids, n), rows, outputs)


def rebuilt(
    source: Network, ids: Sequence[int], rows: Sequence[Row], residues: Sequence[Sequence[int]]
) -> Program:
    """The program of what a walk has found: ``rows`` with their ``ids``, operands first.

    Factors and offsets are recovered from their residues as the fractions they are.

    Raises
    ------
    NoWalk: a constant is no fraction of the size that the primes allow.
    """
    moduli = [(1 << 61) - BELOW[k] for k in range(source.primes)]
    at = [0] + [POINTS + FURTHER * k for k in range(source.primes - 1)]
    # Nothing is folded: (x + c) + (y + d) has been found to cost less than (x + y) + (c + d), x + x than 2 x.
    graph = Graph(fold=False)
    program = source.program
    own = _own_constants(program, moduli[:_FEW])
    values = graph.replay_all(program)
    nodes: dict[int, Scalar] = {}
    residue_of = {i: residues[k] for k, i in enumerate(ids)}

    def recovered(i: int, j: int, quotient: bool, sign: int = 1) -> Fraction:
        parts = []
        for p, r in zip(moduli, at, strict=True):
            x, a = residue_of[i][r], residue_of[j][r]
            parts.append(x * pow(a, -1, p) % p if quotient else (x - sign * a) % p)
            if len(parts) == _FEW and (known := own.get(tuple(parts))) is not None:
                return known
        return fraction(parts, moduli)

    for i, row in zip(ids, rows, strict=True):
        if row.op == LEAF:
            operand = source.leaves[i]
            nodes[i] = values[operand] if isinstance(operand, int) else graph.input(*operand)  # type: ignore[misc]
            continue
        if row.op == SCALE:
            nodes[i] = nodes[row.a] * recovered(i, row.a, quotient=True)
            continue
        if row.op == OFFSET:
            nodes[i] = row.sign * nodes[row.a] + recovered(i, row.a, quotient=False, sign=row.sign)
            continue
        p = moduli[0]
        a, b = residue_of[row.a][0], residue_of[row.b][0]
        if row.op == ADD:
            nodes[i] = nodes[row.a] + row.sign * nodes[row.b]
            image = (a + row.sign * b) % p
        else:
            nodes[i] = nodes[row.a] * nodes[row.b]
            image = a * b % p
        if image != residue_of[i][0]:
            nodes[i] = -nodes[i]
    results = [out if isinstance(out, Fraction) else nodes[out[0]] * out[1] for out in source.outputs]
    return lower(graph, grouped(program, results))


def _own_constants(program: Program, moduli: Sequence[int]) -> dict[tuple[int, ...], Fraction]:
    """Constants of ``program``, their negatives and reciprocals by their residues: these come back however
    long they are, and at once."""
    constants: dict[tuple[int, ...], Fraction] = {}
    for c in {arg for operation in program.operations for arg in operation.args if isinstance(arg, Fraction)}:
        for x in (c, -c, *((1 / c, -1 / c) if c else ())):
            constants[tuple(x.numerator * pow(x.denominator, -1, p) % p for p in moduli)] = x
    return constants


@functools.cache
def library() -> tuple[Any, Any]:
    """The compiled walk, and the ffi that it is bound with; from the cache of kernels if it is there."""
    import cffi

    from robodyn.toolchain.cache import Cache, content_key
    from robodyn.toolchain.compiler import find_c

    home = files("robodyn.search").joinpath("c")
    sources = {
        item.name: item.read_text(encoding="utf-8")
        for item in home.iterdir()
        if item.name.endswith((".c", ".h"))
    }
    compiler = find_c()

    def build(folder: Path) -> str:
        for name, text in sources.items():
            (folder / name).write_text(text, encoding="utf-8")
        library = compiler.compile("walk.c", flags=_FLAGS, folder=folder)
        compiler.link([library], "walk.so", flags=(), folder=folder, extension=False)
        return "walk.so"

    path = Cache().fetch(content_key(["walk", sources, compiler.identity, *_FLAGS]), build)
    ffi = cffi.FFI()
    ffi.cdef(_DECLARED)
    return ffi, ffi.dlopen(str(path))
