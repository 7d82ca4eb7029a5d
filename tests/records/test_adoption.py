"""A record is a robot's if it computes that robot's function, whatever the frames; and only then."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from records.made import ELBOW, arm, better, bundled, fast
from robodyn import Options, count, generate, program
from robodyn.counts import count as operations
from robodyn.dynamics.equality import equals_recursion
from robodyn.formats.arm import import_arm
from robodyn.formats.exporting import export_arm
from robodyn.ir import Input, Operation, Program
from robodyn.ir.field import Field
from robodyn.optimize.records import FOLDER, Record, best_record, identity
from robodyn.optimize.records.record import function_key
from robodyn.optimize.records.rounding import Rounding
from robodyn.optimize.records.validation import adopted
from robodyn.robot import Robot
from robodyn.robot.model import EffectEntry
from robodyn.search.improve import improved, write_record
from robodyn_testing import representative

ROBOT = arm(ELBOW)
#: The same arm, its second frame the other way round: every number that has a sign has another one.
TURNED = arm("""\
name: turned
gravity: [0.3, 0, -9.81]
links:
  - {joint: revolute, alpha: pi/2, a: 0.1, theta: pi, mass: 2, com: [-0.1, -0.2, 0.3],
     inertia: {xx: 0.2, yy: 0.3, zz: 0.4, xy: 0.01, xz: -0.02, yz: -0.03}}
  - {joint: revolute, alpha: pi/2, a: -0.4, d: 0.1, mass: 1.5, com: [-0.3, -0.05, 0.1],
     inertia: {xx: 0.1, yy: 0.2, zz: 0.25, xy: 0.02, xz: -0.01, yz: -0.04}}
""")
ONLY = Options(("inverse_dynamics",))


def offered(robot: Robot, *folders: Path, function: str = "inverse_dynamics") -> Record | None:
    draft = fast(robot, function)
    return adopted(robot, function, lambda _: draft, lambda _: Rounding(draft), folders=folders)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with the record of the elbow."""
    write_record(better(ROBOT), tmp_path / FOLDER)
    return tmp_path / FOLDER


def imported(name: str, format_name: str, folder: Path) -> Robot:
    """A bundled robot, out and in again."""
    path = folder / f"{name}.{format_name}"
    path.write_text(export_arm(bundled(name), format_name).text, encoding="utf-8")
    return import_arm(path).robot


@pytest.mark.parametrize(
    ("name", "format_name"),
    representative(
        [("ur10", "urdf"), ("panda", "urdf"), ("iiwa", "sdf"), ("stanford_full", "sdf")],
        ("ur10", "urdf"),
        ("stanford_full", "sdf"),
        rest="slow",
    ),
)
def test_imported_arms_take_what_the_bundled_ones_take(name: str, format_name: str, tmp_path: Path) -> None:
    robot = imported(name, format_name, tmp_path)
    for function in ("inverse_dynamics", "mass_matrix", "gravity"):
        own, theirs = count(robot, function), count(bundled(name), function)
        assert (own.mul, own.add, own.sincos) == (theirs.mul, theirs.add, theirs.sincos), function


def test_frames_make_no_difference(folder: Path) -> None:
    assert identity(TURNED) != identity(ROBOT)
    assert best_record(TURNED, "inverse_dynamics", "total", (folder,)) is None
    record = offered(TURNED, folder)
    assert record is not None
    assert (record.robot, record.identity) == ("turned", identity(TURNED))
    assert equals_recursion(TURNED, "inverse_dynamics", record.program)
    made = generate(TURNED, replace(ONLY, record_folders=(folder,)))
    assert made.counts["inverse_dynamics"] == operations(better(ROBOT).program)
    note = "equal to the recursion without being written like it: a test, for elbow."
    assert note in re.sub(r"\s+\*?\s*", " ", made.files()["turned.c"])


@pytest.mark.parametrize(
    "change",
    [
        {"gravity": (Fraction(3, 10), Fraction(0), Fraction(-981, 100) + Fraction(1, 10**15))},
        {"links": TURNED.links[:1]},
        {"links": (TURNED.links[0], replace(TURNED.links[1], mass=Fraction(15, 10) + Fraction(1, 10**16)))},
    ],
    ids=["gravity", "fewer joints", "a mass"],
)
def test_another_function_is_another_function(change: dict[str, Any], folder: Path) -> None:
    other = replace(TURNED, **change)
    assert offered(other, folder) is None
    assert generate(other, replace(ONLY, record_folders=(folder,))).counts["inverse_dynamics"] == operations(
        fast(other)
    )


def with_joints(robot: Robot, **changes: Any) -> Robot:
    return replace(
        robot, links=tuple(replace(link, joint=replace(link.joint, **changes)) for link in robot.links)
    )


VISCOUS, COULOMB, ROTOR = Fraction(1, 2), Fraction(3), Fraction(1, 7)


@pytest.mark.parametrize(
    ("changes", "torque", "matrix", "words"),
    [
        ({"viscous": VISCOUS}, 12, 0, ", with friction"),
        ({"viscous": VISCOUS, "coulomb": COULOMB}, 24, 0, ", with friction"),
        ({"motor_inertia": ROTOR}, 12, 6, ", with rotors"),
        ({"viscous": VISCOUS, "motor_inertia": ROTOR}, 24, 6, ", with friction and rotors"),
    ],
    ids=lambda x: " ".join(x) if isinstance(x, dict) else "",
)
def test_friction_and_rotors_are_put_on_top(
    changes: dict[str, Fraction], torque: int, matrix: int, words: str
) -> None:
    robot = with_joints(bundled("ur10"), **changes)
    draft = fast(robot, "inverse_dynamics")
    record = adopted(robot, "inverse_dynamics", lambda _: draft, lambda _: Rounding(draft))
    assert record is not None
    assert record.origin.endswith(f"for ur10{words}")
    assert operations(record.program).total == count(bundled("ur10")).total + torque
    rest = count(bundled("ur10"), "mass_matrix").total
    assert rest <= count(robot, "mass_matrix").total <= rest + matrix


def test_smooth_friction_behind_a_gear_and_loads_go_with_them_or_not(folder: Path) -> None:
    options = replace(ONLY, record_folders=(folder,))
    least = operations(better(ROBOT).program).total
    rubbing = with_joints(TURNED, viscous=VISCOUS, coulomb=COULOMB, motor_inertia=ROTOR)
    smooth = replace(rubbing, rest_velocity=Fraction(1, 1000))
    assert count(rubbing, options=options).total == least + 2 * 6
    assert count(smooth, options=options).total == least + 2 * 6 + 2  # the velocity is scaled
    assert count(replace(rubbing, torque_side="link"), options=options).total == least
    load = EffectEntry("payload", None, (("mass", Fraction(1)), ("com", (Fraction(0),) * 3)))
    assert count(replace(rubbing, effects=(load,)), options=options).total > least + 2 * 6


@pytest.mark.parametrize("harm", ["another program", "another length", "damage", "no key"])
def test_records_that_only_say_so_are_passed_over(harm: str, folder: Path) -> None:
    (path,) = folder.iterdir()
    text = path.read_text(encoding="utf-8")
    if harm == "another program":
        text = re.sub(r"(= mul \S+ )\S+", r"\1 7", text, count=1).replace("  7", " 7")
    elif harm == "another length":
        text = re.sub(r"^tau = (\S+)", r"tau = \1 \1", text, flags=re.M)
    elif harm == "damage":
        text = text.replace("= mul", "= mull")
    else:
        text = re.sub("^computes .*\n", "", text, flags=re.M)
    assert text != path.read_text(encoding="utf-8")
    path.write_text(text, encoding="utf-8")
    assert offered(TURNED, folder) is None
    made = program(TURNED, "inverse_dynamics", replace(ONLY, record_folders=(folder,)))
    assert operations(made) == operations(fast(TURNED))
    write_record(better(ROBOT), folder / "more")
    assert offered(TURNED, folder, folder / "more") is not None


def test_a_search_goes_on_from_it(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("robodyn.search.improve.climb", lambda programs, **_: list(programs))
    monkeypatch.setattr("robodyn.search.improve.search", lambda *_, **__: [])
    monkeypatch.setattr("robodyn.search.improve.closed_forms", lambda *_, **__: [])
    monkeypatch.setattr("robodyn.search.improve.kept_folder", lambda: None)
    record = improved(TURNED, level="search", seconds=0.1, processes=1, folders=(folder,))
    assert operations(record.program) == operations(better(ROBOT).program)
    assert record.identity == identity(TURNED)


def test_a_key_is_that_of_the_function() -> None:
    plain = program(ROBOT, "inverse_dynamics", replace(ONLY, optimize="none"))
    assert function_key(plain) == function_key(better(ROBOT).program) == function_key(fast(TURNED))
    renamed = replace(plain, outputs=tuple(("other", elements) for _, elements in plain.outputs))
    assert len({function_key(plain), function_key(renamed), function_key(fast(ROBOT, "bias"))}) == 3


def test_what_has_no_value_has_no_key() -> None:
    x = Input("q", 0)
    nothing = Program((Operation("sub", (x, x)), Operation("div", (x, 0))), (("tau", (1,)),))
    assert function_key(nothing) is None
    over_the_prime = Fraction(1, Field("robodyn record 1").prime)
    assert function_key(replace(nothing, outputs=(("tau", (over_the_prime,)),))) is None
