"""Gravity by first moments: equal to the plain recursion whichever way it points and whatever is known at run
time only; and fewer operations than the recursion at rest."""

from __future__ import annotations

import pytest

from robodyn.counts import count
from robodyn.dynamics.equality import same_in_field
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.dynamics.lump import NO_LUMP
from robodyn.dynamics.weights import weighed
from robodyn.ir.graph import Graph
from robodyn.kernels.generate import Options, program
from robodyn.optimize.programs import Choice, build, recursion_in
from robodyn.robot import Robot, read_text
from robodyn.robot.bundled import load

#: A slide behind parallel joints, one of them upside down; friction, rotors and, where asked for, names.
ARM = """\
name: leaning
gravity: {gravity}
links:
  - {{joint: revolute, d: 0.3, mass: 3, com: [0.1, 0.2, 0.3], motor_inertia: 0.1}}
  - {{joint: revolute, alpha: -pi/2, a: 0.1, mass: {mass}, com: [0.1, 0, 0.2], {friction}}}
  - {{joint: revolute, alpha: pi, a: 0.2, d: 0.05, theta: pi/2, mass: 1, com: [0, 0.1, 0.1], {friction}}}
  - {{joint: prismatic, alpha: 0.4, a: 0.2, d: 0.1, mass: 1.5, com: [0.1, 0, 0]}}
  - {{joint: revolute, alpha: pi/2, d: 0.2, theta: 0.3, mass: 0.5, com: [0, 0.2, 0.1]}}
"""
FRICTION = "friction: {viscous: 0.2, coulomb: 0.3}"
GRAVITIES = ("[0, 0, -9.81]", "[1.5, -3, 2]", "[0, 9.8, 0]", "[0, 0, 0]")


def arm(gravity: str, mass: str = "2") -> Robot:
    return read_text(ARM.format(gravity=gravity, mass=mass, friction=FRICTION))


@pytest.mark.parametrize("mass", ["2", "load"])
@pytest.mark.parametrize("gravity", GRAVITIES)
@pytest.mark.parametrize("function", ["gravity", "potential_energy", "momentum_observer_term"])
def test_each_way_to_write_it_is_right(function: str, gravity: str, mass: str) -> None:
    robot, known = arm(gravity, mass), FUNCTIONS[function]
    for writing in (*known.writings(robot.n), *known.of_rigid_arms):
        assert same_in_field(robot, function, build(robot, function, Choice(), writing))


def test_a_component_of_gravity_is_one_and_the_product_stays() -> None:
    graph, robot = Graph(), arm("[1.5, -3, 2]")
    inputs = {"q": [graph.input("q", i) for i in range(robot.n)]}
    recursion = recursion_in(graph, robot, Choice(), inputs)
    links = recursion.links(recursion.rest, recursion.rest)
    light = weighed(links)
    assert max(map(abs, light.arm.gravity)) == 1
    for lump, weight in zip(links.lumps, light.lumps, strict=True):
        for g, unit in zip(links.arm.gravity, light.arm.gravity, strict=True):
            assert [g * h for h in (lump.mass, *lump.first)] == [
                unit * h for h in (weight.mass, *weight.first)
            ]
    assert NO_LUMP not in light.lumps


@pytest.mark.parametrize("name", ["panda", "rx90", "stanford"])
def test_it_takes_fewer_operations_than_the_recursion_at_rest(name: str) -> None:
    robot = load(name, warn=lambda _: None)
    known = FUNCTIONS["gravity"]
    both = [
        count(build(robot, "gravity", Choice(), way)).total for way in (known.outputs, *known.of_rigid_arms)
    ]
    assert both[1] < both[0]
    assert count(program(robot, "gravity", Options(("gravity",)))).total <= both[1]
