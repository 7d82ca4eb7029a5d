"""Any x86-64: SSE2, no fused multiply-add."""

from robodyn.targets.target import Chip, Costs, Target

TARGET = Target(
    name="x86-64",
    title="x86-64, SSE2",
    why="no fused multiply-add",
    flags=(),
    lanes=4,
    single=Costs(div=4.0, sqrt=5.0, sincos=20.0),
    chip=Chip(
        3000.0,
        "a desktop; cycles as robodyn's searches weigh them (--objective weighted), usual clock, "
        "100 ns a value",
        cores=8,
        passing_ns=100.0,
    ),
)
