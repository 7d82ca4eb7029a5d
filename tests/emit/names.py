"""Everything that is emitted of a robot, whatever it and its parameters are called."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterable, Sequence
from pathlib import Path

from robodyn.certify.eva import driver_context
from robodyn.emit.parallel import schedule_files
from robodyn.emit.render import environment
from robodyn.firmware import firmware, firmware_options, targets_named
from robodyn.kernels.batch import batch_calls
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.kernels.wrapper import wrapper
from robodyn.resources import data_dir
from robodyn.robot import Robot, read_text
from robodyn.schedule import Machine, solve
from robodyn.schedule.cutting import cut

#: The numbers of a link that may be run-time parameters.
_LINK = """
  - joint: revolute
    alpha: pi/2
    a: {}
    d: {}
    mass: {}
    com: [{}, {}, {}]
    inertia: {{xx: {}, yy: {}, zz: {}, xy: {}, xz: {}, yz: {}}}
    motor_inertia: {}
    friction: {{viscous: {}, coulomb: {}}}
"""
_PLACES = _LINK.count("{}")


def arm(name: str = "arm", parameters: Sequence[str] = ("m_load",), *, head: str = "") -> Robot:
    """A robot called ``name``, with so many links that all ``parameters`` have a place."""
    links = max(2, -(-len(parameters) // _PLACES))
    numbers = [*parameters, *["1"] * (links * _PLACES - len(parameters))]
    text = "".join(_LINK.format(*numbers[k * _PLACES : (k + 1) * _PLACES]) for k in reversed(range(links)))
    return read_text(f"name: {name}\n{head}links:{text}", warn=lambda _: None)


def kernels(robot: Robot) -> dict[str, str]:
    """What ``gen --batch`` writes, with sines of its own, and Python's calls of it."""
    made = generate(robot, Options(("inverse_dynamics", "gravity"), optimize="none", trig="builtin"))
    files = made.files(batch=True)
    signature = made.signatures[0]
    files["robodyn-calls.c"] = wrapper(made.signatures, files, "c")
    files["robodyn-batch-calls.c"] = batch_calls(signature, signature.parameters).source
    return files


def with_libm(robot: Robot) -> dict[str, str]:
    """What ``gen --misra`` writes, and the driver of ``prove``."""
    made = generate(robot, Options(("inverse_dynamics",), optimize="none", misra=True))
    driver = environment().get_template("prove/eva_driver.c.j2")
    return {
        **made.files(),
        f"{robot.name}_eva.c": driver.render(driver_context(robot.name, made.signatures)),
    }


def of_firmware(robot: Robot) -> dict[str, str]:
    """What ``gen --firmware`` writes, with all functions of torques."""
    return dict(firmware(for_firmware(robot), targets_named(())).files)


def for_firmware(robot: Robot) -> Generated:
    """The kernels of a firmware folder."""
    options = Options(("inverse_dynamics", "gravity"), optimize="none")
    return generate(robot, firmware_options(options, (), scalar="float"))


def of_schedule(robot: Robot) -> dict[str, str]:
    """What ``schedule --emit`` writes, with the packed form."""
    made = generate(robot, Options(("inverse_dynamics",), optimize="none"))
    ((signature, program),) = made.unit.functions
    tasks = cut(program, 3)
    timetable = solve(tasks.graph, Machine(2), "critical-path").timetable
    return schedule_files(robot, signature, tasks, timetable, vector=4)


#: The ways to emit, by name: what stands in one folder, and in one program.
WAYS = {"kernels": kernels, "libm": with_libm, "firmware": of_firmware, "schedule": of_schedule}

_NOT_CODE = {
    "c": r'/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'',
    "h": r'/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'',
    "f90": r'![^\n]*|"[^"\n]*"|\'[^\'\n]*\'',
}


def words(file: str, text: str) -> set[str]:
    """The words of a file of C or Fortran that are neither comments nor texts; none of other files."""
    not_code = _NOT_CODE.get(file.rpartition(".")[2])
    if not_code is None:
        return set()
    return set(re.findall(r"[A-Za-z_]\w*", re.sub(not_code, " ", text, flags=re.S)))


# --- compilers --------------------------------------------------------------------------------------------

CLEAN = ("-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Werror", "-fsyntax-only", "-I.")
#: Headers of the C standard: a program may include them before an emitted one.
STANDARD = """
assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign stdarg
stdatomic stdbool stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar wchar wctype
""".split()  # noqa: SIM905 (it reads as the list that it is)
#: Headers that C++ has otherwise, or not at all.
NOT_CPP = {"complex", "stdatomic", "stdnoreturn", "tgmath", "threads"}
#: Headers that a template of C includes.
INCLUDED = {
    header
    for path in data_dir("templates").rglob("*.[ch].j2")
    for header in re.findall(r"#include <(\w+)\.h>", path.read_text(encoding="utf-8"))
}


def including(headers: Iterable[str], *, cpp: bool = False) -> str:
    """C that includes those of ``headers`` that are there; ``cpp``: C++."""
    return "".join(
        f"#if __has_include(<{h}.h>)\n#include <{h}.h>\n#endif\n"
        for h in sorted(headers)
        if not (cpp and h in NOT_CPP)
    )


def usable(headers: Iterable[str], folder: Path, *command: str) -> set[str]:
    """Those of ``headers`` that the compiler can include. Libraries for microcontrollers have a threads.h
    that includes what they lack: newlib, picolibc."""
    cpp = "-xc++" in command
    (folder / "all.c").write_text(including(headers, cpp=cpp), encoding="utf-8")
    if "fatal error" not in complaints(folder, *command, "-E", "-o", "all.i", "all.c"):
        return {*headers}
    found = set()
    for header in headers:
        (folder / "one.c").write_text(including([header], cpp=cpp), encoding="utf-8")
        if "fatal error" not in complaints(folder, *command, "-E", "-o", "one.i", "one.c"):
            found.add(header)
    return found


def complaints(folder: Path, *command: str) -> str:
    """What a compiler says, "" if it is content."""
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", check=False)
    return done.stdout + done.stderr or "." * done.returncode


def written(folder: Path, files: dict[str, str]) -> list[str]:
    """The files, written into ``folder``; the names of the C sources."""
    folder.mkdir(exist_ok=True)
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8", newline="\n")
    return [name for name in files if name.endswith(".c")]
