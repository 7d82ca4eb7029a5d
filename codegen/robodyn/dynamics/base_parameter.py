"""A base parameter: a combination of numbers of links, named as the literature names them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from robodyn.dynamics.arm import Arm
from robodyn.dynamics.lump import Lump

#: Mass, first and second moments of a link about the origin of its frame.
MOMENTS = ("m", "mx", "my", "mz", "Kxx", "Kyy", "Kzz", "Kxy", "Kxz", "Kyz")
#: What the drives add, where torques are the motors'.
DRIVE = ("rotor", "viscous", "coulomb")


class Standard(NamedTuple):
    """A number of a link (from 1) as it is described."""

    quantity: str
    link: int

    def __str__(self) -> str:
        return f"{self.quantity}{self.link}"


@dataclass(frozen=True, slots=True)
class BaseParameter:
    """A combination of numbers of links. Its column is the torques that a unit of ``own`` alone takes."""

    own: Standard
    terms: tuple[tuple[Standard, Fraction], ...]

    def value(self, numbers: Mapping[Standard, Any]) -> Any:
        """Its value where the links' ``numbers`` are these; those that are missing are 0."""
        total: Any = 0
        for standard, factor in self.terms:
            if standard in numbers:
                total = total + factor * numbers[standard]
        return total

    def to_dict(self) -> dict[str, Any]:
        """As JSON has it: its own number, and all that it is made of with factors."""
        return {"own": str(self.own), "terms": {str(x): float(factor) for x, factor in self.terms}}

    def __str__(self) -> str:
        text = ""
        for standard, factor in self.terms:
            size = "" if abs(factor) == 1 else f"{_decimal(abs(factor))} "
            sign = "-" if factor < 0 else "+" if text else ""
            text += f" {sign} {size}{standard}" if text else f"{sign}{size}{standard}"
        return text


def numbers_of(arm: Arm, lumps: Sequence[Lump]) -> dict[Standard, Any]:
    """The numbers of the links of ``arm``, whose moments of mass are ``lumps``, and of their drives."""
    numbers: dict[Standard, Any] = {}
    for i, (body, lump) in enumerate(zip(arm.bodies, lumps, strict=True), 1):
        moments = (lump.mass, *lump.first, *lump.second.entries())
        drive = (body.motor_inertia, body.viscous, body.coulomb)
        values = zip((*MOMENTS, *DRIVE), (*moments, *drive), strict=True)
        numbers.update({Standard(quantity, i): value for quantity, value in values})
    return numbers


def _decimal(x: Fraction) -> str:
    """The shortest decimal that is ``x``, else the nearest of 12 digits."""
    below = x.denominator
    for prime in (2, 5):
        while below % prime == 0:
            below //= prime
    exact = below == 1 and x.denominator < 10**15
    return f"{float(x):.15g}" if exact else f"{float(x):.12g}"
