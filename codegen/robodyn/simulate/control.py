"""What drives the motors in a simulation: tables and controllers."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from robodyn.arrays import Floats
from robodyn.errors import InputError

HELD_TABLE, LINEAR_TABLE, PD, COMPUTED_TORQUE = range(4)


def _none() -> Floats:
    return np.zeros(0)


@dataclass(frozen=True, slots=True)
class Control:
    """Torques of m motors, decided every ``period`` [s] and held (but for ``linear``). Make one with

    ``none()``, ``held(torque, period)``, ``linear(torque, period)``,
    ``pd(q, qd, period, kp, kd, torque=None)``, ``computed(q, qd, qdd, period, kp, kd)``.

    Tables are [rows, m], one row each period from t = 0; the last row stays. All take ``place`` and ``seen``
    [m], the coordinates (from 0) that the motors drive and their encoders read (default: motor j coordinate
    j), and ``limit`` [m], the largest torque [N m or N] that the drives give.
    """

    kind: int
    period: float
    motors: int
    rows: int = 1
    torque: Floats = field(default_factory=_none)
    q: Floats = field(default_factory=_none)
    qd: Floats = field(default_factory=_none)
    qdd: Floats = field(default_factory=_none)
    kp: Floats = field(default_factory=_none)
    kd: Floats = field(default_factory=_none)
    limit: Floats | None = None
    place: tuple[int, ...] = ()
    seen: tuple[int, ...] = ()

    @property
    def model(self) -> bool:
        """Whether the system's own inverse dynamics is needed."""
        return self.kind == COMPUTED_TORQUE

    @classmethod
    def none(cls) -> Control:
        """No motor at all."""
        return cls(HELD_TABLE, math.inf, 0)

    @classmethod
    def held(cls, torque: ArrayLike, period: float, **motors: Any) -> Control:
        """Row k of ``torque`` [rows, m] from k ``period`` to the next."""
        return _control(HELD_TABLE, period, {"torque": torque}, **motors)

    @classmethod
    def linear(cls, torque: ArrayLike, period: float, **motors: Any) -> Control:
        """Straight lines between the rows of ``torque`` [rows, m]."""
        return _control(LINEAR_TABLE, period, {"torque": torque}, **motors)

    @classmethod
    def pd(
        cls, q: ArrayLike, qd: ArrayLike, period: float, kp: ArrayLike, kd: ArrayLike,
        *, torque: ArrayLike | None = None, **motors: Any,
    ) -> Control:  # fmt: skip
        """``torque + kp (q - y) + kd (qd - v)``; all tables [rows, m], gains [m]."""
        ahead = np.zeros(np.shape(q)) if torque is None else torque
        return _control(PD, period, {"q": q, "qd": qd, "torque": ahead}, {"kp": kp, "kd": kd}, **motors)

    @classmethod
    def computed(
        cls, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, period: float, kp: ArrayLike, kd: ArrayLike,
        **motors: Any,
    ) -> Control:  # fmt: skip
        """``model(y, v, qdd + kd (qd - v) + kp (q - y))`` with the system's own ``model``."""
        tables = {"q": q, "qd": qd, "qdd": qdd}
        return _control(COMPUTED_TORQUE, period, tables, {"kp": kp, "kd": kd}, **motors)


def _control(
    kind: int,
    period: float,
    tables: Mapping[str, ArrayLike],
    gains: Mapping[str, ArrayLike] | None = None,
    *,
    limit: ArrayLike | None = None,
    place: Sequence[int] | None = None,
    seen: Sequence[int] | None = None,
) -> Control:
    arrays: dict[str, Any] = {}
    for name, values in tables.items():
        arrays[name] = _table(name, values, next((each.shape for each in arrays.values()), None))
    rows, motors = next(iter(arrays.values())).shape
    if not period > 0:
        raise InputError("the period of the control is not a time", found=f"{period}", expected="more than 0")
    for name, value in (*(gains or {}).items(), ("limit", limit)):
        arrays[name] = None if value is None else _gains(name, value, motors)
    driven = tuple(range(motors)) if place is None else tuple(place)
    read = driven if seen is None else tuple(seen)
    for name, places in (("place", driven), ("seen", read)):
        if len(places) != motors or any(k < 0 for k in places):
            raise InputError(
                f"{name} does not fit the motors", found=f"{places}", expected=f"{motors} coordinates"
            )
    return Control(kind, period, motors, rows, place=driven, seen=read, **arrays)


def _table(name: str, values: ArrayLike, shape: tuple[int, ...] | None = None) -> Floats:
    """A table [rows, m] of finite numbers; of ``shape`` if that is given."""
    table = np.array(values, dtype=np.float64, order="C")
    if table.ndim != 2 or len(table) == 0 or (shape is not None and table.shape != shape):
        expected = "[rows, motors]" if shape is None else f"{list(shape)}"
        raise InputError(
            f"the table {name} has the wrong shape", found=f"{list(table.shape)}", expected=expected
        )
    if not np.isfinite(table).all():
        row = int(np.nonzero(~np.isfinite(table))[0][0])
        raise InputError(f"the table {name} has a number that is not finite", found=f"row {row} {table[row]}")
    return table


def _gains(name: str, values: ArrayLike, motors: int) -> Floats:
    gains = np.array(values, dtype=np.float64)
    if gains.ndim == 0:
        gains = np.full(motors, float(gains))
    if gains.shape != (motors,) or np.isnan(gains).any():
        raise InputError(
            f"{name} does not fit the motors", found=f"{gains.tolist()}", expected=f"{motors} numbers"
        )
    return gains
