"""The recursions run directly on ``Fraction``s, without a graph, and arms to run them on."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, Final

from hypothesis import Phase

from ir.programs import Point
from robodyn.dynamics.arm import Arm, JointAngle, Motion, build_arm, build_motion
from robodyn.dynamics.functions import INPUTS
from robodyn.dynamics.vectors import Mark, unmarked
from robodyn.ir import Input, Label
from robodyn.optimize.programs import Choice, outputs_of
from robodyn.robot import Robot
from robodyn.robot.values import Value, parameter
from robodyn_testing.random_robots import random_robot

#: For properties of random arms: a smaller seed is no simpler arm, and looking for one takes minutes.
NO_SHRINKING: Final = (Phase.explicit, Phase.reuse, Phase.generate)


class State:
    """A robot at a rational point, over ``Fraction``s; ``qd`` and ``qdd`` may be given."""

    def __init__(
        self,
        robot: Robot,
        at: Point,
        qd: Sequence[Fraction | int] | None = None,
        qdd: Sequence[Fraction | int] | None = None,
    ) -> None:
        self.robot, self.at = robot, at
        self.arm: Arm = build_arm(robot, lambda x: x, lambda name: at.number(Input(name, None)))
        self.given: dict[str, list[Any]] = {
            array.name: [at.number(Input(array.name, i)) for i in range(array.size_at(robot.n))]
            for array in INPUTS
        }
        if qd is not None:
            self.given["qd"] = list(qd)
        if qdd is not None:
            self.given["qdd"] = list(qdd)

    def trigonometry(self, angle: JointAngle) -> tuple[Fraction, Fraction]:
        """Cosine and sine of an angle at the point."""
        cosine, sine = angle.offset.cos, angle.offset.sin
        for joint, sign in angle.terms:
            c, s = self.at.circle(Input("q", joint))
            cosine, sine = cosine * c - sign * sine * s, sine * c + sign * cosine * s
        return cosine, sine

    def motion(self, arm: Arm | None = None) -> Motion:
        """The motion, of ``arm`` where it is not the robot's own."""
        q, qd, qdd = (self.given[name] for name in ("q", "qd", "qdd"))
        return build_motion(arm or self.arm, q, qd, qdd, self.trigonometry, lambda x: x)

    def outputs(
        self, function: str, choice: Choice, mark: Mark = unmarked, arm: Arm | None = None
    ) -> list[Fraction]:
        """The outputs of a kernel, its recursion run on fractions."""
        return outputs_of(function, arm or self.arm, choice, self.given, self.trigonometry, lambda x: x, mark)

    def numbers(self) -> dict[Input, Fraction]:
        """Values of the inputs in this state, for a program."""
        return {
            Input(name, i): Fraction(x) for name, values in self.given.items() for i, x in enumerate(values)
        }


class Recorder:
    """A mark that notes what value the recursion gives each name."""

    def __init__(self) -> None:
        self.values: dict[Label, list[Any]] = {}

    @property
    def mark(self) -> Mark:
        """The mark to run a recursion with."""

        def note(value: Any, label: Label) -> Any:
            self.values.setdefault(label, []).append(value)
            return value

        return note


def exact_arm(seed: int, **choices: Any) -> Robot:
    """A random arm whose friction is exact at rest: without tanh all of it is rational."""
    return replace(random_robot(seed, **{"aside": 0.4, **choices}), rest_velocity=None)


def with_named_numbers(robot: Robot, chosen: Callable[[str], bool] = lambda name: True) -> Robot:
    """``robot`` with its numbers, zeros too, replaced by run-time parameters (those that are ``chosen``)."""

    def name(text: str, value: Value) -> Value:
        return parameter(text) if chosen(text) else value

    links = []
    for i, link in enumerate(robot.links, 1):
        joint = link.joint
        given: dict[str, Any] = {
            key: name(f"{key}_{i}", getattr(joint, key))
            for key in ("a", "b", "d", "motor_inertia", "viscous", "coulomb")
        }
        entries = {
            key: name(f"i{key}_{i}", getattr(link.inertia, key))
            for key in ("xx", "yy", "zz", "xy", "xz", "yz")
        }
        x, y, z = (name(f"com_{axis}_{i}", value) for axis, value in zip("xyz", link.com, strict=True))
        links.append(
            replace(
                link,
                joint=replace(joint, **given),
                mass=name(f"mass_{i}", link.mass),
                com=(x, y, z),
                inertia=replace(link.inertia, **entries),
            )
        )
    return replace(robot, links=tuple(links))


def values_of(named: Robot, robot: Robot) -> dict[Input, Fraction]:
    """The numbers of ``robot`` under the names that ``named`` has in their place."""
    found: dict[Input, Fraction] = {}
    for value, number in zip(named.values(), robot.values(), strict=True):
        if value != number:
            ((name, _),) = value.terms  # type: ignore[union-attr]
            assert isinstance(number, Fraction)
            found[Input(name, None)] = number
    return found
