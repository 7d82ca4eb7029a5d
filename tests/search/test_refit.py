"""Programs of one arm made into those of another that is built alike; and the algebra that it takes."""

from __future__ import annotations

import math
import random
from dataclasses import replace
from fractions import Fraction

import pytest

from records.made import ELBOW, arm, better, bundled
from robodyn.counts import count
from robodyn.dynamics.equality import same_in_field
from robodyn.ir import Program
from robodyn.optimize.programs import Choice, build
from robodyn.robot import Robot
from robodyn.robot.model import EffectEntry
from robodyn.search.improve import improved
from robodyn.search.modular import Elimination, fraction_of, value_at_one
from robodyn.search.refit import refitted
from robodyn.search.transfer import _between, transferred

PRIME = 2**607 - 1
INVERSE = "inverse_dynamics"
ROBOT = arm(ELBOW)
#: The elbow with other numbers.
OTHER = arm("""\
name: other
gravity: [0.3, 0, -9.81]
links:
  - {joint: revolute, alpha: pi/2, a: 0.17, mass: 2.3, com: [0.11, 0.22, 0.34],
     inertia: {xx: 0.21, yy: 0.31, zz: 0.44, xy: 0.012, xz: 0.021, yz: 0.033}}
  - {joint: revolute, alpha: -pi/2, a: 0.41, d: 0.13, mass: 1.7, com: [0.33, 0.057, 0.12],
     inertia: {xx: 0.11, yy: 0.23, zz: 0.27, xy: 0.022, xz: 0.011, yz: 0.041}}
""")


def path(one: Robot, other: Robot, function: str = INVERSE) -> list[Program]:
    return [build(_between(one, other, t), function, Choice()) for t in range(4)]


def nearly(name: str, **changes: Fraction) -> Robot:
    """A bundled arm whose third link has its centre elsewhere, by an amount that no search would notice."""
    robot = bundled(name)
    x, y, z = robot.links[2].com
    third = replace(robot.links[2], com=(x + Fraction(1, 10**15), y, z))
    links = [*robot.links[:2], third, *robot.links[3:]]
    joints = [replace(link, joint=replace(link.joint, **changes)) for link in links]  # type: ignore[arg-type]
    return replace(robot, links=tuple(joints), file=None)


def test_other_constants_make_it_the_program_of_another_arm() -> None:
    program = better(ROBOT).program
    refit = refitted(program, path(ROBOT, OTHER), math.inf)
    assert refit is not None
    assert same_in_field(OTHER, INVERSE, refit)
    assert not same_in_field(ROBOT, INVERSE, refit)
    assert [operation.op for operation in refit.operations] == [op.op for op in program.operations]


def test_where_operations_are_missing_there_are_no_constants() -> None:
    """The record leaves out what is zero in its own arm."""
    thin = replace(ROBOT.links[1], com=(Fraction(3, 10), Fraction(0), Fraction(0)))
    simple = replace(ROBOT, links=(ROBOT.links[0], thin))
    program = build(simple, INVERSE, Choice())
    assert refitted(program, path(simple, OTHER), math.inf) is None
    assert refitted(program, path(OTHER, simple), math.inf) is None  # it is another arm's
    assert refitted(program, path(simple, simple), 1.0, clock=lambda: 2.0) is None  # time is over
    assert refitted(program, path(simple, simple), math.inf) == replace(program, origin=None)


@pytest.mark.parametrize("function", [INVERSE, "mass_matrix"])
def test_an_arm_takes_as_many_operations_as_a_bundled_one_that_is_built_alike(function: str) -> None:
    robot = nearly("ur10")
    programs = list(transferred(robot, function, math.inf))
    assert programs
    assert all(same_in_field(robot, function, program) for program in programs)
    assert min(count(program).total for program in programs) == (185 if function == INVERSE else 66)


def test_friction_is_put_on_top() -> None:
    robot = nearly("ur10", viscous=Fraction(1, 2), coulomb=Fraction(3))
    program = next(transferred(robot, INVERSE, math.inf))
    assert same_in_field(robot, INVERSE, program)
    assert count(program).total == 185 + 4 * 6


def test_nothing_is_alike() -> None:
    robot = nearly("ur10")
    assert list(transferred(robot, INVERSE, -math.inf)) == []
    turned = replace(robot.links[0].joint, kind="prismatic")
    assert list(transferred(replace(robot, links=(replace(robot.links[0], joint=turned), *robot.links[1:])),
                            INVERSE, math.inf)) == []  # fmt: skip
    load = EffectEntry("payload", None, (("mass", Fraction(1)), ("com", (Fraction(0),) * 3)))
    assert list(transferred(replace(robot, effects=(load,)), INVERSE, math.inf)) == []


def test_a_search_begins_from_there(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("robodyn.search.improve.climb", lambda programs, **_: list(programs))
    monkeypatch.setattr("robodyn.search.improve.search", lambda *_, **__: [])
    monkeypatch.setattr("robodyn.search.improve.kept_folder", lambda: None)
    robot = nearly("ur10")
    assert count(improved(robot, level="search", seconds=20, processes=1).program).total == 185
    assert count(improved(robot, level="search", seconds=20, processes=1, resume=False).program).total > 185


# --- algebra ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("digits", [1, 10, 80])
def test_a_fraction_is_told_from_its_image(digits: int) -> None:
    chance = random.Random(digits)
    for _ in range(20):
        x = Fraction(chance.randint(-(10**digits), 10**digits), chance.randint(1, 10**digits))
        image = x.numerator * pow(x.denominator, -1, PRIME) % PRIME
        assert fraction_of(image, PRIME) == x
    assert [fraction_of(chance.randrange(PRIME), PRIME) for _ in range(20)] == [None] * 20


def series_of(top: list[int], bottom: list[int], length: int) -> list[int]:
    """The power series of a quotient of polynomials; ``bottom[0]`` is 1."""
    series: list[int] = []
    for k in range(length):
        x = top[k] if k < len(top) else 0
        x -= sum(bottom[j] * series[k - j] for j in range(1, min(k, len(bottom) - 1) + 1))
        series.append(x % PRIME)
    return series


@pytest.mark.parametrize(
    ("top", "bottom"),
    [([3], [1]), ([0, 0, 5], [1]), ([1], [1, 2]), ([3, 1, 4], [1, -5, 9, 2]), ([2, 7], [1, 3])],
)
def test_a_rational_function_is_told_from_its_series(top: list[int], bottom: list[int]) -> None:
    image = value_at_one(series_of(top, bottom, 10), PRIME)
    assert image is not None
    assert fraction_of(image, PRIME) == Fraction(sum(top), sum(bottom))


def test_a_series_that_is_too_short_tells_nothing() -> None:
    exponential = [pow(math.factorial(k), -1, PRIME) for k in range(12)]
    assert value_at_one(exponential, PRIME) is None
    assert value_at_one(series_of([1], [1, -1], 10), PRIME) is None, "a pole at 1"


def test_a_system_is_solved_or_has_no_solution() -> None:
    chance = random.Random(2)
    rows = [[chance.randrange(PRIME) for _ in range(3)] for _ in range(3)]
    rows = [[*row, sum(row) % PRIME, row[0]] for row in rows]  # the last two depend on the others
    rows.append([sum(column) % PRIME for column in zip(*rows, strict=True)])
    system = Elimination(5, PRIME)
    assert [system.add(row) for row in rows] == [True, True, True, False]
    solution = system.solve([1, 2, 3, 6])
    assert solution is not None
    assert [sum(x * y for x, y in zip(row, solution, strict=True)) % PRIME for row in rows] == [1, 2, 3, 6]
    assert solution[3:] == [0, 0], "unknowns that depend on those before stay as they are"
    assert system.solve([1, 2, 3, 7]) is None
