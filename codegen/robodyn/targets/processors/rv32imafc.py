"""RISC-V with 32 bits and a floating-point unit for float: RV32IMAFC, as in microcontrollers.

Cycles are those of a pipelined unit that begins a product, a sum or both fused each cycle; division and
square root keep it busy for some 20 (SiFive's E7 and S7 series). Sines and cosines, and double, which is in
software, were measured in instructions (gcc 12's libgcc, picolibc's square root).
"""

from robodyn.targets.target import RISCV, Board, Chip, Costs, Region, Target

#: The emulator's processor has double, too: without it an image that uses it faults.
_FLOAT_ONLY = ("-cpu", "rv32,d=false")

TARGET = Target(
    name="rv32imafc",
    title="RISC-V RV32IMAFC, floating-point unit for float",
    why="a fused multiply-add costs what a product does",
    flags=("-march=rv32imafc", "-mabi=ilp32f"),
    scalar="float",
    contraction="on",
    registers=30,
    hardware=("float",),
    single=Costs(mul=1.0, add=1.0, fma=1.0, div=20.0, sqrt=20.0, sincos=46.0),
    double=Costs(mul=218.0, add=105.0, div=225.0, sqrt=605.0, sincos=7270.0),
    chip=Chip(400.0, "a microcontroller; cycles as robodyn's searches weigh them, usual clock"),
    board=Board(
        "virt",
        RISCV,
        code=Region(0x8000_0000, "4M"),
        data=Region(0x8040_0000, "4M"),
        counter_mhz=1000.0,
        options=_FLOAT_ONLY,
    ),
)
