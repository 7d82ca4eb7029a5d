"""A frame in another, over any scalar."""

from __future__ import annotations

from dataclasses import dataclass

from robodyn.dynamics.vectors import ZERO, Vector, dot, plus, scaled


@dataclass(frozen=True, slots=True)
class Frame:
    """A frame in another: its origin [m] and its unit axes, the columns of the rotation."""

    origin: Vector
    x: Vector
    y: Vector
    z: Vector

    def rotation(self) -> tuple[Vector, Vector, Vector]:
        """Rows of the rotation [3, 3] that takes vectors of the frame into the other."""
        x, y, z = self.x, self.y, self.z
        return (x[0], y[0], z[0]), (x[1], y[1], z[1]), (x[2], y[2], z[2])

    def place(self, point: Vector) -> Vector:
        """``point`` [m] of the frame, seen from the other [m]."""
        return plus(self.origin, self.turned(point))

    def turned(self, u: Vector) -> Vector:
        """A vector of the frame along the other's axes."""
        return plus(scaled(u[0], self.x), scaled(u[1], self.y), scaled(u[2], self.z))

    def back(self, u: Vector) -> Vector:
        """A vector along the other's axes, along the frame's own."""
        return dot(self.x, u), dot(self.y, u), dot(self.z, u)

    def within(self, outer: Frame) -> Frame:
        """The same frame where the other one lies in ``outer``."""
        return Frame(
            outer.place(self.origin), outer.turned(self.x), outer.turned(self.y), outer.turned(self.z)
        )


#: The other itself.
BASE = Frame(ZERO, (1, 0, 0), (0, 1, 0), (0, 0, 1))
