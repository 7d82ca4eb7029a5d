"""What turns with the motor: its rotor, its ripple, and motors that drive two joints."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from robodyn.effects.effect import Effect, Fault, Parameter, Values
from robodyn.effects.friction import FORCE, SHARE, TORQUE, level
from robodyn.effects.scalars import cosine, sine
from robodyn.effects.traits import Fold, Form, Hidden, Law, Shown, Traits, Usual, Wave, between

#: Where these stand among the others, for a person who reads them.
ORDER = 50

ROTOR = Effect(
    id="rotor_inertia",
    title="Rotor inertia",
    place="rigid",
    parameters=(
        Parameter(
            "inertia", "Inertia of rotor and gear, reflected to the joint.", "kg m^2", "kg",
            sign="nonnegative", names=True, symbol="I_r",
        ),
    ),
    latex=r"\tau = I_r\,\ddot q",
    doc="Adds to `motor_inertia`, where it is better written.",
    signature="in phase with the joint's own acceleration",
    rivals=("inertial_error", "time_delay"),
    separates="poses in which the arm's own inertia about the joint differs",
    source="Craig, Introduction to Robotics, section 9.10",
    equation=lambda p, at: p["inertia"] * at.qdd,
    linear=("inertia",),
    traits=Traits(
        fold=Fold("joint", "motor_inertia", "inertia"),
        candidates=(Law(lambda values, at: (at.qdd,), (1,), lambda x, values: {"inertia": float(x[0])}, 1),),
        wide=True,
        hidden=Hidden(lambda u, way, rng: Form(lambda x: {"inertia": x}, SHARE * u.tau / u.rate)),
        over="acceleration",
    ),
)  # fmt: skip


#: A phase [rad] beyond this would take digits from the position that it is added to.
_LARGEST_PHASE = 10_000


def _ripple_fault(p: Values, revolute: bool) -> Fault | None:
    what = "is so many turns that a position added to it loses its digits"
    fault = Fault("phase", what, f"-{_LARGEST_PHASE} to {_LARGEST_PHASE} rad", "take whole turns off")
    return fault if abs(p["phase"]) > _LARGEST_PHASE else None


def _ripple_energy(p: Values, q: Any) -> Any:
    return -(p["amplitude"] / p["cycles_per_rev"] * cosine(p["cycles_per_rev"] * q + p["phase"]))


def _wave_read(x: Sequence[float], values: Mapping[str, float]) -> dict[str, float | str]:
    amplitude, phase = float(math.hypot(x[0], x[1])), float(math.atan2(x[1], x[0]))
    return {"amplitude": amplitude, "cycles_per_rev": values["cycles"], "phase": phase}


def _ripple_form(u: Usual, way: float, rng: Any) -> Form:
    waves, phase = float(round(between(rng, 20, 60))), float(rng.uniform(-3, 3))
    return Form(lambda x: {"amplitude": x, "cycles_per_rev": waves, "phase": phase}, SHARE * u.tau)


RIPPLE = Effect(
    id="torque_ripple",
    title="Torque ripple",
    place="motor",
    parameters=(
        Parameter(
            "amplitude", "Size of the ripple.", TORQUE, FORCE, sign="nonnegative", names=True, symbol="A",
        ),
        Parameter(
            "cycles_per_rev", "Ripples in a turn of the joint; prismatic: in 2 pi m.", "1", "1/m",
            sign="positive", symbol="N",
        ),
        Parameter("phase", "Phase at q = 0.", "rad", default=Fraction(0), symbol=r"\varphi"),
    ),
    latex=r"\tau = A \sin(N q + \varphi)",
    doc="A wave over the joint's position: cogging, gear teeth, the wave generator of a harmonic drive.",
    signature="a peak in the spectrum over angle, at the same angle at every speed",
    rivals=("spring", "presliding_hysteresis"),
    separates="slow sweeps recorded at the full rate; a low-pass filter erases it",
    source="Preissner, Royston and Shu 2012",
    equation=lambda p, at: p["amplitude"] * sine(p["cycles_per_rev"] * at.q + p["phase"]),
    potential=_ripple_energy,
    check=_ripple_fault,
    linear=("amplitude",),
    traits=Traits(
        several=True,
        combines="waves",
        candidates=(Wave(_wave_read, 4, (1.002, 1.0001)),),
        hidden=Hidden(_ripple_form),
        cycles="cycles_per_rev",
    ),
)  # fmt: skip


def _coupled_form(u: Usual, way: float, rng: Any) -> Form:
    return Form(
        lambda x: {
            "with": float(u.joint - 1), "ratio": way, "inertia": 0.6 * x / u.rate,
            "viscous": 0.5 * x / u.speed, "coulomb": 0.5 * x,
        },
        SHARE * u.tau,
    )  # fmt: skip


COUPLING = Effect(
    id="motor_coupling",
    title="A motor that drives two joints",
    level="pair",
    place="pair",
    parameters=(
        Parameter("with", "Number of the other joint.", kind="joint"),
        Parameter(
            "ratio", "What a turn of the other joint turns the motor.", "1", default=Fraction(1),
            symbol=r"\rho",
        ),
        Parameter(
            "inertia", "Inertia of the motor.", "kg m^2", "kg", sign="nonnegative", default=Fraction(0),
            names=True, symbol="I",
        ),
        Parameter(
            "viscous", "Its viscous friction.", "N m s/rad", "N s/m", sign="nonnegative", default=Fraction(0),
            names=True, symbol="F_v",
        ),
        level("coulomb", "Its Coulomb friction.", "F_c", default=Fraction(0)),
    ),
    latex=r"u = q_j + \rho\,q_k, \quad T = I\ddot u + F_v\dot u + F_c\operatorname{sgn}\dot u, \quad"
    r"\tau_j \mathrel{+}= T, \ \tau_k \mathrel{+}= \rho\,T",
    doc="A motor that turns with joint j and, by `ratio`, with joint k, as in the wrists whose last motor "
    "drives through the joint before.",
    signature="the torque of either joint contains velocity and acceleration of the other",
    rivals=("inertial_error", "rotor_inertia"),
    separates="moving the two joints at different frequencies",
    source="Gautier 1996; Staubli TX40",
    equation=lambda p, at: p["inertia"] * at.qdd + p["viscous"] * at.qd + p["coulomb"] * at.direction,
    linear=("inertia", "viscous", "coulomb"),
    dissipative=True,
    traits=Traits(
        # Without the motor's inertia it is two joints that rub alike.
        candidates=(Shown(5, feasible=lambda x: bool(x[0] > 0)),),
        contains=("rotor_inertia", "viscous_friction", "coulomb_friction"),
        chosen=("with", "ratio"),
        wide=True,
        hidden=Hidden(_coupled_form),
    ),
)  # fmt: skip

EFFECTS = (ROTOR, RIPPLE, COUPLING)
