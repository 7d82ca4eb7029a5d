"""Identification of an arm's parameters from logs: weights, choice of the columns, fit and covariance.

    fit = fit_arm(robot, gates)            # gates: logs that passed robodyn.gate.gate.inspect
    identified(fit).robot                  # the arm with its new parameters (robodyn.identify.outcome)
    fit.worth["coulomb"]                   # drop of the held-out error by fitting it [n, blocks]

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
from robodyn.identify.rows import Rows, bare, rows_of
from robodyn.kernels.array_dynamics import PARAMETERS, Model
from robodyn.robot.masses import only_about_base_axis
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]
#: Index of the moment of inertia about the joint's axis in the parameters of a link.
_ABOUT_AXIS = PARAMETERS.index("zz")


@dataclass(frozen=True, slots=True)
class Load:
    """A load that the description lacks: the ``logs`` (from 0) in which the arm carried it, and its ``mass``
    [kg] if known."""

    logs: tuple[int, ...]
    mass: float | None = None


@dataclass(frozen=True, slots=True)
class Options:
    """What is fitted.

    ``offsets``: torque offsets of all joints, of none, or ("auto") of those that reduce the held-out error.
    ``gains``: whether to fit gains of the torque channels. ``gain_spread``: their prior standard deviation.
    ``loads``: loads carried in some of the logs.
    ``confidence``: confidence in the link parameters; it overrides that of the description.
    ``joints``: for each column (``viscous``, ``coulomb``, ``rotor``), the joints (from 0) at which it is
    fitted. None: all joints.
    ``left_out``: time windows to ignore, as (log from 0, start [s], end [s]).
    """

    offsets: bool | Literal["auto"] = "auto"
    gains: bool = False
    gain_spread: float = GAIN_SPREAD
    loads: tuple[Load, ...] = ()
    confidence: float | None = None
    joints: Mapping[str, frozenset[int]] | None = None
    left_out: tuple[tuple[int, float, float], ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """The result of an identification.

    ``unknowns``: layout of the parameter vector ``solution.z`` [p]. ``covariance``: its covariance [p, p].
    ``first``: the fit without the held-out blocks.
    ``plain``, ``plain_first``: unconstrained least squares, on all rows and without the held-out blocks.
    ``worth``: for each column (``viscous``, ``coulomb``, ``rotor``, ``offset``), by how much it reduces the
    squared residuals of the held-out blocks [n, blocks], in units of the noise.
    ``condition``: condition number of the base regressor.
    ``likeness``: number of correlated samples that count as one independent sample [n].
    ``rows``, ``blocks``: the rows of all logs, and their normal equations.
    """

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
        """The layout of the parameters of links and joints."""
        return self.unknowns.layout

    def worth_t(self, name: str) -> Floats:
        """Student's t [n] of the error reduction by column ``name`` over the held-out blocks."""
        gains = self.worth[name]
        spread = gains.std(axis=1, ddof=1) / np.sqrt(gains.shape[1])
        return np.asarray(gains.mean(axis=1) / np.maximum(spread, 1e-300))


def fit_arm(robot: Robot, gates: Sequence[Gate], options: Options | None = None) -> Fit:
    """Identify the parameters of ``robot`` from logs that passed their gates."""
    options = options or Options()
    windows = [[(a, b) for log, a, b in options.left_out if log == k] for k in range(len(gates))]
    pieces = [piece for k, gate in enumerate(gates) for piece in rows_of(robot, gate, k, windows[k])]
    layout = layout_of(
        robot.n, rotors=robot.torque_side == "motor", offsets=options.offsets is not False,
    )  # fmt: skip
    arm = Model(bare(robot)).arm
    raw, _ = blocks_of(arm, layout, pieces)
    prior = prior_of(robot, layout, _rms_of_rows(pieces), options.confidence)
    unknowns = _unknowns(robot, layout, prior, options, gates)
    filter_correlation = _filter_correlation(pieces) * np.ones(robot.n)
    solution = solve(unknowns, raw, filter_correlation)
    blocks, residuals = raw, [piece.tau for piece in pieces]
    for _ in range(PASSES):
        knees = HUBER_FACTOR * solution.noise
        models = [
            (unknowns.parameters(solution.z, k), unknowns.scales(solution.z)) for k in range(len(gates))
        ]
        blocks, residuals = blocks_of(arm, layout, pieces, models, knees)
        solution = solve(unknowns, blocks, filter_correlation)
    correlation = np.maximum(likeness(residuals, robot.n), filter_correlation)
    weights = solution.weights * filter_correlation / correlation
    prior_weights = (prior.mean, solution.prior[: layout.size])
    worth = {name: held_out_gains(layout, blocks, weights, prior_weights, name) for name in layout.own}
    if options.offsets == "auto":
        unknowns = _select_offsets(
            unknowns,
            worth["offset"],
            _held_out_misfit(unknowns, blocks, solution) * filter_correlation / correlation,
        )
        solution = solve(unknowns, blocks, filter_correlation)
    train = [block for block in blocks if not block.held_out]
    plain_parameters, plain_weights = plain(layout, raw)
    return Fit(
        robot, unknowns, prior, solution,
        covariance(unknowns, blocks, solution, correlation / filter_correlation),
        solve(unknowns, train, filter_correlation),
        plain_parameters, plain(layout, [block for block in raw if not block.held_out])[0],
        worth, condition(layout, raw, plain_weights), correlation, tuple(pieces), tuple(blocks),
    )  # fmt: skip


def _filter_correlation(pieces: Sequence[Rows]) -> float:
    """The number of successive samples that the filter makes correlated.

    The weights of the point estimate account for this correlation only. Further correlation of the residuals
    widens the intervals. If it lowered the weights too, a prior could outweigh logs that contradict it.
    """
    return max(1.0, float(np.median([0.5 / (piece.cutoff * piece.step) for piece in pieces])))


def _rms_of_rows(pieces: Sequence[Rows]) -> Usual:
    """RMS torque, velocity and acceleration of each joint."""

    def rms(name: str) -> Floats:
        count = sum(len(piece.q) for piece in pieces)
        squares = sum((getattr(piece, name) ** 2).sum(axis=0) for piece in pieces)
        return np.asarray(np.sqrt(squares / count))

    return Usual(rms("tau"), rms("qd"), rms("qdd"))


def _unknowns(
    robot: Robot, layout: Layout, prior: Prior, options: Options, gates: Sequence[Gate]
) -> Unknowns:
    """The layout of the parameter vector, with its prior, its constraints and its free components."""
    n = robot.n
    free, rigid = np.ones(layout.size, dtype=bool), np.ones(n + len(options.loads), dtype=bool)
    positive = [*(layout.joint(name) for name in layout.own if name != "offset")]
    if _has_axis_inertia_only(robot):
        rigid[0] = False
        free[layout.link(0)] = False
        axis_inertia = layout.link(0)[_ABOUT_AXIS]
        free[axis_inertia] = True
        positive.append(np.array([axis_inertia]))
    if options.joints is not None:
        for name in set(layout.own) - {"offset"}:
            fixed_joints = sorted(set(range(n)) - options.joints.get(name, frozenset()))
            free[layout.joint(name)[fixed_joints]] = False
    for entry in robot.effects:
        if entry.joint is not None and entry.definition.traits.levels:
            free[layout.joint("coulomb")[entry.joint - 1]] = False  # the effect has this level
    mean, sd, sizes = [prior.mean], [prior.sd], list(prior.sizes)
    for j in still_joints(gates):  # a joint at rest: its measured motion is noise
        for name in layout.own:
            free[layout.joint(name)[j]] &= name == "offset"
    load_of_log = [-1] * len(gates)
    reach = LOAD_REACH * max(length for _, length in prior.sizes)
    heaviest = max(mass for mass, _ in prior.sizes)
    for k, load in enumerate(options.loads):
        for log in load.logs:
            load_of_log[log] = k
        mass = heaviest if load.mass is None else load.mass
        sizes.append((mass, reach))
        mean.append(np.array([load.mass or 0.0, *[0.0] * 9]))
        mass_sd = mass if load.mass is None else KNOWN_MASS * mass
        sd.append(np.array([mass_sd, *[mass * reach] * 3, *[mass * reach**2] * 6]))
    if options.gains:
        mean.append(np.zeros(n))
        sd.append(np.full(n, options.gain_spread))
    total = sum(len(part) for part in mean)
    free = np.concatenate([free, np.ones(total - layout.size, dtype=bool)])
    return Unknowns(
        layout, len(options.loads), options.gains, np.concatenate(mean), np.concatenate(sd), free,
        np.concatenate(positive), tuple(load_of_log), tuple(sizes), rigid,
    )  # fmt: skip


def still_joints(gates: Sequence[Gate]) -> list[int]:
    """The joints (from 0) that do not move in any log."""
    moves = np.any([[joint.moves for joint in gate.joints] for gate in gates], axis=0)
    return [int(j) for j in np.flatnonzero(~moves)]


def _has_axis_inertia_only(robot: Robot) -> bool:
    """Whether the description gives the first link only an inertia about its own axis (fixed in the base)."""
    link = robot.links[0]
    return not link.mass and only_about_base_axis(link.joint, link.inertia) and bool(link.inertia.zz)


def _held_out_misfit(unknowns: Unknowns, blocks: Sequence[Block], solution: Solution) -> Floats:
    """Weighted squared residuals [n] of the fit on the held-out blocks."""
    test = [block for block in blocks if block.held_out]
    return np.asarray(misfits(unknowns, test, solution.z).sum(axis=0) * solution.weights)


def _select_offsets(unknowns: Unknowns, worth: Floats, misfit: Floats) -> Unknowns:
    """Fix the torque offsets at 0 that do not reduce the held-out error enough."""
    spread = worth.std(axis=1, ddof=1) * np.sqrt(worth.shape[1])
    total = worth.sum(axis=1)
    free = unknowns.free.copy()
    significant = (total > WORTH_T * spread) & (total > WORTH_SHARE * misfit)
    useful = significant | ((total > LIKELY_T * spread) & (total > LARGE_SHARE * misfit))
    free[unknowns.layout.joint("offset")] = useful
    return replace(unknowns, free=free)
