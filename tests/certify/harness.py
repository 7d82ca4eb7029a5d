"""A kernel called with any bytes at all: as a program of its own, and as libFuzzer wants it."""

from __future__ import annotations

from collections.abc import Sequence

from robodyn.ir.signature import Signature

_HEAD = """\
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "NAME.h"

/* The next number of the bytes, whatever it is; 0 where they are at an end. */
static const uint8_t *bytes;
static size_t left;
static NAME_real next(void)
{
    NAME_real x = 0;
    if (left >= sizeof x) {
        memcpy(&x, bytes, sizeof x);
        bytes += sizeof x;
        left -= sizeof x;
    }
    return x;
}

static void same_and_finite(const char *what, const NAME_real *x, const NAME_real *y, int n, int tame)
{
    for (int i = 0; i < n; i++) {
        if (x[i] != y[i] && !(isnan(x[i]) && isnan(y[i]))) {
            fprintf(stderr, "%s[%d] differs from call to call\\n", what, i);
            abort();
        }
        if (tame && !isfinite(x[i])) {
            fprintf(stderr, "%s[%d] is not finite\\n", what, i);
            abort();
        }
    }
}
"""

_TAIL = """
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
CALLS    return 0;
}

#ifdef ALONE
/* 64 bits at a time: raw, or a number that is special, tame, subnormal or huge. */
static uint64_t state = 88172645463325252u;
static uint64_t draw(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

int main(void)
{
    static const double special[] = {
        0.0, -0.0, 1e-310, 1e308, 1e30, 6434.0, 411775.0, 1.5707963267948966, INFINITY, NAN,
    };
    uint8_t data[64*sizeof(NAME_real)];
    for (int run = 0; run < 20000; run++) {
        for (size_t i = 0; i < sizeof data; i += sizeof(NAME_real)) {
            const uint64_t bits = draw();
            const uint64_t kind = run % 4 == 0 ? 0 : draw() % 4;
            NAME_real x = (NAME_real)((double)(int64_t)bits/3e18);
            if (kind == 1)
                x = (NAME_real)special[bits % (sizeof special/sizeof special[0])];
            memcpy(data + i, &x, sizeof x);
            if (kind == 2)
                memcpy(data + i, &bits, sizeof x);
        }
        LLVMFuzzerTestOneInput(data, sizeof data);
    }
    return 0;
}
#endif
"""


def harness(signatures: Sequence[Signature]) -> str:
    """C that calls every function of ``signatures`` twice with the same inputs, and stops where the outputs
    differ, or where tame inputs (up to 100 each) give an output that is not finite."""
    name = signatures[0].robot
    parts = [_HEAD]
    calls = []
    for s in signatures:
        calls.append(f"    every_{s.symbol}(data, size);\n")
        parts.append(_one(s, name))
    return ("".join(parts) + _TAIL.replace("CALLS", "".join(calls))).replace("NAME", name)


def _one(s: Signature, name: str) -> str:
    assert not s.states
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
