"""Inverse dynamics of drives that remember, a step at a time, in double precision over many states.

Written from the order of a drive (:mod:`robodyn.effects.effect`) on top of :class:`.Reference`,
:class:`.Drives` and :mod:`.stateful`: the torque behind the bearings is that of a robot whose torques are the
links', the motor's side is a drive without link.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from robodyn.robot.model import EffectEntry, Robot
from robodyn.verify.effects import Drives, Floats, Reactions, place_of, settings
from robodyn.verify.numbers import Parameters, filled
from robodyn.verify.reference import Reference
from robodyn.verify.stateful import Twist, bristle_step, twist_step

_COUPLERS = ("joint_elasticity", "backlash")
_DAHL = "presliding_hysteresis"
_LINK_SIDE = ("link", "bearing", "rigid")


class Stepping:
    """The inverse dynamics of ``robot`` with its memory; states are in the order of the kernel's.

    Raises
    ------
    InputError: a run-time parameter has no value.
    """

    def __init__(self, robot: Robot, parameters: Parameters | None = None) -> None:
        values = filled(robot, parameters)
        self._n = robot.n
        link = tuple(e for e in robot.effects if place_of(e.effect) in _LINK_SIDE)
        motor = tuple(e for e in robot.effects if e not in link and e.effect not in (*_COUPLERS, _DAHL))
        self._links = Reference(replace(robot, torque_side="link", effects=link), values)
        self._motors = Drives(replace(robot, effects=motor), values)
        self._memories: list[tuple[EffectEntry, slice]] = []
        k = 0
        for i in range(1, robot.n + 1):
            entries = [e for e in robot.effects_at(i) if e.effect in (*_COUPLERS, _DAHL)]
            for entry in sorted(entries, key=lambda e: e.effect == _DAHL):
                count = 1 if entry.effect == _DAHL else 3
                self._memories.append((entry, slice(k, k + count)))
                k += count
        self.states = k
        self._settings = {id(entry): settings(entry, values) for entry, _ in self._memories}

    def step(self, q: Floats, qd: Floats, qdd: Floats, state: Floats, dt: float) -> tuple[Floats, Floats]:
        """Torques ``[N, n]`` [N m or N] and the states ``[N, states]`` after ``dt`` [s]."""
        link = [q.copy(), qd.copy(), qdd.copy()]
        couplers = [(e, part) for e, part in self._memories if e.effect in _COUPLERS]
        for entry, part in couplers:
            assert entry.joint is not None
            if entry.text("encoder") == "motor":
                link[0][:, entry.joint - 1] -= state[:, part.start]
        passed = self._links.inverse_dynamics(*link)
        moved, after = [q.copy(), qd.copy(), qdd.copy()], state.copy()
        for entry, part in couplers:
            assert entry.joint is not None
            i = entry.joint - 1
            stepped = twist_step(
                entry.effect, self._settings[id(entry)], passed[:, i], Twist(*state[:, part].T), dt
            )
            after[:, part] = np.stack([stepped.way, stepped.rate, stepped.acceleration], axis=1)
            if entry.text("encoder") == "link":
                for array, ahead in zip(moved, after[:, part].T, strict=True):
                    array[:, i] += ahead
        nothing = np.zeros((len(q), self._n, 3))
        tau = self._motors.torque(moved[0], moved[1], moved[2], Reactions(passed, nothing, nothing))
        for entry, part in self._memories:
            if entry.effect == _DAHL:
                assert entry.joint is not None
                i = entry.joint - 1
                z, torque = bristle_step(self._settings[id(entry)], moved[1][:, i], state[:, part.start], dt)
                after[:, part.start] = z
                tau[:, i] += torque
        return tau, after
