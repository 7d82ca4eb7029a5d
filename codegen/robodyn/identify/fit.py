"""Identification of an arm's parameters from logs: weights, choice of the columns, fit and covariance.

    fit = fit_arm(robot, gates)            # gates: logs that passed robodyn.gate.gate.inspect
    identified(fit).robot                  # the arm with its new parameters (robodyn.identify.outcome)
    fit.worth["rotor"]                     # drop of the held-out error by fitting it [n, blocks]

Nothing here reads a file or writes one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from robodyn.arrays import Floats
from robodyn.gate.gate import Gate
from robodyn.identify.intervals import covariance, likeness
from robodyn.identify.late import delays_of
from robodyn.identify.limits import (
    CHANCE,
    GAIN_SPREAD,
    HUBER_FACTOR,
    KNOWN_MASS,
    LOAD_REACH,
    PASSES,
    RANK,
)
from robodyn.identify.normal import Block, Layout, blocks_of, layout_of
from robodyn.identify.plain import condition, held_out_gains, plain
from robodyn.identify.prior import Prior, Usual, prior_of
from robodyn.identify.problem import Solution, Unknowns, solve
from robodyn.identify.rest import Rest, rest_of, rest_speeds
from robodyn.identify.rows import Rows, bare, rows_of
from robodyn.kernels.array_dynamics import PARAMETERS, Model
from robodyn.robot.masses import only_about_base_axis
from robodyn.robot.model import Robot

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
    ``gains``: whether to fit gains of the torque channels.
    ``loads``: loads carried in some of the logs.
    ``joints``: for each column (``viscous``, ``coulomb``, ``rotor``), the joints (from 0) at which it is
    fitted. None: all joints.
    ``left_out``: time windows to ignore, as (log from 0, start [s], end [s]).
    """

    offsets: bool | Literal["auto"] = "auto"
    gains: bool = False
    loads: tuple[Load, ...] = ()
    joints: Mapping[str, frozenset[int]] | None = None
    left_out: tuple[tuple[int, float, float], ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """The result of an identification.

    ``unknowns``: layout of the parameter vector ``solution.z`` [p]. ``covariance``: its covariance [p, p].
    ``first``: the fit without the held-out blocks.
    ``plain``, ``plain_first``: unconstrained least squares, on all rows and without the held-out blocks.
    ``worth``: for the columns ``rotor`` and ``offset``, by how much each reduces the squared residuals of the
    held-out blocks [n, blocks], in units of the noise.
    ``condition``: condition number of the base regressor.
    ``likeness``: number of correlated samples that count as one independent sample [n].
    ``shift``: by how much torques of each log were set right [logs], s.
    ``late``: by how much torques are read late in each log [logs], and standard errors, s.
    ``rest``: below which speeds directions are not resolved, and what torques scatter by there.
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
    rest: Rest
    shift: Floats
    late: tuple[Floats, Floats]
    rows: tuple[Rows, ...] = field(repr=False)
    blocks: tuple[Block, ...] = field(repr=False)

    @property
    def layout(self) -> Layout:
        """The layout of the parameters of links and joints."""
        return self.unknowns.layout


def evidence(gains: Floats) -> Floats:
    """What held-out blocks say [n] for a column, in nats, of what it takes [n, blocks] off their squares."""
    return np.asarray(0.5 * gains.sum(axis=1))


def sure(n: int) -> float:
    """Evidence that a column of one of ``n`` joints has by chance with a probability of :data:`CHANCE`."""
    return float(np.log(n / CHANCE))


def fit_arm(
    robot: Robot, gates: Sequence[Gate], options: Options | None = None, late: Floats | None = None
) -> Fit:
    """Identify the parameters of ``robot`` from logs that passed their gates.

    ``shift``: by how much torques of each log were set right [logs], s.
    ``late``: by how much [s] the torques of each log are read late. None: if they are, it shows, and they are
    set right.
    """
    shift = np.zeros(len(gates)) if late is None else late
    options = options or Options()
    windows = [[(a, b) for log, a, b in options.left_out if log == k] for k in range(len(gates))]
    pieces = [
        piece for k, gate in enumerate(gates) for piece in rows_of(robot, gate, k, windows[k], shift[k])
    ]
    layout = layout_of(
        robot.n, rotors=robot.torque_side == "motor", offsets=options.offsets is not False,
    )  # fmt: skip
    arm = Model(bare(robot)).arm
    speeds = rest_speeds(arm, layout, pieces)
    still = still_joints(gates)
    if still:  # what they move is noise
        most = np.max([np.abs(piece.signals.qd[:, still]).max(axis=0) for piece in pieces], axis=0)
        speeds[still] = most / RANK + np.finfo(float).tiny
    pieces = [rows.at_rest_below(speeds) for rows in pieces]
    prior = prior_of(robot, layout, _rms_of_rows(pieces))
    unknowns = _unknowns(robot, layout, prior, options, gates)
    filter_correlation = _filter_correlation(pieces) * np.ones(robot.n)
    blocks, residuals = blocks_of(arm, layout, pieces)
    solution = solve(unknowns, blocks, filter_correlation)
    rest = Rest(speeds, solution.noise, np.zeros(robot.n))
    for _ in range(PASSES):
        models = [
            (unknowns.parameters(solution.z, k), unknowns.scales(solution.z)) for k in range(len(gates))
        ]
        weights = [rest.weights(rows) for rows in pieces]
        blocks, residuals = blocks_of(arm, layout, pieces, models, weights, HUBER_FACTOR * solution.noise)
        solution = solve(unknowns, blocks, filter_correlation)
        rest = rest_of(speeds, solution.noise, pieces, residuals)
    residuals = [left * np.sqrt(rest.weights(rows)) for left, rows in zip(residuals, pieces, strict=True)]
    correlation = np.maximum(likeness(residuals, robot.n), filter_correlation)
    by_joint = solution.weights * filter_correlation / correlation
    prior_weights = (prior.mean, solution.prior[: layout.size])
    worth: dict[str, Floats] = {
        name: held_out_gains(layout, blocks, by_joint, prior_weights, name)
        for name in ("rotor", "offset")
        if name in layout.own
    }
    if options.offsets == "auto":
        free = unknowns.free.copy()
        free[layout.joint("offset")] &= evidence(worth["offset"]) > sure(robot.n)
        unknowns = replace(unknowns, free=free)
        solution = solve(unknowns, blocks, filter_correlation)
    wider = correlation / filter_correlation
    delays, errors = delays_of(unknowns, blocks, solution, wider)
    shown = delays**2 > 2 * sure(len(gates)) * errors**2
    if late is None and shown.any():
        return fit_arm(robot, gates, options, np.where(shown, delays, 0.0))
    train = [block for block in blocks if not block.held_out]
    plain_parameters, plain_weights = plain(layout, blocks)
    return Fit(
        robot, unknowns, prior, solution,
        covariance(unknowns, blocks, solution, wider),
        solve(unknowns, train, filter_correlation),
        plain_parameters, plain(layout, [block for block in blocks if not block.held_out])[0],
        worth, condition(layout, blocks, plain_weights), correlation, rest,
        shift, (shift + delays, errors),
        tuple(pieces), tuple(blocks),
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
        sd.append(np.full(n, GAIN_SPREAD))
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
