"""What changes the rigid arm itself, and what acts on it from outside."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

from robodyn.effects.effect import Effect, Fault, Parameter, Values
from robodyn.effects.traits import Fold, Form, Hidden, Shown, Traits, Usual

#: Where these stand among the others, for a person who reads them.
ORDER = 60

_ZERO = Fraction(0)


def _load_form(u: Usual, way: float, rng: Any) -> Form:
    x0, y0, z0 = (float(v) for v in rng.uniform([-0.05, -0.05, 0.03], [0.05, 0.05, 0.15]))
    return Form(lambda x: {"mass": x, "com_x": x0, "com_y": y0, "com_z": z0}, 0.3, 1e-3, 50.0)


PAYLOAD = Effect(
    id="payload",
    title="Payload",
    level="robot",
    place="rigid",
    parameters=(
        Parameter("mass", "Mass.", "kg", sign="nonnegative", names=True, symbol="m"),
        Parameter(
            "com", "Centre of mass in the last link's frame.", "m", kind="vector", names=True, default=_ZERO,
        ),
        Parameter(
            "inertia", "About its centre of mass, along the last link's axes.", "kg m^2", kind="inertia",
            optional=True, names=True,
        ),
    ),
    latex=r"\tau = Y_n(q, \dot q, \ddot q)\,[m,\ m c,\ I]",
    doc="A body fixed to the last link.",
    signature="one body explains the residual of all joints, gravity most of it",
    rivals=("inertial_error", "base_tilt", "torque_gain", "encoder_offset"),
    separates="turning the wrist; a log of the same trajectory without the load",
    source="Atkeson, An and Hollerbach 1986",
    traits=Traits(
        noun="a payload", body=True, candidates=(Shown(6),), wide=True, hidden=Hidden(_load_form)
    ),
)  # fmt: skip


def _delta(name: str, what: str, unit: str) -> Parameter:
    return Parameter(name, f"Added to {what}.", unit, default=_ZERO, names=True)


def _numbers_form(u: Usual, way: float, rng: Any) -> Form:
    a, b = (float(v) for v in rng.standard_normal(2) * 0.05)
    return Form(
        lambda x: {"delta_mass": 0.5 * x * u.mass, "delta_com_x": a * x, "delta_com_y": b * x,
                   "delta_zz": 0.2 * x},
        0.3, 1e-3, 3.0,
    )  # fmt: skip


INERTIAL = Effect(
    id="inertial_error",
    title="Error of a link's inertial parameters",
    place="rigid",
    parameters=(
        _delta("delta_mass", "the mass", "kg"),
        *(_delta(f"delta_com_{axis}", f"the centre of mass, {axis}", "m") for axis in "xyz"),
        *(
            _delta(f"delta_{axes}", f"I{axes} about the centre of mass", "kg m^2")
            for axes in ("xx", "yy", "zz", "xy", "xz", "yz")
        ),
    ),
    latex=r"\tau = Y_k(q, \dot q, \ddot q)\,\Delta\varphi_k",
    doc="The link is not as described. Only what the torques of the arm depend on can be known; `diagnose` "
    "writes it into the link's own numbers.",
    signature="the residual follows the regressor of one link at all joints before it",
    rivals=("payload", "rotor_inertia", "spring"),
    separates="motions that excite that link's accelerations in all directions",
    source="Gautier and Khalil 1990",
    traits=Traits(
        noun="wrong inertial numbers",
        fold=Fold("link"), candidates=(Shown(8),), wide=True, hidden=Hidden(_numbers_form, needs="load")
    ),
)  # fmt: skip


def _tilt_form(u: Usual, way: float, rng: Any) -> Form:
    c, s = (float(f(rng.uniform(0, 2 * math.pi))) for f in (math.cos, math.sin))
    return Form(lambda x: {"tilt_x": x * c, "tilt_y": x * s}, 0.05, 1e-4, 0.25)


TILT = Effect(
    id="base_tilt",
    title="Tilt of the base",
    level="robot",
    place="rigid",
    parameters=(
        Parameter("tilt_x", "Angle about the base's x axis.", "rad", default=_ZERO, symbol=r"\epsilon_x"),
        Parameter(
            "tilt_y", "Angle about the base's y axis, after that.", "rad", default=_ZERO, symbol=r"\epsilon_y"
        ),
    ),
    latex=r"g \leftarrow R_y(\epsilon_y) R_x(\epsilon_x)\, g",
    doc="Gravity is turned in the frame in which it is stated, first about x, then about y: the base's, or "
    "the world's where the description has `base`.",
    signature="the residual depends on the pose alone, and on the first joint too, as nothing else of "
    "gravity does",
    rivals=("payload", "encoder_offset", "spring"),
    separates="turning the first joint by more than 120 degrees with the arm stretched out",
    source="Craig, Introduction to Robotics, section 6.5",
    traits=Traits(
        noun="a tilted base",
        fold=Fold("gravity"), candidates=(Shown(3),), reevaluate=True, wide=True, hidden=Hidden(_tilt_form)
    ),
)  # fmt: skip


def _window(p: Values, revolute: bool) -> Fault | None:
    expected = f"more than {float(p['start'])!r} s"
    fault = Fault("end", "is not after the start", expected, "exchange the two")
    return fault if p["end"] <= p["start"] else None


def _push_form(u: Usual, way: float, rng: Any) -> Form:
    start = float(rng.uniform(0.2, 0.7)) * u.duration
    end = start + float(rng.uniform(0.03, 0.08)) * u.duration
    push = rng.standard_normal(3)
    size = math.sqrt(sum(float(x) ** 2 for x in push))
    window = {"start": round(start, 3), "end": round(end, 3), "link": float(u.joints)}
    force = {f"force_{axis}": float(x) / size for axis, x in zip("xyz", push, strict=True)}
    return Form(lambda x: {**window, **{k: x * f for k, f in force.items()}}, 30.0, 0.01, 500.0)


CONTACT = Effect(
    id="external_contact",
    title="Contact with something outside",
    level="robot",
    place="outside",
    parameters=(
        Parameter("start", "Beginning of the window.", "s"),
        Parameter("end", "End of the window.", "s"),
        Parameter("link", "Number of the link that is touched.", kind="joint"),
        *(
            Parameter(
                f"force_{axis}", f"Force on the link at its frame's origin, along the base's {axis}.", "N",
                default=_ZERO, symbol=f"F_{axis}",
            )
            for axis in "xyz"
        ),
        Parameter(
            "log", "Hash of the log in which it was found: then it is a note, and not simulated.",
            kind="text", optional=True,
        ),
    ),
    latex=r"\tau = -J_k(q)^T F, \quad t_0 \le t \le t_1",
    doc="A force in a window of time. Reported, simulated where it has no `log`, never part of a kernel.",
    signature="a burst in time that the state of the arm does not repeat, of the form of a force on one link",
    rivals=(),
    separates="the same motion again",
    source="De Luca and Mattone 2005",
    check=_window,
    traits=Traits(
        several=True, wide=True, hidden=Hidden(_push_form), over="a short time"
    ),
)  # fmt: skip

EFFECTS = (PAYLOAD, INERTIAL, TILT, CONTACT)
