"""Whoever has nothing but the header: joints, drives, parameters, options, and of which description."""

from __future__ import annotations

import dataclasses

import pytest

from robodyn import Robot
from robodyn.kernels.generate import Options, generate
from robodyn.robot import read_text
from robodyn.robot.identity import identity
from robodyn.version import VERSION

ARM = """
name: bench_arm
title: Two joints on a bench
links:
  - name: shoulder
    joint: revolute
    alpha: 0
    a: 0
    d: 0.3
    theta: 0
    mass: m_upper
    com: [0.1, 0, 0]
    inertia: {xx: 0.1, yy: 0.1, zz: 0.1}
    friction: {viscous: 0.1, coulomb: level}
    motor_inertia: 0.01
    limits: {position: [-2, 2], velocity: 3}
    gear: {ratio: 100, torque_constant: 0.12}
  - name: slide
    joint: prismatic
    alpha: -pi/2
    a: 0.2
    d: 0.05
    theta: pi
    mass: 1
    com: [0.1, 0, 0]
    inertia: {xx: 0.1, yy: 0.1, zz: 0.1}
    effects:
      - {effect: stribeck_friction, level: 0.5, static: 0.7, velocity: 0.1}
effects:
  - {effect: payload, mass: m_tool, com: [0, 0, 0.1]}
"""


@pytest.fixture(scope="module")
def arm() -> Robot:
    return read_text(ARM, "bench_arm.yaml", warn=lambda _: None)


@pytest.fixture(scope="module")
def files(arm: Robot) -> dict[str, str]:
    return generate(arm).files()


def test_the_head_says_what_is_inside(arm: Robot, files: dict[str, str]) -> None:
    for name, text in files.items():
        words = " ".join(text.replace("\n *", "\n").replace("\n!", "\n").split())
        for needed in (
            f"robodyn {VERSION}",
            f"Description: {identity(arm)}",
            "--scalar double --trig libm",
            "1 shoulder revolute alpha 0 a 0 d 0.3 theta q limits: -2 to 2 rad, 3 rad/s "
            "gear: ratio 100, torque constant 0.12 N m/A, so 12 N m/A at the joint",
            "2 slide prismatic alpha -pi/2 a 0.2 d q + 0.05 theta pi",
            "Torques are the motors'",
            "rotor inertia: joint 1 0.01 kg m^2",
            "viscous friction: joint 1 0.1 N m s/rad",
            "Stribeck friction at joint 2: level 0.5 N, static 0.7 N, velocity 0.1 m/s, exponent 2",
            "payload: mass m_tool kg",
            "m_upper: mass of link 1 [kg]",
            "level: Coulomb friction of joint 1 [N m]",
            "m_tool: mass of payload [kg]",
            "1 division",
        ):
            assert needed in words, (name, needed)
        assert "1 divisions" not in words


def test_options_and_numbers_show(arm: Robot) -> None:
    other = generate(arm, Options(scalar="float", trig="builtin", functions=("gravity",), optimize="none"))
    text = other.files(["c"])["bench_arm.h"]
    head = " ".join(text.replace("\n *", "\n").split())
    assert "--optimize none --scalar float --trig builtin --functions gravity" in head
    assert "q joint positions [rad, prismatic m]" in head
    assert "tau joint torques [N m, prismatic N]" in head
    sines = generate(arm, Options(functions=("inverse_dynamics",), trig="given")).files()
    assert "sc[0] = q2" in sines["bench_arm.h"]
    assert "sc(1) = q2" in sines["bench_arm.f90"]
    heavier = dataclasses.replace(arm, gravity=(arm.gravity[0], arm.gravity[1], 2 * arm.gravity[2]))
    assert identity(heavier) in generate(heavier).files(["c"])["bench_arm.h"]
    assert identity(arm) not in generate(heavier).files(["c"])["bench_arm.h"]


def test_behind_the_gear_nothing_of_the_drives_is_claimed(arm: Robot) -> None:
    bare = dataclasses.replace(arm, torque_side="link", effects=())
    header = generate(bare).files(["c"])["bench_arm.h"]
    assert "rotor inertia and friction are not in them" in header
    assert "with viscous" not in header
    assert "viscous friction: joint" not in header


def test_frames_and_names_show_and_break_no_comment() -> None:
    text = """
name: arm
base: {xyz: [0, 0, 2], rpy: [pi, 0, 0.25]}
tool: {xyz: [0, 0, 0.1]}
links:
  - {name: double, joint: revolute, b: 0.125, inertia: {zz: 1}}
  - {name: "*/ #include <x> /*", joint: revolute, alpha: pi/2, mass: 1, com: [1, 0, 0]}
  - {name: "end subroutine", joint: prismatic, mass: 1}
"""
    emitted = generate(read_text(text), Options(functions=("gravity",)))
    files = emitted.files(["c", "fortran"])
    head = " ".join(files["arm.h"].replace("\n *", "\n").split())
    assert "Base frame in the world: [0, 0, 2] m, roll, pitch, yaw pi, 0, 0.25 rad" in head
    assert "Tool frame in the last link: [0, 0, 0.1] m, roll, pitch, yaw 0, 0, 0 rad" in head
    assert "Gravity in the base frame: 0.0, 0.0, 9.81 m/s^2" in head
    assert "b 0.125" in head
    for name in ("double", "* / #include <x> / *", "end subroutine"):
        assert name in head
    assert "*/ #include" not in files["arm.h"] + files["arm.c"]
    for line in files["arm.f90"].splitlines():
        if "end subroutine" in line and "prismatic" in line:
            assert line.lstrip().startswith("!")
