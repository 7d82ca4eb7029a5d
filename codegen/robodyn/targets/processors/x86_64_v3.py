"""x86-64-v3 (Haswell, Zen): a product, a sum or both fused in one slot."""

from robodyn.targets.target import Costs, Target

TARGET = Target(
    name="x86-64-v3",
    title="x86-64 with AVX2 and fused multiply-add",
    why="a fused multiply-add costs what a product does",
    flags=("-march=x86-64-v3",),
    level="-O3",  # poses and Jacobians up to 1.28 times faster than with -O2 (gcc 12), the rest as fast
    contraction="on",
    lanes=4,
    single=Costs(fma=1.0, div=4.0, sqrt=5.0, sincos=18.0),
)
