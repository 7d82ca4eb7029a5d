"""What sensors and limits of a drive make of the torque."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.select.library.candidate import Candidate, Context, single
from robodyn.diagnose.select.library.limits import (
    DRIVE_LIMITS,
    ENCODER_OFF,
    GAIN_MOST,
    LIMIT_EXPLAINED,
    LIMIT_SHARE,
    SENSOR_PILED,
)
from robodyn.effects.effect import Effect
from robodyn.effects.traits import Channel, Shown
from robodyn.gate.limits import PILED_SAMPLES
from robodyn.identify.predict import given_torque
from robodyn.identify.twist import slopes_of
from robodyn.robot.model import Robot


def channels(c: Context, effect: Effect, shown: Shown, j: int) -> Iterator[Candidate]:
    """What the torque channel and the encoder of a joint may show wrong."""
    channel = effect.traits.channel
    assert channel is not None
    total = c.at.total[:, j]

    def read(x: Floats) -> dict[str, float | str]:
        return {channel.parameter: float(x[0])}

    if channel.acts == "limit":
        yield from _saturation(c, effect, channel, shown, j)
    elif channel.acts == "position":
        column = -slopes_of(c.model, c.slow.q, c.slow.qd, c.slow.qdd, c.plain, j).place
        yield Candidate(
            effect.id, j + 1, tuple(range(c.n)), column[:, :, None], (0,), read, shown.order, coarse=True,
            feasible=lambda x: bool(abs(x[0]) < ENCODER_OFF),
        )  # fmt: skip
    elif channel.acts == "delay":
        late = -np.gradient(c.signals.filtered(total), c.signals.period)
        yield single(effect.id, j, [late], (1,), read, shown.order)
    else:
        column = total if channel.acts == "gain" else np.ones_like(c.signals.t)
        most = GAIN_MOST if channel.acts == "gain" else np.inf
        yield single(
            effect.id, j, [column], (0,), read, shown.order, feasible=lambda x: bool(abs(x[0]) < most)
        )


def all_channels(c: Context, effect: Effect, shown: Shown) -> Iterator[Candidate]:
    """All torque channels late by the same, or wrong by the same factor."""
    channel, s, total = effect.traits.channel, c.slow, c.at_slow.total
    assert channel is not None
    assert shown.of_all is not None
    is_gain = channel.acts == "gain"
    if is_gain and c.n == 1:  # it is that of the joint, and would be its own rival
        return
    column = total if is_gain else -np.gradient(s.filtered(total), s.period, axis=0)
    yield Candidate(
        effect.id, None, tuple(range(c.n)), column[:, :, None], (0,) if is_gain else (1,),
        lambda x: {channel.parameter: float(x[0])}, shown.of_all, coarse=True,
        feasible=lambda x: bool(not is_gain or abs(x[0]) < GAIN_MOST),
    )  # fmt: skip


def _saturation(c: Context, effect: Effect, channel: Channel, shown: Shown, j: int) -> Iterator[Candidate]:
    """Beyond a limit the drive gives no more than that, and the log has the command; or the log stops
    there."""
    tau = c.signals.tau[:, j]
    for share in DRIVE_LIMITS:
        yield _clipped(c, effect, channel, shown, j, {"limit": share * float(np.abs(tau).max())})
    top, total = float(np.abs(tau).max()), c.at.total[:, j]
    piled = np.abs(tau) > (1 - 1e-9) * top
    if piled.mean() > SENSOR_PILED and piled.sum() >= PILED_SAMPLES:
        beyond = -np.sign(total) * np.maximum(np.abs(total) - top, 0.0)
        yield single(
            effect.id, j, [beyond], (1,), lambda x: {channel.parameter: top, channel.who: "sensor"},
            shown.order, fixed=True, local=True, feasible=_about_one,
        )  # fmt: skip


def _clipped(
    c: Context, effect: Effect, channel: Channel, shown: Shown, j: int, settings: Mapping[str, float]
) -> Candidate:
    """A drive's limit: what the commands have beyond it."""
    tau, total, limit = c.signals.tau[:, j], c.at.total[:, j], settings["limit"]
    beyond = np.sign(tau) * np.maximum(np.abs(tau) - limit, 0.0)
    if np.mean(beyond != 0) > LIMIT_SHARE or not _is_limit(tau, total, beyond, limit):
        beyond = np.zeros_like(tau)
    return single(
        effect.id, j, [beyond], (1,), lambda x: {channel.parameter: limit, channel.who: "drive"}, shown.order,
        fixed=True, local=True, values=settings, feasible=_about_one,
        again=lambda c, values: _clipped(c, effect, channel, shown, j, values),
    )  # fmt: skip


def _is_limit(tau: Floats, total: Floats, beyond: Floats, limit: float) -> bool:
    """Whether a drive has a limit by which commands ``tau`` [K] go ``beyond`` [K] what the arm needs, by a
    model ``total`` [K]. It must be right where it clips, for cutting peaks off makes every torque smaller;
    and where the arm needs as much: of noise about a torque that is level (friction) as much lies below."""
    rest, at = tau - total, beyond != 0
    miss = np.sqrt(np.mean((rest - beyond)[at] ** 2)) if at.any() else 0.0
    near = at | (np.abs(total) > limit - 2 * miss)
    left = float(np.sum((rest - beyond)[near] ** 2))
    return left < (1 - LIMIT_EXPLAINED) * float(np.sum(rest[near] ** 2))


def leave_little(commands: Sequence[Floats], robot: Robot) -> bool:
    """Whether some drive of ``robot`` would be at its limit for most of the ``commands`` [K, n] of logs: the
    lower the limit, the less is left to be explained."""
    clipped = np.concatenate([given_torque(tau, robot) != tau for tau in commands])
    return bool(np.any(clipped.mean(axis=0) > LIMIT_SHARE))


def _about_one(x: Floats) -> bool:
    return bool(0.7 < x[0] < 1.3)
