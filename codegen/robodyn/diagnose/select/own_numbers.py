"""The rigid arm's own numbers as a nuisance: their columns, where findings have moved the arm.

What a number of a link does to the torques depends on how the arm stands. Of a base that is level, a vertical
first joint feels no centre of mass; of one that leans it does, and nobody has known the centre so far.
Friction under load shows the mass that presses on a bearing, which the torque of the rigid arm does not, and
a link on a spring its inertia apart from its rotor's. So the columns beside findings are those of the arm
with these findings. When exactly friction turns at reversals is a number of each joint that nobody knows
either (:mod:`robodyn.diagnose.select.remainder`).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.fit import Problem, directions
from robodyn.diagnose.select.library import Context
from robodyn.diagnose.select.limits import TURN_TIME
from robodyn.diagnose.select.remainder import turning
from robodyn.identify.motor_regressor import lagging_regressor, motor_regressor
from robodyn.identify.predict import offsets
from robodyn.identify.prior import number_of
from robodyn.kernels.array_dynamics import Model
from robodyn.robot.model import EffectEntry, Robot
from robodyn.simulate.sensors import acting_on, measured_slopes

Floats = NDArray[np.float64]


def own_numbers(start: Problem) -> tuple[Floats, Floats]:
    """Columns [N n, p] of the arm's own numbers, as it is described, and how they are held [p, p]: a
    root of their precision."""
    columns = start.A[:, :, : start.nuisance].reshape(start.rest.size, start.nuisance)
    return columns, np.diag(np.sqrt(start.prior[: start.nuisance]))


def own_numbers_of(
    arm: Robot,
    robot: Robot,
    contexts: Sequence[Context],
    start: Problem,
    *,
    by_drives: bool = False,
    sticking: Floats | None = None,
) -> tuple[Floats, Floats]:
    """The same of ``arm``, which is ``robot`` with findings, and of when its friction turns; ``contexts`` and
    ``start`` are of ``robot``, joints ``sticking`` as in :func:`remainder`. ``by_drives``: with what drives
    make of the loads on their joints. Names are sought without: so free, the arm's numbers would take what is
    to be named."""
    scale = (start.weight / start.sigma)[:, :, None]
    columns, prior = own_numbers(start)
    whole = None
    if by_drives and feels_loads(arm):
        whole = loaded(arm, robot, contexts, start)
    elif _shows_otherwise(arm, robot):
        whole = np.concatenate([_along(arm, c) for c in contexts]) * scale * start.sizes
    if whole is not None:
        ways = directions(whole)
        columns = (whole @ ways).reshape(start.rest.size, ways.shape[1])
        rotors = np.zeros((*whole.shape[:2], 0))
        if by_drives:
            rotors = np.concatenate([_seen(robot, c, _turned(arm, robot, c)) for c in contexts]) * scale
        prior = np.linalg.qr(_roots(start, rotors, len(ways)) @ ways).R
    turns = np.concatenate([turning(arm, c, sticking) for c in contexts]) * scale * TURN_TIME
    turns = turns[:, :, turns.any(axis=(0, 1))]
    p, more = len(prior), turns.shape[2]
    if not more:
        return columns, prior
    both = np.zeros((p + more, p + more))
    both[:p, :p], both[p:, p:] = prior, np.sqrt(start.thin) * np.eye(more)
    return np.concatenate([columns, turns.reshape(-1, more)], axis=1), both


def loaded(arm: Robot, robot: Robot, contexts: Sequence[Context], start: Problem) -> Floats:
    """Torques [N, n, count] by way of the drives of ``arm``, which is ``robot`` with findings, in the rows of
    ``start`` are: by each number of its links, by the rotors of joints whose links lag behind them, each in
    units of what it is known to, and by how these links begin."""
    behind = bool(Model(arm).couplers)
    parts = [
        _behind(arm, robot, c, start.sizes) if behind else _pressed(arm, c, start.sizes) for c in contexts
    ]
    return np.asarray(np.concatenate(parts) * (start.weight / start.sigma)[:, :, None])


def _roots(start: Problem, rotors: Floats, count: int) -> Floats:
    """How ``count`` numbers are held [rows, count]: first those of the arm's links, then the rotors of
    torques ``rotors`` [N, n, R] of a rigid joint, then others. The torques of the rigid arm as ``start`` has
    it are known as it says, whatever makes them up: of a link and its rotor it is their sum that is. All else
    is known as it is said to be."""
    links, p = start.basis.shape
    plain = np.sqrt(start.thin) * np.eye(count)
    plain[:links, :links] -= np.sqrt(start.thin) * start.basis @ start.basis.T
    shown = np.zeros((p, count))
    shown[:, :links] = start.basis.T
    if rotors.shape[2]:
        columns = start.A[:, :, :p].reshape(start.rest.size, p)
        torques = rotors.reshape(-1, rotors.shape[2])
        shown[:, links : links + rotors.shape[2]] = np.linalg.lstsq(columns, torques, rcond=None)[0]
    return np.concatenate([plain, np.sqrt(start.prior[:p])[:, None] * shown])


def _shows_otherwise(arm: Robot, robot: Robot) -> bool:
    """Whether its own numbers show otherwise in the torques of ``arm`` than in those of ``robot``: it stands
    otherwise, or its torque channels pass them on otherwise."""
    is_turned = arm.gravity != robot.gravity or not np.array_equal(offsets(arm), offsets(robot))
    return is_turned or _channels(arm) != _channels(robot)


def _channels(robot: Robot) -> list[EffectEntry]:
    """What of the effects of a robot the torque channel does to a change of the torque."""
    return [entry for acts in ("delay", "gain", "limit") for entry, _ in acting_on(robot.effects, acts)]


def feels_loads(arm: Robot) -> bool:
    """Whether a drive of the arm answers to the loads on its joint."""
    return any(entry.definition.needs_load for entry in arm.effects) or bool(Model(arm).couplers)


def _along(arm: Robot, c: Context) -> Floats:
    """Torques [N, n, 10 n] by the numbers of all links."""
    s = c.slow
    return _seen(arm, c, Model(arm).regressor(s.q - offsets(arm), s.qd, s.qdd).reshape(len(s.q), c.n, -1))


def _pressed(arm: Robot, c: Context, sizes: Floats) -> Floats:
    """The same by way of the drives, each number in units of what it is known to, ``sizes`` [10 n]."""
    s = c.slow
    slopes = motor_regressor(Model(arm), s.q - offsets(arm), s.qd, s.qdd, sizes.reshape(c.n, -1))
    return _seen(arm, c, slopes.reshape(len(s.q), c.n, -1) * sizes)


def _behind(arm: Robot, robot: Robot, c: Context, sizes: Floats) -> Floats:
    """The same where links lag behind their motors, and torques by the rotors of these joints and by how
    their links begin."""
    s, full, model = c.slow, c.signals, Model(arm)
    motion = full.q - offsets(arm), full.qd, full.qdd
    slopes, begins = lagging_regressor(model, motion, full.period, round(s.period / full.period), full.tau)
    slopes = slopes.reshape(len(s.q), c.n, -1) * sizes
    return _seen(arm, c, np.concatenate([slopes, _turned(arm, robot, c), begins], axis=2))


def _turned(arm: Robot, robot: Robot, c: Context) -> Floats:
    """Torques [K, n, R] by the rotors of joints whose links lag behind them, each in units of what it is
    known to as ``robot`` has it."""
    joints = tuple(Model(arm).couplers)
    torques = np.zeros((len(c.slow.q), c.n, len(joints)))
    for column, j in enumerate(joints):
        link = robot.links[j]
        size = float(link.inertial_share) * number_of(link.joint.motor_inertia)
        torques[:, j, column] = c.slow.qdd[:, j] * size
    return torques


def _seen(arm: Robot, c: Context, columns: Floats) -> Floats:
    """Columns along the coarse signals as the torque channel of ``arm`` shows them, filtered and thinned."""
    s = c.slow
    return s.thinned(s.filtered(measured_slopes(columns, s.t, arm.effects, s.tau)))
