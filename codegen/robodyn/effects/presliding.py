"""Presliding friction: a contact that deflects elastically before it slides."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from robodyn.effects.effect import Effect, Memory, Parameter, Site, Values
from robodyn.effects.friction import FORCE, SHARE, TORQUE
from robodyn.effects.scalars import exponential, is_finite, is_positive, magnitude, power, sign
from robodyn.effects.traits import Dahl, Form, Hidden, Traits, Usual, between

#: Where it stands among the others, for a person who reads them.
ORDER = 20


def _bristle_rate(p: Values, at: Site, state: tuple[Any, ...]) -> tuple[Any, ...]:
    (z,) = state
    return (at.qd - p["stiffness"] * magnitude(at.qd) / p["level"] * z,)


def _bristle_torque(p: Values, at: Site, state: tuple[Any, ...]) -> Any:
    (z,) = state
    (rate,) = _bristle_rate(p, at, state)
    return p["stiffness"] * z + p["damping"] * rate


def _bristle_step(p: Values, at: Site, state: tuple[Any, ...], dt: Any) -> tuple[tuple[Any, ...], Any]:
    # Exact for a velocity that is constant over dt: stable for any dt, however stiff the bristles. Where the
    # velocity or dt is infinite or no number, or dt negative, z stays, to the bit: left is 1 then, full 0.
    (z,) = state
    way = p["stiffness"] * magnitude(at.qd) / p["level"] * dt
    moving = is_positive(way) * is_finite(way)
    left = power(exponential(-magnitude(way)), moving)
    full = p["level"] / p["stiffness"] * (sign(at.qd) * moving)
    moved = (full + (z - full) * left,)
    # That a velocity is no number shows in the torque all the same.
    nothing = magnitude(at.qd) - sign(at.qd) * at.qd
    return moved, _bristle_torque(p, at, moved) + nothing


def _bristle_form(u: Usual, way: float, rng: Any) -> Form:
    bend = between(rng, 3e-3, 2e-2) * (1.0 if u.revolute else 0.3)
    return Form(lambda x: {"level": x, "stiffness": x / bend, "damping": 0.01 * x / bend}, SHARE * u.tau)


#: Damping by stiffness [s] from which it is refined.
_DAMPED = 3e-3


def _bristle_read(x: Sequence[float], values: Mapping[str, float]) -> dict[str, float | str]:
    stiffness = float(x[0] / values["bend"])
    return {"level": float(x[0]), "stiffness": stiffness, "damping": _DAMPED * stiffness}


PRESLIDING = Effect(
    id="presliding_hysteresis",
    title="Presliding hysteresis (LuGre)",
    place="motor",
    parameters=(
        Parameter(
            "stiffness", "Stiffness of the contact before it slides.", "N m/rad", "N/m", sign="positive",
            names=True, symbol=r"\sigma_0",
        ),
        Parameter(
            "level", "Coulomb level, reached when it slides.", TORQUE, FORCE, sign="positive", names=True,
            symbol="F_c",
        ),
        Parameter(
            "damping", "Damping of the contact.", "N m s/rad", "N s/m", sign="nonnegative",
            default=Fraction(0), names=True, symbol=r"\sigma_1",
        ),
    ),
    latex=r"\dot z = \dot q - \frac{\sigma_0 |\dot q|}{F_c} z, \qquad \tau = \sigma_0 z + \sigma_1 \dot z",
    doc="The contact is a spring until it slides: friction depends on the way since the last reversal. "
    "State z [rad or m] is how far it is bent; begun at z = 0 it never feeds energy in. In steady motion, "
    "and in functions without memory, tau is F_c sgn(qd).",
    signature="after a reversal the torque follows the distance, not the velocity; a loop over position",
    rivals=("coulomb_friction", "stribeck_friction", "backlash", "joint_elasticity"),
    separates="reversals of several amplitudes below level/stiffness",
    source="Canudas de Wit, Olsson, Astrom and Lischinsky 1995; Dahl 1968 without damping",
    equation=lambda p, at: p["level"] * at.direction,
    memory=Memory(("z",), _bristle_step, _bristle_rate, _bristle_torque),
    dissipative=True,
    traits=Traits(
        levels=("level",),
        one_way="nearly",
        steady=("coulomb_friction", ("level",)),
        adds=("level",),
        candidates=(
            Dahl(
                "level", "stiffness", "damping", (1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2), _bristle_read, 3,
            ),
        ),
        hidden=Hidden(_bristle_form),
        over="velocity",
    ),
)  # fmt: skip

EFFECTS = (PRESLIDING,)
