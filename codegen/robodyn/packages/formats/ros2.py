"""ROS 2: an ament package with a plugin for ``inverse_dynamics_solver``, and the plain header.

The plugin has a place for friction of velocities alone, and holds the arm against another description of it.
"""

from __future__ import annotations

import random
from dataclasses import dataclass
from typing import Final, Literal

from robodyn.emit.languages.c import LANGUAGE as C
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input
from robodyn.packages.format import Files, Format, Package
from robodyn.packages.writing import arithmetic_flags, readme, rendered, sources
from robodyn.robot.coupling import no_couplings
from robodyn.robot.model import Robot
from robodyn.robot.values import Affine

#: Joint positions [rad, m], one joint after another, at which no two axes are parallel by chance.
REFERENCE_POSITIONS: Final = (0.4, -0.7, 0.9, 0.3, -0.5, 0.8, -0.6)
#: What two descriptions of one arm may differ by, such as nominal and calibrated: the cosine of the angle
#: between two axes, and the distance between two axes [m].
SAME_AXES: Final = (0.02, 0.01)


@dataclass(frozen=True, slots=True)
class Axis:
    """Of a joint at ``position`` [rad or m]: ``origin`` [m], a point of it, and its ``direction``, a unit
    vector, along the axes of the world."""

    position: float
    origin: tuple[float, ...]
    direction: tuple[float, ...]


def axes_of(robot: Robot) -> tuple[Axis, ...]:
    """The axes of ``robot`` base to tip, at positions of no symmetry; none where run-time parameters decide
    where they lie."""
    from robodyn.simulate.kinematics import Kinematics

    no_couplings(robot, "a package for ROS 2")

    if any(isinstance(x, Affine) for link in robot.links for x in (link.joint.a, link.joint.b, link.joint.d)):
        return ()
    q = [REFERENCE_POSITIONS[i % len(REFERENCE_POSITIONS)] for i in range(robot.n)]
    origins, rotations = Kinematics(robot, dict.fromkeys(robot.parameters, 1.0)).frames(q)
    return tuple(
        Axis(position, tuple(map(float, origin)), tuple(map(float, rotation[:, 2])))
        for position, origin, rotation in zip(q, origins, rotations, strict=True)
    )


#: Share of an arm's largest torque that is taken for rounding where friction at two positions is compared.
SAME_FRICTION: Final = 1e-9
#: States at which it is compared, and the largest velocity there [rad/s, m/s].
FRICTION_STATES: Final = 8
FRICTION_VELOCITY: Final = 2.0
#: None there is, of the velocities alone, or of more, as of the load that a bearing carries.
Dependence = Literal["none", "velocities", "positions"]
#: What friction is worked out of: the bias less the other two.
FUNCTIONS = ("bias", "coriolis", "gravity")


def friction_of(package: Package) -> Dependence:
    """What the friction in the torques of ``package`` depends on, which has :data:`FUNCTIONS`: it is compared
    at random states, with random run-time parameters, between each position and zero."""
    draw = random.Random(0)
    n = package.robot.n
    answer: Dependence = "none"
    for _ in range(FRICTION_STATES):
        qd = [draw.uniform(-FRICTION_VELOCITY, FRICTION_VELOCITY) for _ in range(n)]
        parameters = {name: draw.uniform(0.5, 1.5) for name in package.parameters}
        here, scale = _friction(package, [draw.uniform(-1, 1) for _ in range(n)], qd, parameters)
        at_zero, other = _friction(package, [0.0] * n, qd, parameters)
        rounding = SAME_FRICTION * max(scale, other)
        if any(abs(x - y) > rounding for x, y in zip(here, at_zero, strict=True)):
            return "positions"
        if any(abs(x) > rounding for x in at_zero):
            answer = "velocities"
    return answer


def _friction(
    package: Package, q: list[float], qd: list[float], parameters: dict[str, float]
) -> tuple[list[float], float]:
    """The friction [N m, N] at a state, and the largest torque there."""
    inputs = {Input(name, None): value for name, value in parameters.items()}
    for name, values in (("q", q), ("qd", qd)):
        inputs |= {Input(name, i): value for i, value in enumerate(values)}
    programs = {signature.function: program for signature, program in package.generated.unit.functions}
    (bias, rest, still) = (
        next(iter(evaluate(programs[function], inputs).values())) for function in FUNCTIONS
    )
    friction = [float(h - c - g) for h, c, g in zip(bias, rest, still, strict=True)]
    return friction, max(abs(float(torque)) for torque in (*bias, *rest, *still))


_TEXTS: Final = ("package.xml", "CMakeLists.txt", "plugins.xml")
_SOURCES: Final = ("solver.cpp", "settings.hpp", "settings.cpp", "axes.hpp", "axes.cpp")
_TEMPLATES: Final = {name: f"{name}.j2" for name in _TEXTS} | {f"src/{x}": f"{x}.j2" for x in _SOURCES}
#: What the methods of the interface call.
_NEEDS: Final = tuple(dict.fromkeys(("inverse_dynamics", "mass_matrix", *FUNCTIONS)))


def _files(package: Package) -> Files:
    robot = package.robot
    about = {"friction": friction_of(package), "gravity": [repr(float(g)) for g in robot.gravity]}
    names = [link.name.replace("\\", "\\\\").replace('"', '\\"') for link in robot.links]  # as C++ has them
    joints = [(f'"{name}"', link.joint.kind) for name, link in zip(names, robot.links, strict=True)]
    model = {"joints": joints, "axes": axes_of(robot), "same": SAME_AXES}
    return {
        **readme(package, **about),
        **rendered(package, _TEMPLATES, flags=arithmetic_flags(package), **model, **about),
        **sources(package, headers=f"include/{package.name}"),
    }


FORMAT = Format(
    name="ros2",
    title="a ROS 2 package",
    tool="ROS 2 with inverse_dynamics_solver 1.0 (Humble), 2.0 (Jazzy) or 6.0 (Rolling)",
    language=C,
    files=_files,
    take="colcon build --base-paths {folder}",
    functions=_NEEDS,
    needs=_NEEDS,
    lacks=frozenset({"memory", "given sines"}),
    called=lambda robot: f"{robot}_dynamics".lower(),  # as ROS has it (REP 144)
)
