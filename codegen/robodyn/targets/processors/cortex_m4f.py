"""Arm Cortex-M4 with the floating-point unit FPv4-SP: float in hardware, double in software.

VMUL and VADD take one cycle, VFMA three, VDIV and VSQRT 14 (Cortex-M4 Technical Reference Manual, table 7-1);
sines and cosines, and double, were measured in instructions (gcc 12's libgcc; the square root is fdlibm's).
"""

from robodyn.targets.target import Chip, Costs, Target, mps2

TARGET = Target(
    name="cortex-m4f",
    aliases=("cortex-m4",),
    title="Cortex-M4F, floating-point unit for float",
    why="a fused multiply-add takes three cycles, a product and a sum two",
    flags=("-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"),
    scalar="float",
    registers=30,
    hardware=("float",),
    single=Costs(mul=1.0, add=1.0, div=14.0, sqrt=14.0, sincos=46.0),
    double=Costs(mul=51.0, add=66.0, div=577.0, sqrt=600.0, sincos=2570.0),
    chip=Chip(168.0, "STM32F4; cycles as robodyn's searches weigh them (--objective weighted), usual clock"),
    board=mps2("mps2-an386"),
)
