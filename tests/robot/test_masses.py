"""Masses that nobody knows: what is refused, what is not, and what is 0 on purpose."""

from __future__ import annotations

from pathlib import Path

import pytest

import robodyn
from robodyn import InputError, load
from robodyn.formats.arm import description_text, import_arm
from robodyn.robot import read_text
from robodyn.robot.masses import massless, unknown_masses
from robodyn_testing import require_module

MASS = "<mass value='2'/>"
TENSOR = "<inertia ixx='0.1' iyy='0.1' izz='0.1'/>"
WHOLE = f"<inertial>{MASS}{TENSOR}</inertial>"
SHAPE = "<visual><geometry><sphere radius='0.1'/></geometry></visual>"
POSES = ["forward_kinematics", "jacobian", "link_poses"]


def urdf(*links: str, fixed: str = "") -> str:
    """An arm with such links behind its joints, and a last one that does not move."""
    text = "<robot name='arm'><link name='l0'/>"
    for i, inside in enumerate((*links, fixed), 1):
        kind = "revolute" if i <= len(links) else "fixed"
        text += f"<link name='l{i}'>{inside}</link><joint name='j{i}' type='{kind}'><parent link='l{i - 1}'/>"
        text += f"<child link='l{i}'/><origin xyz='0.1 0.2 0.3'/><axis xyz='0 {i % 2} {1 - i % 2}'/>"
        text += "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint>"
    return text + "</robot>"


@pytest.mark.parametrize(
    ("links", "unknown"),
    [
        ((WHOLE, WHOLE), ()),
        ((WHOLE, SHAPE), (2,)),
        ((SHAPE, WHOLE), (1,)),
        ((WHOLE, ""), (2,)),
        (("", WHOLE), ()),  # half of a universal joint
        (("", ""), (2,)),
        ((WHOLE, f"<inertial>{MASS}</inertial>"), (2,)),
        ((WHOLE, f"<inertial>{MASS}{TENSOR.replace('0.1', '0')}</inertial>"), ()),
    ],
)
def test_urdf(tmp_path: Path, links: tuple[str, ...], unknown: tuple[int, ...]) -> None:
    file = tmp_path / "arm.urdf"
    file.write_text(urdf(*links))
    robot = load(file, warn=lambda _: None)
    assert unknown_masses(robot) == unknown
    again = read_text(description_text(import_arm(file)))
    assert unknown_masses(again) == unknown, "the description does not forget it"
    robodyn.program(robot, "jacobian")
    if not unknown:
        robodyn.program(robot, "inverse_dynamics")
        return
    place = rf"arm\.urdf:1:\d+: arm: torques and inertias .* joint {unknown[0]} \(j{unknown[0]}\).*--massless"
    with pytest.raises(InputError, match=place):
        robodyn.program(robot, "inverse_dynamics")
    assumed = load(file, massless=True, warn=lambda _: None)
    assert not unknown_masses(assumed)
    assert {assumed.links[joint - 1].origins.inertia for joint in unknown} == {"assumed"}
    robodyn.program(assumed, "inverse_dynamics")
    described = read_text(description_text(import_arm(file, massless=True)))
    assert [link.origins for link in described.links] == [link.origins for link in assumed.links]


def test_what_moves_with_a_body_needs_none(tmp_path: Path) -> None:
    (tmp_path / "arm.urdf").write_text(urdf(WHOLE, fixed=SHAPE))
    assert not unknown_masses(load(tmp_path / "arm.urdf", warn=lambda _: None))


def test_mjcf_of_meshes_is_unknown(tmp_path: Path) -> None:
    require_module("mujoco")
    model = (
        "<mujoco><asset><mesh name='m' vertex='0 0 0 1 0 0 0 1 0 0 0 1'/></asset><worldbody><body name='b'>"
        "<joint name='j'/>{}</body></worldbody></mujoco>"
    )
    (tmp_path / "arm.xml").write_text(model.format("<geom type='mesh' mesh='m'/>"))
    assert unknown_masses(load(tmp_path / "arm.xml", warn=lambda _: None)) == (1,)
    (tmp_path / "arm.xml").write_text(model.format("<geom size='0.1'/>"))
    robot = load(tmp_path / "arm.xml", warn=lambda _: None)
    assert (unknown_masses(robot), robot.links[0].origins.inertia) == ((), "assumed")
    carried = "<geom size='0.1'/><body><geom type='mesh' mesh='m'{}/></body>"
    for weight, unknown in (
        ("", (1,)),
        (" mass='0'", ()),
    ):  # a body that is partly of meshes is unknown as a whole
        (tmp_path / "arm.xml").write_text(model.format(carried.format(weight)))
        assert unknown_masses(load(tmp_path / "arm.xml", warn=lambda _: None)) == unknown


@pytest.mark.parametrize(
    ("inside", "mass"),
    [("<inertial><mass>2</mass></inertial>", 2), ("", 1), ("<inertial auto='true'/>", 0)],
)
def test_sdf(tmp_path: Path, inside: str, mass: int) -> None:
    """What is left out is 1 by the format, as Drake 1.51 reads it; what simulators compute is unknown."""
    (tmp_path / "arm.sdf").write_text(
        f"<sdf version='1.7'><model name='m'><link name='a'/><link name='b'>{inside}</link><joint name='w' "
        "type='fixed'><parent>world</parent><child>a</child></joint><joint name='j' type='revolute'><parent>a"
        "</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"
    )
    warnings: list[str] = []
    robot = load(tmp_path / "arm.sdf", without=["auto"], warn=warnings.append)
    (link,) = robot.links
    assert link.mass == mass
    assert link.origins.inertia == ("assumed" if mass else "absent")
    assert unknown_masses(robot) == (() if mass else (1,))
    assert any("not stated, and by the format 1 kg" in text for text in warnings) == bool(mass)


@pytest.mark.parametrize(
    ("text", "unknown"),
    [
        ("links: [{joint: revolute}, {joint: revolute}]", ()),
        ("origin: {inertial: absent}\nlinks: [{joint: revolute}, {joint: revolute}]", (1, 2)),
        ("links: [{joint: revolute, mass: 1}, {joint: revolute}, {joint: revolute, mass: 1}]", ()),
        ("links: [{joint: revolute, mass: 1}, {joint: revolute, origin: {inertial: absent}}]", (2,)),
        ("links: [{joint: revolute, mass: 1}, {joint: revolute, confidence: unknown}]", ()),
    ],
)
def test_descriptions(text: str, unknown: tuple[int, ...]) -> None:
    """What they leave out is 0, unless they say that nobody knows."""
    robot = read_text(f"name: arm\n{text}\n", warn=lambda _: None)
    assert unknown_masses(robot) == unknown
    assert unknown_masses(massless(robot)) == ()


def test_heads_do_not_say_that_what_is_unknown_is_0(tmp_path: Path) -> None:
    (tmp_path / "arm.urdf").write_text(urdf(WHOLE, SHAPE))
    robot = load(tmp_path / "arm.urdf", warn=lambda _: None)
    head = robodyn.generate(robot, robodyn.Options(tuple(POSES))).files(("c",))["arm.h"]
    words = " ".join(head.replace("*", " ").split())
    assert "mass, centre of mass, inertia (joint 2): absent and unknown" in words
    kernel = robodyn.compile(robot, functions=POSES)
    assert kernel.forward_kinematics([0, 0]).shape == (3, 4)
    with pytest.raises(InputError, match="nobody states"):
        robodyn.compile(robot)
