"""Arms that nobody has seen: 2 to 7 joints, revolute and prismatic, any mounting, light and heavy.

Drawn anew for each seed and written as a description. Joints that could not be told apart (two slides, or two
axes, in one line) are not drawn.
"""

from __future__ import annotations

import numpy as np

from peers.numbers import Array

#: How an arm is mounted: gravity [m/s^2] in the frame of its base.
MOUNTINGS = {
    "floor": (0.0, 0.0, -9.81),
    "ceiling": (0.0, 0.0, 9.81),
    "wall": (9.81, 0.0, 0.0),
    "slope": (4.905, 0.0, -8.496),
}
#: Standard gravity is on most floors.
_SHARES = (0.55, 0.15, 0.15, 0.15)
_PRISMATIC = 0.2


def random_arm(seed: int) -> str:
    """The description (YAML) of an arm of its own for each ``seed``."""
    rng = np.random.default_rng((seed, 39))
    n = int(rng.integers(2, 8))
    kinds, alphas = _axes(rng, n)
    size, mass = (float(np.exp(rng.uniform(*np.log(span)))) for span in ((0.15, 0.6), (2, 40)))
    mounting = str(rng.choice(list(MOUNTINGS), p=_SHARES))
    masses = [mass * float(np.exp(rng.normal(0, 0.3))) * 0.65**k for k in range(n)]
    lines = [
        f"name: random_{seed}", f"title: drawn at random, {n} joints, on the {mounting}",
        f"gravity: {_list(MOUNTINGS[mounting])}", "links:",
    ]  # fmt: skip
    for k in range(n):
        slides = kinds[k] == "prismatic"
        # Neighbours that are parallel are apart, and what turns is not always in one plane.
        apart = alphas[k] == "0" and k > 0
        a = size * float(rng.uniform(0.5, 1.2) if apart else rng.choice([0.0, rng.uniform(0, 0.4)]))
        d = 0.0 if slides else size * float(rng.choice([0.0, rng.uniform(-0.5, 1.0)]))
        com, inertia = _body(rng, masses[k], size)
        reach = 1.0 if slides else (0.7 * size) ** 2 * (n - k) ** 0.5
        rotor = sum(masses[k:]) * reach * float(rng.uniform(0.15, 1.0))
        low = float(rng.uniform(0.0, 0.3)) if slides else float(rng.uniform(-2.4, -1.2))
        span = float(rng.uniform(0.3, 0.8)) if slides else float(rng.uniform(2.6, 4.4))
        speed = float(rng.uniform(0.4, 1.0) if slides else rng.uniform(1.2, 3.5))
        lines += [
            f"  - joint: {kinds[k]}", f"    alpha: {alphas[k]}", f"    a: {a:.4f}", f"    d: {d:.4f}",
            f"    theta: {rng.choice(['0', 'pi/2', '-pi/2'])}", f"    mass: {masses[k]:.4f}",
            f"    com: {_list(com)}", f"    inertia: {{{inertia}}}", f"    motor_inertia: {rotor:.4g}",
            f"    limits: {{position: [{low:.3f}, {low + span:.3f}], velocity: {speed:.3f},"
            f" acceleration: {speed * float(rng.uniform(2.5, 5.0)):.3f}}}",
        ]  # fmt: skip
    return "\n".join([*lines, ""])


def _axes(rng: np.random.Generator, n: int) -> tuple[list[str], list[str]]:
    kinds: list[str] = []
    alphas: list[str] = []
    for k in range(n):
        kinds.append("prismatic" if rng.random() < _PRISMATIC else "revolute")
        alpha = str(rng.choice(["0", "pi/2", "-pi/2", "0.5"], p=[0.35, 0.3, 0.25, 0.1])) if k else "0"
        slide = k > 0 and kinds[k] == kinds[k - 1] == "prismatic"
        # Parallel axes of three joints in turn are common, four in turn are not.
        if slide or (alphas[-3:] == ["0"] * 3 and alpha == "0"):
            alpha = "pi/2"
        alphas.append(alpha)
    if "revolute" not in kinds:
        kinds[-1] = "revolute"
    return kinds, alphas


def _body(rng: np.random.Generator, mass: float, size: float) -> tuple[Array, str]:
    """Centre [3] (m) and inertia of a solid ellipsoid that lies anyhow."""
    axes = size * rng.uniform([0.25, 0.1, 0.1], [0.6, 0.3, 0.3])
    turned, _ = np.linalg.qr(rng.standard_normal((3, 3)))
    tensor = turned @ np.diag(mass / 5 * (axes @ axes - axes**2)) @ turned.T
    com = size * rng.uniform([0.1, -0.15, -0.15], [0.6, 0.15, 0.3])
    pairs = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
    return com, ", ".join(f"{name}: {tensor[place]:.6g}" for name, place in pairs.items())


def _list(values: tuple[float, ...] | Array) -> str:
    return "[" + ", ".join(f"{value:.5g}" for value in values) + "]"
