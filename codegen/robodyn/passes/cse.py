"""Common subexpressions: equal operations, up to order and sign of their operands, become one."""

from __future__ import annotations

from robodyn.ir.lowering import lower
from robodyn.ir.program import Program
from robodyn.passes.replay import as_graph


def cse(program: Program) -> Program:
    """``program`` with equal operations merged and no algebra done."""
    return lower(*as_graph(program, fold=False))
