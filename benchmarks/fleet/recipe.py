"""What a simulated fleet is made of: options with their defaults, and a TOML file of them."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Final

from benchmarks.fleet.limits import FEWEST_LOGS, LARGEST_RECIPE

from robodyn.effects.catalogue import effect
from robodyn.errors import InputError
from robodyn.files import label, read_text
from robodyn.project.tables import Tables, shown

Range = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Recipe:
    """Ranges are from least to most.

    ``units``: of the fleet, spread evenly over the types; ``days``: length of the record; ``logs``: of a
    unit; ``duration`` [s] and ``rates`` [Hz] of logs; ``short`` and ``slow``: shares of logs that last a
    third as long, or move at a third of the speed.

    What is planted, as shares of the units: ``friction_units``, in which friction of one joint grows by a
    share within ``friction_size`` in ``growth`` days (``one_law``: the share of them in which it is only
    viscous friction, and as many in which only Coulomb friction); ``play_units``, in which a gap grows from
    nothing until it shows ``play_size`` noise floors; ``payload_units``, in which a payload is not entered
    from a day on, in ``payload_always`` of them from the first log on, and shows ``payload_size`` noise
    floors. In ``program_units`` the arm runs other programs from a day on, in ``clock_units`` the time stamps
    run by ``clock_share`` too fast from a day on, in ``date_units`` the clock loses its date on a day.
    ``effects`` are further ones, ids of the catalogue with their shares of the units: they grow to
    ``effect_size`` noise floors. ``programs``: of a unit, one after the other by chance.

    All units scatter about their type: ``scatter_friction`` (log-normal, drawn for each joint of the type),
    ``scatter_inertial``, ``scatter_gain`` (torque constant); ``daily_friction`` is from log to log. Friction
    falls with temperature: ``viscous_slope`` and ``coulomb_slope``, shares a kelvin. ``workshop`` [deg C],
    ``season`` [K], ``daily`` [K] and ``warm_up`` [K] make the temperature, ``thermometer`` [K] is its error
    in the log, and ``temperature`` says whether it is logged. The type's description is wrong by
    ``sheet_inertial`` and ``sheet_friction``, and of ``sheet_silent`` of the types lacks friction.
    """

    units: int = 100
    seed: int = 0
    days: float = 365.0
    logs: tuple[int, int] = (5, 20)
    programs: tuple[int, int] = (2, 4)
    duration: Range = (10.0, 20.0)
    rates: tuple[float, ...] = (250.0,)
    short: float = 0.08
    slow: float = 0.08
    noise: float = 0.015
    encoder_bits: int = 19
    friction_units: float = 0.04
    friction_size: Range = (0.1, 0.5)
    one_law: float = 0.15
    growth: Range = (30.0, 200.0)
    play_units: float = 0.01
    play_size: Range = (3.0, 6.0)
    payload_units: float = 0.01
    payload_size: Range = (3.0, 10.0)
    payload_always: float = 0.3
    program_units: float = 0.0
    clock_units: float = 0.0
    clock_share: float = 0.1
    date_units: float = 0.0
    effects: tuple[tuple[str, float], ...] = ()
    effect_size: Range = (3.0, 6.0)
    scatter_friction: Range = (0.15, 0.25)
    scatter_inertial: Range = (0.01, 0.03)
    scatter_gain: Range = (0.01, 0.02)
    daily_friction: float = 0.03
    viscous_slope: Range = (0.01, 0.02)
    coulomb_slope: Range = (0.001, 0.005)
    workshop: Range = (18.0, 24.0)
    season: Range = (1.0, 6.0)
    daily: float = 1.5
    warm_up: Range = (3.0, 18.0)
    thermometer: float = 0.7
    temperature: bool = True
    sheet_inertial: float = 0.1
    sheet_friction: float = 0.3
    sheet_silent: float = 0.3


#: Numbers of a recipe that are shares, and those that are more than 0.
_SHARES: Final = (
    "short", "slow", "friction_units", "one_law", "play_units", "payload_units", "payload_always",
    "program_units", "clock_units", "clock_share",
    "date_units", "sheet_silent",
)  # fmt: skip
_POSITIVE: Final = ("days", "programs", "duration", "rates", "encoder_bits", "growth", "play_size",
                    "payload_size", "effect_size", "noise")  # fmt: skip


def read_recipe(path: Path, **options: int) -> Recipe:
    """The recipe in the TOML file ``path``: keys as of :class:`Recipe`, ranges as lists of two, effects a
    table of shares. ``options`` replace what it says.

    Raises
    ------
    InputError: it is no such file; with the place of what is wrong.
    """
    tables = Tables(
        read_text(path, LARGEST_RECIPE, "a recipe of a fleet, such as fleet-recipe.toml"), label(path)
    )
    known = {field.name: field.default for field in fields(Recipe)}
    tables.check_keys((), known)
    values = {name: _value(tables, name, value, known[name]) for name, value in tables.data.items()}
    return Recipe(**{**values, **options})


def _value(tables: Tables, name: str, value: Any, default: Any) -> Any:
    """The value of the key ``name``, of the kind of its ``default``."""
    if name == "effects":
        shares = tables.table(name)
        for id, share in shares.items():
            effect(id)
            _number(tables, (name, id), share, 1.0)
        return tuple(shares.items())
    most = 1.0 if name in _SHARES else math.inf
    positive = name in _POSITIVE
    if isinstance(default, bool):
        if not isinstance(value, bool):
            raise _wrong(tables, (name,), value, "true or false")
        return value
    if not isinstance(default, tuple):
        return _number(tables, (name,), value, most, positive=positive, whole=isinstance(default, int))
    if not isinstance(value, list) or not value or (name != "rates" and len(value) != 2):
        raise _wrong(tables, (name,), value, "a list of numbers" if name == "rates" else "[least, most]")
    whole = isinstance(default[0], int)
    numbers = tuple(_number(tables, (name,), each, most, positive=positive, whole=whole) for each in value)
    if name != "rates" and numbers[0] > numbers[1]:
        raise _wrong(tables, (name,), value, "[least, most]")
    if name == "logs" and numbers[0] < FEWEST_LOGS:
        raise _wrong(tables, (name,), value, f"{FEWEST_LOGS} logs of a unit, or more")
    return numbers


def _number(
    tables: Tables,
    at: tuple[str, ...],
    value: Any,
    most: float,
    *,
    positive: bool = False,
    whole: bool = False,
) -> float:
    kind = int if whole else (int, float)
    if (
        not isinstance(value, kind)
        or isinstance(value, bool)
        or not 0 <= value <= most
        or (positive and value == 0)
    ):
        what = "a whole number" if whole else "a number"
        above = ", more than 0" if positive else ", 0 or more"
        raise _wrong(tables, at, value, what + (" from 0 to 1" if most == 1 else above))
    return value if whole else float(value)


def _wrong(tables: Tables, at: tuple[str, ...], value: Any, expected: str) -> InputError:
    return InputError(
        f"{'.'.join(at)} of the recipe is wrong",
        where=tables.places.of(*at),
        found=shown(value),
        expected=expected,
    )
