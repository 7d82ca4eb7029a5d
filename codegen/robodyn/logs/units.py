"""Units of what a log holds, and how its columns become SI units at the joints."""

from __future__ import annotations

import difflib
from dataclasses import dataclass
from fractions import Fraction
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.errors import InputError
from robodyn.logs.mapping import NUMBERS, Channel
from robodyn.robot.model import Robot
from robodyn.robot.names import shown
from robodyn.robot.numbers import NumberError, parse
from robodyn.robot.values import PI

#: The SI units of each group; N, m of a prismatic joint.
SI: Final = {"t": "s", "q": "rad", "ql": "rad", "qd": "rad/s", "qdd": "rad/s^2", "tau": "N m"}
SI_PRISMATIC: Final = {"t": "s", "q": "m", "ql": "m", "qd": "m/s", "qdd": "m/s^2", "tau": "N"}
#: A log whose times begin later [s] has dates for times: they count from the first sample instead.
DATES: Final = 1e6
#: Units that say nothing without a further number: a key of the map each.
TICKS, RAW = "ticks", "raw"

#: By what they are of: units, and their factors to the SI unit.
_UNITS: Final = {
    "angle": {
        "rad": Fraction(1), "mrad": Fraction(1, 1000), "urad": Fraction(1, 10**6), "deg": PI / 180,
        "mdeg": PI / 180_000, "arcmin": PI / 10_800, "arcsec": PI / 648_000, "rev": 2 * PI,
    },
    "length": {
        "m": Fraction(1), "cm": Fraction(1, 100), "mm": Fraction(1, 1000), "um": Fraction(1, 10**6),
    },
    "time": {
        "s": Fraction(1), "ms": Fraction(1, 1000), "us": Fraction(1, 10**6), "ns": Fraction(1, 10**9),
        "min": Fraction(60),
    },
    "torque": {
        "N m": Fraction(1), "mN m": Fraction(1, 1000), "uN m": Fraction(1, 10**6), "kN m": Fraction(1000),
        "N cm": Fraction(1, 100), "N mm": Fraction(1, 1000), "kgf m": Fraction(980665, 100000),
        "kgf cm": Fraction(980665, 10**7), "lbf ft": Fraction("1.3558179483314004"),
        "lbf in": Fraction("0.1129848290276167"), "ozf in": Fraction("0.00706155181422604"),
    },
    "force": {"N": Fraction(1), "mN": Fraction(1, 1000), "kN": Fraction(1000)},
    "current": {"A": Fraction(1), "mA": Fraction(1, 1000)},
    "share": {"rated": Fraction(1), "%": Fraction(1, 100), "permille": Fraction(1, 1000)},
}  # fmt: skip
#: What columns of a group may be of, where not of angles and lengths.
_KINDS: Final = {"t": ("time",), "tau": ("torque", "force", "current", "share")}
#: Time derivatives of a position.
_RATES: Final = {"qd": "/s", "qdd": "/s^2"}

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


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit as a group of columns has it: its ``name``; ``factor`` to the SI unit; ``kind``: what it is of.

    ``kind`` is time, angle, length, torque, force, current, share, ticks or raw; of the rates of positions
    it is that of the position.
    """

    name: str
    factor: Fraction
    kind: str


class UnknownUnit(ValueError):
    """A unit that a group of columns cannot have: what is wrong, what stands there, what is expected."""

    def __init__(self, what: str, text: str, expected: str) -> None:
        super().__init__(what)
        self.what, self.text, self.expected = what, text, expected


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
    unit = _lookup(text, group)
    if unit is None:
        names = list(names_of(group))
        close = difflib.get_close_matches(normal(text), names, n=1, cutoff=0.75)
        raise UnknownUnit("the unit is unknown here", text, close[0] if close else ", ".join(names))
    wrong = ("torque",) if prismatic else ("length", "force")
    if unit.kind in wrong:
        joint = "prismatic" if prismatic else "revolute"
        sound = [name for name in names_of(group) if (_lookup(name, group) or unit).kind not in wrong]
        raise UnknownUnit(f"the unit does not fit a {joint} joint", text, ", ".join(sound))
    if not factor:
        raise UnknownUnit("the factor of a unit is 0", text, "another factor")
    return Unit(unit.name, factor * unit.factor, unit.kind)


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
    rate = _RATES.get(group, "")
    names = [name for kind in _KINDS.get(group, ("angle", "length")) for name in _UNITS[kind]]
    return (
        *(f"{name}{rate}" for name in (*names, *([TICKS] if group != "tau" else []))),
        *(["rev/min"] if group == "qd" else []),
        *([RAW] if group != "t" else []),
    )


def is_unit(text: str) -> bool:
    """Whether ``text`` is a unit of any column of a log."""
    return any(_lookup(text, group) is not None for group in SI)


def _lookup(text: str, group: str) -> Unit | None:
    name, rate = normal(text), _RATES.get(group, "")
    if name == RAW and group != "t":
        return Unit(RAW, Fraction(1), "raw")
    if name == "rev/min" and group == "qd":
        return Unit(name, 2 * PI / 60, "angle")
    if not name.endswith(rate):
        return None
    head = name.removesuffix(rate)
    if head == TICKS and group != "tau":
        return Unit(name, Fraction(1), "ticks")
    kinds = _KINDS.get(group, ("angle", "length"))
    return next((Unit(name, _UNITS[kind][head], kind) for kind in kinds if head in _UNITS[kind]), None)


# --- to SI units ------------------------------------------------------------------------------------------


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


def convert(x: Floats, channel: Channel, group: str, joint: int, stated: str, robot: Robot | None) -> None:
    """Bring the column ``x`` [K] of ``joint`` (from 0) to SI units, in place.

    ``stated``: the unit that the file itself states, which the map's goes before.

    Raises
    ------
    InputError: the unit is not one of the group, or a number that it needs is nowhere.
    """
    prismatic = robot is not None and robot.links[joint].joint.kind == "prismatic"
    unit = _unit(channel, group, stated, prismatic=prismatic)
    factor = _factor(channel, group, joint, unit, robot)
    zero, offset = channel.number("zero", joint), channel.number("offset", joint)
    bits = channel.number("bits", joint)
    if bits:
        x[x >= 2.0 ** (int(bits) - 1)] -= 2.0 ** int(bits)
    if zero:
        x -= float(zero)
    scaled(x, factor * (channel.number("sign", joint) or 1))
    if offset:
        x += float(offset)


def seconds(x: Floats, channel: Channel, stated: str, origin: float | None = None) -> float | None:
    """Bring times ``x`` [K] to seconds, in place; dates count from the first sample, whose reading this
    returns: 0 where times are no dates, None where none of them is finite.

    ``origin``: what it has returned for earlier samples of the same stream.

    Raises
    ------
    InputError: the unit is none of time.
    """
    unit = _unit(channel, "t", stated, prismatic=False)
    factor = channel.number("factor", 0)
    if unit.kind == "ticks" and factor is None:
        raise _lacks(channel, "t", unit, "factor")
    factor = unit.factor * (factor or 1)
    zero, offset = channel.number("zero", 0), channel.number("offset", 0)
    if zero:
        x -= float(zero)
        origin = 0.0
    finite = x[np.isfinite(x)]
    if origin is None and len(finite):
        first = float(finite[0])
        origin = first if abs(first * float(factor)) > DATES else 0.0
    if origin:
        x -= origin
    scaled(x, factor * (channel.number("sign", 0) or 1))
    if offset:
        x += float(offset)
    return origin


def date_of(origin: float, channel: Channel, stated: str) -> float:
    """The ``origin`` of times in seconds."""
    factor = _unit(channel, "t", stated, prismatic=False).factor * (channel.number("factor", 0) or 1)
    return origin * float(factor)


def of_stamps(stamps: NDArray[np.int64], origin: int) -> Floats:
    """Seconds of ``stamps`` [K] in nanoseconds; dates count from ``origin`` [ns]."""
    if abs(origin) > DATES * 1e9:
        stamps = stamps - origin
    t: Floats = stamps / 1e9
    return t


def _unit(channel: Channel, group: str, stated: str, *, prismatic: bool) -> Unit:
    # A motor's angle drives a slide as well: the gear is then in rad/m.
    is_slide = prismatic and not ("gear" in channel.numbers or "gear" in channel.of_robot)
    text = channel.unit or stated
    if not text and "counts_per_turn" in channel.numbers:
        text = f"ticks{SI[group][3:]}"
    elif not text:
        is_raw = "factor" in channel.numbers and group != "t"
        text = RAW if is_raw else (SI_PRISMATIC if is_slide else SI)[group]
    try:
        unit = unit_of(text, group, prismatic=is_slide)
        if is_slide and unit.kind == "angle":
            what = "a prismatic joint has a gear between its motor and itself"
            raise UnknownUnit(what, text, "gear: rad/m")
        return unit
    except UnknownUnit as error:
        remedy = f"that is what the file states: say the unit in the map, {group}: {{unit: ...}}"
        raise InputError(
            f"{group}: {error.what}",
            where=channel.place,
            found=shown(error.text),
            expected=error.expected,
            remedy=remedy if stated and not channel.unit else None,
        ) from None


def _factor(channel: Channel, group: str, joint: int, unit: Unit, robot: Robot | None) -> Fraction:
    """SI units at the joint to a unit of the column."""
    described = None if robot is None else robot.links[joint].joint.gear
    of_robot = {
        "gear": None if described is None else described.ratio,
        "torque_constant": None if described is None else described.torque_constant,
    }

    def number(key: str) -> Fraction | None:
        """The value at ``key``: the map's, or the description's where the map says so."""
        if key not in channel.of_robot:
            return channel.number(key, joint)
        if of_robot[key] is None:
            raise InputError(
                f"the description has no {key} for joint {joint + 1}",
                where=channel.place,
                found=f"{key}: robot",
                remedy=f"write gear: {{ratio: ..., torque_constant: ...}} at its link, or a number for {key}",
            )
        return of_robot[key]

    factor, gear, scale = unit.factor, number("gear"), channel.number("factor", joint)
    counts, rated = channel.number("counts_per_turn", joint), channel.number("rated", joint)
    if unit.kind == "raw" and scale is None:
        raise _lacks(channel, group, unit, "factor")
    if unit.kind == "ticks":
        if counts is None and scale is None:
            raise _lacks(channel, group, unit, "counts_per_turn")
        if counts is not None:
            factor = factor * 2 * PI / counts
    elif unit.kind == "current":
        constant = number("torque_constant")
        if constant is None:
            constant = of_robot["torque_constant"]
            gear = of_robot["gear"] if gear is None else gear
        if constant is None:
            raise _lacks(channel, group, unit, "torque_constant")
        factor = factor * constant
    elif unit.kind == "share":
        if rated is None:
            raise _lacks(channel, group, unit, "rated")
        factor = factor * rated
    if scale is not None:
        factor = factor * scale
    if gear is not None:
        factor = factor * gear if group == "tau" else factor / gear
    return factor


def _lacks(channel: Channel, group: str, unit: Unit, key: str) -> InputError:
    """What to say of a ``unit`` that needs the number ``key``."""
    return InputError(
        f"{group} in {unit.name} needs a number",
        where=channel.place,
        found=f"no {key}",
        expected=f"{key}: {'seconds to a tick' if group == 't' else NUMBERS[key]}",
        remedy=f"write {group}: {{columns: ..., unit: {unit.name}, {key}: ...}} in a map",
    )
