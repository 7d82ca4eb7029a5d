"""A model along a log."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from robodyn.diagnose.select.library.candidate import Context, Hints
from robodyn.diagnose.select.library.position import cycles_in
from robodyn.identify.predict import given_torque, model_torque
from robodyn.identify.twist import behind_motors
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.signals import Signals


def context_of(model: Model, signals: Signals, hints: Hints | None = None) -> Context:
    """The model evaluated along the signals; the whole of it where effects remember."""
    if model.robot.effects:
        signals = replace(signals, tau=given_torque(signals.tau, model.robot))
    slow = signals.coarse()
    at, at_slow = (behind_motors(model, s.q, s.qd, s.qdd, s.period, s.tau) for s in (signals, slow))
    if model.robot.effects:
        total = model_torque(
            model.robot, signals.t, signals.q, signals.qd, signals.qdd, signals.tau, compiled=False
        )
        at = replace(at, total=total)
        at_slow = replace(
            at_slow, total=signals.filtered(total)[:: max(1, signals.every // 2)][: len(slow.t)]
        )
    plain = model.rigid_torque(slow.q, slow.qd, slow.qdd) if model.couplers else at_slow.rigid
    top = np.abs(signals.qd).max(axis=0)
    none = Hints(top, ((),) * signals.n)
    context = Context(model, signals, at, model.direction(signals.qd), slow, at_slow, plain, hints or none)
    if hints is None:
        cycles = tuple(tuple(cycles_in(context, j)) for j in range(signals.n))
        context = replace(context, hints=Hints(top, cycles))
    return context
