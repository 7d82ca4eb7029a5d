"""What may be missing: for each entry of the catalogue the columns that it would add to the torques.

Friction of the drive is evaluated by the definitions themselves at unit parameters, where they are linear;
what is not linear in a parameter has a grid of values. Columns are torques [K, n], at the full rate,
unfiltered."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.rigid import Evaluated, Model
from robodyn.diagnose.signals import Signals
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Site

Floats = NDArray[np.float64]


def _anything(x: Floats) -> bool:
    return True


@dataclass(frozen=True, slots=True, eq=False)
class Candidate:
    """An effect at a place, with what is not linear in it fixed.

    ``columns`` [K, rows, c]: torques by the linear parameters, at the joints ``rows`` (from 0); ``signs``
    [c]: +1 for what must not be negative, 0 for what may be anything; ``read`` makes the catalogue's
    parameters of the coefficients, ``feasible`` whether physics allows them. ``coarse``: the columns are of
    coarse signals. ``order`` says which of two that explain alike is the simpler. ``given``: the values of
    what is not linear, by name (:func:`again` makes the same with others)."""

    effect: str
    joint: int | None
    rows: tuple[int, ...]
    columns: Floats
    signs: tuple[int, ...]
    read: Callable[[Floats], dict[str, float | str]]
    order: int
    coarse: bool = False
    #: It shows in few parts of a log only.
    local: bool = False
    feasible: Callable[[Floats], bool] = _anything
    given: Mapping[str, float] = field(default_factory=dict)

    @property
    def name(self) -> str:
        """For people."""
        return f"{self.effect} at joint {self.joint}" if self.joint else self.effect


@dataclass(frozen=True, slots=True, eq=False)
class Hints:
    """What all parts of a recording share: top speeds [n], and numbers of waves by joint."""

    top: Floats
    cycles: tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True, eq=False)
class Context:
    """A model along a log, and along its coarse signals."""

    model: Model
    signals: Signals
    at: Evaluated
    way: Floats
    slow: Signals
    at_slow: Evaluated
    hints: Hints

    @property
    def n(self) -> int:
        """Number of joints."""
        return self.signals.n


def context_of(model: Model, signals: Signals, hints: Hints | None = None) -> Context:
    """The model evaluated along the signals; the whole of it where effects remember."""
    from dataclasses import replace

    from robodyn.diagnose.predict import model_torque

    slow = signals.coarse()
    at = model.evaluate(signals.q, signals.qd, signals.qdd)
    at_slow = model.evaluate(slow.q, slow.qd, slow.qdd)
    if model.robot.effects:
        total = model_torque(model.robot, signals.t, signals.q, signals.qd, signals.qdd)
        at = replace(at, total=total)
        at_slow = replace(
            at_slow, total=signals.filtered(total)[:: max(1, signals.every // 2)][: len(slow.t)]
        )
    top = np.abs(signals.qd).max(axis=0)
    none = Hints(top, ((),) * signals.n)
    context = Context(model, signals, at, np.sign(signals.qd), slow, at_slow, hints or none)
    if hints is None:
        cycles = tuple(tuple(_cycles(context, j)) for j in range(signals.n))
        context = replace(context, hints=Hints(top, cycles))
    return context


#: Grids of what is not linear.
_STRIBECK = (0.01, 0.02, 0.04, 0.08, 0.15, 0.3)
_EFFICIENCY = (0.3, 0.45, 0.6, 0.7, 0.8, 0.88, 0.94)
_BENDS = (1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2)  # rad or m: level over stiffness
_TRANSITIONS = (0.05, 0.5)
#: Limits of a drive as shares of the largest torque, and the share of samples that pile up at a sensor's.
_LIMITS = (0.5, 0.65, 0.8, 0.9, 0.96)
_PILED = 0.003
#: Cutoff [Hz] of what is differentiated twice.
_TWIST = 6.0


def candidates(c: Context) -> Iterator[Candidate]:
    """Everything that the catalogue has and a log can show."""
    for j in range(c.n):
        yield from _friction(c, j)
        yield from _loads(c, j)
        yield from _conservative(c, j)
        yield from _elastic(c, j)
        yield from _sensor(c, j)
        yield from _saturation(c, j)
    for j in range(c.n):
        for k in range(c.n):
            if k != j:
                yield from _coupling(c, j, k)
    yield from _whole(c)


def _site(c: Context, j: int) -> Site:
    s = c.signals
    m, f = c.at.m[:, j], c.at.f[:, j]
    revolute = c.model.robot.links[j].joint.kind == "revolute"
    return Site(
        revolute, s.q[:, j], s.qd[:, j], s.qdd[:, j], c.way[:, j], c.at.rigid[:, j],
        (f[:, 0], f[:, 1], f[:, 2]), (m[:, 0], m[:, 1], m[:, 2]),
    )  # fmt: skip


def _column(effect: str, values: Mapping[str, Any], at: Site) -> Floats:
    equation = CATALOGUE[effect].equation
    assert equation is not None
    return np.asarray(equation(values, at) + np.zeros_like(at.qd))


def _one(
    effect: str, j: int, columns: list[Floats], signs: tuple[int, ...],
    read: Callable[[Floats], dict[str, float | str]], order: int, **more: Any,
) -> Candidate:  # fmt: skip
    return Candidate(effect, j + 1, (j,), np.stack(columns, axis=1)[:, None, :], signs, read, order, **more)


def _friction(c: Context, j: int) -> Iterator[Candidate]:
    at = _site(c, j)
    viscous = _column("viscous_friction", {"coefficient": 1.0}, at)
    coulomb = _column("coulomb_friction", {"level": 1.0}, at)
    yield _one("viscous_friction", j, [viscous], (1,), lambda x: {"coefficient": float(x[0])}, 1)
    yield _one("coulomb_friction", j, [coulomb], (1,), lambda x: {"level": float(x[0])}, 1)
    moving = np.abs(at.direction)
    yield _one(
        "asymmetric_friction", j, [coulomb, moving], (1, 0),
        lambda x: {"positive": float(x[0] + x[1]), "negative": float(x[0] - x[1])}, 3,
        feasible=lambda x: bool(abs(x[1]) <= x[0]),
    )  # fmt: skip
    top = max(float(c.hints.top[j]), 1e-9)
    for velocity in _STRIBECK:
        if velocity < 0.6 * top:
            yield _stribeck(c, j, {"velocity": velocity})
    for bend in _BENDS:
        yield _bristles(c, j, {"bend": bend})


def _stribeck(c: Context, j: int, given: Mapping[str, float]) -> Candidate:
    at, velocity = _site(c, j), given["velocity"]
    fixed = {"velocity": velocity, "exponent": 2}
    rise = _column("stribeck_friction", {"level": 0.0, "static": 1.0, **fixed}, at)
    level = _column("stribeck_friction", {"level": 1.0, "static": 1.0, **fixed}, at)

    def read(x: Floats) -> dict[str, float | str]:
        return {"level": float(x[0]), "static": float(x[0] + x[1]), "velocity": velocity}

    return _one(
        "stribeck_friction",
        j,
        [level, rise],
        (1, 1),
        read,
        4,
        given=given,
    )


def _bristles(c: Context, j: int, given: Mapping[str, float]) -> Candidate:
    """Dahl's bristles: the way since reversals, over the bend at which they slide."""
    bend = given["bend"]
    bent = _bent(c.signals.q[:, j], bend)

    def read(x: Floats) -> dict[str, float | str]:
        return {"level": float(x[0]), "stiffness": float(x[0] / bend), "damping": 0.0}

    return _one("presliding_hysteresis", j, [bent], (1,), read, 4, given=given)


def _bent(q: Floats, bend: float) -> Floats:
    """Bristles over the bend of sliding [K], along positions ``q``: exact between samples."""
    way = np.diff(q, prepend=q[0]) / bend
    left = np.exp(-np.abs(way)).tolist()
    gone = (np.sign(way) * -np.expm1(-np.abs(way))).tolist()
    found = []
    z = 0.0
    for kept, new in zip(left, gone, strict=True):
        z = z * kept + new
        found.append(z)
    return np.array(found)


def _loads(c: Context, j: int) -> Iterator[Candidate]:
    at = _site(c, j)
    kinds = [("torque", "mu", {"mu": 1.0})]
    if at.revolute:
        kinds += [("radial", "mu_r", {"mu_r": 1.0}), ("thrust", "mu_r", {"mu_r": 1.0})]
    else:
        kinds += [("linear", "mu", {"mu": 1.0, "span": 1.0})]
    for kind, key, values in kinds:
        column = _column("load_dependent_friction", {"bearing": kind, **values}, at)

        def read(x: Floats, kind: str = kind, key: str = key) -> dict[str, float | str]:
            more: dict[str, float | str] = {"span": 1.0} if kind == "linear" else {}
            return {"bearing": kind, key: float(x[0]), **more}

        yield _one("load_dependent_friction", j, [column], (1,), read, 2)
    for efficiency in _EFFICIENCY:
        yield _loss(c, j, {"efficiency": efficiency})


def _loss(c: Context, j: int, given: Mapping[str, float]) -> Candidate:
    """The loss at a fixed efficiency, with a factor of its own (1 where the efficiency is right), and
    breakaway."""
    at, efficiency = _site(c, j), given["efficiency"]
    at = Site(at.revolute, at.q, at.qd, at.qdd, at.direction, c.at.passed[:, j])
    loss = _column("transmission_loss", {"breakaway": 0.0, "efficiency": efficiency}, at)
    level = _column("transmission_loss", {"breakaway": 1.0, "efficiency": 1}, at)

    def read(x: Floats) -> dict[str, float | str]:
        inverse = 1 + float(x[0]) * (1 / efficiency - 1)
        return {"efficiency": min(1.0, 1 / inverse), "breakaway": float(max(x[1], 0.0))}

    return _one("transmission_loss", j, [loss, level], (1, 1), read, 4, given=given)


def _conservative(c: Context, j: int) -> Iterator[Candidate]:
    at = _site(c, j)
    one = np.ones_like(at.q)
    yield _one("rotor_inertia", j, [at.qdd], (1,), lambda x: {"inertia": float(x[0])}, 1)
    middle = float(np.mean(at.q))

    def read(x: Floats) -> dict[str, float | str]:
        rest = middle - float(x[1] / x[0]) if x[0] else 0.0
        return {"stiffness": float(x[0]), "rest": rest, "cubic": 0.0}

    yield _one("spring", j, [at.q - middle, one], (0, 0), read, 3)
    for cycles in c.hints.cycles[j]:
        yield _ripple(c, j, {"cycles": cycles})


def _ripple(c: Context, j: int, given: Mapping[str, float]) -> Candidate:
    cycles, q = given["cycles"], c.signals.q[:, j]

    def read(x: Floats) -> dict[str, float | str]:
        return {
            "amplitude": float(np.hypot(x[0], x[1])),
            "cycles_per_rev": cycles,
            "phase": float(np.arctan2(x[1], x[0])),
        }

    return _one(
        "torque_ripple", j, [np.sin(cycles * q), np.cos(cycles * q)], (0, 0), read, 4,
        given=given,
    )  # fmt: skip


def _cycles(c: Context, j: int, count: int = 4) -> list[float]:
    """The numbers of waves a radian that stand out of what the model leaves, over the joint's position."""
    q, s = c.signals.q[:, j], c.signals
    rest = s.tau[:, j] - c.at.total[:, j]
    span = float(np.ptp(q))
    if span < 0.2:
        return []
    # Against slow changes over position and over velocity, which are other effects.
    basis = np.stack([np.ones_like(q), q, q**2, q**3, s.qd[:, j], np.sign(s.qd[:, j]), s.qdd[:, j]], axis=1)
    rest = rest - basis @ np.linalg.lstsq(basis, rest, rcond=None)[0]
    lowest = 2.5 * 2 * np.pi / span
    highest = min(400.0, 0.2 * np.pi / s.period / max(float(np.abs(s.qd[:, j]).max()), 1e-9))
    if highest <= lowest:
        return []
    # Sums over small steps of position, and their spectrum.
    step = np.pi / 4 / highest
    bins = ((q - q.min()) / step).astype(int)
    sums = np.bincount(bins, rest)
    size = 1 << int(np.ceil(np.log2(8 * len(sums))))
    power = np.abs(np.fft.rfft(sums, size)) ** 2
    tried = 2 * np.pi * np.arange(len(power)) / (size * step)
    power[(tried < lowest) | (tried > highest)] = 0.0
    found: list[float] = []
    for k in np.argsort(power)[::-1]:
        if all(abs(tried[k] - other) > 4 / span for other in found):
            found.append(float(tried[k]))
        if len(found) == count:
            break
    return found


def _elastic(c: Context, j: int) -> Iterator[Candidate]:
    """A twist in proportion to the torque that is passed on. Measured at the motor, the link is behind it,
    and what is passed on is what the motor gives less what it needs itself; measured at the link, the
    motor's inertia is ahead of it."""
    s = c.slow
    own = c.at_slow.total[:, j] - c.at_slow.passed[:, j]
    rotor = float(c.model.robot.links[j].joint.motor_inertia)  # type: ignore[arg-type]  # constants
    for encoder, passed in (("motor", s.tau[:, j] - own), ("link", c.at_slow.passed[:, j])):
        twists = [("joint_elasticity", 0.0, passed)]
        twists += [("backlash", w, 0.5 * passed / (np.abs(passed) + w)) for w in _TRANSITIONS]
        for effect, w, twist in twists:
            slow = s.filtered(twist, min(_TWIST, s.cutoff))
            rate = np.gradient(slow, s.period)
            acceleration = np.gradient(rate, s.period)
            if encoder == "motor":
                column, rows = -_directional(c, j, slow, rate, acceleration), tuple(range(c.n))
            else:
                column, rows = (rotor * acceleration)[:, None], (j,)

            def read(
                x: Floats, effect: str = effect, encoder: str = encoder, w: float = w
            ) -> dict[str, float | str]:
                if effect == "backlash":
                    return {"gap": float(x[0]), "encoder": encoder, "transition": w}
                stiffness = float(1 / x[0]) if x[0] > 0 else 1e12
                return {"stiffness": stiffness, "damping": 0.0, "encoder": encoder}

            if encoder == "motor" or rotor:
                yield Candidate(effect, j + 1, rows, column[:, :, None], (1,), read, 5, coarse=True)


def _directional(c: Context, j: int, q: Floats, qd: Floats, qdd: Floats) -> Floats:
    """Derivative [K, n] of the rigid torques as joint j moves by the twist; of coarse signals."""
    s = c.slow
    size = max(float(np.abs(q).max()), 1e-12)
    step = 1e-4 / size
    moved = [x.copy() for x in (s.q, s.qd, s.qdd)]
    for array, way in zip(moved, (q, qd, qdd), strict=True):
        array[:, j] += step * way
    found: Floats = (c.model.evaluate(*moved).rigid - c.at_slow.rigid) / step
    return found


def _sensor(c: Context, j: int) -> Iterator[Candidate]:
    one = np.ones_like(c.signals.t)
    total = c.at.total[:, j]
    yield _one("torque_bias", j, [one], (0,), lambda x: {"bias": float(x[0])}, 1)
    yield _one("torque_gain", j, [total], (0,), lambda x: {"gain": float(x[0])}, 2)
    late = -np.gradient(c.signals.filtered(total), c.signals.period)
    yield _one("time_delay", j, [late], (1,), lambda x: {"delay": float(x[0])}, 3)
    ones, zero = np.ones_like(c.slow.t), np.zeros_like(c.slow.t)
    column = -_directional(c, j, ones, zero, zero)
    yield Candidate(
        "encoder_offset", j + 1, tuple(range(c.n)), column[:, :, None], (0,),
        lambda x: {"offset": float(x[0])}, 3, coarse=True, feasible=lambda x: bool(abs(x[0]) < 0.25),
    )  # fmt: skip


def _saturation(c: Context, j: int) -> Iterator[Candidate]:
    """Beyond a limit the drive gives no more than that, and the log has the command; or the log stops
    there."""
    tau = c.signals.tau[:, j]
    for share in _LIMITS:
        yield _clipped(c, j, {"limit": share * float(np.abs(tau).max())})
    top, total = float(np.abs(tau).max()), c.at.total[:, j]
    if np.mean(np.abs(tau) > (1 - 1e-9) * top) > _PILED:
        beyond = -np.sign(total) * np.maximum(np.abs(total) - top, 0.0)
        yield _one(
            "torque_saturation", j, [beyond], (1,), lambda x: {"limit": top, "clips": "sensor"}, 2,
            local=True, feasible=_about_one,
        )  # fmt: skip


def _clipped(c: Context, j: int, given: Mapping[str, float]) -> Candidate:
    tau, limit = c.signals.tau[:, j], given["limit"]
    beyond = np.sign(tau) * np.maximum(np.abs(tau) - limit, 0.0)
    return _one(
        "torque_saturation", j, [beyond], (1,), lambda x: {"limit": limit, "clips": "drive"}, 2,
        local=True, given=given, feasible=_about_one,
    )  # fmt: skip


def _about_one(x: Floats) -> bool:
    return bool(0.7 < x[0] < 1.3)


def _coupling(c: Context, j: int, k: int) -> Iterator[Candidate]:
    """A motor that turns with j and k: on both joints."""
    s = c.signals
    for ratio in (1.0, -1.0):
        if j < k:  # named at the outer joint, whose motor it is
            continue
        u, rate = s.qd[:, j] + ratio * s.qd[:, k], s.qdd[:, j] + ratio * s.qdd[:, k]
        parts = [rate, u, np.sign(u)]
        columns = np.stack([np.stack([x, ratio * x], axis=1) for x in parts], axis=2)

        def read(x: Floats, k: int = k, ratio: float = ratio) -> dict[str, float | str]:
            names = dict(zip(("inertia", "viscous", "coulomb"), (float(v) for v in x), strict=True))
            return {"with": float(k + 1), "ratio": ratio, **names}

        yield Candidate("motor_coupling", j + 1, (j, k), columns, (1, 1, 1), read, 5)


def _whole(c: Context) -> Iterator[Candidate]:
    s, rows = c.slow, tuple(range(c.n))
    Y = c.model.regressor(s.q, s.qd, s.qdd)

    def body(x: Floats) -> dict[str, float | str]:
        m = float(x[0])
        r = x[1:4] / m if m else np.zeros(3)
        shift = m * (r @ r * np.eye(3) - np.outer(r, r))
        upper = [shift[a, b] for a, b in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
        names = ("xx", "yy", "zz", "xy", "xz", "yz")
        inertia = {f"inertia_{name}": float(v - u) for name, v, u in zip(names, x[4:], upper, strict=True)}
        return {"mass": m, "com_x": float(r[0]), "com_y": float(r[1]), "com_z": float(r[2]), **inertia}

    yield Candidate(
        "payload", None, rows, Y[:, :, -1], (1, *(0,) * 9), body, 6, coarse=True,
        feasible=lambda x: bool(x[0] > 0 and np.linalg.norm(x[1:4]) < 0.7 * x[0]),
    )  # fmt: skip
    gx, gy, gz = (float(g) for g in c.model.robot.gravity)
    # d g / d tilt_x and d g / d tilt_y
    tilts = [_gravity_by(c, turned) for turned in ((0.0, -gz, gy), (gz, 0.0, -gx))]
    yield Candidate(
        "base_tilt", None, rows, np.stack(tilts, axis=2), (0, 0),
        lambda x: {"tilt_x": float(x[0]), "tilt_y": float(x[1])}, 3, coarse=True,
        feasible=lambda x: bool(np.abs(x).max() < 0.3),
    )  # fmt: skip
    late = -np.gradient(s.filtered(c.at_slow.total), s.period, axis=0)
    yield Candidate(
        "time_delay", None, rows, late[:, :, None], (1,), lambda x: {"delay": float(x[0])}, 2, coarse=True
    )
    for k in range(c.n - 1, -1, -1):
        yield Candidate("inertial_error", k + 1, rows, Y[:, :, k], (0,) * 10, _standard, 8, coarse=True)


def _standard(x: Floats) -> dict[str, float | str]:
    names = ("m", "mx", "my", "mz", "xx", "yy", "zz", "xy", "xz", "yz")
    return dict(zip(names, (float(v) for v in x), strict=True))


def _gravity_by(c: Context, change: tuple[float, float, float]) -> Floats:
    """Torques [K, n] by a change of gravity (they are linear in it); of coarse signals."""
    from dataclasses import replace
    from fractions import Fraction

    s, zeros = c.slow, np.zeros_like(c.slow.q)
    x, y, z = (Fraction(g) for g in change)
    return Model(replace(c.model.robot, gravity=(x, y, z))).evaluate(s.q, zeros, zeros).rigid


def again(c: Context, candidate: Candidate, given: Mapping[str, float]) -> Candidate:
    """``candidate`` in the context ``c`` with other values of what is not linear."""
    make = {
        "stribeck_friction": _stribeck,
        "presliding_hysteresis": _bristles,
        "transmission_loss": _loss,
        "torque_ripple": _ripple,
        "torque_saturation": _clipped,
    }[candidate.effect]
    assert candidate.joint is not None
    return make(c, candidate.joint - 1, given)
