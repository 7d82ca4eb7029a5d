"""What is lost under load: friction in the bearings, and in the gear."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from robodyn.effects import thesis_friction as thesis
from robodyn.effects.effect import Effect, Fault, Parameter, Site, Values
from robodyn.effects.efficiency import efficiency_at
from robodyn.effects.friction import FORCE, TORQUE, level
from robodyn.effects.scalars import magnitude, root

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
_NEEDS: dict[str, tuple[tuple[str, ...], ...]] = {
    "journal": (("mu", "radius"), ("mu_r",)),
    "radial": (("mu", "radius"), ("mu_r",)),
    "thrust": (("mu", "radius"), ("mu_r",)),
    "linear": (("mu", "span"),),
    "torque": (("mu",),),
}


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
            return Fault(
                name, f"means nothing to a '{kind}' bearing", ", ".join(sorted(allowed)), "delete it"
            )
    if "mu_r" in p and ("mu" in p or "radius" in p):
        return Fault(
            "mu_r", "stands beside mu or radius, whose product it is", "one or the other", "delete one"
        )
    return None


LOAD = Effect(
    id="load_dependent_friction",
    title="Load-dependent friction in bearings",
    level="joint",
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
    "share of the joint torque. f and n act about the origin of the link's frame, z along the joint.",
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
)  # fmt: skip


# --- the gear ---------------------------------------------------------------------------------------------


def _loss(p: Values, at: Site) -> Any:
    """Table 3.2: ``tau/eta`` where the motor drives, ``tau eta`` where it brakes.

    Both cases as one; a direction between -1 and 1 gives that share of the loss of its case, and never feeds
    energy in; at rest there is no loss.
    """
    total = p["breakaway"] * at.direction
    curve = p["efficiency"]
    if isinstance(curve, tuple):
        load = magnitude(at.tau) / p["rated_torque"]
        share = efficiency_at(load, curve, p["interpolation"])
    else:
        share = curve
    if not isinstance(curve, tuple) and curve == 1:
        return total
    inverse = 1 / share
    even = (inverse + share) / 2 - 1
    odd = (inverse - share) / 2
    s = at.direction
    return at.tau * even * magnitude(s) + magnitude(at.tau) * odd * s + total


def _loss_fault(p: Values, revolute: bool) -> Fault | None:
    table = isinstance(p["efficiency"], tuple)
    if table and "rated_torque" not in p:
        return Fault(
            "efficiency",
            "is a table, and rated_torque is missing",
            "rated_torque: the torque of load fraction 1",
            "give rated_torque",
        )
    if not table and "rated_torque" in p:
        return Fault("rated_torque", "means nothing to a constant efficiency", "a table", "delete it")
    return None


TRANSMISSION = Effect(
    id="transmission_loss",
    title="Transmission loss",
    level="joint",
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
    "besides. Rotor inertia acts before the gear. A cubic through the knots is monotone; beyond the outer "
    "knots the curve stays level.",
    signature="two branches over the joint torque: steeper than 1 where the motor drives, flatter where it "
    "brakes",
    rivals=("load_dependent_friction", "torque_gain", "coulomb_friction"),
    separates="lifting and lowering, and loads of three to one",
    source="Dhanaraj 1990, section 3.3, Table 3.2",
    equation=_loss,
    check=_loss_fault,
    linear=("breakaway",),
    dissipative=True,
    needs_load=True,
)  # fmt: skip

EFFECTS = (LOAD, TRANSMISSION)
