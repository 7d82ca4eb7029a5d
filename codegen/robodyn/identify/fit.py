"""An arm's numbers from logs: rows, weights, what is worth fitting, the fit, its intervals.

    fit = fit_arm(robot, gates)                     # gates: logs that have passed robodyn.gate.gate.inspect
    identified(fit).robot                           # the arm with its new numbers (robodyn.identify.outcome)
    fit.worth["coulomb"]                            # by joint and held-out block, what the column is worth

Nothing here reads a file or writes one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from robodyn.gate.gate import Gate
from robodyn.identify.intervals import covariance, likeness
from robodyn.identify.limits import (
    GAIN_SPREAD,
    HUBER_FACTOR,
    KNOWN_MASS,
    LARGE_SHARE,
    LIKELY_T,
    LOAD_REACH,
    PASSES,
    WORTH_SHARE,
    WORTH_T,
)
from robodyn.identify.normal import Block, Layout, blocks_of, layout_of
from robodyn.identify.plain import condition, held_out_gains, plain
from robodyn.identify.prior import Prior, Usual, prior_of
from robodyn.identify.problem import Solution, Unknowns, misfits, solve
from robodyn.identify.rows import Rows, Strength, bare, rows_of
from robodyn.kernels.array_dynamics import PARAMETERS, Model
from robodyn.robot.masses import only_about_base_axis
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]
#: Of a link's parameters that about its joint's axis.
_ABOUT_AXIS = PARAMETERS.index("zz")


@dataclass(frozen=True, slots=True)
class Load:
    """A body that the arm carried in some logs and that its description lacks: which ``logs`` (from 0), its
    ``mass`` [kg] if that is known."""

    logs: tuple[int, ...]
    mass: float | None = None


@dataclass(frozen=True, slots=True)
class Options:
    """What is fitted. ``offsets`` of torque channels: all, none, or where they are worth it on samples that
    were held out; ``gains`` of torque channels, known to about ``gain_spread``; ``loads`` of some logs;
    ``confidence``: in place of what the description says of its links; ``joints``: by the name of a joint's
    column (``viscous``, ``coulomb``, ``rotor``) the joints (from 0) at which it is fitted, None: at all;
    ``left_out``: windows of time that do not count, as (log from 0, start [s], end [s]); ``strengths``:
    numbers of effects, each by the effect's place in the robot's and the number's name."""

    offsets: bool | Literal["auto"] = "auto"
    gains: bool = False
    gain_spread: float = GAIN_SPREAD
    loads: tuple[Load, ...] = ()
    confidence: float | None = None
    joints: Mapping[str, frozenset[int]] | None = None
    left_out: tuple[tuple[int, float, float], ...] = ()
    strengths: tuple[Strength, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """The numbers of an arm as logs have them. ``unknowns`` say what stands where in ``solution.z`` [p], of
    which ``covariance`` [p, p] is the uncertainty; ``first`` is the fit without the blocks that are held out,
    ``plain`` and ``plain_first`` are unconstrained least squares of all rows and of these; ``worth``: by name
    of a joint's column (``viscous``, ``coulomb``, ``rotor``, ``offset``) how much less [n, blocks] it leaves
    of blocks that are held out, in units of the noise; ``condition`` of the base regressor; ``likeness`` [n]:
    how many samples say what one says; ``rows`` of all logs."""

    robot: Robot
    unknowns: Unknowns
    prior: Prior
    solution: Solution
    covariance: Floats
    first: Solution
    plain: Floats
    plain_first: Floats
    worth: Mapping[str, Floats]
    condition: float
    likeness: Floats
    rows: tuple[Rows, ...] = field(repr=False)
    blocks: tuple[Block, ...] = field(repr=False)

    @property
    def layout(self) -> Layout:
        """Where parameters stand."""
        return self.unknowns.layout

    def worth_t(self, name: str) -> Floats:
        """Student's t [n] of what a joint's column is worth over the blocks that are held out."""
        gains = self.worth[name]
        spread = gains.std(axis=1, ddof=1) / np.sqrt(gains.shape[1])
        return np.asarray(gains.mean(axis=1) / np.maximum(spread, 1e-300))


def fit_arm(
    robot: Robot, gates: Sequence[Gate], options: Options | None = None, beside: Robot | None = None
) -> Fit:
    """The numbers of ``robot`` from logs that have passed their gates. What its effects do is evaluated on
    the arm ``beside``, which has the same effects and perhaps better numbers (None: on ``robot``)."""
    options = options or Options()
    beside = beside or robot
    windows = [[(a, b) for log, a, b in options.left_out if log == k] for k in range(len(gates))]
    pieces = [
        piece
        for k, gate in enumerate(gates)
        for piece in rows_of(beside, gate, k, windows[k], options.strengths)
    ]
    layout = layout_of(
        robot.n, rotors=robot.torque_side == "motor", offsets=options.offsets is not False,
        strengths=len(options.strengths),
    )  # fmt: skip
    arm = Model(bare(robot)).arm
    raw, _ = blocks_of(arm, layout, pieces)
    prior = prior_of(robot, layout, _usual(pieces), options.confidence)
    unknowns = _unknowns(robot, layout, prior, options, gates)
    alike = _band(pieces) * np.ones(robot.n)
    solution = solve(unknowns, raw, alike)
    blocks, left = raw, [piece.tau for piece in pieces]
    for _ in range(PASSES):
        knees = HUBER_FACTOR * solution.noise
        models = [
            (unknowns.parameters(solution.z, k), unknowns.scales(solution.z)) for k in range(len(gates))
        ]
        blocks, left = blocks_of(arm, layout, pieces, models, knees)
        solution = solve(unknowns, blocks, alike)
    long = np.maximum(likeness(left, robot.n), alike)
    weights = solution.weights * alike / long
    about = (prior.mean, solution.prior[: layout.size])
    worth = {name: held_out_gains(layout, blocks, weights, about, name) for name in layout.own}
    if options.offsets == "auto":
        unknowns = _with_offsets(
            unknowns, worth["offset"], _left_out(unknowns, blocks, solution) * alike / long
        )
        solution = solve(unknowns, blocks, alike)
    train = [block for block in blocks if not block.held_out]
    by_plain, plain_weights = plain(layout, raw)
    return Fit(
        robot, unknowns, prior, solution, covariance(unknowns, blocks, solution, long / alike),
        solve(unknowns, train, alike),
        by_plain, plain(layout, [block for block in raw if not block.held_out])[0],
        worth, condition(layout, raw, plain_weights), long, tuple(pieces), tuple(blocks),
    )  # fmt: skip


def _band(pieces: Sequence[Rows]) -> float:
    """How many samples the band of the filter makes alike: what is left beyond that is no matter of the point
    estimate, but of its intervals. (Weights that fall with all that residuals have in common would let a
    prior that the logs contradict prove itself.)"""
    return max(1.0, float(np.median([0.5 / (piece.cutoff * piece.step) for piece in pieces])))


def _usual(pieces: Sequence[Rows]) -> Usual:
    """What is usual in the rows."""

    def rms(name: str) -> Floats:
        count = sum(len(piece.q) for piece in pieces)
        squares = sum((getattr(piece, name) ** 2).sum(axis=0) for piece in pieces)
        return np.asarray(np.sqrt(squares / count))

    return Usual(rms("tau"), rms("qd"), rms("qdd"))


def _unknowns(
    robot: Robot, layout: Layout, prior: Prior, options: Options, gates: Sequence[Gate]
) -> Unknowns:
    """What is fitted of ``robot`` with ``prior`` and ``options``."""
    n = robot.n
    free, rigid = np.ones(layout.size, dtype=bool), np.ones(n + len(options.loads), dtype=bool)
    positive = [*(layout.joint(name) for name in layout.own if name != "offset"), layout.strength]
    if _turns_only(robot):
        rigid[0] = False
        free[layout.link(0)] = False
        about = layout.link(0)[_ABOUT_AXIS]
        free[about] = True
        positive.append(np.array([about]))
    if options.joints is not None:
        for name in set(layout.own) - {"offset"}:
            held = sorted(set(range(n)) - options.joints.get(name, frozenset()))
            free[layout.joint(name)[held]] = False
    for entry in robot.effects:
        if entry.joint is not None and entry.definition.traits.levels:
            free[layout.joint("coulomb")[entry.joint - 1]] = False  # the joint has a law with a level
    mean, sd, sizes = [prior.mean], [prior.sd], list(prior.sizes)
    for j in still_joints(gates):  # what noise makes of its motion says nothing
        for name in layout.own:
            free[layout.joint(name)[j]] &= name == "offset"
    carried = [-1] * len(gates)
    reach = LOAD_REACH * max(length for _, length in prior.sizes)
    heaviest = max(mass for mass, _ in prior.sizes)
    for k, load in enumerate(options.loads):
        for log in load.logs:
            carried[log] = k
        mass = heaviest if load.mass is None else load.mass
        sizes.append((mass, reach))
        mean.append(np.array([load.mass or 0.0, *[0.0] * 9]))
        known = mass if load.mass is None else KNOWN_MASS * mass
        sd.append(np.array([known, *[mass * reach] * 3, *[mass * reach**2] * 6]))
    if options.gains:
        mean.append(np.zeros(n))
        sd.append(np.full(n, options.gain_spread))
    total = sum(len(part) for part in mean)
    free = np.concatenate([free, np.ones(total - layout.size, dtype=bool)])
    return Unknowns(
        layout, len(options.loads), options.gains, np.concatenate(mean), np.concatenate(sd), free,
        np.concatenate(positive), tuple(carried), tuple(sizes), rigid,
    )  # fmt: skip


def still_joints(gates: Sequence[Gate]) -> list[int]:
    """Joints (from 0) that move in none of the logs."""
    moves = np.any([[joint.moves for joint in gate.joints] for gate in gates], axis=0)
    return [int(j) for j in np.flatnonzero(~moves)]


def _turns_only(robot: Robot) -> bool:
    """Whether the first link is stated to have nothing but an inertia about its axis, fixed in the base."""
    link = robot.links[0]
    return not link.mass and only_about_base_axis(link.joint, link.inertia) and bool(link.inertia.zz)


def _left_out(unknowns: Unknowns, blocks: Sequence[Block], solution: Solution) -> Floats:
    """Weighted squares [n] that the fit leaves of the blocks that are held out."""
    test = [block for block in blocks if block.held_out]
    return np.asarray(misfits(unknowns, test, solution.z).sum(axis=0) * solution.weights)


def _with_offsets(unknowns: Unknowns, worth: Floats, left: Floats) -> Unknowns:
    """Offsets held at none where they are not worth it."""
    spread = worth.std(axis=1, ddof=1) * np.sqrt(worth.shape[1])
    total = worth.sum(axis=1)
    free = unknowns.free.copy()
    sure = (total > WORTH_T * spread) & (total > WORTH_SHARE * left)
    worthy = sure | ((total > LIKELY_T * spread) & (total > LARGE_SHARE * left))
    free[unknowns.layout.joint("offset")] = worthy
    return replace(unknowns, free=free)
