"""What a model leaves of a log, in its full equations, and what that changes by where joints turn round.

A joint with dry friction that turns round sticks for a moment: its friction goes from one side to the other
while the joint stands, and not when a filtered velocity changes its sign. So in a model friction turns some
thousandths of a second too early or too late, at every reversal alike, which would be taken for a delay or
for friction of another size. While it sticks or creeps, its friction is anything within its level, and a law
that is steepest near rest (Stribeck's) would be fitted to that: so below some speed, to be fitted as well, it
fades (Karnopp 1985 has an interval about zero velocity; the course in it is taken to be a straight line).
"""

from __future__ import annotations

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.select.library import Context
from robodyn.effects.traits import Dahl
from robodyn.identify.oscillator import dahl_deflection
from robodyn.identify.predict import given_torque, offsets
from robodyn.identify.twist import behind_motors
from robodyn.kernels.array_dynamics import Model
from robodyn.simulate.sensors import measured_torque


def remainder(model: Model, c: Context) -> Floats:
    """What a ``model`` leaves [N, n] of a log, filtered and thinned."""
    s, robot, model = c.signals, model.robot, model.along(c.reuse)
    q = c.reuse.shifted(s.q, offsets(robot))
    torque = behind_motors(model, q, s.qd, s.qdd, s.period, s.tau)
    total = torque.total
    for entry in robot.effects:
        for law in entry.definition.traits.candidates:
            if isinstance(law, Dahl) and entry.joint:  # the model has them sliding
                j, level = entry.joint - 1, entry.number(law.level)
                if level > 0:
                    limit = level / entry.number(law.stiffness)
                    deflection = dahl_deflection(s.q[:, j], limit)
                    rate = np.gradient(limit * deflection, s.period)
                    total[:, j] += level * (deflection - model.direction(s.qd)[:, j])
                    total[:, j] += entry.number(law.damping) * rate
    tau = measured_torque(total, s.t, robot.effects, noise=s.torque_noise)
    return s.thinned(s.filtered(given_torque(s.tau, robot) - tau))
