"""Joints with elasticity or backlash."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.select.library.candidate import Candidate, Context
from robodyn.diagnose.select.limits import DAMPED, OSCILLATOR_RATE, TWIST_CUTOFF
from robodyn.effects.effect import Effect
from robodyn.effects.traits import Twist
from robodyn.identify.twist import lag_of, slopes_of
from robodyn.logs.signals import low_pass


def twists(c: Context, effect: Effect, twist: Twist, j: int) -> Iterator[Candidate]:
    """A twist by the transmitted torque. Measured at the motor, the link oscillates behind it; measured at
    the link, the motor's inertia is ahead of it."""
    if any(entry.definition.coupler is not None for entry in c.model.robot.effects_at(j + 1)):
        return
    yield from _ahead(c, effect, twist, j)
    oscillator = _oscillator(c, j)
    if oscillator.inertia <= 0:
        return
    for hertz in twist.hertz:
        for more in twist.more:
            yield _behind(c, effect, twist, j, {**more, **oscillator.springs(hertz)})


class Oscillator:
    """What drives the link of joint ``j`` (from 0) on its spring: the arm's torque and its slopes along the
    motion, at the coarse rate and at that of the steps."""

    def __init__(self, c: Context, j: int) -> None:
        self.slow = slopes_of(c.model, c.slow.q, c.slow.qd, c.slow.qdd, c.plain, j)
        coarse = max(1, c.signals.every // 2)
        fine = [d for d in range(1, coarse + 1) if coarse % d == 0]
        step = max((d for d in fine if 1 / (c.signals.period * d) >= OSCILLATOR_RATE), default=1)
        self.every, self.period = coarse // step, c.signals.period * step
        self.torque = c.at.passed[::step, j]
        self.passed = (c.signals.tau - c.at.total + c.at.passed)[::step, j]
        count = len(self.torque)
        at = np.arange(count) / self.every

        def often(x: Floats) -> Floats:
            return np.asarray(np.interp(at, np.arange(len(x)), x))

        felt = (self.slow.inertia, self.slow.rate, self.slow.place)
        self.felt = (often(felt[0][:, j]), often(felt[1][:, j]), often(felt[2][:, j]))
        self.inertia = float(np.mean(self.slow.inertia[:, j]))
        self._between: dict[int, list[Floats]] = {}

    def springs(self, hertz: float) -> dict[str, float]:
        """A spring on which the link has this natural frequency [Hz], lightly damped."""
        rate = 2 * np.pi * hertz
        return {"stiffness": self.inertia * rate**2, "damping": 2 * DAMPED * self.inertia * rate}

    def column(self, effect: str, values: Mapping[str, float]) -> Floats:
        """What the torques [K, n] of coarse signals change by."""
        lag = lag_of(effect, values, self.torque, self.felt, self.period, self.passed, self._between)
        if not np.isfinite(lag).all():
            return np.zeros_like(self.slow.place)
        return self.slow.of(lag[:: self.every][: len(self.slow.place)])


def _oscillator(c: Context, j: int) -> Oscillator:
    oscillator: Oscillator = c.kept.get(("oscillator", j)) or Oscillator(c, j)
    c.kept["oscillator", j] = oscillator
    return oscillator


def _behind(c: Context, effect: Effect, twist: Twist, j: int, settings: Mapping[str, float]) -> Candidate:
    """A link behind its motor, with all of the spring or the backlash as it is ``settings``."""
    values = {**settings, **twist.fixed}
    column = _oscillator(c, j).column(effect.id, values)
    return Candidate(
        effect.id, j + 1, tuple(range(c.n)), column[:, :, None], (1,),
        lambda x: {**values, "encoder": "motor"}, twist.order, coarse=True, fixed=True, reach=twist.reach,
        likely=lambda x: all(settings[name] <= most for name, most in twist.likely.items()),
        values=settings, again=lambda c, values: _behind(c, effect, twist, j, values),
    )  # fmt: skip


def _ahead(c: Context, effect: Effect, twist: Twist, j: int) -> Iterator[Candidate]:
    """A motor ahead of its link, where the encoder is."""
    s, coupler = c.slow, effect.coupler
    rotor = float(c.model.robot.links[j].joint.motor_inertia)  # type: ignore[arg-type]  # constants
    if not rotor or coupler is None:
        return
    for values in twist.ahead:
        lead = np.asarray(coupler.twist(values, c.at_slow.passed[:, j]))
        slow = low_pass(lead, 1 / s.period, min(TWIST_CUTOFF, s.cutoff))
        acceleration = np.gradient(np.gradient(slow, s.period), s.period)

        def read(x: Floats, values: Mapping[str, float] = values) -> dict[str, float | str]:
            return twist.read_ahead(x, values)

        column = (rotor * acceleration)[:, None, None]
        yield Candidate(effect.id, j + 1, (j,), column, (1,), read, twist.order, coarse=True)
