"""Arm Cortex-M3: floating point in software. Costs are instructions, measured in qemu with libgcc."""

from robodyn.targets.architectures import CORTEX_M, MPS2
from robodyn.targets.target import Board, Chip, Costs, Target

TARGET = Target(
    name="cortex-m3",
    title="Cortex-M3, no floating-point unit",
    why="floating point in software",
    flags=("-mcpu=cortex-m3", "-mthumb", "-mfloat-abi=soft"),
    scalar="float",
    registers=8,
    hardware=(),
    costs=Costs(mul=60.0, add=64.0, div=190.0, sqrt=260.0, sincos=1400.0),
    chip=Chip(72.0, "STM32F1; instructions as robodyn's searches weigh them, a cycle each; usual clock"),
    board=Board("mps2-an385", CORTEX_M, **MPS2),
)
