"""64-bit Arm (Armv8-A): fused multiply-add, 32 registers, costs taken from those of x86-64-v3."""

from dataclasses import replace

from robodyn.targets.processors import x86_64_v3

TARGET = replace(
    x86_64_v3.TARGET,
    name="aarch64",
    title="64-bit Arm",
    flags=(),
    level="-O2",
    registers=30,
    costs_as="x86-64-v3",
)
