"""A forger who knows at which sizes of the inputs rounding is bounded, and in which arithmetic.

What he adds is equal as a function, harmless where it is looked at, and ruins a torque elsewhere.
"""

from __future__ import annotations

import shutil
from fractions import Fraction
from pathlib import Path
from typing import Final

import pytest

from records.made import arm, bundled, fast
from records.test_forger import QD, QDD, ROBOT, Forgery, genuine, power, written
from robodyn import InputError, Options, load, program
from robodyn.dynamics.equality import same_in_field
from robodyn.ir import Input, Operand
from robodyn.ir.signature import ScalarType
from robodyn.optimize.records import Record, best_record
from robodyn.optimize.records.rounding import Rounding
from robodyn.robot import Robot

SLIDING: Final = Input("q", 2)  # the prismatic joint of ROBOT
#: A slender last link, which may have a run-time parameter for its mass, and smooth friction.
SLENDER: Final = """\
name: slender
links:
  - {{joint: revolute, mass: 3, com: [0.1, 0, 0.2], inertia: {{zz: 0.25}}, friction: {{coulomb: 4}}}}
  - {{joint: revolute, alpha: pi/2, a: 0.4, mass: {mass}, com: [0.001, 0, 0.003], inertia: {{zz: 1e-6}}}}
{more}
"""
SMOOTH: Final = "friction_at_rest: {{smooth: {{velocity: {velocity}}}}}"


def slender(mass: str = "0.02", more: str = "") -> Robot:
    return arm(SLENDER.format(mass=mass, more=more))


def noise(forged: Forgery, output: int, size: Operand) -> None:
    """An output plus ``size`` and minus it."""
    elements = list(forged.elements)
    elements[output] = forged.add("sub", forged.add("add", elements[output], size), size)
    forged.elements = tuple(elements)


def finished(forged: Forgery, robot: Robot, function: str = "inverse_dynamics") -> Record:
    made = forged.program(forged.add("mul", Fraction(0), QD))
    assert same_in_field(robot, function, made), "it is equal as a function"
    return written(robot, made, function)


def check_refused(
    record: Record, robot: Robot, functions: tuple[str, ...] = (), scalar: ScalarType = "double"
) -> None:
    for function in functions or (record.function,):
        with pytest.raises(InputError, match=f"does not compute its {record.function}"):
            program(robot, function, Options((function,), records=(record,), scalar=scalar))


@pytest.mark.parametrize("function", ["inverse_dynamics", "gravity", "bias"])
def test_a_parameter_that_is_not_one(function: str) -> None:
    """(tau + m^128) - m^128 is tau at 1 kg, 0 at 2 kg, and no number at 300 kg."""
    robot = slender("m_last")
    forged = Forgery(fast(robot))
    noise(forged, 0, power(forged, Input("m_last", None), 7))
    check_refused(finished(forged, robot), robot, (function,))


@pytest.mark.parametrize("x", [QD, QDD, Input("q", 0), SLIDING], ids=str)
def test_powers_that_are_small_where_they_are_looked_at(x: Input) -> None:
    """Even if they are read in a sine, so that they might be taken for an angle, of a turn at most."""
    for is_called_an_angle in (False, True):
        forged = Forgery(genuine())
        noise(forged, 0, power(forged, forged.add("mul", Fraction(1, 7), x), 6))
        if is_called_an_angle:
            noise(forged, 1, forged.add("sin", x))
        check_refused(finished(forged, ROBOT), ROBOT, ("inverse_dynamics", "gravity", "bias"))


def test_the_noise_of_a_long_axis() -> None:
    """No higher degree than the recursion, and as much as the torque at some metres."""
    for size in ("1e8", "1e12"):
        forged = Forgery(genuine())
        square = forged.add("mul", SLIDING, SLIDING)
        noise(forged, 0, forged.add("mul", Fraction(size), square))
        check_refused(finished(forged, ROBOT), ROBOT)


@pytest.mark.parametrize(
    "factors", [("1e30", "1e30", "1e-30", "1e-30"), ("1e-25", "1e-25", "1e25", "1e25")], ids=str
)
def test_what_only_a_double_can_bear(factors: tuple[str, ...]) -> None:
    forged = Forgery(genuine())
    x: Operand = forged.elements[0]
    for factor in factors:
        x = forged.add("mul", Fraction(factor), x)
    forged.elements = (x, *forged.elements[1:])
    record = finished(forged, ROBOT)
    check_refused(record, ROBOT, scalar="float")


@pytest.mark.parametrize(("velocity", "size"), [("0.001", 1e7), ("1e-9", 1e13), ("1e-12", 1e16)], ids=str)
@pytest.mark.parametrize("scalar", ["double", "float"])
def test_steep_friction_allows_nothing(velocity: str, size: float, scalar: ScalarType) -> None:
    robot = slender(more=SMOOTH.format(velocity=velocity))
    forged = Forgery(fast(robot))
    for output in (0, 1):
        noise(forged, output, Fraction(size))
    check_refused(finished(forged, robot), robot, scalar=scalar)


def test_the_small_elements_of_a_mass_matrix() -> None:
    """(M22 + 170 cos q2) - 170 cos q2 is 0 in single precision, and is divided by."""
    robot = slender()
    recursion = program(robot, "mass_matrix", Options(("mass_matrix",), optimize="fast"))
    forged = Forgery(recursion)
    noise(forged, 3, forged.add("mul", Fraction(170), forged.add("cos", Input("q", 1))))
    record = finished(forged, robot, "mass_matrix")
    for function in ("mass_matrix", "forward_dynamics"):
        check_refused(record, robot, (function,), scalar="float")
        check_refused(record, robot, (function,))


@pytest.mark.parametrize("hidden", ["moving", "resting"])
def test_constants_that_grow_while_nobody_looks(hidden: str) -> None:
    """Constants of 480 digits, raised to the 256th power once nothing moves: ``gen`` did not end."""
    forged = Forgery(genuine())
    constants = [Fraction(10**480 + k, 2 * 10**480 + k + 2) for k in (7, 11)]
    powers: list[Operand] = []
    for k, constant in enumerate(constants):
        small: Operand = forged.add("mul", Fraction(1, 10**12), Input("qdd", k + 1))
        if hidden == "resting":
            small = forged.add("mul", Fraction(0), forged.add("cos", Input("q", 1)))
        powers.append(power(forged, forged.add("add", small, constant), 8))
    total = powers[0]
    for k in range(30):
        total = forged.add("sub" if k % 2 else "add", total, powers[1])
    noise(forged, 0, total)
    record = written(ROBOT, forged.program(forged.add("mul", Fraction(0), QD)))
    check_refused(record, ROBOT, ("inverse_dynamics", "gravity", "bias"))


def test_many_files_beside_a_robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each is opened for its head: 40,000 took seconds. The one with the robot's name comes first."""
    assert ROBOT.file is not None
    shutil.copy(ROBOT.file, tmp_path / "arm.yaml")
    robot = load(tmp_path / "arm.yaml", warn=lambda _: None)
    folder = tmp_path / "records"
    folder.mkdir()
    record = best_record(ROBOT, "inverse_dynamics")
    assert record is not None
    (folder / f"{robot.name}.inverse_dynamics.total.record").write_text(record.text())
    for k in range(1500):
        (folder / f"a{k}.inverse_dynamics.total.record").write_text("identity: none\n")
    reads = 0
    whole = Path.open

    def counted(self: Path, *args: object, **kwargs: object) -> object:
        nonlocal reads
        reads += self.suffix == ".record"
        return whole(self, *args, **kwargs)  # type: ignore[call-overload]

    monkeypatch.setattr(Path, "open", counted)
    found = best_record(robot, "inverse_dynamics")
    assert found is not None
    assert found.program == record.program
    assert reads <= 2
    assert best_record(robot, "gravity") is None
    (folder / f"{robot.name}.inverse_dynamics.total.record").unlink()
    reads = 0
    assert best_record(robot, "inverse_dynamics") is not None, "the bundled one"
    assert reads <= 1100


@pytest.mark.parametrize("name", ["puma560", "tx40"])
@pytest.mark.parametrize("scalar", ["double", "float"])
def test_shipped_records_lose_little(name: str, scalar: ScalarType) -> None:
    robot = bundled(name)
    for function in ("inverse_dynamics", "mass_matrix"):
        record = best_record(robot, function)
        if record is not None:
            recursion = program(robot, function, Options((function,), optimize="fast"))
            rounding = Rounding(recursion, scalar)
            assert rounding.reads_as(record.program)
            assert rounding.allows(record.program)
