"""The customised programs of the thesis and the counts that it compares (sections 2.4, 2.5, appendix D)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from statistics import median
from typing import Any, Final

import numpy as np

from robodyn.counts.thesis import TABLE_2_10
from robodyn.robot import Inertia, Robot
from robodyn.thesis.case_arm import D4_START
from robodyn.thesis.claims import PUMA, SMALL_PUMA, Arms, Outcome
from robodyn.thesis.printed import LISTINGS, TABLE_2_10_QUOTED, bundled, table_2_10
from robodyn.verify.reference import Reference

#: Numbers of program D.1.1: diagonals of the pseudo-inertias of its three links about the frames' origins
#: [kg m^2]; masses and centres of mass are those of D.1.2.
D_1_1: Final = tuple(
    tuple(map(Fraction, row.split()))
    for row in ("0.0058 0.0058 -0.0058", "0.6984 0.0340 0.2416", "0.0039 0.0335 0.1432")
)
#: Random states of the comparison, a sample (the row says how many: its largest torques depend on them);
#: and their seed.
_STATES: Final = 1000
_SEED: Final = 0
#: Half the range of angles [rad], rates [rad/s] and accelerations [rad/s^2].
_RANGES: Final = (3.0, 2.0, 3.0)
#: Program D.4: rows of the file of torques, their spacing [s], and the step of the integration in it.
_ROWS: Final = 201
_SPACING: Final = 0.01


def _pairs() -> dict[tuple[str, str], tuple[int, int]]:
    """Table 2.10 by row and method: the total of the thesis and that of the other."""
    totals = {row: sum(figures["I"]) for row, figures in table_2_10().items()}
    return {
        (row, method): (totals[row], sum(pair))
        for row, figures in TABLE_2_10_QUOTED.items()
        for method, pair in figures.items()
    }


def customised_counts(_: Arms) -> Outcome:
    """In how many pairs of Table 2.10 the thesis has fewer operations, and by how much [%]."""
    pairs = _pairs().values()
    fewer = [round(100 * (1 - own / other), 1) for own, other in pairs if own < other]
    figures: dict[str, Any] = {"pairs": len(pairs), "fewer": len(fewer), "median_pct": median(fewer)}
    return {**figures, "least_pct": min(fewer), "most_pct": max(fewer)}, None


def more_than_three_joints(_: Arms) -> Outcome:
    """The same by the number of joints, and the margin of the Stanford arm's listing."""
    pairs = _pairs()
    six, three = (
        [own < other for (row, _), (own, other) in pairs.items() if row[-1] == joints] for joints in "63"
    )
    listing, quoted = sum(LISTINGS["stanford_6"][1]), pairs["stanford_6", "II"][1]
    counts = {"six": sum(six), "six_of": len(six), "three": sum(three), "three_of": len(three)}
    return {**counts, "listing": listing, "quoted": quoted}, all(six) and not all(three)


def arm_at_three_joints(_: Arms) -> Outcome:
    """ARM's totals (method II) beside the thesis's for three joints."""
    pairs = _pairs()
    totals = {row: list(pairs[row, "II"]) for row in ("puma_3", "stanford_3")}
    return totals, all(other < own for own, other in totals.values())


def arm_at_six_joints(_: Arms) -> Outcome:
    """ARM's total beside the thesis's for the PUMA of six joints."""
    own, other = _pairs()["puma_6", "II"]
    more = round(100 * (other / own - 1), 1)
    return {"own": own, "arm": other, "more_pct": more, "needed": round(1.3 * own)}, abs(more - 30) < 5


def incomplete_listings(_: Arms) -> Outcome:
    """Operations of definitions that the listings lack."""
    lacking = {name: sum(complete) - sum(printed) for name, (printed, complete) in LISTINGS.items()}
    return {"lacking": {name: n for name, n in lacking.items() if n}, "listings": len(LISTINGS)}, None


def _counts_of(name: str) -> tuple[dict[str, list[int]], bool]:
    """A listing as printed and completed, and whether its count is stated right."""
    printed, complete = LISTINGS[name]
    return {"printed": list(printed), "complete": list(complete)}, printed == TABLE_2_10[name][:2]


def listing_counts(_: Arms) -> Outcome:
    """The three listings whose count is stated right, as printed and completed."""
    counts = {name: _counts_of(name) for name in ("stanford_3", "puma_3", "puma_6")}
    return {name: found for name, (found, _) in counts.items()}, all(right for _, right in counts.values())


def listing_of_stanford(_: Arms) -> Outcome:
    """The listing of the Stanford arm's six joints."""
    return _counts_of("stanford_6")


def parameters(_: Arms) -> Outcome:
    """Numbers in which the arm of program D.2 is another than that of the tables, links by kind of number."""
    arms = [bundled(name).links for name in (PUMA, "puma560_d2")]
    links = {
        name: [i for i, (a, b) in enumerate(zip(*arms, strict=True), 1) if getattr(a, of) != getattr(b, of)]
        for name, of in (("centres_of_mass", "com"), ("tensors", "inertia"), ("masses", "mass"))
    }
    x = [float(robot[1].com[0]) for robot in arms]  # type: ignore[arg-type]  # numbers here
    return {**links, "x_of_link_2": x}, not any(links.values())


def two_programs(_: Arms) -> Outcome:
    """How far the torques of D.1.1's and D.1.2's arms are apart [N m], joint by joint, at random states."""
    newton_euler = bundled(SMALL_PUMA)
    chance = np.random.default_rng(_SEED)
    states = [chance.uniform(-limit, limit, (_STATES, newton_euler.n)) for limit in _RANGES]
    first, second = (
        Reference(robot).inverse_dynamics(*states) for robot in (newton_euler, _lagrange_arm(newton_euler))
    )
    apart = abs(first - second).max(axis=0)
    figures: dict[str, Any] = {
        name: np.round(numbers, 1).tolist()
        for name, numbers in (
            ("most", apart),
            ("rms", np.sqrt(((first - second) ** 2).mean(axis=0))),
            ("of_rms", np.sqrt((first**2).mean(axis=0))),
        )
    }
    return {**figures, "states": _STATES}, bool((apart < 1e-3).all())


def _lagrange_arm(newton_euler: Robot) -> Robot:
    """The arm of D.1.1: tensors about the centres of mass by its pseudo-inertias about the origins."""
    links = []
    for link, (x, y, z) in zip(newton_euler.links, D_1_1, strict=True):
        cx, cy, cz = (link.mass * c * c for c in link.com)  # type: ignore[operator]  # numbers here
        none = Fraction(0)
        inertia = Inertia(y + z - (cy + cz), x + z - (cx + cz), x + y - (cx + cy), none, none, none)
        links.append(replace(link, inertia=inertia))
    return replace(newton_euler, links=tuple(links))


def rows_of_torques(_: Arms) -> Outcome:
    """Rows of D.4's file of torques that are one short, as time / 0.01 cut off in single precision, and the
    rows that the step from 2 s on asks for.

    A step of 0.02 s evaluates at its beginning, twice in its middle and at its end; time is added up in
    0.01 s. The first row is that of time 0.
    """
    single = np.float32
    spacing, t = single(_SPACING), single(0)
    cut, exact = [], []
    for step in range((_ROWS - 1) // 2 + 1):
        middle = single(t + spacing)
        end = single(middle + spacing)
        cut += [int(time / spacing) for time in (t, middle, middle, end)]
        exact += [2 * step + halves for halves in (0, 1, 1, 2)]
        t = end
    short = sum(a < b for a, b in zip(cut, exact, strict=True))
    beyond = sorted({row + 1 for row in exact if row + 1 > _ROWS})
    figures = {"short": short, "evaluations": len(exact), "rows": _ROWS, "beyond": beyond}
    return figures, not short and not beyond


def columns_of_the_inertia_matrix(_: Arms) -> Outcome:
    """What gravity adds to a "column of D" at D.4's start, if it is not left out [N m]; and link 3's mass."""
    robot = bundled("puma560_3dof_d4")
    reference = Reference(robot)
    unit, rest = np.eye(robot.n), np.zeros((robot.n, robot.n))
    torques = reference.inverse_dynamics(np.tile(D4_START, (robot.n, 1)), rest, unit)
    off = abs(torques.T - reference.mass_matrix(np.array(D4_START))).max()
    return {"off": round(float(off), 1), "mass": float(robot.links[2].mass)}, off < 1e-9  # type: ignore[arg-type]
