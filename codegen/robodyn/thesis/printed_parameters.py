"""Parameters of the PUMA 560 as the thesis prints them: data, slips included.

Source: Dhanaraj 1990, Tables 2.5 and 2.6, program D.2. Link by link from the first; None where the table has
no figure.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Final


@dataclass(frozen=True, slots=True)
class PrintedLink:
    """Mass [kg] and centre of mass [m] (Table 2.5), principal moments and rotor inertia [kg m^2] (2.6)."""

    mass: Fraction
    com: tuple[Fraction, Fraction, Fraction]
    moments: tuple[Fraction | None, Fraction | None, Fraction | None]
    motor: Fraction


def _link(body: str, moments: str, motor: str) -> PrintedLink:
    mass, x, y, z = map(Fraction, body.split())
    xx, yy, zz = (None if text == "-" else Fraction(text) for text in moments.split())
    return PrintedLink(mass, (x, y, z), (xx, yy, zz), Fraction(motor))


PUMA: Final = (
    _link("0 0 0 0", "- - 0.35", "1.14"),
    _link("17.40 0.0680 0.0060 -0.0160", "0.130 0.524 0.539", "4.71"),
    _link("4.80 0 -0.0700 0.0140", "0.066 0.0125 0.086", "0.83"),
    _link("0.82 0 0 -0.0190", "0.0018 0.0018 0.0013", "0.20"),
    _link("0.34 0 0 0", "0.0030 0.0030 0.0040", "0.179"),
    _link("0.09 0 0 0.032", "0.0015 0.0015 0.0004", "0.193"),
)

#: Program D.2: tensors about the links' origins with the rotors in Izz [kg m^2], and the last digit that is
#: printed of each.
D_2: Final[tuple[tuple[Fraction | None, Fraction | None, Fraction], ...]] = tuple(
    (None if xx == "-" else Fraction(xx), None if yy == "-" else Fraction(yy), Fraction(zz))
    for xx, yy, zz in (
        ("-", "-", "1.490"),
        ("0.1351", "0.6089", "5.3301"),
        ("0.066", "0.0134", "0.9395"),
        ("0.0021", "0.0021", "0.2013"),
        ("0.0003", "0.0003", "0.1794"),
        ("0.0002422", "0.0002422", "0.1930"),
    )
)
D_2_LAST_DIGIT: Final = Fraction(1, 10000)


def moved_to_origin(link: PrintedLink) -> tuple[Fraction | None, Fraction | None, Fraction | None]:
    """Moments [kg m^2] of Table 2.6 about the link's origin by the offsets of Table 2.5, with the rotor in
    Izz: how D.2's numbers came about."""
    x, y, z = (u * u for u in link.com)
    squares, rotors = (y + z, x + z, x + y), (Fraction(0), Fraction(0), link.motor)
    xx, yy, zz = (
        None if moment is None else moment + link.mass * square + rotor
        for moment, square, rotor in zip(link.moments, squares, rotors, strict=True)
    )
    return xx, yy, zz
