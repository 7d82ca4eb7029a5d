"""Kernels of arms whose joints follow others: by references that map on their own; counts and refusals."""

from __future__ import annotations

import random
from fractions import Fraction

import numpy as np
import pytest

import robodyn
from robodyn.dynamics.equality import same_in_field
from robodyn.errors import InputError
from robodyn.firmware.vectors import states_of, vectors
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input
from robodyn.kernels.generate import Generated, Options, generate, maker
from robodyn.kernels.through_sympy import symbolic
from robodyn.robot.model import Robot
from robodyn.robot.reader import read_text
from robodyn.verify import VerifyReport, verify
from robodyn.verify.coupled import Following
from robodyn.verify.oracles import exact_oracle
from robodyn_testing import require_tool
from robodyn_testing.coupled_files import MIXED, PALLETIZER

ALL = ("all",)
DRIVES = {
    "ripple and spring": "effects: [{effect: torque_ripple, amplitude: 0.4, cycles_per_rev: 3, phase: 0.1}, "
    "{effect: spring, stiffness: 3, rest: 0.2}], ",
    "bearing": "effects: [{effect: load_dependent_friction, bearing: thrust, mu: 0.1, radius: 0.05}], ",
}


def totals(made: Generated) -> dict[str, int]:
    return {function: count.total for function, count in made.counts.items()}


def test_a_level_axis_makes_every_function_cheaper() -> None:
    robot = read_text(PALLETIZER)
    options = Options(
        functions=("inverse_dynamics", "gravity", "mass_matrix", "forward_dynamics", "jacobian")
    )
    coupled, free = (totals(generate(arm, options)) for arm in (robot, robot.free))
    assert all(coupled[function] < free[function] for function in free)
    assert coupled["inverse_dynamics"] <= 230  # 310 of the same arm with five motors
    made = generate(robot, Options(functions=("forward_kinematics",)))
    assert made.counts["forward_kinematics"].sincos == 8  # of four angles: the level axis has none


@pytest.mark.parametrize(("ratio", "offset"), [("1", "0"), ("-1", "0"), ("1", "pi/2")])
def test_ratios_of_one_and_quarter_turns_only_add_up(ratio: str, offset: str) -> None:
    """What two joints feel is added up, in each element of a result; no sine is turned further."""
    text = PALLETIZER[: PALLETIZER.index("couplings:")]
    robot = read_text(text + f"couplings: [{{joint: upper, of: lower, ratio: {ratio}, offset: {offset}}}]")
    m = len(robot.commanded)
    options = Options(functions=("inverse_dynamics", "mass_matrix"))
    coupled, free = (generate(arm, options).counts for arm in (robot, robot.free))
    for function, elements in (("inverse_dynamics", m), ("mass_matrix", m * (m + 1) // 2)):
        assert coupled[function].total <= free[function].total + elements
        assert coupled[function].sincos <= free[function].sincos


def verified(robot: Robot) -> VerifyReport:
    """How all functions compare, each with a reference at least."""
    require_tool("cc")
    kernel = robodyn.compile(robot, functions=ALL)
    assert all(signature.joints == len(robot.commanded) for signature in kernel.signatures.values())
    report = verify(robot, kernel, states=25, exact_states=2, lagrangian=False)
    assert not report.uncompared
    assert {row.function for row in report.comparisons} == set(kernel.functions)
    return report


@pytest.mark.thorough
@pytest.mark.parametrize("text", [PALLETIZER, MIXED])
def test_every_function_is_what_independent_references_say(text: str) -> None:
    report = verified(read_text(text))
    assert report.passed, report.to_text()


@pytest.mark.thorough
@pytest.mark.parametrize("drives", DRIVES)
def test_effects_at_followers_act_there(drives: str) -> None:
    report = verified(read_text(MIXED.replace("{name: c, ", f"{{name: c, {DRIVES[drives]}")))
    assert report.passed, report.to_text()


def test_a_wrong_mapping_is_noticed() -> None:
    """Programs of an arm whose coupling is another one: another sign, no offset, another leader."""
    robot = read_text(MIXED)
    for old, new in (("ratio: -1/3", "ratio: 1/3"), ("offset: 0.25", "offset: 0"), ("of: b, r", "of: c, r")):
        other = read_text(MIXED.replace(old, new))
        for function in ("inverse_dynamics", "mass_matrix", "jacobian", "forward_kinematics"):
            program = maker(other, Options(optimize="fast")).program(function)
            assert same_in_field(other, function, program)
            assert not same_in_field(robot, function, program), (new, function)


def test_the_exact_reference_is_the_mapped_one() -> None:
    robot = read_text(PALLETIZER)
    at, u = Following.of(robot), np.array([[0.1, 0.2, 0.3, 0.4]])
    assert at.joints(u) == pytest.approx(np.array([[0.1, 0.2, 0.3, np.pi / 2 - 0.5, 0.4]]))
    exact = exact_oracle(robot, {}).torque(u, u, u).astype(float)
    beneath = exact_oracle(robot.free, {}).torque(at.joints(u), at.spread(u), at.spread(u)).astype(float)
    assert exact == pytest.approx(beneath @ at.G)


@pytest.mark.parametrize("function", ["inverse_dynamics", "mass_matrix", "jacobian", "link_poses"])
@pytest.mark.parametrize("text", [PALLETIZER, MIXED])
def test_sympy_has_the_same_formulas(text: str, function: str) -> None:
    robot, chance = read_text(text), random.Random(function)
    model = symbolic(robot, function)
    known = {
        symbol: Fraction(chance.randint(-99, 99), 64)
        for symbols in (*model.inputs.values(), model.parameters.values())
        for symbol in symbols
    }
    inputs = {
        Input(array, k): float(known[symbol])
        for array, symbols in model.inputs.items()
        for k, symbol in enumerate(symbols)
    } | {Input(name, None): float(known[symbol]) for name, symbol in model.parameters.items()}
    values = {symbol: float(x) for symbol, x in known.items()}
    for symbol, expression in model.steps:
        values[symbol] = float(expression.subs(values))
    written = [float(result.subs(values)) for result in model.results]
    program = maker(robot, Options(optimize="fast")).program(function)
    results = [x for row in evaluate(program, inputs).values() for x in row]
    assert written == pytest.approx(results, abs=1e-9)


def test_what_is_solved_for_is_not_written_through_sympy() -> None:
    with pytest.raises(InputError, match="forward_dynamics through sympy cannot do joints that follow"):
        symbolic(read_text(PALLETIZER), "forward_dynamics")


def test_vectors_of_firmware_are_confirmed_by_exact_torques() -> None:
    robot = read_text(PALLETIZER)
    made = generate(robot, Options(functions=("inverse_dynamics",)))
    ((interface, program),) = made.unit.functions
    states = states_of(robot, interface, program, {})
    assert vectors(robot, interface.function, program, states, {}, "double").confirmed


def test_files_say_what_the_coordinates_are() -> None:
    text = generate(read_text(PALLETIZER), Options(functions=("inverse_dynamics", "link_poses"))).files(["c"])
    head = " ".join(text["palletizer.h"].replace("*", " ").split())
    assert "Coordinates, which arrays have an element for: waist, lower, upper, hand" in head
    assert "level = -1 lower -1 upper +1.570796327 rad" in head
    assert "tau[4]" in head
    assert "link_positions[15]" in head


def test_gears_count_at_joints_that_are_commanded() -> None:
    robot = read_text(MIXED)
    made = generate(robot, Options(functions=("motor_torque",)))
    assert made.signatures[0].outputs == (("tau_motor", 2),)
    two = MIXED.replace("{name: b, ", "{name: b, gear: {ratio: 3}, ")
    with pytest.raises(InputError, match="a gear at joint 2, which follows another"):
        generate(read_text(two), Options(functions=("motor_torque",)))


@pytest.mark.parametrize(
    "options",
    [
        Options(functions=("inverse_kinematics",)),
        Options(optimize="full"),
        Options(engine="sympy"),
    ],
)
def test_what_there_is_not_yet_is_said(options: Options) -> None:
    with pytest.raises(InputError, match="follow others"):
        generate(read_text(PALLETIZER), options)


def test_memory_at_joints_that_follow_is_refused() -> None:
    text = MIXED.replace("{name: c, ", "{name: c, effects: [{effect: backlash, gap: 1e-3, stiffness: 1e4}], ")
    with pytest.raises(InputError, match="effects that remember"):
        generate(read_text(text))
