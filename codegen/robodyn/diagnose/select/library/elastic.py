"""Joints that twist or have play."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.library.candidate import Candidate, Context
from robodyn.diagnose.select.signals import low_pass
from robodyn.diagnose.select.twist import lag_of, slopes_of

Floats = NDArray[np.float64]

#: Where a joint may swing on its spring [Hz], and how much it is damped as a share of what would stop it.
_SWINGS, _DAMPED = tuple(4.0 * 1.25**k for k in range(12)), 0.05
#: Widths of play [rad or m], teeth by the swing of the joint on them [Hz], and the torque of its rounding.
_GAPS, _TEETH = tuple(1e-3 * 1.25**k for k in range(17)), (8.0, 12.0, 18.0, 30.0)
_ROUNDED = 0.05
_TRANSITIONS = (0.05, 0.5)
#: Cutoff [Hz] of what is differentiated twice; fewest steps a second of a swing.
_TWIST, _STEPS = 6.0, 300.0


def elastic(c: Context, j: int) -> Iterator[Candidate]:
    """A twist by the torque that is passed on. Measured at the motor, the link swings behind it; measured at
    the link, the motor's inertia is ahead of it."""
    if any(e.effect in ("joint_elasticity", "backlash") for e in c.model.robot.effects_at(j + 1)):
        return
    yield from _ahead(c, j)
    swing = _swing(c, j)
    if swing.inertia <= 0:
        return
    for hertz in _SWINGS:
        yield behind(c, j, swing.springs(hertz))
    for hertz in _TEETH:
        for gap in _GAPS:
            yield behind(c, j, {"gap": gap, **swing.springs(hertz)})


class Swing:
    """What the link of joint ``j`` (from 0) swings under: the arm's torque and its slopes along the motion,
    at the coarse rate and at that of the steps."""

    def __init__(self, c: Context, j: int) -> None:
        self.slow = slopes_of(c.model, c.slow.q, c.slow.qd, c.slow.qdd, c.plain, j)
        coarse = max(1, c.signals.every // 2)
        fine = [d for d in range(1, coarse + 1) if coarse % d == 0]
        step = max((d for d in fine if 1 / (c.signals.period * d) >= _STEPS), default=1)
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

    def springs(self, hertz: float) -> dict[str, float]:
        """A spring on which the link swings so often a second, lightly damped."""
        rate = 2 * np.pi * hertz
        return {"stiffness": self.inertia * rate**2, "damping": 2 * _DAMPED * self.inertia * rate}

    def column(self, effect: str, values: Mapping[str, float]) -> Floats:
        """What the torques [K, n] of coarse signals change by."""
        lag = lag_of(effect, values, self.torque, self.felt, self.period, self.passed)
        if not np.isfinite(lag).all():
            return np.zeros_like(self.slow.place)
        return self.slow.of(lag[:: self.every][: len(self.slow.place)])


def _swing(c: Context, j: int) -> Swing:
    swing: Swing = c.kept.get(("swing", j)) or Swing(c, j)
    c.kept["swing", j] = swing
    return swing


def behind(c: Context, j: int, given: Mapping[str, float]) -> Candidate:
    """A link behind its motor, with all of the spring or the play as it is ``given``."""
    effect = "backlash" if "gap" in given else "joint_elasticity"
    values = dict(given) if effect == "joint_elasticity" else {**given, "transition": _ROUNDED}
    column = _swing(c, j).column(effect, values)

    def read(x: Floats) -> dict[str, float | str]:
        return {**values, "encoder": "motor"}

    return Candidate(
        effect,
        j + 1,
        tuple(range(c.n)),
        column[:, :, None],
        (1,),
        read,
        5,
        coarse=True,
        fixed=True,
        given=given,
    )


def _ahead(c: Context, j: int) -> Iterator[Candidate]:
    """A motor ahead of its link, where the encoder is."""
    s = c.slow
    rotor = float(c.model.robot.links[j].joint.motor_inertia)  # type: ignore[arg-type]  # constants
    if not rotor:
        return
    passed = c.at_slow.passed[:, j]
    twists = [("joint_elasticity", 0.0, passed)]
    twists += [("backlash", w, 0.5 * passed / (np.abs(passed) + w)) for w in _TRANSITIONS]
    for effect, w, twist in twists:
        slow = low_pass(twist, 1 / s.period, min(_TWIST, s.cutoff))
        acceleration = np.gradient(np.gradient(slow, s.period), s.period)

        def read(x: Floats, effect: str = effect, w: float = w) -> dict[str, float | str]:
            if effect == "backlash":
                return {"gap": float(x[0]), "encoder": "link", "transition": w}
            stiffness = float(1 / x[0]) if x[0] > 0 else 1e12
            return {"stiffness": stiffness, "damping": 0.0, "encoder": "link"}

        column = (rotor * acceleration)[:, None, None]
        yield Candidate(effect, j + 1, (j,), column, (1,), read, 5, coarse=True)
