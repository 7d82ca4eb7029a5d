"""The customised programs of the thesis and the counts that it compares (sections 2.4, 2.5, appendix D)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from statistics import median
from typing import Any, Final

from robodyn.counts.thesis import TABLE_2_10
from robodyn.robot import Inertia, Robot
from robodyn.thesis.claims.arms import PUMA, Arms
from robodyn.thesis.claims.claim import Outcome
from robodyn.thesis.claims.formulations import SMALL_PUMA
from robodyn.thesis.printed_counts import LISTINGS, TABLE_2_10_QUOTED, table_2_10

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


def _pairs_of_table_2_10() -> dict[str, dict[str, tuple[int, int]]]:
    """By row and method: the total of the thesis and that of the other."""
    totals = {row: sum(figures["I"]) for row, figures in table_2_10().items()}
    return {
        row: {method: (totals[row], sum(pair)) for method, pair in figures.items()}
        for row, figures in TABLE_2_10_QUOTED.items()
    }


def _fewer(pair: tuple[int, int]) -> float:
    return round(100 * (1 - pair[0] / pair[1]), 1)


def customised_counts(_: Arms) -> Outcome:
    """In how many pairs of Table 2.10 the thesis has fewer operations, and by how much [%]."""
    shares = {
        f"{row}, {method}": _fewer(pair)
        for row, methods in _pairs_of_table_2_10().items()
        for method, pair in methods.items()
    }
    fewer = {name: share for name, share in shares.items() if share > 0}
    figures: dict[str, Any] = {
        "pairs": len(shares),
        "fewer": len(fewer),
        "least_pct": min(fewer.values()),
        "most_pct": max(fewer.values()),
        "median_pct": median(fewer.values()),
        "by_pair": shares,
    }
    return figures, None


def more_than_three_joints(_: Arms) -> Outcome:
    """The same by the number of joints, and the margin of the Stanford arm's listing."""
    pairs = _pairs_of_table_2_10()
    fewer = {
        joints: [
            _fewer(pair) > 0
            for row, methods in pairs.items()
            if row[-1] == joints
            for pair in methods.values()
        ]
        for joints in "36"
    }
    counted = sum(LISTINGS["stanford_6"][1])
    quoted = pairs["stanford_6"]["II"][1]
    figures = {
        "six": sum(fewer["6"]),
        "six_of": len(fewer["6"]),
        "three": sum(fewer["3"]),
        "three_of": len(fewer["3"]),
        "listing": counted,
        "quoted": quoted,
    }
    return figures, all(fewer["6"]) and not all(fewer["3"])


def arm_at_three_joints(_: Arms) -> Outcome:
    """ARM's totals (method II) beside the thesis's for three joints."""
    pairs = _pairs_of_table_2_10()
    totals = {row: list(pairs[row]["II"]) for row in ("puma_3", "stanford_3")}
    return totals, all(other < own for own, other in totals.values())


def arm_at_six_joints(_: Arms) -> Outcome:
    """ARM's total beside the thesis's for the PUMA of six joints."""
    own, other = _pairs_of_table_2_10()["puma_6"]["II"]
    more = round(100 * (other / own - 1), 1)
    return {"own": own, "arm": other, "more_pct": more, "needed": round(1.3 * own)}, abs(more - 30) < 5


def incomplete_listings(_: Arms) -> Outcome:
    """Operations of definitions that the listings lack."""
    lacking = {
        name: sum(complete) - sum(printed)
        for name, (printed, complete) in LISTINGS.items()
        if complete != printed
    }
    return {"lacking": lacking, "listings": len(LISTINGS)}, None


def _stated(row: str) -> tuple[int, int]:
    mul, add, _ = TABLE_2_10[row]
    return mul, add


def listing_counts(_: Arms) -> Outcome:
    """The three listings whose count is stated right, as printed and completed."""
    names = ("stanford_3", "puma_3", "puma_6")
    figures = {
        name: {"printed": list(LISTINGS[name][0]), "complete": list(LISTINGS[name][1])} for name in names
    }
    return figures, all(LISTINGS[name][0] == _stated(name) for name in names)


def listing_of_stanford(_: Arms) -> Outcome:
    """The listing of the Stanford arm's six joints."""
    printed, complete = LISTINGS["stanford_6"]
    return {"printed": list(printed), "complete": list(complete)}, printed == _stated("stanford_6")


def parameters(arms: Arms) -> Outcome:
    """Numbers in which the arm of program D.2 is another than that of the tables, links by kind of number."""
    tables, used = (arms.load_robot(name) for name in (PUMA, "puma560_d2"))
    pairs = list(zip(tables.links, used.links, strict=True))
    links = {
        "centres_of_mass": [i for i, (a, b) in enumerate(pairs, 1) if a.com != b.com],
        "tensors": [i for i, (a, b) in enumerate(pairs, 1) if a.inertia != b.inertia],
        "masses": [i for i, (a, b) in enumerate(pairs, 1) if a.mass != b.mass],
    }
    x = [float(robot.links[1].com[0]) for robot in (tables, used)]  # type: ignore[arg-type]  # numbers here
    return {**links, "x_of_link_2": x}, not any(links.values())


def two_programs(arms: Arms) -> Outcome:
    """How far the torques of D.1.1's and D.1.2's arms are apart [N m], joint by joint, at random states."""
    import numpy as np

    from robodyn.verify.reference import Reference

    newton_euler = arms.load_robot(SMALL_PUMA)
    chance = np.random.default_rng(_SEED)
    states = [chance.uniform(-limit, limit, (_STATES, newton_euler.n)) for limit in _RANGES]
    first, second = (
        Reference(robot).inverse_dynamics(*states) for robot in (newton_euler, _lagrange_arm(newton_euler))
    )
    apart = abs(first - second).max(axis=0)
    figures = {
        "most": [round(float(x), 1) for x in apart],
        "rms": [round(float(x), 1) for x in np.sqrt(((first - second) ** 2).mean(axis=0))],
        "of_rms": [round(float(x), 1) for x in np.sqrt((first**2).mean(axis=0))],
        "states": _STATES,
    }
    return figures, bool((apart < 1e-3).all())


def _lagrange_arm(newton_euler: Robot) -> Robot:
    """The arm of D.1.1: tensors about the centres of mass by its pseudo-inertias about the origins."""
    links = []
    for link, (x, y, z) in zip(newton_euler.links, D_1_1, strict=True):
        cx, cy, cz = (Fraction(c) * Fraction(c) for c in link.com)  # type: ignore[arg-type]  # numbers here
        mass = Fraction(link.mass)  # type: ignore[arg-type]
        zero = Fraction(0)
        inertia = Inertia(
            y + z - mass * (cy + cz), x + z - mass * (cx + cz), x + y - mass * (cx + cy), zero, zero, zero
        )
        links.append(replace(link, inertia=inertia))
    return replace(newton_euler, links=tuple(links))


def rows_of_torques(_: Arms) -> Outcome:
    """Rows of D.4's file of torques that are one short, as time / 0.01 cut off in single precision, and the
    rows that the step from 2 s on asks for.

    A step of 0.02 s evaluates at its beginning, twice in its middle and at its end; time is added up in
    0.01 s. The first row is that of time 0.
    """
    import numpy as np

    single = np.float32
    spacing, t = single(_SPACING), single(0)
    short, evaluations, last = 0, 0, []
    for step in range((_ROWS - 1) // 2 + 1):
        stages = [(t, 0)]
        for half in (1, 2):
            t = single(t + spacing)
            stages += [(t, half)] * (2 if half == 1 else 1)
        for time, halves in stages:
            exact = 2 * step + halves
            short += int(time / spacing) < exact
            evaluations += 1
            last.append(exact + 1)
    figures: dict[str, Any] = {
        "short": short,
        "evaluations": evaluations,
        "rows": _ROWS,
        "beyond": sorted({row for row in last if row > _ROWS}),
    }
    return figures, not short and not figures["beyond"]


def columns_of_the_inertia_matrix(arms: Arms) -> Outcome:
    """What gravity adds to a "column of D" at D.4's start, if it is not left out [N m]; and link 3's mass."""
    import numpy as np

    from robodyn.thesis.case_arm import D4_START
    from robodyn.verify.reference import Reference

    robot = arms.load_robot("puma560_3dof_d4")
    reference = Reference(robot)
    unit, rest = np.eye(robot.n), np.zeros((robot.n, robot.n))
    torques = reference.inverse_dynamics(np.tile(D4_START, (robot.n, 1)), rest, unit)
    off = abs(torques.T - reference.mass_matrix(np.array(D4_START))).max()
    return {"off": round(float(off), 1), "mass": float(robot.links[2].mass)}, off < 1e-9  # type: ignore[arg-type]
