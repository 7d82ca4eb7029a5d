"""The C of calls from Python that need no Python: one state, in arrays that the kernel can read."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.emit.render import environment
from robodyn.ir.signature import Signature
from robodyn.kernels.function import array_of, optional_of, shapes_of
from robodyn.toolchain.library import DIRECT


def direct_calls(signatures: Sequence[Signature]) -> str:
    """The source of a module of Python with the functions among ``signatures`` that need nothing but arrays:
    no run-time parameters and no memory; "" where there is none."""
    chosen = [s for s in signatures if not s.parameters and not s.states]
    if not chosen:
        return ""
    template = environment().get_template("c/direct.c.j2")
    functions = [_function(s) for s in chosen]
    arrays = [function["arrays"] for function in functions]
    return template.render(
        module=DIRECT,
        robot=chosen[0].robot,
        scalar=chosen[0].scalar,
        functions=functions,
        axes=max([1, *(array["axes"] for each in arrays for array in each)]),
        longest=max(map(len, arrays)),
        converted=max(1, *(sum(a["size"] for a in each if a["says"] != "number") for each in arrays)),
        left_out=max([1, *(size for s in chosen for name, size in s.inputs if name in optional_of(s))]),
    )


def _function(s: Signature) -> dict[str, Any]:
    arrays = (*s.inputs, *s.outputs)
    shapes = [shape for each in shapes_of(s) for _, shape in each]
    name = f"{s.function}_robodyn_batch"  # of kernels.wrapper, with one state
    arguments = [f"const {s.scalar} *"] * len(s.inputs) + [f"{s.scalar} *"] * len(s.outputs)
    places = ", ".join(f"at[{k}]" for k in range(len(arrays)))
    return {
        "name": s.function,
        "needed": sum(name not in optional_of(s) for name, _ in s.inputs),
        "inputs": len(s.inputs),
        "outputs": len(s.outputs),
        "prototype": f"void {name}(ptrdiff_t, {', '.join(arguments)}, const {s.scalar} *)",
        "call": f"{name}(1, {places}, NULL)",
        "arrays": [
            {
                "axes": len(shape),
                "shape": ", ".join(map(str, shape)) or "0",
                "size": size,
                "says": array_of(name, size).says,
            }
            for (name, size), shape in zip(arrays, shapes, strict=True)
        ],
    }
