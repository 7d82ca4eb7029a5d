"""Arguments of functions: arrays with shape, unit and meaning; and the inputs that functions may have."""

from __future__ import annotations

from math import prod
from typing import Literal, NamedTuple

#: Elements of a state along one axis: a number, or as many as there are joints (n), base parameters (p), or
#: branches of the inverse kinematics (b).
Length = int | Literal["n", "p", "b"]


class Array(NamedTuple):
    """An argument of a kernel: what it holds, its unit (and that at prismatic joints, where it is another),
    and the shape of one state's, ``()`` for a single number. C and Fortran have it as one row of numbers,
    matrices row by row. ``optional``: calls from Python may leave it out, it is zero then, and that of one
    state may go with many states."""

    name: str
    holds: str
    unit: str
    prismatic: str = ""
    shape: tuple[Length, ...] = ("n",)
    optional: bool = False

    def shape_at(self, n: int, p: int = 0, b: int = 0) -> tuple[int, ...]:
        """The shape for ``n`` joints, ``p`` base parameters and ``b`` branches."""
        lengths = {"n": n, "p": p, "b": b}
        return tuple(lengths[length] if isinstance(length, str) else length for length in self.shape)

    def size_at(self, n: int, p: int = 0, b: int = 0) -> int:
        """How many numbers these are."""
        return prod(self.shape_at(n, p, b))

    def shape_of(self, size: int, n: int = 0) -> tuple[int, ...]:
        """The shape of so many numbers, for ``n`` joints if that is known.

        Raises
        ------
        ValueError: the array has not so many, whatever the number of joints.
        """
        count = 0  # of base parameters or branches; no array has both
        if {"p", "b"} & set(self.shape):
            count = size // max(1, self.size_at(n, 1, 1))
        else:
            free = self.shape.count("n")
            n = round((size / self.size_at(1)) ** (1 / free)) if free else 0
        if self.size_at(n, count, count) != size:
            raise ValueError(f"{self.name} is {list(self.shape)}, and not of {size} numbers")
        return self.shape_at(n, count, count)

    @property
    def text(self) -> str:
        """What it holds and its unit, for the heads of files."""
        rows = ", row by row" if len(self.shape) > 1 else ""
        unit = self.unit + (f", prismatic {self.prismatic}" if self.prismatic else "")
        return f"{self.holds}{rows}" + (f" [{unit}]" if unit else "")

    @property
    def words(self) -> str:
        """The same for Python, where matrices are matrices."""
        units = " or ".join(unit for unit in (self.unit, self.prismatic) if unit)
        return f"{self.holds}, {units}" if units else self.holds


#: What a function may be given.
Q = Array("q", "joint positions", "rad", "m")
QD = Array("qd", "joint velocities", "rad/s", "m/s")
QDD = Array("qdd", "joint accelerations", "rad/s^2", "m/s^2")
TAU = Array("tau", "joint torques", "N m", "N")
#: In q's place, where sines and cosines are given.
SC = Array("sc", "sines and cosines, as listed below", "")
#: What pushes the tool, on request.
WRENCH = Array(
    "w", "force and moment on the tool at its origin, along the world's axes", "N, N m", shape=(6,)
)
PI = Array("pi", "base parameters, as listed below", "SI units", shape=("p",))
#: What poses are given and computed as.
POSE = Array("T", "frame of the tool in the world, [R p]", "1 and m", shape=(3, 4))
NEAR = Array(
    "q_near", "joint positions, which joints take that the pose leaves free", "rad", "m", optional=True
)
INPUTS = (Q, QD, QDD, TAU, WRENCH, PI, POSE, NEAR)
