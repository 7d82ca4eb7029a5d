"""Logs of arms that somebody pushes, at rest, in motion, and after a motion, by MuJoCo."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from benchmarks.blind_arms.arms import bare, index_of, perturbed, rubbing
from benchmarks.blind_arms.laws import law_of
from benchmarks.blind_arms.logs import _measured, _noisy, effect, outsider
from benchmarks.blind_arms.motion import inverse

from peers.numbers import Array, number
from robodyn.logs.log import Log
from robodyn.robot.model import EffectEntry, Robot
from robodyn.simulate.trajectories.trajectory import Law

Kind = Literal["rest", "full", "stops"]
#: Pushes are as large beside the dry friction of the joints.
_FRICTIONS = 3.0
#: Pushes that vary: how many times the dry friction and thrice the noise they make at the joint where they
#: show best; shortest and longest [s]; where along the way to the next joint a link is touched, and how far
#: beside it [m]; the longest rise as a share of the push.
_SIZES, _WIDTHS, _ALONG, _BESIDE, _RISE = (3.0, 12.0), (0.2, 2.0), (0.2, 1.0), 0.05, 0.4


@dataclass(frozen=True, slots=True, eq=False)
class Push:
    """What was done: from ``start`` to ``end`` [s] a ``force`` [3] (N) on ``link``; ``seen`` [n]: the torques
    that it makes at the middle of its window; ``columns`` [n, 3]: by unit forces there; it rises and fades
    in ``rise`` [s]."""

    start: float
    end: float
    link: int
    force: Array
    seen: Array
    columns: Array
    rise: float = 0.0


@dataclass(frozen=True, slots=True, eq=False)
class Pushed:
    """A log of an arm that is pushed, and the model that is given for it."""

    given: Robot
    log: Log
    pushes: tuple[Push, ...]
    noise: Array


def pushed_log(
    arm: str,
    kind: Kind,
    seed: int,
    *,
    pushes: int = 3,
    duration: float = 10.0,
    inertia_error: float = 0.3,
    friction: bool = True,
    rate: float = 500.0,
    varied: bool = False,
    sticks: bool = False,
) -> Pushed:
    """A log of ``arm`` with as many ``pushes``; masses, centres and inertias of the given model are off
    by the share ``inertia_error``, and it knows no friction.

    ``varied``: pushes are short and long, rise and fade, and act anywhere near a link's frame; else they
    begin and end at once, at its origin. ``sticks``: dry friction holds a joint where it stands; else it
    creeps."""
    rng, other = np.random.default_rng((seed, 5)), np.random.default_rng((seed, 6))
    if varied:
        rng = np.random.default_rng((seed, 5, index_of(arm), *kind.encode()))
        other = np.random.default_rng((seed, 6, index_of(arm), *kind.encode()))
    known = rubbing(bare(arm)) if friction else bare(arm)
    law = _still(known, seed, duration) if kind == "rest" else law_of(known, 2 * seed, duration, "full")
    if kind == "stops":
        law = _stopping(law_of(known, 2 * seed, 0.5 * duration, "full"), 0.5 * duration)
    step, every = 5e-4, max(1, round(1 / (rate * 5e-4)))
    probe = np.linspace(0, duration, 201)
    q, qd, qdd = law(probe)
    size = np.sqrt(np.mean(inverse(bare(arm), q, qd, qdd) ** 2, axis=0))
    rubs = np.array([number(link.joint.coulomb) for link in known.links])
    # What is less than stiction does not reach the motors.
    usual = np.maximum(size, 0.05 * size.max()) + _FRICTIONS * rubs
    noise = 0.01 * np.maximum(size, 0.05 * size.max())
    made: list[Push] = []
    entries: list[EffectEntry] = []
    first = 0.55 * duration if kind == "stops" else 0.1 * duration
    room = (0.95 * duration - first) / max(pushes, 1)
    for k in range(pushes):
        width = float(rng.uniform(0.3, 0.9))
        rise, point = 0.0, np.zeros(3)
        if varied:
            width = float(np.exp(other.uniform(*np.log(_WIDTHS))))
            width = min(width, 0.6 * room)
            rise = width * float(other.uniform(0, _RISE))
            along, beside = other.uniform(*_ALONG), other.uniform(-_BESIDE, _BESIDE, 3)
        start = round(first + room * k + float(rng.uniform(0, max(room - width - 0.4, 0.05))), 3)
        link = int(rng.integers(2, known.n + 1))
        way = rng.standard_normal(3)
        way /= np.linalg.norm(way)
        pose = law(np.array([0.0, start + width / 2]))[0][1]
        if varied:
            point = along * _end(known, pose, link) + beside
        columns = _columns(known, pose, link, point)
        share = np.abs(columns @ way) / usual
        times = float(rng.uniform(0.3, 1.0))
        if varied:
            share, times = (
                np.abs(columns @ way) / (rubs + 3 * noise),
                float(np.exp(other.uniform(*np.log(_SIZES)))),
            )
        force = way * times / max(float(share.max()), 1e-3)
        force *= min(1.0, 300.0 / float(np.linalg.norm(force)))
        end = round(start + width, 3)
        x, y, z = (float(f) for f in force)
        entry = effect(
            "external_contact", None, start=start, end=end, link=link, force_x=x, force_y=y, force_z=z
        )
        more = outsider("", None, rise=rise, **dict(zip(("x", "y", "z"), point.tolist(), strict=True)))
        entries.append(replace(entry, settings=(*entry.settings, *more.settings)))
        made.append(Push(start, end, link, force, columns @ force, columns, rise))
    true = replace(known, effects=tuple(entries))
    log, _ = _measured(true, known, law, duration, every, step, seed, sticks)
    given = bare(arm)
    given = perturbed(given, inertia_error, seed) if inertia_error else given
    return Pushed(
        given, _noisy(log, known, noise, 20, "none", np.random.default_rng((seed, 3))), tuple(made), noise
    )


def _still(robot: Robot, seed: int, duration: float) -> Law:
    """The arm at rest in the pose of a motion at some time."""
    moves = law_of(robot, 2 * seed, duration, "full")
    pose = moves(np.linspace(0.0, duration, 101))[0][int(np.random.default_rng(seed).integers(101))]

    def law(t: Array) -> tuple[Array, Array, Array]:
        q = np.tile(pose, (len(t), 1))
        return q, 0 * q, 0 * q

    return law


def _stopping(moves: Law, until: float) -> Law:
    def law(t: Array) -> tuple[Array, Array, Array]:
        q, qd, qdd = moves(np.minimum(t, until))
        late = (t > until)[:, None]
        return q, np.where(late, 0.0, qd), np.where(late, 0.0, qdd)

    return law


def _end(robot: Robot, q: Array, link: int) -> Array:
    """The origin of the next link's frame [3] in a link's; of the last link twice its centre."""
    data = _placed(robot, q)[1]
    if link == robot.n:
        return 2 * np.array([number(x) for x in robot.links[-1].com])
    turned = data.xmat[link].reshape(3, 3)
    return np.asarray(turned.T @ (data.xpos[link + 1] - data.xpos[link]))


def _placed(robot: Robot, q: Array) -> tuple[Any, Any]:
    """MuJoCo's model and data of ``robot`` in a pose [n]."""
    import mujoco
    from benchmarks.blind_arms.model import build_model

    model = build_model(robot, 1e-3)
    data = mujoco.MjData(model)
    data.qpos[:] = q
    mujoco.mj_forward(model, data)
    return model, data


def _columns(robot: Robot, q: Array, link: int, point: Array) -> Array:
    """Torques [n, 3] that unit forces on a ``point`` [3] of a link's frame make, by MuJoCo."""
    import mujoco

    model, data = _placed(robot, q)
    result = np.zeros((robot.n, 3))
    place = data.xpos[link] + data.xmat[link].reshape(3, 3) @ point
    for axis in range(3):
        total = np.zeros(model.nv)
        mujoco.mj_applyFT(model, data, np.eye(3)[axis], np.zeros(3), place, link, total)
        result[:, axis] = total
    return result
