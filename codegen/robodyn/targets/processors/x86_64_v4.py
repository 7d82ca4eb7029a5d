"""x86-64-v4: as x86-64-v3, with AVX-512's registers and instructions."""

from dataclasses import replace

from robodyn.targets.processors import x86_64_v3

TARGET = replace(
    x86_64_v3.TARGET,
    name="x86-64-v4",
    title="x86-64 with AVX-512",
    flags=("-march=x86-64-v4",),
    level="-O2",  # with -O3 inverse kinematics take up to 1.4 times as long (gcc 12)
    costs_as="x86-64-v3",
)
