"""Arguments of functions: arrays with shape, unit and meaning; and the inputs that functions may have."""

from __future__ import annotations

from math import prod
from typing import Literal, NamedTuple

#: Elements of a state along one axis: a number, or as many as there are joints (n) or base parameters (p).
Length = int | Literal["n", "p"]


class Array(NamedTuple):
    """An argument of a kernel: what it holds, its unit (and that at prismatic joints, where it is another),
    and the shape of one state's, ``()`` for a single number. C and Fortran have it as one row of numbers,
    matrices row by row."""

    name: str
    holds: str
    unit: str
    prismatic: str = ""
    shape: tuple[Length, ...] = ("n",)

    def shape_at(self, n: int, p: int = 0) -> tuple[int, ...]:
        """The shape for ``n`` joints and ``p`` base parameters."""
        return tuple(n if length == "n" else p if length == "p" else length for length in self.shape)

    def size_at(self, n: int, p: int = 0) -> int:
        """How many numbers these are."""
        return prod(self.shape_at(n, p))

    def shape_of(self, size: int, n: int = 0) -> tuple[int, ...]:
        """The shape of so many numbers, for ``n`` joints if that is known.

        Raises
        ------
        ValueError: the array has not so many, whatever the number of joints.
        """
        p = 0
        if "p" in self.shape:
            p = size // max(1, self.size_at(n, 1))
        else:
            free = self.shape.count("n")
            n = round((size / self.size_at(1)) ** (1 / free)) if free else 0
        if self.size_at(n, p) != size:
            raise ValueError(f"{self.name} is {list(self.shape)}, and not of {size} numbers")
        return self.shape_at(n, p)

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
INPUTS = (Q, QD, QDD, TAU, WRENCH, PI)
