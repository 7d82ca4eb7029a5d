"""Arm Cortex-M3: floating point in software.

Costs are instructions of gcc 12's libgcc, measured in qemu; those of the square root are fdlibm's.
"""

from robodyn.targets.target import Chip, Costs, Target, mps2

TARGET = Target(
    name="cortex-m3",
    title="Cortex-M3, no floating-point unit",
    why="floating point in software",
    flags=("-mcpu=cortex-m3", "-mthumb", "-mfloat-abi=soft"),
    scalar="float",
    registers=8,
    hardware=(),
    single=Costs(mul=34.0, add=53.0, div=150.0, sqrt=260.0, sincos=1370.0),
    double=Costs(mul=51.0, add=66.0, div=577.0, sqrt=600.0, sincos=2570.0),
    chip=Chip(72.0, "STM32F1; instructions as robodyn's searches weigh them, a cycle each; usual clock"),
    board=mps2("mps2-an385"),
)
