"""Arm Cortex-M7 with the floating-point unit FPv5: float and double in hardware."""

from robodyn.targets.target import Chip, Costs, Target, mps2

TARGET = Target(
    name="cortex-m7",
    title="Cortex-M7, floating-point unit for float and double",
    why="the bits are those of every other target",
    flags=("-mcpu=cortex-m7", "-mthumb", "-mfpu=fpv5-d16", "-mfloat-abi=hard"),
    registers=15,
    single=Costs(div=16.0, sqrt=14.0, sincos=38.0),
    double=Costs(div=30.0, sqrt=30.0, sincos=47.0),
    chip=Chip(480.0, "STM32H7; cycles as robodyn's searches weigh them (--objective weighted), usual clock"),
    board=mps2("mps2-an500"),
)
