"""The machine of the thesis's schedules: Table 4.8 counts 0.135 ms a task of three operations, 45 us each."""

from robodyn.targets.target import Chip, Costs, Target

TARGET = Target(
    name="thesis-1990",
    title="the thesis's processors",
    single=Costs(mul=1.0, add=1.0, div=1.0, sqrt=1.0, sincos=0.0),
    chip=Chip(1 / 45, "Table 4.8: 45 us an operation, sines and passing values free", cores=13),
)
