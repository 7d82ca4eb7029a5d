"""Plain least squares: base parameters of the rigid arm with viscous and Coulomb friction and rotors.

    python -m benchmarks.gap.least_squares ROBOT.yaml LOG.csv... --cutoff HZ [--raster S] [--smooth] [--json]

prints 100 RMS residual / RMS torque of each joint on fitted and held-out samples (the rule:
:mod:`benchmarks.gap.recordings`). No physical constraint, no prior, no robust weights, and no code of
``robodyn identify`` or ``robodyn diagnose``: the regressor is Pinocchio's. A yardstick, not a best result.
With ``--smooth`` Coulomb friction is that of tanh(v / v_s) in place of the sign, v_s of each joint being the
one of half decades below its RMS speed with which its own torque is fitted best.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from benchmarks.gap.arm import base_columns, pinocchio_model, regressor
from benchmarks.gap.recordings import Floats, Motion, motion, read, rms, shares

from robodyn.robot import load
from robodyn.robot.model import Robot

#: Decades below RMS speed in which the speed is sought at which friction is three quarters of itself.
DECADES = 4
#: Fits, each weighted by the residuals that the one before leaves at each joint.
ROUNDS = 3


@dataclass(frozen=True, slots=True)
class Fit:
    """What least squares leave: residuals [K, n] of each log, and the parameters by name; speeds [n] of
    smoothed friction, 0 where it is a sign."""

    residuals: tuple[Floats, ...]
    parameters: dict[str, float]
    speeds: Floats


def fit(robot: Robot, motions: Sequence[Motion], *, smooth: bool = False) -> Fit:
    """Weighted least squares on the fitted samples of ``motions``, three rounds."""
    model = pinocchio_model(robot)
    independent = base_columns(model)
    rigid = [regressor(model, m.q, m.qd, m.qdd)[:, :, independent] for m in motions]
    speeds = smoothing(robot, rigid, motions) if smooth else np.zeros(robot.n)
    tables = [_columns(robot, Y, m, speeds) for Y, m in zip(rigid, motions, strict=True)]
    Y = np.concatenate([table[m.fitted] for table, m in zip(tables, motions, strict=True)])
    tau = np.concatenate([m.tau[m.fitted] for m in motions])
    weights = 1 / np.sqrt((tau**2).mean(axis=0))
    x = np.zeros(Y.shape[2])
    for _ in range(ROUNDS):
        x = _solved((Y * weights[:, None]).reshape(-1, Y.shape[2]), (tau * weights).ravel())
        weights = 1 / np.sqrt(((tau - Y @ x) ** 2).mean(axis=0))
    residuals = tuple(m.tau - table @ x for table, m in zip(tables, motions, strict=True))
    names = [f"base{k}" for k in independent] + list(_names(robot))
    return Fit(residuals, dict(zip(names, map(float, x), strict=True)), speeds)


def _names(robot: Robot) -> tuple[str, ...]:
    kinds = ("viscous", "coulomb") if robot.torque_side == "link" else ("viscous", "coulomb", "rotor")
    return tuple(f"{kind}{j + 1}" for kind in kinds for j in range(robot.n))


def smoothing(robot: Robot, rigid: Sequence[Floats], motions: Sequence[Motion]) -> Floats:
    """Speeds [n] of smoothed friction with which fitted samples of each joint alone are fitted best."""
    usual = rms([m.qd[m.fitted] for m in motions])
    best, least = np.zeros(robot.n), np.full(robot.n, np.inf)
    for step in 10.0 ** (-0.5 * np.arange(2 * DECADES + 1)):
        tables = [_columns(robot, Y, m, step * usual) for Y, m in zip(rigid, motions, strict=True)]
        Y = np.concatenate([table[m.fitted] for table, m in zip(tables, motions, strict=True)])
        tau = np.concatenate([m.tau[m.fitted] for m in motions])
        left = [tau[:, j] - Y[:, j] @ _solved(Y[:, j], tau[:, j]) for j in range(robot.n)]
        squares = np.array([float(x @ x) for x in left])
        best = np.where(squares < least, step * usual, best)
        least = np.minimum(squares, least)
    return best


def _columns(robot: Robot, rigid: Floats, m: Motion, speeds: Floats) -> Floats:
    """``rigid`` [K, n, p] with a column for each joint's friction and, at the motor, its rotor."""
    way = np.where(speeds > 0, np.tanh(m.qd / np.where(speeds > 0, speeds, 1.0)), np.sign(m.qd))
    kinds = [m.qd, way]
    if robot.torque_side != "link":
        kinds.append(m.qdd)
    diagonal = [kind[:, :, None] * np.eye(robot.n) for kind in kinds]
    return np.concatenate([rigid, *diagonal], axis=2)


def _solved(Y: Floats, tau: Floats) -> Floats:
    size = np.sqrt((Y**2).sum(axis=0))
    size[size == 0] = 1
    x, *_ = np.linalg.lstsq(Y / size, tau, rcond=1e-10)
    return np.asarray(x / size, dtype=np.float64)


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line."""
    assert __doc__
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("robot")
    parser.add_argument("logs", nargs="+")
    parser.add_argument("--cutoff", type=float, required=True, help="of the low-pass of positions [Hz]")
    parser.add_argument("--raster", type=float, help="even step for logs with jitter [s]")
    parser.add_argument("--smooth", action="store_true", help="friction of tanh(v / v_s)")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args(arguments)
    robot = load(options.robot, warn=lambda _: None)
    motions = [motion(read(path), options.cutoff, options.raster) for path in options.logs]
    result = fit(robot, motions, smooth=options.smooth)
    rows = {}
    for what in ("fitted", "held_out"):
        masks = [getattr(m, what) for m in motions]
        left = [r[mask] for r, mask in zip(result.residuals, masks, strict=True)]
        rows[what] = shares(left, [m.tau[mask] for m, mask in zip(motions, masks, strict=True)])
    if options.json:
        print(json.dumps({k: v.tolist() for k, v in rows.items()} | {"parameters": result.parameters}))
        return 0
    for what, row in rows.items():
        print(f"{what:9s}", *(f"{share:6.1f}" for share in row))
    return 0


if __name__ == "__main__":
    sys.exit(main())
