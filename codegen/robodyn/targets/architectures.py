"""Architectures that images are made for: compiler, emulator, and how instructions are counted there."""

from __future__ import annotations

from robodyn.targets.target import Architecture, Board, Region
from robodyn.tools import Tool, Use

#: An image is run without a screen, and talks through the debugger.
_QUIET = (
    "-display", "none", "-monitor", "none", "-serial", "none", "-semihosting-config",
    "enable=on,target=native",
)  # fmt: skip

#: Cortex-M. SysTick has 24 bits: instructions are slow, lest it runs over.
CORTEX_M = Architecture(
    name="arm",
    macro="__arm__",
    prefix="arm-none-eabi-",
    compiler_package="gcc-arm-none-eabi",
    binutils_package="binutils-arm-none-eabi",
    emulator=Tool(
        ("qemu-system-arm",), Use.FIRMWARE, "images run and measured without a board", "qemu-system-arm"
    ),
    options=_QUIET,
    counter="SysTick",
    shift=5,
)


def mps2(machine: str) -> Board:
    """One of Arm's boards MPS2, with a Cortex-M3, M4 or M7."""
    return Board(machine, CORTEX_M, Region(0x0000_0000, "4M"), Region(0x2000_0000, "4M"), counter_mhz=25.0)


#: RISC-V with 32 bits, where an image has the machine to itself; mcycle then counts nanoseconds.
RISCV = Architecture(
    name="riscv",
    macro="__riscv",
    prefix="riscv64-unknown-elf-",
    compiler_package="gcc-riscv64-unknown-elf",
    binutils_package="binutils-riscv64-unknown-elf",
    emulator=Tool(
        ("qemu-system-riscv32",), Use.FIRMWARE, "images run and measured without a board", "qemu-system-misc"
    ),
    options=(*_QUIET, "-bios", "none"),
    counter="mcycle",
    shift=0,
)
