"""What models leave of logs: RMS of the raw torque less the model's, sample for sample.

Torques are neither filtered nor left out, save 1 % at either end of an unbroken piece: a figure for people,
and the same for every model. Positions are filtered as for any model
(:func:`robodyn.identify.predict.predicted`).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from robodyn.gate.gate import Gate
from robodyn.identify.limits import END_SHARE, LONG_CHUNK
from robodyn.identify.normal import Layout
from robodyn.identify.predict import cutoff_of, gains, smooth_motion
from robodyn.identify.regressor import Links
from robodyn.identify.rows import bare, blocks_of, kept_torque, true_torque
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.logs.signals import low_pass
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Squares:
    """Sums over samples: what each of several models leaves, squared [S, n], of the blocks that a first fit
    uses and of those held out; the same of the torque [n]; how many samples."""

    fitted: Floats
    held_out: Floats
    torque_fitted: Floats
    torque_held_out: Floats
    fitted_count: int
    held_out_count: int

    def __add__(self, other: Squares) -> Squares:
        return Squares(
            self.fitted + other.fitted,
            self.held_out + other.held_out,
            self.torque_fitted + other.torque_fitted,
            self.torque_held_out + other.torque_held_out,
            self.fitted_count + other.fitted_count,
            self.held_out_count + other.held_out_count,
        )

    def rms(self) -> Floats:
        """Over all samples [S, n]."""
        return np.asarray(
            np.sqrt((self.fitted + self.held_out) / max(self.fitted_count + self.held_out_count, 1))
        )

    def torque_rms(self) -> Floats:
        """Of the torque over all samples [n]."""
        count = max(self.fitted_count + self.held_out_count, 1)
        return np.asarray(np.sqrt((self.torque_fitted + self.torque_held_out) / count))

    def torque_rms_held_out(self) -> Floats:
        """Of the torque over the samples held out [n]."""
        return np.asarray(np.sqrt(self.torque_held_out / max(self.held_out_count, 1)))

    def rms_held_out(self) -> Floats:
        """Over the samples held out [S, n]."""
        return np.asarray(np.sqrt(self.held_out / max(self.held_out_count, 1)))


def squares_of(
    robot: Robot, layout: Layout, gate: Gate, models: Floats, scales: Floats | None = None
) -> Squares:
    """What is left of a log by each of the ``models`` [S, p], parameters in the ``layout`` of ``robot``, the
    torque of which is multiplied by ``scales`` [S, n]."""
    gain = gains(robot)
    edges, held_out = blocks_of(gate.log.samples)
    sums = [np.zeros((len(models), robot.n)) for _ in range(2)]
    torque, counts = [np.zeros(robot.n) for _ in range(2)], [0, 0]
    rigid = models[:, : 10 * robot.n].reshape(len(models), robot.n, 10)
    for part in gate.segments:
        piece = Log(gate.log.t[part], gate.log.q[part], None, None, gate.log.tau[part])
        _, q, qd, qdd = smooth_motion(gate, part)
        through = partial(low_pass, rate=1 / gate.period, cutoff=cutoff_of(gate, part))
        model = Model(bare(robot), seen=through if gate.blurred else None)
        tau = true_torque(robot, piece)
        known = kept_torque(robot, piece, q, qd, qdd)
        if known is not None:
            tau = tau - known
        way = model.direction(qd)
        own = {"viscous": qd, "coulomb": way, "rotor": qdd, "offset": np.ones_like(q)}
        index = part.start + np.arange(len(q))
        which = held_out[np.searchsorted(edges, index, side="right") - 1]
        end = int(END_SHARE * len(q))
        inner = (index >= part.start + end) & (index < part.stop - end)
        for a in range(0, len(q), LONG_CHUNK):
            chunk = slice(a, min(a + LONG_CHUNK, len(q)))
            predicted = Links.along(model.arm, q[chunk], qd[chunk], qdd[chunk]).torques(rigid)
            for name in layout.own:
                predicted += models[:, layout.joint(name)][:, :, None] * own[name][chunk].T
            if scales is not None:
                predicted *= scales[:, :, None]
            left = (tau[chunk].T - predicted) * (1 + gain)[:, None]
            for k, mask in enumerate((inner & ~which, inner & which)):
                here = mask[chunk]
                sums[k] += np.einsum("snk,snk->sn", left[:, :, here], left[:, :, here])
                torque[k] += (piece.tau[chunk][here] ** 2).sum(axis=0)
                counts[k] += int(here.sum())
    return Squares(sums[0], sums[1], torque[0], torque[1], counts[0], counts[1])
