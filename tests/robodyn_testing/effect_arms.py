"""Arms with every effect of the catalogue that a kernel holds, a few at each joint."""

from __future__ import annotations

from typing import Final

from robodyn.robot import Robot, read_text

_REVOLUTE = """
name: rubbing
links:
  - joint: revolute
    d: 0.5
    inertia: {zz: 0.35}
    motor_inertia: 1.14
    friction: {viscous: 1.2, coulomb: 3}
    effects:
      - {effect: load_dependent_friction, bearing: journal, mu: 0.1, radius: 0.1, span: 0.2}
      - effect: transmission_loss
        breakaway: 6.3
        efficiency: [[0.0076, 0.3458], [0.0307, 0.4543], [0.0856, 0.5619], [1, 0.9]]
        rated_torque: 97.6
        interpolation: cubic
  - joint: revolute
    alpha: -pi/2
    d: 0.1501
    mass: 17.4
    com: [0.068, 0.006, -0.016]
    inertia: {xx: 0.13, yy: 0.524, zz: 0.539, xy: 0.01}
    motor_inertia: 4.71
    effects:
      - {effect: stribeck_friction, level: 3, static: f_s, velocity: 0.8}
      - {effect: load_dependent_friction, bearing: thrust, mu_r: 0.01}
      - {effect: load_dependent_friction, bearing: radial, mu: 0.02, radius: 0.08}
      - {effect: spring, stiffness: 20, rest: 0.1, cubic: 3}
      - {effect: transmission_loss, efficiency: 0.7}
  - joint: revolute
    a: 0.4318
    mass: 4.8
    com: [0, -0.07, 0.014]
    inertia: {xx: 0.066, yy: 0.0125, zz: 0.066}
    motor_inertia: 0.83
    effects:
      - {effect: asymmetric_friction, positive: 2, negative: 1.5}
      - {effect: torque_ripple, amplitude: 0.7, cycles_per_rev: 50.5, phase: 0.3}
      - {effect: motor_coupling, with: 2, ratio: -0.5, inertia: 0.2, viscous: 0.3, coulomb: 0.4}
      - {effect: load_dependent_friction, bearing: torque, mu: 0.05}
effects:
  - effect: payload
    mass: m_load
    com: [0.01, -0.4, 0.02]
    inertia: {xx: 0.01, yy: 0.02, zz: 0.015, xz: 0.001}
"""

_PRISMATIC = """
name: sliding
links:
  - joint: revolute
    inertia: {zz: 0.3}
    motor_inertia: 0.953
    friction: {viscous: 1.2, coulomb: c_1}
    effects: [{effect: stribeck_friction, level: 3, static: 5, velocity: 0.4, exponent: 1.4}]
  - joint: prismatic
    alpha: pi/2
    d: 0.3
    mass: 4.25
    com: [0.01, 0.02, 0.6447]
    inertia: {xx: 2.51, yy: 2.51, zz: 0.006}
    motor_inertia: 0.782
    effects:
      - {effect: load_dependent_friction, bearing: linear, mu: 0.1, span: 0.3}
      - {effect: spring, stiffness: -30}
      - {effect: transmission_loss, breakaway: 2, efficiency: [[0, 0.4], [0.5, 0.8]], rated_torque: 50}
  - joint: revolute
    alpha: pi/2
    mass: 2
    com: [0.1, 0, 0]
    inertia: {xx: 0.002, yy: 0.02, zz: 0.02}
    motor_inertia: 0.1
    effects: [{effect: torque_ripple, amplitude: 0.7, cycles_per_rev: 6}]
"""

_REMEMBERING = """
name: remembering
links:
  - joint: revolute
    inertia: {zz: 0.35}
    motor_inertia: 1.14
    friction: {viscous: 1.2}
    effects: [{effect: presliding_hysteresis, stiffness: 3000, level: 2, damping: 5}]
  - joint: revolute
    alpha: -pi/2
    mass: 17.4
    com: [0.068, 0.006, -0.016]
    inertia: {xx: 0.13, yy: 0.524, zz: 0.539}
    motor_inertia: 4.71
    friction: {viscous: 2, coulomb: 3}
    effects:
      - {effect: joint_elasticity, stiffness: 20000, damping: 10, encoder: motor}
      - {effect: load_dependent_friction, bearing: journal, mu: 0.1, radius: 0.08, span: 0.2}
      - {effect: transmission_loss, breakaway: 1, efficiency: 0.8}
  - joint: revolute
    a: 0.4318
    mass: 4.8
    com: [0, -0.07, 0.014]
    inertia: {xx: 0.066, yy: 0.0125, zz: 0.066}
    motor_inertia: 0.83
    effects:
      - {effect: backlash, gap: 0.002, encoder: link}
      - {effect: torque_ripple, amplitude: 0.7, cycles_per_rev: 50, phase: 0.3}
      - {effect: presliding_hysteresis, stiffness: k_b, level: 1}
      - {effect: spring, stiffness: 20}
"""

_SMOOTH = _REVOLUTE.replace("name: rubbing", "name: smooth\nfriction_at_rest: {smooth: {velocity: 0.5}}")
_BANDED = _PRISMATIC.replace("name: sliding", "name: banded\nfriction_at_rest: {dead_band: {velocity: 0.2}}")

TEXTS: Final = {
    "rubbing": _REVOLUTE,
    "sliding": _PRISMATIC,
    "remembering": _REMEMBERING,
    "smooth": _SMOOTH,
    "banded": _BANDED,
}


def arm(name: str) -> Robot:
    """The arm of that name."""
    return read_text(TEXTS[name], name)


def arm_of(
    joint: str = "", robot: str = "", *, head: str = "", link: str = "", kind: str = "revolute"
) -> Robot:
    """Two joints with the given effects at the first and of the whole robot, in flow style."""
    return read_text(arm_text(joint, robot, head=head, link=link, kind=kind))


def arm_text(
    joint: str = "", robot: str = "", *, head: str = "", link: str = "", kind: str = "revolute"
) -> str:
    """The description of :func:`arm_of`."""
    return (
        f"name: arm\n{head}links:\n  - joint: {kind}\n    mass: 2\n{link}    effects: [{joint}]\n"
        f"  - joint: revolute\neffects: [{robot}]\n"
    )
