"""A commented robot description to begin with."""

from __future__ import annotations

from robodyn.errors import InputError
from robodyn.robot.keys import LINKS
from robodyn.robot.names import check_robot_name

_HEAD = """\
# A serial arm, base to tip, in SI units. Change the numbers; delete what you do not know.
# A number may be arithmetic with pi (-pi/2, 17*0.0254), or a name (mass: m_tool): a name becomes a
# run-time parameter of the generated kernels.
name: {name}                     # a C identifier; prefixes every emitted symbol
title: {title}
source: where the numbers come from
gravity: [0, 0, -9.81]           # in the base frame, m/s^2; with base in the world's
# base: {{xyz: [0, 0, 0.5], rpy: [pi, 0, 0]}}  # the base frame in the world: from a ceiling; rpy as in URDF
# confidence: unknown            # the inertial numbers of all links are a guess
# origin: {{inertial: measured}}   # where numbers come from: stated, measured, assumed or synthetic

# Modified (Craig) Denavit-Hartenberg frames: from frame i-1 turn alpha about x and go a along x, then
# turn theta about z and go d along z. Rows of standard DH: add the line "convention: sdh".
links:
"""
_FIRST = """\
  - name: link1
    joint: revolute              # or prismatic
    alpha: 0                     # alpha_{i-1}, rad
    a: 0                         # a_{i-1}, m
    # b: 0                       # along y behind alpha, m: short offsets where axes are nearly parallel
    d: 0.4                       # m; prismatic: constant added to q
    theta: 0                     # rad; revolute: constant added to q
    # pose: {xyz: [0, 0, 0.4], rpy: [0, 0, 0]}  # in place of these numbers: joint's frame in the one before
    mass: 8.0                    # kg
    com: [0, -0.02, -0.1]        # in the link's frame, m
    inertia: {xx: 0.05, yy: 0.05, zz: 0.03, xy: 0, xz: 0, yz: 0}  # about the centre of mass, kg m^2
    motor_inertia: 0.5           # rotor, reflected to the joint; kg m^2, prismatic kg
    gear: {ratio: 100, torque_constant: 0.12}                     # motor turns a joint turn; motor N m/A
    friction: {viscous: 1.0, coulomb: 2.0}                        # N m s/rad, N m
    limits: {position: [-pi, pi], velocity: 3.0, acceleration: 10.0, torque: 150}
    confidence: 0.1              # inertial numbers are right to about this share; or unknown
    # acknowledged: why          # implausible numbers stand as they are: no warning; --strict refuses
    # effects:                   # what the joint has beyond a rigid body
    #   - {effect: stribeck_friction, level: 2.0, static: 3.0, velocity: 0.05}  # in place of coulomb
    #   - {effect: transmission_loss, efficiency: 0.85}
"""
_MORE = """\
  - name: link{i}
    joint: revolute
    alpha: {alpha}
    a: {a}
    d: 0
    theta: 0
    mass: {mass}
    com: [0.15, 0, 0]
    inertia: {{xx: 0.01, yy: 0.04, zz: 0.04}}                         # entries left out are 0
    motor_inertia: 0.2
"""
_TAIL = """\

# tool: {xyz: [0, 0, 0.1], rpy: [0, 0, 0]}  # the tool's frame in the last link's
# torque_side: motor             # motor (default): rotor and friction are in the torque; or link
# friction_at_rest: exact        # or {smooth: {velocity: 1e-3}}, or {dead_band: {velocity: 1e-3}}
# effects:                       # of the whole robot
#   - {effect: payload, mass: m_load, com: [0, 0, 0.1]}
"""


def starter(name: str = "my_arm", joints: int = 2) -> str:
    """A commented description of a made-up arm, ending in a line break; it loads without a warning.

    Raises
    ------
    InputError: ``name`` is not a robot's name, or ``joints`` is not in 1 ... 100.
    """
    check_robot_name(name)
    if not 1 <= joints <= LINKS:
        raise InputError("the number of joints is out of range", found=str(joints), expected=f"1 to {LINKS}")
    title = f"An arm with {joints} joint" + ("s" if joints > 1 else "")
    parts = [_HEAD.format(name=name, title=title), _FIRST]
    for i in range(2, joints + 1):
        # A shoulder that turns the axis, then parallel joints: an arm in a plane.
        alpha, a = ("-pi/2", "0") if i == 2 else ("0", "0.3")
        mass = f"{max(8.0 / i, 0.1):.1f}"
        parts.append(_MORE.format(i=i, alpha=alpha, a=a, mass=mass))
    return "".join(parts) + _TAIL
