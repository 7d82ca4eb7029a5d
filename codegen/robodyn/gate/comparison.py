"""Readings of a log, each as likely as a fit of the arm to it says.

A reading is better than the log as it stands where blocks that are held out are M / 0.01 times as likely with
it, M readings tried (Wasserman, Ramdas and Balakrishnan 2020), in nearly all of them, and less is left of a
torque.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from robodyn.arrays import Floats
from robodyn.effects import sensors
from robodyn.gate import limits
from robodyn.gate.arm_fit import ArmFit, Solution, Table
from robodyn.gate.flag import named
from robodyn.gate.readings import Reading, as_logged, readings
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True, eq=False)
class Trial:
    """A reading, its table and fit, and by how much it is more likely than what it is compared with."""

    reading: Reading
    table: Table
    fit: Solution
    gain: float = 0.0


class Comparison:
    """All readings of a log, whose positions reach ``largest`` [n], beside one that holds already."""

    def __init__(self, arm: ArmFit, robot: Robot, largest: Floats, reading: Reading | None = None) -> None:
        self.arm, self.robot, self.largest = arm, robot, largest
        self.base = self._trial(reading or as_logged(arm.n))
        arm.same = arm.alike(self.base.table, self.base.fit)
        self.base = self._trial(self.base.reading)

    def better(self) -> list[Trial]:
        """What is better than the base, best first."""
        base = self.base
        tried = [replace(one, gain=self._gain(one)) for one in self._all()]
        threshold = math.log(len(tried) / limits.CHANCE)
        likely = sorted((one for one in tried if one.gain > threshold), key=lambda one: -one.gain)
        held = self.arm.held_out(base.table, base.reading.looseness)
        better = []
        for one in likely[: 2 * self.arm.n]:
            other = self.arm.held_out(one.table, one.reading.looseness)
            changes = one.reading.by_channel(other.T).T - base.reading.by_channel(held.T).T
            prior = float(base.fit.penalty - one.fit.penalty)
            gains = (base.table.counts / self._rows(one) * changes).sum(axis=1) + prior / limits.BLOCKS
            total = float(gains.sum())
            fall = math.exp(float(self._changes(one).max()))
            relief = fall > limits.LEAST_RELIEF or (one.reading.remedy and prior > threshold)
            if total - gains.max() > threshold and (gains > 0).sum() >= limits.STEADY and relief:
                better.append(replace(one, gain=total))
        return sorted(better, key=lambda one: -one.gain)

    def _trial(self, reading: Reading) -> Trial:
        table = self.arm.table(reading)
        return Trial(reading, table, self.arm.whole(table, reading.looseness))

    def _rows(self, one: Trial) -> Floats:
        """How many rows say the same by torque channel, in the base and in ``one``."""
        same: Floats = 0.5 * (self.arm.same + one.reading.by_channel(self.arm.alike(one.table, one.fit)))
        return same

    def _changes(self, one: Trial) -> Floats:
        """By how much the log-likelihood of a row is more, by torque channel [n]."""
        scores = [x.reading.by_channel(self.arm.score(x.table, x.fit)) for x in (one, self.base)]
        return np.asarray(scores[0] - scores[1])

    def _gain(self, one: Trial) -> float:
        counts = self.base.table.counts.sum(axis=0)
        prior = float(self.base.fit.penalty - one.fit.penalty)
        return float(counts / self._rows(one) @ self._changes(one)) + prior

    def _all(self) -> Iterator[Trial]:
        base, n = replace(self.base.reading, joints=(), remedy=""), self.arm.n
        yield from map(self._trial, readings(self.robot, self.largest, base))
        for j in range(n):
            yield from self._gains([j])
            if 0 < j < n - 1:  # of a wrist; a factor of the whole arm is one of its masses
                yield from self._gains(list(range(j, n)))
        everyone = named("tau", range(1, n + 1))
        yield from self._late(everyone)
        yield from self._clock()
        for j in range(n):
            yield from self._zeros(j)
        if base.gravity == "whole" and any(self.robot.gravity):
            text = "the torques have no gravity: as a controller gives them that compensates it"
            one = replace(base, kind="perhaps_no_gravity", where=everyone, text=text, gravity="error")
            yield from (self._trial(one), self._trial(replace(one, gravity="none")))
        if base.gravity == "whole" and any(self.robot.gravity):
            yield from self._mounted()
        if base.looseness == 1:
            text = "nothing else than masses and inertias far from the description's explains the torques"
            one = replace(base, kind="description_off", where=self.robot.name, text=text)
            yield self._trial(replace(one, looseness=limits.LOOSENED))

    def _mounted(self) -> Iterator[Trial]:
        """The arm on a wall, a slope or a ceiling where its description has it elsewhere; a tilt by little is
        an effect."""
        described = np.array([*map(float, self.robot.gravity)])
        size, down = np.linalg.norm(described), self.arm.gravity(self.base.table)
        if described @ down < math.cos(limits.TILT) * size * np.linalg.norm(down):
            down = 0.1 * np.rint(10 * size * down / np.linalg.norm(down))
            vector = f"[{', '.join(f'{x + 0:.3g}' for x in down)}]"
            yield self._trial(
                replace(
                    self.base.reading, kind="mounting", where="gravity", down=tuple(down.tolist()),
                    text=f"acts along {vector}, the arm being mounted otherwise than described",
                    remedy=f"write gravity in the description as the arm is mounted: about {vector}",
                )
            )  # fmt: skip

    # --- readings with a number, by Gauss and Newton -----------------------------------------------------

    def _gains(self, joints: list[int]) -> Iterator[Trial]:
        base, numbers = self.base.reading, [j + 1 for j in joints]
        inside = np.isin(np.arange(self.arm.n), joints)
        start = replace(base, kind=sensors.GAIN.id, where=named("tau", numbers), joints=tuple(numbers))

        def at(log_gain: float) -> Reading:
            scale = np.array(base.tau_scale) * np.where(inside, math.exp(-log_gain), 1.0)
            return replace(start, tau_scale=tuple(scale.tolist()))

        def slope(one: Trial, x: Floats) -> Floats:
            return np.asarray((one.table.model + one.table.columns[..., : self.arm.r] @ x) * inside[:, None])

        def text(value: float, error: float) -> str:
            gain = math.exp(value) / base.tau_scale[joints[0]]
            return f"{gain:.3g} +- {gain * error:.1g} times the torque in N m (N)"

        yield from self._fitted(at, slope, text, most=1.4)

    def _late(self, everyone: str) -> Iterator[Trial]:
        base, h = replace(self.base.reading, kind="late_torque", where=everyone), 2e-3

        def at(late: float) -> Reading:
            return replace(base, late=base.late + late)

        def slope(one: Trial, _: Floats) -> Floats:
            early, late = (self.arm.table(replace(one.reading, late=one.reading.late + d)) for d in (-h, h))
            return np.asarray((early.columns[..., -1] - late.columns[..., -1]) / (2 * h))

        def text(value: float, error: float) -> str:
            return f"{1e3 * (base.late + value):.3g} +- {1e3 * error:.1g} ms late against q"

        yield from self._fitted(at, slope, text, most=0.02)

    def _clock(self) -> Iterator[Trial]:
        base, h = replace(self.base.reading, kind="clock", where="t"), 0.01

        def at(log_clock: float) -> Reading:
            return replace(base, clock=base.clock * math.exp(log_clock))

        def slope(one: Trial, x: Floats) -> Floats:
            return self._change(one, replace(one.reading, clock=one.reading.clock * math.exp(h)), x) / h

        def text(value: float, error: float) -> str:
            clock = base.clock * math.exp(value)
            return f"{clock:.3g} +- {clock * error:.1g} times the time that passed, as the torques tell"

        for one in self._fitted(at, slope, text, most=0.3):
            remedy = f"divide t by about {one.reading.clock:.3g}, and multiply rates by it"
            yield replace(one, reading=replace(one.reading, remedy=remedy))

    def _change(self, one: Trial, reading: Reading, x: Floats) -> Floats:
        """By how much the model's torques [n, K] are more in another ``reading``, its numbers being ``x``."""
        other, rigid = self.arm.table(reading), slice(0, self.arm.r)
        change = other.columns[..., rigid] - one.table.columns[..., rigid]
        return np.asarray(other.model - one.table.model + change @ x)

    def _zeros(self, j: int) -> Iterator[Trial]:
        base, h = replace(self.base.reading, kind="zero", where=f"q{j + 1}", joints=(j + 1,)), 0.02
        is_angle = self.robot.links[j].joint.kind == "revolute"
        unit, factor = ("degrees", math.degrees(1)) if is_angle else ("mm", 1e3)

        def at(value: float) -> Reading:
            return replace(base, zero=tuple(x + value * (k == j) for k, x in enumerate(base.zero)))

        def slope(one: Trial, x: Floats) -> Floats:
            zero = tuple(z + h * (k == j) for k, z in enumerate(one.reading.zero))
            return self._change(one, replace(one.reading, zero=zero), x) / h

        def text(value: float, error: float) -> str:
            zero = base.zero[j] + value
            return f"reads {factor * zero:.4g} +- {factor * error:.1g} {unit} more than the model's"

        for first in (0.0, math.pi / 2, math.pi, -math.pi / 2) if is_angle else (0.0,):
            yield from self._fitted(at, slope, text, most=0.5, first=first)

    def _fitted(
        self,
        at: Callable[[float], Reading],
        column: Callable[[Trial, Floats], Floats],
        text: Callable[[float, float], str],
        *,
        most: float,
        first: float = 0.0,
    ) -> Iterator[Trial]:
        """The most likely of the readings ``at`` a number, that begins with ``first`` and changes by ``most``
        in a step. ``column``: the slope of the model with it."""
        value, error, one = first, math.inf, self._trial(at(first))
        if first and self._gain(one) < 0:
            return
        x = one.fit.x
        for _ in range(limits.STEPS):
            step = self.arm.whole(one.table, one.reading.looseness, column(one, x))
            x, error = step.x[1:], float(step.error)
            change = min(max(float(step.x[0]), -most), most)
            value += change
            one = self._trial(at(value))
            if abs(change) < 0.1 * error:
                break
        yield replace(one, reading=replace(one.reading, text=text(value, error)))

    def beside_friction(self) -> tuple[Floats, Floats, Floats]:
        """What bias and friction leave of the torques and of the model's [n, K]; and the share [n] of the
        first that the arm leaves too, NaN: it tells nothing."""
        table = self.base.table
        left, shares = [], np.full(self.arm.n, np.nan)
        for j, variance in enumerate(self.base.fit.variance.tolist()):
            weight = np.sqrt(table.weight[j])[:, None]
            pair = np.stack([table.columns[j, :, -1] + table.model[j], table.model[j]], axis=1)
            friction, sizes = weight * table.columns[j][:, self.arm.friction], pair.std(axis=0)
            rest = weight * pair - friction @ np.linalg.lstsq(friction, weight * pair, rcond=1e-9)[0]
            left.append(rest)
            if sizes[1] > 0.2 * sizes[0] > 0:
                alone = float((rest[:, 0] ** 2).sum() / (weight**2).sum())
                shares[j] = variance / (alone + table.floor[j])
        own, model = np.moveaxis(np.array(left), 2, 0)
        return own, model, shares
