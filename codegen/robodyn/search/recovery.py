"""Back from residues to a program: the constants of a network as the fractions that they are."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from robodyn.ir.graph import Graph, Scalar
from robodyn.ir.lowering import lower
from robodyn.ir.program import Program
from robodyn.passes.replay import grouped
from robodyn.search.network import ADD, BELOW, FURTHER, LEAF, OFFSET, POINTS, SCALE, Network, Row
from robodyn.search.reconstruction import fraction


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


#: So many primes tell the constants of a program from all others.
_FEW = 3


def _own_constants(program: Program, moduli: Sequence[int]) -> dict[tuple[int, ...], Fraction]:
    """Constants of ``program``, their negatives and reciprocals by their residues: these come back however
    long they are, and at once."""
    constants: dict[tuple[int, ...], Fraction] = {}
    for c in {arg for operation in program.operations for arg in operation.args if isinstance(arg, Fraction)}:
        for x in (c, -c, *((1 / c, -1 / c) if c else ())):
            constants[tuple(x.numerator * pow(x.denominator, -1, p) % p for p in moduli)] = x
    return constants
