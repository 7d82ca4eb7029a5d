"""The motions of the blind tests: periodic ones, from pose to pose with rests, and poor ones on purpose."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Literal

import numpy as np

from peers.numbers import Array
from robodyn.robot.model import Limits, Robot
from robodyn.simulate.trajectories.fourier import fourier
from robodyn.simulate.trajectories.trajectory import Law

Motion = Literal["full", "one_way", "narrow", "rest", "stops"]
_HARMONICS = 5


def law_of(robot: Robot, seed: int, duration: float, motion: Motion) -> Law:
    """The law of a motion at rest in the beginning, of about 0.1 Hz and its harmonics."""
    periods = max(1, round(0.1 * duration))
    frequency = periods / duration
    if motion == "rest":
        return _rest(robot, seed)
    if motion == "one_way":
        return _one_way(robot, seed, duration)
    if motion == "stops":
        return _stops(robot, seed, duration)
    if motion == "narrow":
        near = tuple(
            replace(link, joint=replace(link.joint, limits=_narrow(link.joint.limits)))
            for link in robot.links
        )
        robot = replace(robot, links=near)
    law = fourier(robot, frequency, _HARMONICS, seed, periods=periods, share=0.9).law
    assert law is not None
    return law


def _rest(robot: Robot, seed: int) -> Law:
    """A pose that is held."""
    rng = np.random.default_rng((seed, 12))
    low, high = np.array([[float(x) for x in link.joint.limits.position or ()] for link in robot.links]).T
    pose = low + (high - low) * rng.uniform(0.25, 0.75, robot.n)
    return lambda t: (np.tile(pose, (len(t), 1)), *np.zeros((2, len(t), robot.n)))


def _narrow(limits: Limits) -> Limits:
    assert limits.position is not None
    low, high = limits.position
    return replace(
        limits, position=(low + (high - low) * Fraction(48, 100), high - (high - low) * Fraction(48, 100))
    )


def _one_way(robot: Robot, seed: int, duration: float) -> Law:
    """Every joint goes from one side to the other, never back, with a ripple on its speed."""
    rng = np.random.default_rng((seed, 11))
    bounds = [link.joint.limits.position for link in robot.links]
    low, high = np.array([[float(x) for x in pair] for pair in bounds if pair]).T
    start, way = 0.9 * low + 0.1 * high, 0.8 * (high - low) * 0.6
    if rng.random() < 0.5:
        start, way = high - 0.1 * (high - low), -way
    k = rng.integers(2, 6, robot.n)
    phase = rng.uniform(0, 2 * np.pi, robot.n)

    def law(t: Array) -> tuple[Array, Array, Array]:
        # Speed sin^2 of half the time's angle times (1 + 0.6 sin): never negative, integrated numerically.
        x = t[:, None] / duration
        speed = np.sin(np.pi * x) ** 2 * (1 + 0.6 * np.sin(2 * np.pi * k * x + phase))
        h = t[1] - t[0]
        travel = np.vstack([np.zeros((1, robot.n)), np.cumsum((speed[1:] + speed[:-1]) / 2, axis=0)]) * h
        factor = way / travel[-1]
        return start + travel * factor, speed * factor, np.gradient(speed, h, axis=0) * factor

    return law


def _stops(robot: Robot, seed: int, duration: float) -> Law:
    """From pose to pose by trapezoids of speed, with rests of 0.1 to 1 s; at times a joint stays behind."""
    rng = np.random.default_rng((seed, 13))
    joints = [link.joint.limits for link in robot.links]
    low, high = np.array([[float(x) for x in limits.position or ()] for limits in joints]).T
    fast = np.array([float(limits.velocity or 1) for limits in joints])
    hard = np.array([float(limits.acceleration or 1) for limits in joints])
    times, poses, rises, lasts = [0.0], [low + (high - low) * rng.uniform(0.2, 0.8, robot.n)], [0.0], [0.0]
    while times[-1] + lasts[-1] < duration:
        times.append(times[-1] + lasts[-1] + float(rng.uniform(0.1, 1.0)))
        stays = rng.random(robot.n) < 0.15
        poses.append(np.where(stays, poses[-1], low + (high - low) * rng.uniform(0.05, 0.95, robot.n)))
        way = np.abs(poses[-1] - poses[-2])
        share, slow = float(rng.uniform(0.2, 0.4)), float(rng.uniform(0.3, 0.9))
        # A trapezoid that rises and falls for the share s of T: speed way / T / (1 - s), and that over s T.
        least = np.maximum(way / fast / (1 - share), np.sqrt(way / hard / (1 - share) / share))
        lasts.append(max(float(least.max()) / slow, 0.05))
        rises.append(share * lasts[-1])

    def law(t: Array) -> tuple[Array, Array, Array]:
        k = np.clip(np.searchsorted(times, t, side="right") - 1, 1, None)
        last, rise = np.array(lasts)[k], np.array(rises)[k]
        x = np.clip(t - np.array(times)[k], 0, last)
        top = 1 / (last - rise)
        rising, falling = np.minimum(x, rise), np.maximum(x - (last - rise), 0)
        place = top * (x - rise / 2 + (rise - rising) ** 2 / (2 * rise) - falling**2 / (2 * rise))
        speed = top * (rising - falling) / rise
        moves = (x > 0) & (x < last)
        gain = np.where(moves, top / rise, 0.0) * ((x < rise) * 1.0 - (x > last - rise))
        start = np.array(poses)[k - 1]
        way = np.array(poses)[k] - start
        return start + way * place[:, None], way * speed[:, None], way * gain[:, None]

    return law
