"""What the templates are told of one function, in any language: statements, results, words about it."""

from __future__ import annotations

import textwrap
from typing import Any

from robodyn.counts.count import Count
from robodyn.dynamics.functions import function_named
from robodyn.emit.body import body_lines
from robodyn.emit.head import contained
from robodyn.emit.language import FunctionText, Language
from robodyn.emit.spelling import WIDTH
from robodyn.emit.statements import Body
from robodyn.emit.unit import Unit, counted_text
from robodyn.ir.signature import Signature


def function_text(
    language: Language, signature: Signature, counted: Count, body: Body, unit: Unit
) -> dict[str, Any]:
    """``body`` as ``language``'s templates place it."""
    syntax = language.syntax(signature, unit)
    lines = body_lines(body, syntax, builtin=unit.builtin, lanes=unit.lanes, early_writes=unit.early_writes)
    read = body.arrays
    unused = [array for array, _ in signature.inputs if array not in read]
    if signature.parameters and not body.reads_parameters:
        unused.append("p")
    if signature.states and "dt" not in read:
        unused.append("dt")
    rereads = not unit.builtin and any(syntax.rereads(s.expression) for s in body.statements)
    return {
        "symbol": signature.symbol,
        "purpose": function_named(signature.function).purpose,
        "contains": textwrap.wrap(_contains(signature, unit), WIDTH, break_on_hyphens=False),
        "counted": textwrap.wrap(counted_text(counted), WIDTH, break_on_hyphens=False),
        "unused": unused,
        **language.function(FunctionText(signature, unit, lines, tuple(unused), rereads)),
    }


def _contains(signature: Signature, unit: Unit) -> str:
    """What of the drives is in a function's torques; empty if nothing is."""
    function = function_named(signature.function)
    taken = {array.name for array in function.inputs}
    drives: tuple[str, ...] = ()
    if "qd" in taken:
        drives = contained(unit.robot, accelerated="qdd" in taken or function.solves)
    return f"with {', '.join(drives)}" if drives else ""
