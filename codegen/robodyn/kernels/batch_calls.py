"""The C between Python and a batch kernel.

``F_robodyn_columns(count, stride, inputs..., outputs..., parameters)``
    runs F on ``count`` states, element j of state k at ``[j*stride + k]``;
``F_robodyn_rows(count, inputs..., outputs..., parameters)``
    runs F on states that stand one after another.
"""

from __future__ import annotations

from collections.abc import Sequence

from robodyn.ir.signature import Signature
from robodyn.toolchain.library import Calls


def batch_calls(signature: Signature, parameters: Sequence[str]) -> Calls:
    """The calls of ``signature``; run-time ``parameters`` are an array, in that order."""
    s = signature
    arrays = "".join(f", const {s.scalar} *i{k}" for k in range(len(s.inputs)))
    arrays += "".join(f", {s.scalar} *o{k}" for k in range(len(s.outputs)))
    arrays += f", const {s.scalar} *parameters"
    passed = "".join(f", i{k}" for k in range(len(s.inputs)))
    passed += "".join(f", o{k}" for k in range(len(s.outputs)))
    passed += ", &p" if s.parameters else ""
    fill = [f"    {s.robot}_params p = {{0}};"] if s.parameters else []
    fill += [f"    p.{name} = parameters[{k}];" for k, name in enumerate(parameters) if name in s.parameters]
    columns = f"void {s.function}_robodyn_columns(size_t count, size_t stride{arrays})"
    rows = f"void {s.function}_robodyn_rows(size_t count{arrays})"
    lines = [f"/* Calls from Python into the batches of {s.robot}. */", f'#include "{s.robot}_batch.h"']
    lines += [f"{columns};", f"{rows};"]
    for head, call in (
        (columns, f"{s.symbol}_batch(count, stride{passed});"),
        (rows, f"{s.symbol}_batch_rows(count{passed});"),
    ):
        lines += [head, "{", *fill, "    (void)parameters;", f"    {call}", "}"]
    return Calls(f"{columns};\n{rows};\n", "\n".join(lines) + "\n")
