"""What is lost under load: friction in the bearings, and in the gear."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any, Literal

from robodyn.effects import thesis_friction as thesis
from robodyn.effects.effect import Effect, Fault, Parameter, Site, Values
from robodyn.effects.efficiency import efficiency_at
from robodyn.effects.friction import FORCE, TORQUE, level
from robodyn.effects.scalars import magnitude, root
from robodyn.effects.traits import Form, Hidden, Law, Traits, Usual

#: Where these stand among the others, for a person who reads them.
ORDER = 30

# --- bearings ---------------------------------------------------------------------------------------------

BEARINGS = ("journal", "linear", "thrust", "radial", "torque")


def _bearing(p: Values, at: Site) -> Any:
    kind = p["bearing"]
    if kind == "torque":
        return p["mu"] * magnitude(at.tau) * at.direction
    if kind == "linear":
        return thesis.linear_bearing(p["mu"], p["span"], at.f, at.n, at.direction)
    mu, r = (p["mu_r"], 1) if "mu_r" in p else (p["mu"], p["radius"])
    if kind == "thrust":
        return thesis.thrust_bearing(mu, r, at.f, at.direction)
    if kind == "journal" and "span" in p:
        printed = p.get("variant") == "printed"
        return thesis.journal_bearing(mu, r, p["span"], at.f, at.n, at.direction, as_printed=printed)
    return mu * r * root(at.f[0] * at.f[0] + at.f[1] * at.f[1]) * at.direction


#: What each bearing must have; of sets of names one.
_ROUND: tuple[tuple[str, ...], ...] = (("mu", "radius"), ("mu_r",))
_NEEDS = {**dict.fromkeys(BEARINGS, _ROUND), "linear": (("mu", "span"),), "torque": (("mu",),)}


def _bearing_fault(p: Values, revolute: bool) -> Fault | None:
    kind = p["bearing"]
    if kind != "torque" and (kind == "linear") == revolute:
        fit = "linear or torque" if kind != "linear" else "journal, thrust, radial or torque"
        joint = "a revolute" if revolute else "a prismatic"
        return Fault("bearing", f"'{kind}' does not fit {joint} joint", fit, "choose one of those")
    sets = _NEEDS[kind]
    if not any(all(name in p for name in names) for names in sets):
        wanted = " or ".join(" and ".join(names) for names in sets)
        return Fault("bearing", f"'{kind}' lacks a number", wanted, f"give {wanted}")
    allowed = {"bearing", *(name for names in sets for name in names)}
    allowed |= {"span", "variant"} if kind == "journal" else set()
    for name in p:
        if name not in allowed:
            what = f"means nothing to a '{kind}' bearing"
            return Fault(name, what, ", ".join(sorted(allowed)), "delete it")
    twice = "mu_r" in p and ("mu" in p or "radius" in p)
    what = "stands beside mu or radius, whose product it is"
    return Fault("mu_r", what, "one or the other", "delete one") if twice else None


#: Distances of two bearings that are tried [m], and efficiencies of a gear.
_SPANS = (0.03, 0.1, 0.3, 1.0)
_EFFICIENCIES = (0.3, 0.45, 0.6, 0.7, 0.8, 0.88, 0.94)


def _pressed(bearing: str, name: str, kind: Literal["any", "revolute", "prismatic"], spans: bool) -> Law:
    """A bearing of which the parameter ``name`` is to be found, with or without a span."""
    return Law(
        lambda values, at: (_bearing({"bearing": bearing, name: 1.0, **values}, at),), (1,),
        lambda x, values: {"bearing": bearing, name: float(x[0]), **values}, 2,
        grid=tuple({"span": span} for span in _SPANS) if spans else ({},), kind=kind,
    )  # fmt: skip


def _bearing_form(u: Usual, way: float, rng: Any) -> Form:
    if not u.revolute:
        return Form(lambda x: {"bearing": "linear", "mu": x, "span": 0.3}, 0.05, 1e-4, 0.5)
    if rng.random() < 0.5:
        return Form(lambda x: {"bearing": "torque", "mu": x}, 0.05, 1e-3, 0.5)
    return Form(lambda x: {"bearing": "radial", "mu_r": x}, 0.005, 1e-5, 0.1)


LOAD = Effect(
    id="load_dependent_friction",
    title="Load-dependent friction in bearings",
    place="bearing",
    parameters=(
        Parameter("bearing", "Kind of the bearing.", kind="choice", choices=BEARINGS),
        Parameter(
            "mu", "Coefficient of friction.", "1", sign="nonnegative", optional=True, names=True,
            symbol=r"\mu",
        ),
        Parameter(
            "radius", "Radius of the bearing.", "m", sign="positive", optional=True, names=True, symbol="r",
        ),
        Parameter(
            "span", "Distance of the two bearings.", "m", sign="positive", optional=True, names=True,
            symbol="d",
        ),
        Parameter(
            "mu_r", "Product of mu and radius.", "m", sign="nonnegative", optional=True, names=True,
            symbol=r"\mu r",
        ),
        Parameter(
            "variant", "Eq 3.3 corrected, or with the sign that the thesis prints.", kind="choice",
            choices=("corrected", "printed"), optional=True,
        ),
    ),
    latex=r"\begin{aligned}"
    r"\text{journal: } & \tau = \tfrac{\mu r}{d}"
    r"\Bigl[\sqrt{(\tfrac d2 f_x + n_y)^2 + (\tfrac d2 f_y - n_x)^2}"
    r" + \sqrt{(\tfrac d2 f_x - n_y)^2 + (\tfrac d2 f_y + n_x)^2}\Bigr]\operatorname{sgn}\dot q \\"
    r"\text{linear: } & \tau = \tfrac{\mu}{d}\bigl[|\tfrac d2 f_x - n_y| + |\tfrac d2 f_x + n_y|"
    r" + |\tfrac d2 f_y - n_x| + |\tfrac d2 f_y + n_x|\bigr]\operatorname{sgn}\dot q \\"
    r"\text{thrust: } & \tau = \mu r |f_z| \operatorname{sgn}\dot q, \quad"
    r"\text{radial: } \tau = \mu r \sqrt{f_x^2 + f_y^2}\,\operatorname{sgn}\dot q, \quad"
    r"\text{torque: } \tau = \mu |\tau_L| \operatorname{sgn}\dot q \end{aligned}",
    doc="Coulomb friction in bearings under the load that the arm puts on them: two journals `span` apart "
    "(without `span` as `radial`), two sliding bearings, a thrust bearing, the radial force alone, or a "
    "share of the joint torque. f and n act about the origin of the link's modified DH frame, z along the "
    "joint, also where the description is in standard DH. `variant: printed` has n_x in Eq 3.3 with the sign "
    "of n_y, as the thesis prints it.",
    signature="the friction band widens with the load, in both directions alike",
    rivals=("coulomb_friction", "transmission_loss", "torque_gain"),
    separates="poses of much reaction and little torque (the arm upright, then stretched out), a change of "
    "payload, and both directions through the same pose",
    source="Dhanaraj 1990, Eqs 3.3 to 3.5 and Table 3.1, Eq 3.3 corrected",
    equation=_bearing,
    check=_bearing_fault,
    linear=("mu", "mu_r"),
    dissipative=True,
    needs_load=True,
    traits=Traits(
        several=True,
        combines="bearings",
        candidates=(
            _pressed("journal", "mu_r", "revolute", spans=True),
            _pressed("linear", "mu", "prismatic", spans=True),
            _pressed("torque", "mu", "any", spans=False),
            _pressed("radial", "mu_r", "revolute", spans=False),
            _pressed("thrust", "mu_r", "revolute", spans=False),
        ),
        hidden=Hidden(_bearing_form, needs="load"),
        over="load, each way",
    ),
)  # fmt: skip


# --- the gear ---------------------------------------------------------------------------------------------


def _loss(p: Values, at: Site) -> Any:
    """Table 3.2: ``tau/eta`` where the motor drives, ``tau eta`` where it brakes.

    Both cases as one; a direction between -1 and 1 gives that share of the loss of its case, and never feeds
    energy in; at rest there is no loss.
    """
    total = p["breakaway"] * at.direction
    share = p["efficiency"]
    if isinstance(share, tuple):
        share = efficiency_at(magnitude(at.tau) / p["rated_torque"], share, p["interpolation"])
    elif share == 1:
        return total
    inverse = 1 / share
    even = (inverse + share) / 2 - 1
    odd = (inverse - share) / 2
    s = at.direction
    return at.tau * even * magnitude(s) + magnitude(at.tau) * odd * s + total


def _loss_fault(p: Values, revolute: bool) -> Fault | None:
    table = isinstance(p["efficiency"], tuple)
    if table and "rated_torque" not in p:
        what, expected = (
            "is a table, and rated_torque is missing",
            "rated_torque: the torque of load fraction 1",
        )
        return Fault("efficiency", what, expected, "give rated_torque")
    if not table and "rated_torque" in p:
        return Fault("rated_torque", "means nothing to a constant efficiency", "a table", "delete it")
    return None


def _loss_columns(values: Values, at: Site) -> tuple[Any, Any]:
    """Torques by a factor of the loss, which is 1 where the efficiency is right, and by the breakaway."""
    return _loss({"breakaway": 0.0, **values}, at), _loss({"breakaway": 1.0, "efficiency": 1}, at)


def _loss_read(x: Sequence[float], values: Mapping[str, float]) -> dict[str, float | str]:
    inverse = 1 + float(x[0]) * (1 / values["efficiency"] - 1)
    return {"efficiency": min(1.0, 1 / inverse), "breakaway": float(max(x[1], 0.0))}


def _loss_form(u: Usual, way: float, rng: Any) -> Form:
    rest = float(rng.choice([0.0, 0.3]))
    return Form(lambda x: {"efficiency": 1 / (1 + x), "breakaway": rest * x * u.tau}, 0.05, 0.003, 1.5)


TRANSMISSION = Effect(
    id="transmission_loss",
    title="Transmission loss",
    place="gear",
    parameters=(
        level("breakaway", "Breakaway torque, referred to the joint's side.", r"\tau_B", default=Fraction(0)),
        Parameter(
            "efficiency", "A number, or [[load fraction, efficiency], ...].", "1", kind="efficiency",
            sign="share", default=Fraction(1), symbol=r"\eta",
        ),
        Parameter(
            "rated_torque", "Torque of load fraction 1.", TORQUE, FORCE, sign="positive", optional=True,
            symbol=r"\tau_{\max}",
        ),
        Parameter(
            "interpolation", "Between the knots of a table.", kind="choice", choices=("linear", "cubic"),
            default="linear",
        ),
    ),
    latex=r"\tau_{in} = \begin{cases} \tau + (1/\eta - 1)\,\tau\,|s| + \tau_B s & \tau s \ge 0 \\"
    r" \tau + (\eta - 1)\,\tau\,|s| + \tau_B s & \tau s < 0 \end{cases},"
    r" \qquad s = \operatorname{sgn}\dot q, \quad \eta = \eta(|\tau|/\tau_{\max})",
    doc="What a harmonic drive loses: the motor must give more than the joint takes when it drives, tau/eta, "
    "and gets less back when it brakes, tau eta (Table 3.2, all four quadrants), and a breakaway torque "
    "besides. Rotor inertia acts before the gear. A cubic through the knots is the monotone one of "
    "Fritsch and Butland (PCHIP: weighted harmonic means for slopes, three-point ones at the ends); beyond "
    "the outer knots the curve stays level.",
    signature="two branches over the joint torque: steeper than 1 where the motor drives, flatter where it "
    "brakes",
    rivals=("load_dependent_friction", "torque_gain", "coulomb_friction"),
    separates="lifting and lowering, and loads of three to one",
    source="Dhanaraj 1990, section 3.4, Table 3.2",
    equation=_loss,
    check=_loss_fault,
    linear=("breakaway",),
    dissipative=True,
    needs_load=True,
    traits=Traits(
        one_way="nearly",
        candidates=(
            Law(_loss_columns, (1, 1), _loss_read, 2, grid=tuple({"efficiency": e} for e in _EFFICIENCIES)),
        ),
        contains=("coulomb_friction",),
        hidden=Hidden(_loss_form, needs="load"),
        over="load, each way",
        nothing={"efficiency": 1.0},
    ),
)  # fmt: skip

EFFECTS = (LOAD, TRANSMISSION)
