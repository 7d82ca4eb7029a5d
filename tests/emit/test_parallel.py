"""Parallel C from schedules, and the packed form: the serial bits, no races, strict compilers content."""

from __future__ import annotations

import itertools
import subprocess
from pathlib import Path

import pytest

from emit.kernels import ODD, RANDOM, robots, write
from robodyn import InputError
from robodyn.emit.parallel import schedule_files
from robodyn.ir import Signature
from robodyn.ir.program import Program
from robodyn.kernels.generate import Options, generate
from robodyn.robot import Robot, load, read_text
from robodyn.schedule import Machine, solve
from robodyn.schedule.cutting import Cut, cut
from robodyn.schedule.lanes import Waiting, lanes, pack
from robodyn.schedule.machine import Timetable
from robodyn.schedule.task_program import task_program
from robodyn_testing import representative, require_tool
from robodyn_testing.effect_arms import TEXTS

FLAGS = ("-std=c11", "-O1", "-ffp-contract=off", "-pthread")
STRICT = ("-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror")
TOOL = """
name: tool
links:
  - joint: revolute
    mass: 3
    com: [0.1, 0, 0.2]
    inertia: {xx: 0.1, yy: 0.2, zz: 0.25}
    friction: {viscous: 2, coulomb: 1.5}
  - {joint: revolute, alpha: pi/2, a: a_2, mass: 2, com: [0.2, 0.1, 0.1], inertia: {xx: 1, yy: 1, zz: 1.1}}
  - {joint: prismatic, alpha: 0.7, d: d_3 + 0.1, mass: 2*m_tool + 0.5, com: [x_tool, y_tool, -0.05]}
"""


def robot(name: str) -> Robot:
    return read_text(TOOL) if name == "tool" else load(name, warn=lambda _: None)


def kernel(
    name: str, function: str = "inverse_dynamics", scalar: str = "double"
) -> tuple[Signature, Program]:
    made = generate(robot(name), Options(functions=(function,), scalar=scalar))  # type: ignore[arg-type]
    ((signature, program),) = made.unit.functions
    return signature, program


def scheduled(program: Program, p: int, k: int, waiting: Waiting) -> tuple[Cut, Timetable]:
    tasks = cut(program, k)
    machine = Machine(p) if waiting == "barrier" else Machine(p, 2, synchronised=False)
    return tasks, solve(tasks.graph, machine, "critical-path").timetable


def all_files(
    name: str, p: int, k: int, waiting: Waiting, function: str = "inverse_dynamics", scalar: str = "double"
) -> dict[str, str]:
    signature, program = kernel(name, function, scalar)
    return schedule_files(robot(name), signature, *scheduled(program, p, k, waiting), waiting=waiting)


def ran(folder: Path, files: dict[str, str], states: int, *flags: str) -> str:
    """Compile all, compare so many states, and hand over what the check said."""
    sources = write(folder, files)
    gcc = require_tool("gcc")
    # Threads outnumber the cores here: let each other run at once.
    name = sources[0].removesuffix(".c")
    command = [gcc, *FLAGS, *flags, f"-D{name}_spins=1u", *sources, "-lm", "-o", "check"]
    made = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert (made.returncode, made.stderr) == (0, "")
    done = subprocess.run(
        ["./check", str(states)], cwd=folder, capture_output=True, text=True, check=False, timeout=600
    )
    assert done.stderr == ""
    assert done.returncode == 0
    return done.stdout


@pytest.mark.parametrize(
    ("name", "p", "k", "waiting"),
    representative(
        [
            ("puma560", 3, 3, "barrier"),
            ("stanford", 2, 6, "counters"),
            ("puma560_3dof", 4, 1, "counters"),
            ("puma560_3dof", 1, 3, "barrier"),
            ("tool", 3, 2, "barrier"),
        ],
        "puma560_3dof",
    ),
)
def test_the_bits_are_those_of_the_serial_kernel(
    name: str, p: int, k: int, waiting: Waiting, tmp_path: Path
) -> None:
    said = ran(tmp_path, all_files(name, p, k, waiting), 400, *STRICT)
    assert said.startswith("states 400 differing 0 ")


@pytest.mark.thorough
def test_the_thesis_s_tasks_run(tmp_path: Path) -> None:
    """Table 4.1's tasks as a program of their own, serial and parallel."""
    arm = robot("stanford")
    tasks = task_program(arm)
    made = generate(arm, Options(functions=("inverse_dynamics",)))
    ((signature, _),) = made.unit.functions
    files = schedule_files(arm, signature, tasks, solve(tasks.graph, Machine(3), "thesis").timetable)
    assert ran(tmp_path, files, 300, *STRICT).startswith("states 300 differing 0 ")


@pytest.mark.parametrize(
    ("name", "p", "waiting"),
    representative(
        representative(
            itertools.product(["puma560", "stanford", "ur10"], [2, 3, 4], ["barrier", "counters"]),
            ("puma560", 4, "barrier"),
            rest="slow",
        )
    ),
)
def test_thread_sanitizer_has_nothing_to_say(name: str, p: int, waiting: Waiting, tmp_path: Path) -> None:
    said = ran(tmp_path, all_files(name, p, 3, waiting), 1000, "-fsanitize=thread")
    assert said.startswith("states 1000 differing 0 ")


LONGEST = "the_longest_name_that_a_robot_may_have_x"
SOON = ("ghosts", "confusing")
#: All but those that remember between calls.
ODD_ONES = [name for name in (*ODD, *RANDOM) if name != "effects_remembering"]


@pytest.mark.parametrize(
    "name",
    [name if name in SOON else pytest.param(name, marks=pytest.mark.slow) for name in ODD_ONES],
)
def test_odd_robots(name: str, tmp_path: Path) -> None:
    """No tasks, no values that pass, names of other things: strict compilers are content, and bits equal."""
    arm = robots()[name]
    made = generate(arm, Options(functions=("inverse_dynamics",)))
    ((signature, program),) = made.unit.functions
    files = schedule_files(arm, signature, *scheduled(program, 3, 3, "barrier"), vector=4)
    assert ran(tmp_path, files, 60, *STRICT, "-Wno-psabi").startswith("states 60 differing 0 ")


def test_barriers_stand_only_where_a_value_passes() -> None:
    _, program = kernel("puma560")
    tasks, timetable = scheduled(program, 2, 3, "barrier")
    plan = lanes(tasks, timetable)
    assert len(plan.barriers) < timetable.levels
    level = {
        one.task: k
        for k, row in enumerate(timetable.slots, 1)
        for one in timetable.placements
        if one.task in row
    }
    for i, operation in enumerate(program.operations):
        for arg in operation.args:
            if isinstance(arg, int) and plan.processor_of[arg] != plan.processor_of[i]:
                made, used = (level.get(tasks.task_of[x], 0) for x in (arg, i))
                assert any(made < barrier <= used for barrier in plan.barriers)
    alone, table = scheduled(program, 1, 3, "barrier")
    assert lanes(alone, table).barriers == ()


def test_counters_follow_a_schedule_without_levels() -> None:
    _, program = kernel("puma560")
    tasks, timetable = scheduled(program, 2, 3, "counters")
    with pytest.raises(InputError, match="--sync counters"):
        lanes(tasks, timetable, "barrier")


def test_what_remembers_is_refused() -> None:
    text = next(text for text in TEXTS.values() if "presliding" in text)
    arm = read_text(text, warn=lambda _: None)
    made = generate(arm, Options(functions=("inverse_dynamics",)))
    ((signature, program),) = made.unit.functions
    with pytest.raises(InputError, match="remembers"):
        schedule_files(arm, signature, *scheduled(program, 2, 3, "barrier"))


# --- lanes of a vector --------------------------------------------------------------------------------------

MAIN = """
#include <stdio.h>
#include <string.h>
#include "{name}_packed.h"
int main(void) {{
    unsigned long long seed = 1;
    for (int state = 0; state < 2000; ++state) {{
        {name}_real x[{n}][16], one[64], two[64];
        for (int i = 0; i < {n}; ++i) for (int j = 0; j < 16; ++j) {{
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            x[i][j] = ({name}_real)((double)(seed >> 11) / 9007199254740992.0 * 6 - 3);
        }}
        {name}_{function}({arguments}, one);
        {name}_packed_{function}({arguments}, two);
        if (memcmp(one, two, {size} * sizeof one[0])) return 1;
    }}
    puts("same");
    return 0;
}}
"""


@pytest.mark.parametrize(("name", "function", "width", "scalar"), [
    ("puma560", "inverse_dynamics", 4, "double"), ("stanford", "inverse_dynamics", 8, "float"),
    ("puma560_3dof", "forward_dynamics", 2, "double"),
])  # fmt: skip
@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_packed_bits(
    name: str, function: str, width: int, scalar: str, compiler: str, tmp_path: Path
) -> None:
    signature, program = kernel(name, function, scalar)
    files = schedule_files(robot(name), signature, *scheduled(program, 1, 3, "barrier"), vector=width)
    n = len(signature.inputs)
    files["main.c"] = MAIN.format(
        name=name, n=n, function=function, arguments=", ".join(f"x[{i}]" for i in range(n)),
        size=signature.outputs[0][1],
    )  # fmt: skip
    sources = [source for source in write(tmp_path, files) if "parallel" not in source]
    tool = require_tool(compiler)
    strict = (*STRICT, "-Wno-psabi") if compiler == "gcc" else STRICT
    command = [tool, "-std=c11", "-O2", "-ffp-contract=off", *strict, *sources, "-lm", "-o", "check"]
    made = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (made.returncode, made.stderr) == (0, "")
    assert (
        subprocess.run(["./check"], cwd=tmp_path, capture_output=True, text=True, check=False).stdout
        == "same\n"
    )


def test_packing_keeps_the_order_and_the_kinds() -> None:
    _, program = kernel("puma560")
    found = pack(program, 4)
    done: set[int] = set()
    for group in found.groups:
        assert len({program.operations[i].op for i in group}) == 1
        assert len(group) <= 4
        for i in group:
            assert all(arg in done for arg in program.operations[i].args if isinstance(arg, int))
        done |= set(group)
    assert done == set(range(len(program.operations)))
    assert found.filling > 0.8
    with pytest.raises(InputError, match="2, 4 or 8"):
        pack(program, 3)
