"""Robots whose files are compiled and parsed: bundled, random, and those that break generators of code."""

from __future__ import annotations

import dataclasses
import re
import subprocess
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Final

from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import Robot, bundled_names, load, read_text
from robodyn_testing.effect_arms import TEXTS as EFFECT_TEXTS
from robodyn_testing.random_robots import random_robot

STRICT: Final = (
    "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wdouble-promotion", "-Werror",
)  # fmt: skip
STRICT_CPP: Final = ("-x", "c++", "-std=c++17", "-pedantic", "-Wall", "-Wextra", "-Werror")
STRICT_FORTRAN: Final = ("-std=f2018", "-Wall", "-Wextra", "-Werror")

_ODD: Final = {
    "ghost": "links: [{joint: revolute}]",
    "ghosts": "links: [{joint: revolute, alpha: 1, a: 0.5}, {joint: prismatic}, {joint: revolute, theta: 1}]",
    # Torques that are constants, inputs that nothing reads.
    "lift": "links: [{joint: prismatic, mass: 3}]",
    "table": "links: [{joint: revolute, inertia: {xx: 1, yy: 1, zz: 1}}]",
    "floating": """
gravity: [0, 0, 0]
links: [{joint: revolute, mass: 1, com: [1, 0, 0]}, {joint: prismatic, mass: 1}]
""",
    "pendulum": "gravity: [0, -9.8, 0]\nlinks: [{joint: revolute, mass: 1, com: [1, 0, 0]}]",
    "tilted": "links: [{joint: revolute, alpha: 0.3, theta: 0.7, mass: 1, com: [1, 0, 0.1]}]",
    "rubbing": "links: [{joint: revolute, inertia: {zz: 1}, friction: {viscous: 2, coulomb: 1.5}}]",
    "smooth": """
friction_at_rest: {smooth: {velocity: 0.02}}
links:
  - {joint: revolute, alpha: pi/2, mass: 2, com: [0.1, 0, 0.2], friction: {coulomb: 3}}
  - {joint: prismatic, alpha: 1, mass: 1, com: [0.1, 0, 0.2], motor_inertia: 2, friction: {coulomb: 3}}
""",
    "behind_the_gear": """
torque_side: link
links:
  - {joint: revolute, alpha: pi/2, mass: 2, com: [0.1, 0, 0.2], motor_inertia: 1, friction: {coulomb: 3}}
  - {joint: revolute, alpha: pi/2, mass: 1, com: [0.1, 0, 0.2], motor_inertia: 2, friction: {viscous: c_2}}
""",
    "tool": """
links:
  - {joint: revolute, mass: 3, com: [0.1, 0, 0.2], inertia: {xx: 0.1, yy: 0.2, zz: 0.25}}
  - {joint: revolute, alpha: pi/2, a: a_2, mass: 2, com: [0.2, 0.1, 0.1], inertia: {xx: 1, yy: 1, zz: 1.1}}
  - joint: prismatic
    alpha: 0.7
    d: d_3 + 0.1
    mass: 2*m_tool + 0.5
    com: [x_tool, y_tool, -0.05]
    inertia: {xx: i_tool, yy: 0.02, zz: i_tool, xy: j_tool}
    motor_inertia: i_motor
    friction: {viscous: viscous_3, coulomb: coulomb_3}
""",
    # A parameter that no function needs, and one that some need.
    "indifferent": """
links:
  - {joint: revolute, mass: m_base, com: [0, 0, z_base], inertia: {xx: i_base, yy: 1, zz: 1}}
  - {joint: revolute, alpha: pi/2, mass: 2, com: [0.2, 0, 0], inertia: {zz: 1}, friction: {viscous: v_2}}
""",
    # The longest names there may be, in the longest lines.
    "the_longest_name_that_a_robot_may_have_x": """
links:
  - {joint: revolute, alpha: 0.1, mass: A, com: [B, C, D], inertia: {xx: E, yy: F, zz: G, xy: H}}
  - {joint: revolute, alpha: 1, a: A2, d: B2, mass: C2, com: [D2, E2, F2], inertia: {xx: E, yy: F, xz: H}}
  - {joint: prismatic, alpha: 2, a: A2, d: B2, mass: C2, com: [D2, E2, F2], inertia: {xx: E, yy: F, yz: H}}
""",
    # Names of parameters that are names of other things in the emitted text.
    "confusing": """
links:
  - {joint: revolute, alpha: 0.1, mass: q, com: [tau, w1_x, c1], inertia: {xx: rk, yy: 9 + p, zz: 9 + q}}
  - {joint: revolute, alpha: 0.2, a: sin, mass: t1, com: [again, s1, m], inertia: {xx: qd}}
""",
    "huge_and_tiny": """
links:
  - {joint: revolute, alpha: 1, mass: 1e30, com: [1e-5, 3e-20, 1e7], inertia: {xx: 1e30, yy: 1e30, zz: 1e-30}}
  - {joint: revolute, alpha: 2, a: 1e-9, mass: 1e-30, com: [123456789.123456789, 1, 1], inertia: {zz: 1}}
""",
}


def _odd(name: str, text: str) -> Robot:
    if name.startswith("the_longest"):  # 31 characters each
        text = re.sub(r"\b([A-H]2?)\b", lambda m: f"{m[1].lower():_<2}".replace("__", "_x") + "y" * 29, text)
        text = re.sub(r"\b([a-h])_y", r"\1xy", text)
    return read_text(f"name: {name}\n{text}", warn=lambda _: None)


#: Robots whose drives have effects.
EFFECTS: Final = tuple(f"effects_{name}" for name in EFFECT_TEXTS)
ODD: Final = (*_ODD, *EFFECTS)
#: Random arms by name, with their numbers of joints.
_JOINTS: Final = dict(enumerate((3, 5, 7, 1, 2, 3, 4, 2, 5, 1), start=60))
RANDOM: Final = tuple(f"random_{seed}" for seed in _JOINTS)


@cache
def robots() -> dict[str, Robot]:
    """All of them by name."""
    found = {name: load(name, warn=lambda _: None) for name in bundled_names()}
    found |= {name: _odd(name, text) for name, text in _ODD.items()}
    found |= {
        f"effects_{name}": read_text(text.replace(f"name: {name}", f"name: effects_{name}", 1))
        for name, text in EFFECT_TEXTS.items()
    }
    found |= {f"random_{seed}": random_robot(seed, joints=n) for seed, n in _JOINTS.items()}
    return found


@cache
def made(name: str, trig: str = "libm") -> Generated:
    """The kernels of a robot in double."""
    return generate(robots()[name], Options(trig=trig))  # type: ignore[arg-type]


def in_single(generated: Generated) -> Generated:
    """The same programs for float."""
    functions = tuple((dataclasses.replace(s, scalar="float"), p) for s, p in generated.unit.functions)
    options = dataclasses.replace(generated.options, scalar="float")
    unit = dataclasses.replace(generated.unit, functions=functions, options=options.text)
    return dataclasses.replace(generated, unit=unit, options=options)


def write(folder: Path, files: dict[str, str]) -> list[str]:
    """Write ``files`` into ``folder``; the names of the sources."""
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8", newline="\n")
    return [name for name in files if not name.endswith(".h")]


def together(sources: Sequence[str], folder: Path, name: str) -> str:
    """A file that includes ``sources``: read as one, they cost the compiler one start; its name."""
    (folder / name).write_text("".join(f'#include "{source}"\n' for source in sources), encoding="utf-8")
    return name


def complaints(tool: str, flags: Sequence[str], sources: Sequence[str], folder: Path) -> str:
    """What a compiler says of ``sources``, "" if it is content."""
    done = subprocess.run(
        [tool, *flags, "-c", *sources],
        cwd=folder,
        capture_output=True,
        text=True,
        errors="replace",
        check=False,
    )
    said = done.stdout + done.stderr
    return said or ("" if done.returncode == 0 else f"exit status {done.returncode}")
