"""Fold: constants into constants, ``k (l x)`` into ``(k l) x``, ``k x + l x`` into ``(k + l) x``."""

from __future__ import annotations

from robodyn.ir.lowering import lower
from robodyn.ir.program import Program
from robodyn.passes.replay import as_graph


def fold(program: Program) -> Program:
    """``program`` without arithmetic among constants and identities."""
    return lower(*as_graph(program, fold=True))
