"""A kernel called with any bytes at all: as a program of its own, and as libFuzzer wants it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from robodyn.ir.signature import Signature


def harness(signatures: Sequence[Signature]) -> str:
    """C that calls every function of ``signatures`` twice with the same inputs, and stops where the outputs
    differ, or where tame inputs (up to 100 each) give an output that is not finite."""
    text = Path(__file__).with_suffix(".c").read_text(encoding="utf-8")
    functions = "".join(map(_one, signatures))
    calls = "".join(f"    every_{s.symbol}(data, size);\n" for s in signatures)
    text = text.replace("\nFUNCTIONS", functions).replace("CALLS", calls)
    return text.replace("NAME", signatures[0].robot)


def _one(s: Signature) -> str:
    assert not s.states
    name = s.robot
    given = [array for array, _ in s.inputs]
    extra = ["&p"] if s.parameters else []
    lines = [f"static void every_{s.symbol}(const uint8_t *data, size_t size)", "{", "    int tame = 1;"]
    lines += [f"    {name}_real {array}[{size}];" for array, size in s.inputs]
    lines += [f"    {name}_real {array}[{size}], {array}_again[{size}];" for array, size in s.outputs]
    if s.parameters:
        lines.append(f"    {name}_params p;")
    lines += ["    bytes = data;", "    left = size;"]
    for array, size in s.inputs:
        lines += [f"    for (int i = 0; i < {size}; i++) {{", f"        {array}[i] = next();"]
        lines += [f"        tame = tame && fabs((double){array}[i]) <= 100.0;", "    }"]
    for member in s.parameters:
        lines += [f"    p.{member} = next();", f"    tame = tame && fabs((double)p.{member}) <= 100.0;"]
    for again in ("", "_again"):
        arguments = [*given, *(array + again for array, _ in s.outputs), *extra]
        lines.append(f"    {s.symbol}({', '.join(arguments)});")
    finite = "0" if s.function == "forward_dynamics" else "tame"  # a pivot may be zero for odd parameters
    lines += [
        f'    same_and_finite("{array}", {array}, {array}_again, {size}, {finite});'
        for array, size in s.outputs
    ]
    return "\n" + "\n".join([*lines, "}"]) + "\n"
