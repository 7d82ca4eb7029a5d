"""Units of what a log holds, and the factors that bring them to SI units of the joint side."""

from __future__ import annotations

import difflib
from dataclasses import dataclass
from fractions import Fraction
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from robodyn.robot.numbers import NumberError, parse
from robodyn.robot.values import PI

Floats = NDArray[np.float64]
Group = Literal["t", "q", "qd", "qdd", "tau", "ql"]

#: How far a quantity is from a position: time derivatives.
_RATES: Final = {"q": "", "ql": "", "qd": "/s", "qdd": "/s^2"}
_ANGLES: Final = {
    "rad": Fraction(1), "mrad": Fraction(1, 1000), "urad": Fraction(1, 10**6),
    "deg": PI / 180, "mdeg": PI / 180_000, "arcmin": PI / 10_800, "arcsec": PI / 648_000,
    "rev": 2 * PI,
}  # fmt: skip
_LENGTHS: Final = {
    "m": Fraction(1),
    "cm": Fraction(1, 100),
    "mm": Fraction(1, 1000),
    "um": Fraction(1, 10**6),
}
_TIMES: Final = {
    "s": Fraction(1), "ms": Fraction(1, 1000), "us": Fraction(1, 10**6), "ns": Fraction(1, 10**9),
    "min": Fraction(60),
}  # fmt: skip
_TORQUES: Final = {
    "N m": Fraction(1), "mN m": Fraction(1, 1000), "uN m": Fraction(1, 10**6), "kN m": Fraction(1000),
    "N cm": Fraction(1, 100), "N mm": Fraction(1, 1000), "kgf m": Fraction(980665, 100000),
    "kgf cm": Fraction(980665, 10**7), "lbf ft": Fraction("1.3558179483314004"),
    "lbf in": Fraction("0.1129848290276167"), "ozf in": Fraction("0.00706155181422604"),
}  # fmt: skip
_FORCES: Final = {"N": Fraction(1), "mN": Fraction(1, 1000), "kN": Fraction(1000)}
_CURRENTS: Final = {"A": Fraction(1), "mA": Fraction(1, 1000)}
_SHARES: Final = {"rated": Fraction(1), "%": Fraction(1, 100), "permille": Fraction(1, 1000)}

#: Other spellings; spaces, dots and stars between units are all the same.
_ALIASES: Final = {
    "°": "deg", "degree": "deg", "degrees": "deg", "grad": "deg", "radian": "rad", "radians": "rad",
    "turn": "rev", "turns": "rev", "revolution": "rev", "revolutions": "rev", "U": "rev",
    "sec": "s", "second": "s", "seconds": "s", "msec": "ms", "milliseconds": "ms", "usec": "us", "µs": "us",
    "μs": "us", "microseconds": "us", "nsec": "ns", "nanoseconds": "ns", "µm": "um", "μm": "um",
    "Nm": "N m", "mNm": "mN m", "uNm": "uN m", "kNm": "kN m", "Ncm": "N cm", "Nmm": "N mm", "amps": "A",
    "kgcm": "kgf cm", "kgm": "kgf m", "amp": "A", "ampere": "A", "amperes": "A", "‰": "permille",
    "per mille": "permille", "percent": "%", "share": "rated", "counts": "ticks", "count": "ticks",
    "tick": "ticks", "inc": "ticks", "increments": "ticks", "metre": "m", "metres": "m", "meter": "m",
    "meters": "m", "unitless": "raw", "lsb": "raw", "LSB": "raw", "1": "raw",
}  # fmt: skip
_RATE_ALIASES: Final = {"rpm": "rev/min", "dps": "deg/s", "RPM": "rev/min", "U/min": "rev/min"}

#: Units that say nothing without a further number: a key of the map each.
TICKS, RAW = "ticks", "raw"


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit as a group of columns has it: its ``name``; ``factor`` to the SI unit; ``kind``: what it is of.

    ``kind`` is time, angle, length, torque, force, current, share, ticks or raw; of the rates of positions
    it is that of the position.
    """

    name: str
    factor: Fraction
    kind: str


def unit_of(text: str, group: str, *, prismatic: bool = False) -> Unit:
    """The unit that ``text`` names for a column of ``group``; arithmetic and ``*`` may stand before it.

    Raises
    ------
    UnknownUnit: there is none such for this group.
    """
    factor = Fraction(1)
    for place in (k for k, mark in enumerate(text) if mark == "*"):
        if _lookup(text, group) is not None:
            break
        try:
            value = parse(text[:place]).value
        except NumberError:
            continue
        if _lookup(text[place + 1 :], group) is not None:
            assert isinstance(value, Fraction)
            factor, text = value, text[place + 1 :]
    unit = _known(text, group, prismatic)
    if not factor:
        raise UnknownUnit("the factor of a unit is 0", text, "another factor")
    return Unit(unit.name, factor * unit.factor, unit.kind)


class UnknownUnit(ValueError):
    """A unit that a group of columns cannot have: what is wrong, what stands there, what is expected."""

    def __init__(self, what: str, text: str, expected: str) -> None:
        super().__init__(what)
        self.what, self.text, self.expected = what, text, expected


def _known(text: str, group: str, prismatic: bool) -> Unit:
    unit = _lookup(text, group)
    if unit is None:
        names = list(names_of(group))
        close = difflib.get_close_matches(normal(text), names, n=1, cutoff=0.75)
        expected = close[0] if close else ", ".join(names)
        raise UnknownUnit("the unit is unknown here", text, expected)
    wrong = {"length", "force"} if not prismatic else {"torque"}
    if unit.kind in wrong:
        joint = "prismatic" if prismatic else "revolute"
        sound = [name for name in names_of(group) if (_lookup(name, group) or unit).kind not in wrong]
        raise UnknownUnit(f"the unit does not fit a {joint} joint", text, ", ".join(sound))
    return unit


def normal(text: str) -> str:
    """The usual spelling of a unit."""
    text = " ".join(text.replace("·", " ").replace("*", " ").replace("²", "^2").split())
    text = text.replace(" / ", "/").replace("s2", "s^2").replace("**", "^")
    text = _RATE_ALIASES.get(text, text)
    head, slash, rate = text.partition("/")
    head = _ALIASES.get(head, _ALIASES.get(head.replace(".", ""), _ALIASES.get(head.replace(" ", ""), head)))
    return f"{head}{slash}{rate}"


def names_of(group: str) -> tuple[str, ...]:
    """Names of the units that columns of ``group`` may have."""
    if group == "t":
        return (*_TIMES, TICKS)
    if group == "tau":
        return (*_TORQUES, *_FORCES, *_CURRENTS, *_SHARES, RAW)
    rate = _RATES[group]
    more = ("rev/min",) if group == "qd" else ()
    return (*(f"{name}{rate}" for name in (*_ANGLES, *_LENGTHS, TICKS)), *more, RAW)


def _lookup(text: str, group: str) -> Unit | None:
    name = normal(text)
    if name == RAW and group != "t":
        return Unit(RAW, Fraction(1), "raw")
    if group == "t":
        if name == TICKS:
            return Unit(TICKS, Fraction(1), "ticks")
        return Unit(name, _TIMES[name], "time") if name in _TIMES else None
    if group == "tau":
        tables = (
            ("torque", _TORQUES), ("force", _FORCES), ("current", _CURRENTS), ("share", _SHARES)
        )  # fmt: skip
        return next((Unit(name, table[name], kind) for kind, table in tables if name in table), None)
    rate = _RATES[group]
    if group == "qd" and name == "rev/min":
        return Unit(name, 2 * PI / 60, "angle")
    head = name.removesuffix(rate) if rate else name
    if rate and head == name:
        return None
    if head == TICKS:
        return Unit(name, Fraction(1), "ticks")
    for kind, table in (("angle", _ANGLES), ("length", _LENGTHS)):
        if head in table:
            return Unit(name, table[head], kind)
    return None


def scaled(x: Floats, factor: Fraction) -> None:
    """Multiply ``x`` by ``factor`` in place; a factor of 1 leaves every bit.

    A whole reciprocal divides: 8 ms are then the double nearest to 0.008 s, as text has it.
    """
    if factor == 1:
        return
    if factor == -1:
        np.negative(x, out=x)
    elif abs(factor.numerator) == 1 and factor.denominator <= 1 << 53:
        x /= float(factor.denominator * factor.numerator)
    else:
        x *= float(factor)


def is_unit(text: str) -> bool:
    """Whether ``text`` is a unit of any column of a log."""
    return any(_lookup(text, group) is not None for group in ("t", "q", "qd", "qdd", "tau"))
