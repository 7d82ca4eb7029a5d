"""What drives the motors in a simulation: tables, controllers, a function of Python."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robodyn.errors import InputError

Floats = NDArray[np.float64]
Callback = Callable[[float, Floats, Floats], ArrayLike]

HELD_TABLE, LINEAR_TABLE, PD, COMPUTED_TORQUE, CALLBACK = range(5)


@dataclass(frozen=True, slots=True)
class Control:
    """Torques of m motors, decided every ``period`` [s] and held (but for ``linear``). Make one with

    ``none()``, ``held(torque, period)``, ``linear(torque, period)``,
    ``pd(q, qd, period, kp, kd, torque=None)``, ``computed(q, qd, qdd, period, kp, kd)``,
    ``function(callback, motors, period)``.

    Tables are [rows, m], one row each period from t = 0; the last row stays. ``place`` and ``seen`` [m] are
    the coordinates (from 0) that the motors drive and their encoders read; default: motor j coordinate j.
    ``limit`` [m] is the largest torque [N m or N] that the drives give.
    """

    kind: int
    period: float
    motors: int
    rows: int = 1
    torque: Floats = field(default_factory=lambda: np.zeros(0))
    q: Floats = field(default_factory=lambda: np.zeros(0))
    qd: Floats = field(default_factory=lambda: np.zeros(0))
    qdd: Floats = field(default_factory=lambda: np.zeros(0))
    kp: Floats = field(default_factory=lambda: np.zeros(0))
    kd: Floats = field(default_factory=lambda: np.zeros(0))
    callback: Callback | None = None
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
    def held(
        cls,
        torque: ArrayLike,
        period: float,
        *,
        limit: ArrayLike | None = None,
        place: Sequence[int] | None = None,
        seen: Sequence[int] | None = None,
    ) -> Control:
        """Row k of ``torque`` [rows, m] from k ``period`` to the next."""
        table = _table("torque", torque)
        return _control(HELD_TABLE, period, table.shape, limit, place, seen, torque=table)

    @classmethod
    def linear(
        cls,
        torque: ArrayLike,
        period: float,
        *,
        limit: ArrayLike | None = None,
        place: Sequence[int] | None = None,
        seen: Sequence[int] | None = None,
    ) -> Control:
        """Straight lines between the rows of ``torque`` [rows, m]."""
        table = _table("torque", torque)
        return _control(LINEAR_TABLE, period, table.shape, limit, place, seen, torque=table)

    @classmethod
    def pd(
        cls,
        q: ArrayLike,
        qd: ArrayLike,
        period: float,
        kp: ArrayLike,
        kd: ArrayLike,
        *,
        torque: ArrayLike | None = None,
        limit: ArrayLike | None = None,
        place: Sequence[int] | None = None,
        seen: Sequence[int] | None = None,
    ) -> Control:
        """``torque + kp (q - y) + kd (qd - v)``; all tables [rows, m], gains [m]."""
        table = _table("q", q)
        shape = table.shape
        ahead = np.zeros(shape) if torque is None else _table("torque", torque, shape)
        return _control(
            PD, period, shape, limit, place, seen,
            torque=ahead, q=table, qd=_table("qd", qd, shape),
            kp=_gains("kp", kp, shape[1]), kd=_gains("kd", kd, shape[1]),
        )  # fmt: skip

    @classmethod
    def computed(
        cls,
        q: ArrayLike,
        qd: ArrayLike,
        qdd: ArrayLike,
        period: float,
        kp: ArrayLike,
        kd: ArrayLike,
        *,
        limit: ArrayLike | None = None,
        place: Sequence[int] | None = None,
        seen: Sequence[int] | None = None,
    ) -> Control:
        """``model(y, v, qdd + kd (qd - v) + kp (q - y))`` with the system's own ``model``."""
        table = _table("q", q)
        shape = table.shape
        return _control(
            COMPUTED_TORQUE, period, shape, limit, place, seen,
            q=table, qd=_table("qd", qd, shape), qdd=_table("qdd", qdd, shape),
            kp=_gains("kp", kp, shape[1]), kd=_gains("kd", kd, shape[1]),
        )  # fmt: skip

    @classmethod
    def function(
        cls,
        callback: Callback,
        motors: int,
        period: float,
        *,
        limit: ArrayLike | None = None,
        place: Sequence[int] | None = None,
        seen: Sequence[int] | None = None,
    ) -> Control:
        """``callback(t, y, v)`` gives the torques [m] from what the encoders read, [m] each."""
        return _control(CALLBACK, period, (1, motors), limit, place, seen, callback=callback)


def _control(
    kind: int,
    period: float,
    shape: tuple[int, ...],
    limit: ArrayLike | None,
    place: Sequence[int] | None,
    seen: Sequence[int] | None,
    callback: Callback | None = None,
    **tables: Floats,
) -> Control:
    rows, motors = shape
    if not period > 0:
        raise InputError("the period of the control is not a time", found=f"{period}", expected="more than 0")
    limits = None if limit is None else _gains("limit", limit, motors)
    driven = tuple(range(motors)) if place is None else tuple(place)
    read = driven if seen is None else tuple(seen)
    for name, places in (("place", driven), ("seen", read)):
        if len(places) != motors or any(k < 0 for k in places):
            raise InputError(
                f"{name} does not fit the motors", found=f"{places}", expected=f"{motors} coordinates"
            )
    return Control(
        kind, period, motors, rows, callback=callback, limit=limits, place=driven, seen=read, **tables
    )


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
