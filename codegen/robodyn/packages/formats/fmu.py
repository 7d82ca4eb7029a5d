"""FMI 3.0: the arm with all its effects as a unit for model exchange and co-simulation.

The unit is our simulator: the engine of :mod:`robodyn.simulate`, its glue for this arm, and the functions
of the standard around them, so that a unit and ``robodyn simulate`` give the same motion. Functions of the
kernel are further outputs.
"""

from __future__ import annotations

import uuid
from collections.abc import Iterator
from hashlib import sha256
from typing import TYPE_CHECKING, Any, Final

from robodyn.emit.languages.c import LANGUAGE as C
from robodyn.emit.markdown import Markdown
from robodyn.errors import InputError
from robodyn.packages import fmi
from robodyn.packages.format import Files, Format, Package
from robodyn.packages.writing import arithmetic_flags, readme, rendered, zipped
from robodyn.resources import data_dir

if TYPE_CHECKING:
    from robodyn.simulate.system import System

#: The longest step [s]: nothing else limits it while all is stuck.
LONGEST_STEP: Final = 1e-2
#: Steps that one call may take.
STEPS: Final = 10_000_000
#: What an importer simulates unless it is asked for something else [s].
STOP_TIME, STEP_SIZE = 10.0, 1e-3
_HEADERS = ("fmi3PlatformTypes.h", "fmi3FunctionTypes.h", "fmi3Functions.h")
_OWN = ("unit.h", "derivatives.h", "unit.c", "absent.c", "results.c", "robot.h")
_SOURCES = {name: f"{name}.j2" for name in _OWN}
_DESCRIPTIONS = {
    "modelDescription.xml": "modelDescription.xml.j2",
    "sources/buildDescription.xml": "buildDescription.xml.j2",
}


def _files(package: Package) -> Files:
    from robodyn.simulate.system import system_of
    from robodyn.toolchain.compiler import library_suffix, shared_library

    if package.scalar != "double":
        raise InputError(
            f"numbers of {package.format.title} are doubles",
            found=f"--scalar {package.scalar}",
            expected="double",
        )
    results = fmi.results_of(package)
    system = system_of(package.robot, package.generated.options)
    flags = ("-std=c99", "-O2", *arithmetic_flags(package))
    texts = _texts(package, system, results, flags)
    sources = {
        path.removeprefix("sources/"): text for path, text in texts.items() if path.endswith((".c", ".h"))
    }
    machine = fmi.platform_name()
    library = f"{package.name}{library_suffix()}"
    binary = shared_library(sources, library, flags=(*flags, "-fvisibility=hidden"))
    archive: Files = {**texts, f"binaries/{machine}/{library}": binary}
    notes = readme(
        package, machine=Markdown(machine), elastic=bool(system.coupled), outputs=fmi.arrays_of(results)
    )
    return {f"{package.name}.fmu": zipped(archive), **notes}


def _texts(
    package: Package, system: System, results: tuple[fmi.Result, ...], flags: tuple[str, ...]
) -> dict[str, str]:
    """All of the unit but its binary, which is compiled with ``flags``."""
    from robodyn.simulate.engine import engine_files
    from robodyn.simulate.plant import system_glue

    fixed = {path: text for path, text in engine_files().items() if path != "engine/engine.c"}
    fixed["engine/engine_glue.h"] = system_glue(system)
    fixed |= {f"kernel/{path}": text for path, text in package.generated.files((C.name,)).items()}
    folder = data_dir("templates") / "package" / package.format.name / "fmi"
    fixed |= {f"fmi/{name}": (folder / name).read_text(encoding="utf-8") for name in _HEADERS}
    values = {
        **_values(package, system, results),
        "description": fmi.describe(package, system, results),
        "flags": flags,
        "compiled": sorted(
            {*(path for path in fixed if path.endswith(".c")), "unit.c", "absent.c", "results.c"}
        ),
    }
    templates = _DESCRIPTIONS | _SOURCES
    state = sha256()  # what tells this unit from another, in the form of a UUID
    for path, text in sorted((rendered(package, templates, token="", **values) | fixed).items()):
        state.update(f"{path}\0{text}\0".encode())
    token = f"{{{uuid.UUID(bytes=state.digest()[:16])}}}"
    texts = rendered(package, templates, token=token, **values)
    written = {path: texts.pop(path) for path in _DESCRIPTIONS}
    return written | {f"sources/{path}": text for path, text in sorted((texts | fixed).items())}


def _values(package: Package, system: System, results: tuple[fmi.Result, ...]) -> dict[str, Any]:
    """What the templates of the sources are told."""
    from robodyn.emit.c_syntax import static_function
    from robodyn.simulate.engine import ATOL, RTOL
    from robodyn.simulate.plant import drive_limits
    from robodyn.simulate.start import start_program

    limits = drive_limits(package.robot, {})
    motors = static_function(
        "unit_motors", ("q",), {"motor": "motor"}, start_program(system), system.parameters
    )
    return {
        "tolerance": repr(RTOL),
        "absolute": repr(ATOL / RTOL),
        "longest_step": repr(LONGEST_STEP),
        "steps": STEPS,
        "stop_time": repr(STOP_TIME),
        "step_size": repr(STEP_SIZE),
        "motors": system.motors,
        "encoders": system.encoders,
        "coupled": system.coupled,
        "breaks": sorted(map(repr, system.breaks), key=float),
        "limits": []
        if limits is None
        else ["HUGE_VAL" if x == float("inf") else repr(float(x)) for x in limits],
        "motors_at_rest": motors,
        "derivatives": not system.contacts,
        "tangents": "" if system.contacts else _tangents(package, system, results),
        "members": [f"p[{k}]" for k in range(len(package.parameters))],
        "calls": list(_calls(package, results)),
        "results": fmi.size_of(results),
    }


def _tangents(package: Package, system: System, results: tuple[fmi.Result, ...]) -> str:
    """The C functions of directional derivatives: of forces, of rates of internal states, of results."""
    from robodyn.emit.c_syntax import static_function
    from robodyn.simulate.system import tangents_of

    states, rates = ("y", "v", "a", "s", "z", "dy", "dv", "dz"), ("y", "v", "z", "dy", "dv", "dz")
    arguments = {"force_tangent": states, "rates_tangent": rates}
    programs = tangents_of(package.robot, package.generated.options)
    texts = [
        static_function(
            f"system_{name}", arguments[name], {array: array for array, _ in program.outputs}, program,
            system.parameters,
        )
        for name, program in programs.items()
    ]  # fmt: skip
    changes = (*fmi.KNOWN, *(f"d{name}" for name in fmi.KNOWN))
    program = fmi.results_tangent(package, results)
    texts.append(
        static_function("unit_results_tangent", changes, {"results": "results"}, program, system.parameters)
    )
    return "\n".join(texts)


def _calls(package: Package, results: tuple[fmi.Result, ...]) -> Iterator[str]:
    """The calls of the functions of the kernel, in C."""
    for result in results:
        arguments = [array.name for array in result.routine.inputs]
        arguments += [f"results + {place}" for place in result.places]
        arguments += ["&parameters"] if package.parameters else []
        yield f"{result.routine.symbol}({', '.join(arguments)})"


FORMAT = Format(
    name="fmu",
    title="an FMI unit",
    tool="simulators with FMI 3.0: model exchange and co-simulation",
    language=C,
    files=_files,
    take="fmpy simulate {folder}/{name}.fmu",
    functions=("forward_kinematics",),
    lacks=frozenset({"given sines"}),
    binary=True,
)
