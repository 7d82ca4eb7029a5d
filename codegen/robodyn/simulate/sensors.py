"""What sensors make of the true signals: encoders, rates taken from them, and the torque channel.

The torque channel acts in this order: delay (of the true torque), gain, bias, noise, saturation of the
sensor, quantisation. The encoder: offset, noise, quantisation. Delay, gain, bias, saturation and offset are
effects of the robot (:mod:`robodyn.effects.sensors`); they act on what a model predicts as on what is
simulated.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any, Literal, TypeVar, cast

import numpy as np

from robodyn.arrays import Floats
from robodyn.effects.traits import Acts, Channel
from robodyn.errors import InputError
from robodyn.robot.model import EffectEntry
from robodyn.simulate.differences import difference, low_pass

#: One number for all joints, or one for each.
PerJoint = float | tuple[float, ...]
Rate = Literal["true", "difference", "filtered", "none"]
Parameters = Mapping[str, float]

_RATES = ("true", "difference", "filtered", "none")
_POSITION, _TORQUE = 0, 1
#: A torque so near to the sensor's limit is at it, as a share of the limit: logs are rounded.
_AT_LIMIT = 1e-3


#: A dataclass of what sensors see, as a log is: times t [K], and q, qd, qdd, tau [K, n], rates perhaps None.
_Log = TypeVar("_Log")


@dataclass(frozen=True, slots=True)
class Sensors:
    """The sensors of an arm; by default they show the truth.

    ``position_resolution`` and ``position_noise`` (standard deviation) [rad or m]; ``torque_resolution`` and
    ``torque_noise`` [N m or N]; 0 for none; for all joints, or a number each.

    ``velocity``: ``true``; the ``difference`` to the sample before, of the measured position; that,
    ``filtered`` by a Butterworth low-pass of ``order`` 1 or 2 with its -3 dB at ``cutoff`` [Hz], which looks
    only back; or ``none``. ``acceleration`` is the same of the measured velocity (of the difference, where
    the velocity is not recorded). The first difference stands for the sample before it too.

    Raises
    ------
    InputError: a size is negative or not finite, or the filter lacks its cutoff.
    """

    position_resolution: PerJoint = 0.0
    position_noise: PerJoint = 0.0
    velocity: Rate = "true"
    acceleration: Rate = "true"
    cutoff: float | None = None
    order: int = 2
    torque_resolution: PerJoint = 0.0
    torque_noise: PerJoint = 0.0

    def __post_init__(self) -> None:
        for name in ("position_resolution", "position_noise", "torque_resolution", "torque_noise"):
            for value in np.atleast_1d(getattr(self, name)):
                if not (math.isfinite(value) and value >= 0):
                    raise InputError(f"{name} is not a size", found=str(value), expected="0 or more")
        for name in ("velocity", "acceleration"):
            if getattr(self, name) not in _RATES:
                raise InputError(
                    f"unknown kind of {name}", found=repr(getattr(self, name)), expected=", ".join(_RATES)
                )
        if self.order not in (1, 2):
            raise InputError("the low-pass has no such order", found=str(self.order), expected="1 or 2")
        if "filtered" in (self.velocity, self.acceleration) and self.cutoff is None:
            raise InputError("the low-pass has no cutoff", expected="cutoff [Hz]")

    def describe(self) -> dict[str, Any]:
        """Its options, for the provenance of a log."""
        return asdict(self)


def resolution_of(bits: int) -> float:
    """The step [rad] of an encoder of that many bits a turn.

    Raises
    ------
    InputError: not 1 to 64 bits.
    """
    if not 1 <= bits <= 64:
        raise InputError(
            "the resolution of an encoder is out of range", found=str(bits), expected="1 to 64 bits a turn"
        )
    return math.tau / float(2**bits)


def measure(
    true: _Log,
    sensors: Sensors,
    effects: Sequence[EffectEntry] = (),
    *,
    seed: int = 0,
    parameters: Parameters | None = None,
) -> _Log:
    """The log that the sensors make of the ``true`` signals; times and provenance stay.

    Where the drive clips the torque, the true torque is the command, for that is what the log has. Each joint
    has random numbers of its own for position and for torque: they depend on ``seed`` and joint alone.

    Raises
    ------
    InputError: the options do not fit the log, or ``true`` lacks a rate that is to be shown as it is.
    """
    log: Any = true
    n = log.q.shape[1]
    position = measured_position(log.q, effects, parameters)
    position = position + _noise(sensors.position_noise, "position_noise", log.q, seed, _POSITION)
    position = _quantised(position, _sizes(sensors.position_resolution, "position_resolution", n))
    rate = _rate("velocity", sensors.velocity, log.t, position, log.qd, sensors)
    base = rate
    if rate is None and sensors.acceleration not in ("true", "none"):
        base = difference(log.t, position)  # the acceleration still comes of the position
    second = _rate("acceleration", sensors.acceleration, log.t, base, log.qdd, sensors)
    torque = _amplified(log.tau, log.t, effects, parameters)
    torque = torque + _noise(sensors.torque_noise, "torque_noise", log.q, seed, _TORQUE)
    torque = _clipped(torque, effects, parameters)
    torque = _quantised(torque, _sizes(sensors.torque_resolution, "torque_resolution", n))
    return cast(_Log, replace(log, q=position, qd=rate, qdd=second, tau=torque))


def measured_torque(
    tau: Floats,
    t: Floats,
    effects: Sequence[EffectEntry],
    parameters: Parameters | None = None,
    *,
    noise: Floats | None = None,
) -> Floats:
    """What the torque channel shows of ``tau`` [K, n] (N m or N) at the times ``t`` [K] (s); with ``noise``
    [n], the standard deviations of the channel's own before it is clipped, what it shows on average.

    Several entries at a joint, and those of the whole robot, add up: delays and biases are summed, gains
    multiply, the least limit holds. A delayed torque lies on the line between its samples, and before the
    first has the first's value. Other effects, and a saturation of the drive, are passed over.

    Raises
    ------
    InputError: an entry names a joint that is not there; or there is a delay and ``t`` does not increase.
    """
    torque = _amplified(np.asarray(tau, float), t, effects, parameters)
    return _clipped(torque, effects, parameters, noise)


def measured_slopes(slopes: Floats, t: Floats, effects: Sequence[EffectEntry], measured: Floats) -> Floats:
    """What the torque channel shows of small changes ``slopes`` [K, n, c] of the torque, at times ``t`` [K]
    (s): late and scaled as the torque is, and nothing of them while what was ``measured`` [K, n] is at the
    sensor's limit.

    Raises
    ------
    InputError: as :func:`measured_torque`.
    """
    shown = np.zeros_like(slopes)
    for column in range(slopes.shape[2]):
        shown[:, :, column] = _scaled(slopes[:, :, column], t, effects, None)
    sizes, limits = np.abs(measured), _limits(effects, measured.shape[1], None)
    reached = np.where(np.isfinite(limits), np.minimum(limits, sizes.max(axis=0, initial=0.0)), np.inf)
    within = sizes < (1 - _AT_LIMIT) * reached  # a limit that is put too high is that of what is measured
    return np.asarray(shown * within[:, :, None])


def measured_position(
    q: Floats, effects: Sequence[EffectEntry], parameters: Parameters | None = None
) -> Floats:
    """What the encoders show of the positions ``q`` [K, n] (rad or m): the true ones and their offsets.

    Raises
    ------
    InputError: an entry names a joint that is not there.
    """
    position = np.array(q, dtype=np.float64)
    for entry, name, joints in _entries("position", effects, position.shape[1]):
        position[:, joints] += entry.number(name, parameters)
    return position


# --- the torque channel -----------------------------------------------------------------------------------


def _amplified(
    tau: Floats, t: Floats, effects: Sequence[EffectEntry], parameters: Parameters | None
) -> Floats:
    """Delay, gain and bias."""
    torque = _scaled(tau, t, effects, parameters)
    for entry, name, joints in _entries("bias", effects, tau.shape[1]):
        torque[:, joints] += entry.number(name, parameters)
    return torque


def _scaled(tau: Floats, t: Floats, effects: Sequence[EffectEntry], parameters: Parameters | None) -> Floats:
    """Delay and gain."""
    n = tau.shape[1]
    delays = np.zeros(n)
    for entry, name, joints in _entries("delay", effects, n):
        delays[joints] += entry.number(name, parameters)
    torque = np.array(tau, dtype=np.float64)
    if delays.any() and not (np.diff(t) > 0).all():
        raise InputError(
            "a torque cannot be delayed where the times do not increase", expected="t increasing"
        )
    for j in np.flatnonzero(delays):
        torque[:, j] = np.interp(t - delays[j], t, tau[:, j])
    for entry, name, joints in _entries("gain", effects, n):
        torque[:, joints] *= 1 + entry.number(name, parameters)
    return torque


def _clipped(
    tau: Floats, effects: Sequence[EffectEntry], parameters: Parameters | None, noise: Floats | None = None
) -> Floats:
    """Saturation of the sensors, and its mean where there is ``noise`` [n] beforehand: near a limit that
    takes off what goes beyond and leaves what does not, so that the mean stays below both."""
    limits = _limits(effects, tau.shape[1], parameters)
    clipped = np.clip(tau, -limits, limits)
    if noise is not None:
        for j in np.flatnonzero(np.isfinite(limits) & (noise > 0)):
            below, above = (limits[j] + way * tau[:, j] for way in (1, -1))
            clipped[:, j] = tau[:, j] + _excess(-below, noise[j]) - _excess(-above, noise[j])
    return clipped


def _limits(effects: Sequence[EffectEntry], n: int, parameters: Parameters | None) -> Floats:
    """The limits [n] of the sensors; infinite where there is none."""
    limits = np.full(n, np.inf)
    for entry, name, joints in _entries("limit", effects, n, who="sensor"):
        limits[joints] = np.minimum(limits[joints], entry.number(name, parameters))
    return limits


def _excess(x: Floats, noise: float) -> Floats:
    """By how much ``x`` [K] with normal noise is beyond 0, on average (0 where it is not)."""
    from scipy.special import ndtr

    at = x / noise
    return np.asarray(x * ndtr(at) + noise * np.exp(-(at**2) / 2) / math.sqrt(math.tau))


def acting_on(effects: Iterable[EffectEntry], acts: Acts) -> Iterator[tuple[EffectEntry, Channel]]:
    """The entries that do so to a channel, and how."""
    for entry in effects:
        channel = entry.definition.traits.channel
        if channel is not None and channel.acts == acts:
            yield entry, channel


def _entries(
    acts: Acts, effects: Sequence[EffectEntry], n: int, who: str = ""
) -> Iterator[tuple[EffectEntry, str, slice]]:
    """The entries that do so to a channel (if by somebody, by ``who``), each with the parameter that says how
    much and the joints it is at."""
    for entry, channel in acting_on(effects, acts):
        if channel.who and entry.text(channel.who) != who:
            continue
        if entry.joint is not None and not 1 <= entry.joint <= n:
            raise InputError(
                f"{entry.effect}: there is no such joint",
                found=str(entry.joint),
                expected=f"a joint of 1 to {n}",
            )
        joints = slice(None) if entry.joint is None else slice(entry.joint - 1, entry.joint)
        yield entry, channel.parameter, joints


# --- rates ------------------------------------------------------------------------------------------------


def _rate(
    name: str, kind: Rate, t: Floats, below: Floats | None, true: Floats | None, sensors: Sensors
) -> Floats | None:
    """The rate called ``name`` as the log has it; ``below`` is what it is the rate of."""
    if kind == "none":
        return None
    if kind == "true":
        if true is None:
            raise InputError(
                f"there is no true {name} to show",
                remedy=f"choose difference, filtered or none for the {name}",
            )
        return true
    assert below is not None
    slope = difference(t, below)
    return slope if kind == "difference" else low_pass(t, slope, sensors.cutoff or 0.0, sensors.order)


# --- noise and steps --------------------------------------------------------------------------------------


def _sizes(value: PerJoint, name: str, n: int) -> Floats:
    sizes = np.atleast_1d(np.asarray(value, dtype=np.float64))
    if np.ndim(value) and sizes.shape != (n,):
        raise InputError(
            f"{name} does not fit the joints", found=str(len(sizes)), expected=f"1 or {n} numbers"
        )
    return np.broadcast_to(sizes, (n,))


def _noise(value: PerJoint, name: str, q: Floats, seed: int, channel: int) -> Floats:
    """Gaussian noise [K, n]; the numbers of a joint are those of no other, whatever noise these have."""
    if seed < 0:
        raise InputError("a seed is a number of 0 or more", found=str(seed))
    noise = np.zeros_like(q)
    for j, size in enumerate(_sizes(value, name, q.shape[1])):
        if size:
            stream = np.random.SeedSequence(seed, spawn_key=(channel, j))
            noise[:, j] = size * np.random.default_rng(stream).standard_normal(len(q))
    return noise


def _quantised(x: Floats, steps: Floats) -> Floats:
    """The nearest whole multiples of the ``steps`` [n]; 0 leaves a column as it is."""
    result = np.array(x)
    for j in np.flatnonzero(steps):
        result[:, j] = steps[j] * np.rint(x[:, j] / steps[j])
    return result
