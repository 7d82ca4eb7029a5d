"""What a model leaves of real logs on held-out samples, beside plain least squares on the fitted ones.

    python -m benchmarks.gap.score MODEL.yaml LOG.csv... --cutoff HZ [--raster S] [--from GIVEN.yaml]
                                   [--smooth] [--rest identify.json] [--json]

The model's torque is that of its compiled kernel along positions filtered by the rule
(:mod:`benchmarks.gap.recordings`); what its sensors do to it is added here. Nothing of how ``identify`` or
``diagnose`` judge a model is used. ``--from`` is the description whose torque side and geometry plain least
squares take (default: the model). Ratios above 1 mean that the model leaves more than least squares. With
``--smooth`` least squares have smoothed friction; with ``--rest`` that of the model fades below the speeds
that ``identify`` wrote, in proportion to the speed.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.gap.least_squares import fit
from benchmarks.gap.recordings import Floats, Motion, motion, read, rms, shares

import robodyn
from robodyn.robot import load
from robodyn.robot.model import EffectEntry, Robot

#: Effects of sensors and drives, which no kernel has.
_CHANNELS = ("torque_bias", "torque_gain", "time_delay", "encoder_offset", "torque_saturation")
#: Joints whose encoder is before a spring or play: a kernel would have to look ahead.
_SOFT = ("joint_elasticity", "backlash")


@dataclass(frozen=True, slots=True)
class Score:
    """Held-out and fitted figures [n] of a model and of plain least squares: RMS residual (N m or N), and
    100 RMS residual / RMS torque; the same of the model before anything was found."""

    rms: Floats
    share: Floats
    fitted_share: Floats
    plain_rms: Floats
    plain_share: Floats
    before_share: Floats | None

    @property
    def ratio(self) -> Floats:
        """Held-out residual of the model over that of plain least squares [n]."""
        return self.rms / self.plain_rms


def residual(robot: Robot, m: Motion, rest: Floats | None = None) -> Floats:
    """Torque as logged (a command as far as the drive could give it) less that of ``robot`` [K, n], whose
    Coulomb friction is less in proportion to the speed below the speeds ``rest`` [n]."""
    logged = m.tau.copy()
    for entry in _of(robot, "torque_saturation"):
        if entry.text("clips") == "drive":
            columns = _columns(entry)
            logged[:, columns] = np.clip(logged[:, columns], -entry.number("limit"), entry.number("limit"))
    tau = torque(robot, m)
    if rest is not None:
        tau = _at_rest(robot, m, tau, np.maximum(rest, 1e-300))
    return logged - channel(robot, m.t, tau)


def _at_rest(robot: Robot, m: Motion, tau: Floats, rest: Floats) -> Floats:
    """Torques ``tau`` [K, n]; of a joint slower than ``rest`` [n] they go in a straight line from what they
    would be at that speed one way to what they would be the other way."""
    tau = tau.copy()
    for j in range(robot.n):
        forth, back = (torque(robot, _moving(m, j, speed))[:, j] for speed in (rest[j], -rest[j]))
        slow = np.abs(m.qd[:, j]) < rest[j]
        line = (forth + back) / 2 + m.qd[:, j] / rest[j] * (forth - back) / 2
        tau[slow, j] = line[slow]
    return tau


def _moving(m: Motion, j: int, speed: float) -> Motion:
    """The motion with one speed of joint ``j`` (from 0)."""
    qd = m.qd.copy()
    qd[:, j] = speed
    return replace(m, qd=qd)


def torque(robot: Robot, m: Motion) -> Floats:
    """True torques [K, n] of ``robot`` along measured positions, by its compiled kernel."""
    q = m.q.copy()
    for entry in _of(robot, "encoder_offset"):
        q[:, _columns(entry)] -= entry.number("offset")
    if any(e.effect in _SOFT and e.text("encoder") == "motor" for e in robot.effects):
        from robodyn.identify.predict import model_torque

        inside = tuple(e for e in robot.effects if e.effect not in _CHANNELS)
        return model_torque(replace(robot, effects=inside), m.t, q, m.qd, m.qdd, m.tau)
    kernel = robodyn.compile(robot, functions=["inverse_dynamics"], optimize="fast", mode="abi")
    step: dict[str, Any] = {}
    if kernel.signatures["inverse_dynamics"].states:
        step["dt"] = float(m.t[1] - m.t[0])
    return np.asarray(kernel.inverse_dynamics(q, m.qd, m.qdd, **step), dtype=np.float64)


def channel(robot: Robot, t: Floats, tau: Floats) -> Floats:
    """What the torque channels of ``robot`` show of true torques [K, n]: delay, gain, bias, limit."""
    shown = tau.copy()
    late = np.zeros(robot.n)
    for entry in _of(robot, "time_delay"):
        late[_columns(entry)] += entry.number("delay")
    for j in np.flatnonzero(late):
        shown[:, j] = np.interp(t - late[j], t, tau[:, j])
    for entry in _of(robot, "torque_gain"):
        shown[:, _columns(entry)] *= 1 + entry.number("gain")
    for entry in _of(robot, "torque_bias"):
        shown[:, _columns(entry)] += entry.number("bias")
    for entry in _of(robot, "torque_saturation"):
        if entry.text("clips") == "sensor":
            columns = _columns(entry)
            shown[:, columns] = np.clip(shown[:, columns], -entry.number("limit"), entry.number("limit"))
    return shown


def _of(robot: Robot, id: str) -> list[EffectEntry]:
    return [entry for entry in robot.effects if entry.effect == id]


def _columns(entry: EffectEntry) -> slice:
    return slice(None) if entry.joint is None else slice(entry.joint - 1, entry.joint)


def score(
    model: Robot,
    motions: Sequence[Motion],
    start: Robot | None = None,
    *,
    rest: Floats | None = None,
    smooth: bool = False,
) -> Score:
    """``model``, with friction that fades below the speeds ``rest`` [n], on ``motions`` beside plain least
    squares with the geometry of ``start`` and friction that is ``smooth``."""
    left = [residual(model, m, rest) for m in motions]
    plain = fit(start or model, motions, smooth=smooth).residuals
    tau = [m.tau for m in motions]

    def part(tables: Sequence[Floats], which: str) -> list[Floats]:
        return [x[getattr(m, which)] for x, m in zip(tables, motions, strict=True)]

    held = part(tau, "held_out")
    before = None
    if start is not None:
        before = shares(part([residual(start, m) for m in motions], "held_out"), held)
    return Score(
        rms(part(left, "held_out")),
        shares(part(left, "held_out"), held),
        shares(part(left, "fitted"), part(tau, "fitted")),
        rms(part(plain, "held_out")),
        shares(part(plain, "held_out"), held),
        before,
    )


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line."""
    assert __doc__
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("model")
    parser.add_argument("logs", nargs="+")
    parser.add_argument("--cutoff", type=float, required=True, help="of the low-pass of positions [Hz]")
    parser.add_argument("--raster", type=float, help="even step for logs with jitter [s]")
    parser.add_argument("--from", dest="given", help="description that the model was made of")
    parser.add_argument("--smooth", action="store_true", help="smoothed friction for least squares")
    parser.add_argument("--rest", type=Path, help="identify.json with the speeds of rest")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args(arguments)
    model, start = (load(x, warn=lambda _: None) if x else None for x in (options.model, options.given))
    assert model is not None
    motions = [motion(read(path), options.cutoff, options.raster) for path in options.logs]
    rest = np.array(json.loads(options.rest.read_text("utf-8"))["rest"]) if options.rest else None
    result = score(model, motions, start, rest=rest, smooth=options.smooth)
    lines = {
        "held out, RMS": result.rms,
        "least squares, RMS": result.plain_rms,
        "held out, %": result.share,
        "least squares, %": result.plain_share,
        "fitted, %": result.fitted_share,
        "ratio": result.ratio,
    }
    if result.before_share is not None:
        lines["before, %"] = result.before_share
    if options.json:
        print(json.dumps({name: line.tolist() for name, line in lines.items()}))
        return 0
    for name, line in lines.items():
        print(f"{name:18s}", *(f"{x:9.4g}" for x in line))
    return 0


if __name__ == "__main__":
    sys.exit(main())
