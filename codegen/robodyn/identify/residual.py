"""What models leave of logs: RMS of the raw torque less the model's, of samples that say something.

Torques are not filtered. Left out are 1 % at either end of an unbroken piece, and of each joint what it does
at rest, where every torque within its dry friction is right: figures for people, and the same samples for
every model. Positions are filtered as for any model (:func:`robodyn.identify.predict.predicted`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from robodyn.arrays import Floats
from robodyn.gate.gate import Gate
from robodyn.identify.limits import END_SHARE
from robodyn.identify.normal import Layout
from robodyn.identify.predict import gains, smooth_motion
from robodyn.identify.regressor import Links
from robodyn.identify.rest import Rest
from robodyn.identify.rows import bare, blocks_of, direction, kept_torque, true_torque
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True, eq=False)
class Squares:
    """Sums of squares [2, S + 1, n] of what each of several models leaves, ``left``, and of the torque itself
    last: over blocks that a first fit uses, and over those held out; ``count`` [2, n] of samples, and
    ``resting`` [n] of those at rest, which are not counted."""

    left: Floats
    count: Floats
    resting: Floats

    def __add__(self, other: Squares) -> Squares:
        return Squares(self.left + other.left, self.count + other.count, self.resting + other.resting)

    def rms(self, *, held_out: bool = False) -> Floats:
        """Over all samples, or those held out, [S + 1, n]."""
        part = slice(1 if held_out else 0, 2)
        return np.asarray(np.sqrt(self.left[part].sum(axis=0) / np.maximum(self.count[part].sum(axis=0), 1)))


def squares_of(
    robot: Robot,
    layout: Layout,
    gate: Gate,
    rest: Rest,
    models: Floats,
    scales: Floats,
    late: float,
    longest: int = 4096,
) -> Squares:
    """What is left of a log by each of the ``models`` [S, p], parameters in the ``layout`` of ``robot``, the
    torque of which is multiplied by ``scales`` [S, n]; ``rest`` of its joints; its torques are read ``late``
    [s]. Of a joint that rests throughout all samples count. Models are evaluated at ``longest`` samples at a
    time."""
    gain = gains(robot)
    edges, held_out = blocks_of(gate.log.samples)
    left, count = np.zeros((2, len(models) + 1, robot.n)), np.zeros((2, robot.n))
    resting = np.zeros(robot.n)
    rigid = models[:, : 10 * robot.n].reshape(len(models), robot.n, 10)
    for part in gate.segments:
        piece = Log(gate.log.t[part], gate.log.q[part], None, None, gate.log.tau[part])
        _, q, qd, qdd = smooth_motion(gate, part)
        model = Model(bare(robot))
        tau = true_torque(robot, piece, late)
        known = kept_torque(robot, piece, q, qd, qdd)
        if known is not None:
            tau = tau - known
        way = direction(qd, rest.speeds)
        own = {"viscous": qd, "coulomb": way, "rotor": qdd, "offset": np.ones_like(q)}
        index = part.start + np.arange(len(q))
        which = held_out[np.searchsorted(edges, index, side="right") - 1]
        end = int(END_SHARE * len(q))
        inner = (index >= part.start + end) & (index < part.stop - end)
        silent = (np.abs(qd) < rest.silent) & inner[:, None]
        resting += silent.sum(axis=0)
        silent &= ~silent[inner].all(axis=0)
        for a in range(0, len(q), longest):
            chunk = slice(a, min(a + longest, len(q)))
            predicted = Links.along(model.arm, q[chunk], qd[chunk], qdd[chunk]).torques(rigid)
            for name in layout.own:
                predicted += models[:, layout.joint(name)][:, :, None] * own[name][chunk].T
            predicted *= scales[:, :, None]
            missed = (tau[chunk].T - predicted) * (1 + gain)[:, None]
            every = np.concatenate([missed, piece.tau[chunk].T[None]])
            for k, mask in enumerate((inner & ~which, inner & which)):
                counted = mask[chunk, None] & ~silent[chunk]
                left[k] += np.einsum("snk,kn->sn", every**2, counted)
                count[k] += counted.sum(axis=0)
    return Squares(left, count, resting)
