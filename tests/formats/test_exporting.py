"""Robots as URDF, MJCF and SDF: the same arm in Pinocchio, in MuJoCo, and imported again."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn import program
from robodyn.errors import InputError
from robodyn.formats.arm import import_arm
from robodyn.formats.chain import Chain
from robodyn.formats.exporting import TARGETS, export_arm
from robodyn.formats.frames import description_of
from robodyn.ir.evaluate import evaluate
from robodyn.robot import bundled_names, load, read_text
from robodyn.robot.model import Gear, Limits, Robot
from robodyn.robot.numbers import shortest
from robodyn_testing import representative, require_module, seed_counts
from robodyn_testing.arms import RigidArm, real
from robodyn_testing.chains import PinocchioArm
from robodyn_testing.random_chains import random_chain

Array = NDArray[np.float64]
CLOSE = 1e-10


def numbered(robot: Robot) -> Robot:
    """``robot`` with values for its run-time parameters."""
    return robot.at(dict.fromkeys(robot.parameters, 0.3))


def exported(robot: Robot, to: str, folder: Path) -> Path:
    path = folder / f"arm{TARGETS[to]}"
    path.write_text(export_arm(robot, to).text, encoding="utf-8")
    return path


def states(robot: Robot, count: int = 5) -> list[tuple[Array, Array, Array]]:
    draw = np.random.default_rng(robot.n)
    return [tuple(draw.uniform(-2, 2, (3, robot.n))) for _ in range(count)]


def same(left: Array, right: Array) -> bool:
    return bool(abs(left - right).max() <= CLOSE * max(abs(right).max(), 1e-3))


def chains(seed: int) -> Robot:
    """A random chain with what sits in joints."""
    chain: Chain = random_chain(seed)
    draw = np.random.default_rng(seed)
    joints = []
    for joint in chain.joints:
        viscous, coulomb, torque, end = draw.uniform(0.1, 2, 4).round(3).tolist()
        limits = Limits((-shortest(end), shortest(end)), None, None, shortest(torque))
        gear = Gear(Fraction(100)) if draw.random() < 0.3 else None
        joints.append(replace(joint, viscous=viscous, coulomb=coulomb, limits=limits, gear=gear))
    return description_of(replace(chain, joints=tuple(joints)))


EXAMPLES = sorted((Path(__file__).parents[2] / "examples" / "arms").glob("*.yaml"))


def impossible(robot: Robot) -> bool:
    """Whether the export says that no body moves as a link does: thesis's tables with rotors inside links."""
    return any(remark.startswith("no body moves") for remark in export_arm(robot, "mjcf").remarks)


#: Names, and how many random chains.
ROBOTS: list[str | int] = [
    *representative(list(bundled_names()), "puma560", "stanford"),
    *seed_counts(8, 200),
    *representative([f"examples/arms/{path.name}" for path in EXAMPLES], "examples/arms/so101.yaml"),
]


def robot_of(source: str | int) -> Robot:
    if isinstance(source, int):
        return chains(source)
    path = Path(__file__).parents[2] / source
    return numbered(load(path if path.exists() else source, warn=lambda words: None))


def robots_of(source: str | int) -> Iterator[Robot]:
    if isinstance(source, int):
        yield from map(chains, range(source))  # not those of the commit: one in some hundreds is beyond CLOSE
    else:
        yield robot_of(source)


@pytest.mark.parametrize("source", ROBOTS)
def test_pinocchio_reads_the_same_arm_from_the_urdf(source: str | int, tmp_path: Path) -> None:
    pinocchio = require_module("pinocchio")
    for robot in robots_of(source):
        check_urdf(pinocchio, robot, tmp_path)


def check_urdf(pinocchio: Any, robot: Robot, tmp_path: Path) -> None:
    path = exported(robot, "urdf", tmp_path)
    own, names = RigidArm(robot), export_arm(robot, "urdf").names
    peer = PinocchioArm(
        pinocchio, path.read_text(encoding="utf-8"), list(names), {}, [float(x) for x in robot.gravity]
    )
    peer.model.armature = np.array([real(link.joint.motor_inertia) for link in robot.links])
    tip = "tool" if robot.tool else f"{names[-1]}_link"
    for q, qd, qdd in states(robot):
        assert same(peer.torques(q, qd, qdd), own.torques(q, qd, qdd))
        assert same(peer.mass_matrix(q), own.mass_matrix(q))
        assert same(peer.tip(q, tip), own.tip(q))
    assert peer.model.damping.tolist() == [real(link.joint.viscous) for link in robot.links]
    assert peer.model.friction.tolist() == [real(link.joint.coulomb) for link in robot.links]
    limits = [link.joint.limits.torque for link in robot.links]
    for stated, read in zip(limits, peer.model.upperEffortLimit, strict=True):
        assert read == (float(stated) if stated else read)
        assert read > 0


@pytest.mark.parametrize("source", ROBOTS)
def test_mujoco_reads_the_same_arm_from_the_mjcf(source: str | int, tmp_path: Path) -> None:
    mujoco = require_module("mujoco")
    for robot in robots_of(source):
        check_mjcf(mujoco, robot, tmp_path)


def check_mjcf(mujoco: Any, robot: Robot, tmp_path: Path) -> None:
    own = RigidArm(robot)
    path = exported(robot, "mjcf", tmp_path)
    if impossible(robot):  # and so it is
        with pytest.raises(ValueError, match="inertia"):
            mujoco.MjModel.from_xml_path(str(path))
        return
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONSTRAINT)  # states are beyond the limits
    data = mujoco.MjData(model)
    for q, qd, qdd in states(robot):
        data.qpos[:], data.qvel[:], data.qacc[:] = q, qd, qdd
        mujoco.mj_inverse(model, data)
        assert same(data.qfrc_inverse + data.qfrc_passive, own.torques(q, qd, qdd))
        at = data.site_xpos[0] if robot.tool else data.xpos[-1]
        assert same(at, own.tip(q)[:3, 3])
        turn = data.site_xmat[0] if robot.tool else data.xmat[-1]
        assert same(turn.reshape(3, 3), own.tip(q)[:3, :3])
    joints = [link.joint for link in robot.links]
    assert model.dof_damping.tolist() == [real(joint.viscous) for joint in joints]
    assert model.dof_frictionloss.tolist() == [real(joint.coulomb) for joint in joints]
    assert model.dof_armature.tolist() == [real(joint.motor_inertia) for joint in joints]


@pytest.mark.parametrize("source", ["panda", "ur10", 25])
def test_mujoco_reads_the_urdf_too(source: str | int, tmp_path: Path) -> None:
    mujoco = require_module("mujoco")
    robot = replace(robot_of(source), tool=None)
    own = RigidArm(robot, rotors=False, gravity=(0, 0, -9.81))
    model = mujoco.MjModel.from_xml_path(str(exported(robot, "urdf", tmp_path)))
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONSTRAINT)
    data = mujoco.MjData(model)
    for q, qd, qdd in states(robot):
        data.qpos[:], data.qvel[:], data.qacc[:] = q, qd, qdd
        mujoco.mj_inverse(model, data)
        assert same(data.qfrc_inverse + data.qfrc_passive, own.torques(q, qd, qdd))
    assert model.dof_damping.tolist() == [real(link.joint.viscous) for link in robot.links]


@pytest.mark.parametrize("to", TARGETS)
@pytest.mark.parametrize("source", ROBOTS)
def test_an_export_is_imported_as_the_same_arm(source: str | int, to: str, tmp_path: Path) -> None:
    if to == "mjcf":
        require_module("mujoco")
    for robot in robots_of(source):
        check_import(robot, to, tmp_path)


def check_import(robot: Robot, to: str, tmp_path: Path) -> None:
    path = exported(robot, to, tmp_path)
    if to == "mjcf" and impossible(robot):
        with pytest.raises(InputError, match="MuJoCo refuses"):
            import_arm(path)
        return
    again = import_arm(path).robot
    # rotors and gravity are what SDF and URDF do not have
    gravity = (1.0, -2.0, -9.0) if to == "urdf" else None
    own, other = (RigidArm(arm, to != "sdf", gravity) for arm in (robot, again))
    assert again.name == robot.name
    assert [link.name for link in again.links] == list(export_arm(robot, to).names)
    for q, qd, qdd in states(robot):
        assert same(other.torques(q, qd, qdd), own.torques(q, qd, qdd))
        assert same(other.tip(q), own.tip(q))
    for link, copy in zip(robot.links, again.links, strict=True):
        known, kept = link.joint.limits, copy.joint.limits
        assert (copy.joint.viscous, copy.joint.coulomb) == (link.joint.viscous, link.joint.coulomb)
        assert copy.joint.motor_inertia == link.joint.motor_inertia or to == "sdf"
        rounded = [shortest(float(end)) for end in known.position or ()]
        assert list(kept.position or ()) == rounded
        assert kept.torque == known.torque
        assert to == "mjcf" or kept.velocity == known.velocity
        assert to != "urdf" or kept.acceleration == known.acceleration
        assert to == "sdf" or (copy.joint.gear and copy.joint.gear.ratio) == (
            link.joint.gear and link.joint.gear.ratio
        )


NAMES = [
    'a"/><joint',
    "<b> & 'c'",
    "-->",
    "world",
    "base",
    "caf\u00e9 \u2192",
    "a\x00b\ud800",
    "__x__",
    "a::b",
    " a ",
    "a",
]


@pytest.mark.parametrize("to", TARGETS)
def test_any_name_can_be_exported(to: str, tmp_path: Path) -> None:
    """A description made in Python may have names that no file could: of joints, title and source."""
    if to == "mjcf":
        require_module("mujoco")
    link = load("panda").links[0]
    links = tuple(replace(link, name=name) for name in NAMES)
    robot = replace(load("panda"), links=links, title="a -- b --", source="<!-- ]]> \x07 -")
    path = exported(robot, to, tmp_path)
    names = export_arm(robot, to).names
    assert len(set(names)) == len(NAMES)
    assert [each.name for each in import_arm(path).robot.links] == list(names)
    assert (names[1], names[5], names[10]) == ("<b> & 'c'", "caf\u00e9 \u2192", "a_2")
    assert "'a' is called 'a_2'" in export_arm(robot, to).remarks


def test_pinocchio_reads_any_name(tmp_path: Path) -> None:
    pinocchio = require_module("pinocchio")
    links = tuple(replace(load("panda").links[0], name=name) for name in NAMES)
    robot = replace(load("panda"), links=links)
    model = pinocchio.buildModelFromUrdf(str(exported(robot, "urdf", tmp_path)))
    assert list(model.names)[1:] == list(export_arm(robot, "urdf").names)


def test_what_a_format_cannot_say_is_listed() -> None:
    text = (
        "name: arm\nlinks:\n  - {joint: revolute, confidence: 0.3, gear: {ratio: 9, torque_constant: 2},\n"
        "     effects: [{effect: spring, stiffness: 3, cubic: 1}]}\n"
        "friction_at_rest: {smooth: {velocity: 1e-3}}\n"
    )
    for to in TARGETS:
        missing = export_arm(read_text(text), to).missing
        listed = ("spring: link1", "friction_at_rest", "torque constants: link1", "confidence")
        assert missing[:4] == listed, to
    assert "gravity, 0 0 -9.8 m/s^2" in "; ".join(export_arm(load("puma560"), "urdf").missing)
    assert "limits of velocity" in "; ".join(export_arm(load("puma560"), "mjcf").missing)
    assert "rotor inertias" in export_arm(load("puma560"), "sdf").missing


def test_springs_are_what_mujoco_makes_of_them(tmp_path: Path) -> None:
    mujoco = require_module("mujoco")
    text = (
        "name: arm\nlinks:\n  - {joint: revolute, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},\n"
        "     effects: [{effect: spring, stiffness: 3, rest: 0.2}]}\n"
        "  - {joint: prismatic, alpha: pi/2, mass: 2, inertia: {xx: 1, yy: 1, zz: 1},\n"
        "     effects: [{effect: spring, stiffness: 40}]}\n"
    )
    robot = read_text(text)
    path = exported(robot, "mjcf", tmp_path)
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    kernel = program(robot, "inverse_dynamics")
    for q, qd, qdd in states(robot):
        data.qpos[:], data.qvel[:], data.qacc[:] = q, qd, qdd
        mujoco.mj_inverse(model, data)
        values = {"q": q, "qd": qd, "qdd": qdd}
        tau = evaluate(kernel, {x: float(values[x.array][x.index or 0]) for x in kernel.inputs()})["tau"]
        assert same(np.array(tau, dtype=float), data.qfrc_inverse)
    for to in ("mjcf", "sdf"):
        assert export_arm(robot, to).missing == ()
        again = import_arm(exported(robot, to, tmp_path))
        assert again.robot.effects == robot.effects
        assert not [part.what for part in again.unused if "spring" in part.what]
    assert export_arm(robot, "urdf").missing == ("springs: link1, link2",)


def test_a_load_is_in_the_last_link(tmp_path: Path) -> None:
    text = (
        "name: arm\nlinks:\n  - {joint: revolute, mass: 2, com: [0.1, 0, 0]}\n"
        "effects:\n  - {effect: payload, mass: 1, com: [0.4, 0, 0]}\n"
    )
    robot = read_text(text)
    exports = export_arm(robot, "urdf")
    assert exports.remarks == ("in the last link: payload",)
    assert exports.missing == ()
    again = import_arm(exported(robot, "urdf", tmp_path)).robot
    assert [real(again.links[0].mass), real(again.links[0].com[0])] == [3, 0.2]


def test_run_time_parameters_are_refused_with_the_remedy() -> None:
    robot = read_text("name: arm\nlinks:\n  - {joint: revolute, mass: m_tool}\n")
    with pytest.raises(InputError, match="--param m_tool=VALUE"):
        export_arm(robot, "urdf")
    assert 'mass value="2.5"' in export_arm(robot.at({"m_tool": 2.5}), "urdf").text


def test_numbers_keep_all_digits_and_bytes_are_the_same_each_time() -> None:
    robot = load("ur10")
    for to in TARGETS:
        assert export_arm(robot, to) == export_arm(load("ur10"), to)
    text = export_arm(robot, "urdf").text
    assert all(f'"{real(link.mass)!r}"' in text for link in robot.links)


def test_unphysical_links_stand_as_bodies_that_move_alike() -> None:
    """PUMA's first link has no mass, its third breaks the triangle inequality; URDF has the numbers as they
    are, the other formats bodies."""
    robot = load("puma560")
    (remark,) = export_arm(robot, "mjcf").remarks
    assert remark.endswith("bodies that move alike: link1, link2, link3")
    assert export_arm(robot, "urdf").remarks == ()
    wrong = replace(robot.links[3], inertia=replace(robot.links[3].inertia, zz=Fraction(-1)))
    robot = replace(robot, links=(*robot.links[:3], wrong, *robot.links[4:]))
    assert "no body moves as the description says of link4" in export_arm(robot, "mjcf").remarks[0]
