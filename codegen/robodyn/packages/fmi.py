"""An arm as FMI 3.0 describes it: variables with units, which of them are states, what depends on what.

Variables are numbered in blocks, in the order in which the unit's C has them: time, motor torques, states
(coordinates, velocities, internal states of effects), their slopes, run-time parameters, indicators of
events, results of functions. The states' order is that of the engine.
"""

from __future__ import annotations

import itertools
import platform
import re
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from robodyn.dynamics.functions import array_named
from robodyn.emit.head import parameter_uses
from robodyn.errors import InputError
from robodyn.ir.derivative import directional
from robodyn.ir.graph import Graph, Scalar
from robodyn.ir.lowering import lower
from robodyn.ir.program import Input, Program
from robodyn.packages.format import Argument, Package, Routine
from robodyn.passes import FRESH, run

if TYPE_CHECKING:
    from robodyn.simulate.system import System

#: What a unit has itself; other results of functions are outputs.
KNOWN: Final = ("q", "qd", "qdd", "tau")
#: Exponents of SI base units, of every unit that the names of units are made of.
_BASE: Final[Mapping[str, Mapping[str, int]]] = {
    "1": {}, "kg": {"kg": 1}, "m": {"m": 1}, "s": {"s": 1}, "A": {"A": 1}, "rad": {"rad": 1},
    "N": {"kg": 1, "m": 1, "s": -2}, "J": {"kg": 1, "m": 2, "s": -2},
}  # fmt: skip
_SYSTEMS: Final = {"win32": "windows"}
_MACHINES: Final = {"amd64": "x86_64", "arm64": "aarch64", "i686": "x86", "i386": "x86"}


@dataclass(frozen=True, slots=True)
class Variable:
    """A variable: its number, what it is to the standard, and for the derivative of a state that state's
    number; ``depends``: the numbers of the inputs and states that it follows from, None: any."""

    reference: int
    name: str
    causality: str
    variability: str
    initial: str | None
    unit: str
    description: str
    start: str | None = None
    derivative: int | None = None
    depends: tuple[int, ...] | None = None


@dataclass(frozen=True, slots=True)
class Result:
    """A function of the kernel whose results are outputs, and where in the row of all of them each begins."""

    routine: Routine
    places: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Description:
    """The variables of a unit and its structure."""

    variables: tuple[Variable, ...]
    derivatives: tuple[Variable, ...]
    indicators: tuple[Variable, ...]

    @property
    def outputs(self) -> tuple[Variable, ...]:
        """The outputs."""
        return tuple(v for v in self.variables if v.causality == "output")

    @property
    def initial_unknowns(self) -> tuple[Variable, ...]:
        """What follows from start values: outputs, states and their derivatives that are computed."""
        counted = (*self.outputs, *self.derivatives)
        return tuple(dict.fromkeys(v for v in counted if v.initial == "calculated"))

    @property
    def units(self) -> dict[str, Mapping[str, int]]:
        """The units by name, each with its exponents of SI base units."""
        names = dict.fromkeys(v.unit for v in self.variables if v.unit)
        return {name: exponents for name in names if (exponents := base_units(name)) is not None}


def base_units(unit: str) -> dict[str, int] | None:
    """The exponents of SI base units in ``unit``, as in ``N m s/rad``; None where it is no single unit."""
    above, _, below = unit.partition("/")
    total: dict[str, int] = {}
    for text, sign in ((above, 1), (below.removeprefix("(").removesuffix(")"), -1)):
        for factor in text.split():
            symbol = re.fullmatch(r"([A-Za-z1]+)(?:\^([1-9]))?", factor)
            if symbol is None or symbol[1] not in _BASE:
                return None
            for base, exponent in _BASE[symbol[1]].items():
                total[base] = total.get(base, 0) + sign * exponent * int(symbol[2] or 1)
    return {base: exponent for base, exponent in total.items() if exponent} if unit else None


def platform_name() -> str:
    """This machine as the standard names it."""
    machine = platform.machine().lower()
    return f"{_MACHINES.get(machine, machine)}-{_SYSTEMS.get(sys.platform, sys.platform)}"


def results_of(package: Package) -> tuple[Result, ...]:
    """The functions that make outputs; of all that the arm has, those that can.

    Raises
    ------
    InputError: one that is asked for by name needs what the unit has not.
    """
    begin: dict[str, int] = {}
    total = 0
    results = []
    for signature, routine in zip(package.generated.signatures, package.routines, strict=True):
        missing = [array.name for array in routine.inputs if array.name not in KNOWN]
        if not missing and not routine.stateful:
            for array in routine.outputs:
                if array.name not in begin:
                    begin[array.name], total = total, total + array.size
            results.append(Result(routine, tuple(begin[array.name] for array in routine.outputs)))
        elif package.generated.options.insists_on(signature.function):
            raise InputError(
                f"{package.format.title} has no place for the function {routine.name}",
                found=f"it needs {', '.join(missing) or 'memory from call to call'}",
                expected=f"functions of {', '.join(KNOWN)}",
                remedy="name others with --functions",
            )
    return tuple(results)


def arrays_of(results: Iterable[Result]) -> dict[str, Argument]:
    """The arrays of all results, each once, by what the unit calls them: ``function_tau`` where it has a
    ``tau`` itself."""
    arrays = (array for result in results for array in result.routine.outputs)
    return {f"{'function_' if array.name in KNOWN else ''}{array.name}": array for array in arrays}


def size_of(results: Iterable[Result]) -> int:
    """How many numbers all results are."""
    ends = (p + a.size for r in results for p, a in zip(r.places, r.routine.outputs, strict=True))
    return max(ends, default=0)


def results_tangent(package: Package, results: Sequence[Result]) -> Program:
    """How results change where ``q``, ``qd``, ``qdd`` and ``tau`` change at the rates ``dq`` and so on."""
    graph = Graph()
    row: list[Scalar] = [0] * size_of(results)
    behind = _programs(package)
    for result in results:
        program = behind[result.routine]
        values = iter(graph.replay(program))
        for (_, elements), place in zip(program.outputs, result.places, strict=True):
            for k in range(len(elements)):
                row[place + k] = next(values)
    seeds: dict[Input, Scalar] = {
        Input(name, i): graph.input(f"d{name}", i) for name in KNOWN for i in range(package.robot.n)
    }
    return run(lower(graph, [("results", directional(graph, row, seeds))]), FRESH)


def _programs(package: Package) -> dict[Routine, Program]:
    """The program of each function."""
    programs = (program for _, program in package.generated.unit.functions)
    return dict(zip(package.routines, programs, strict=True))


def describe(package: Package, system: System, results: Sequence[Result]) -> Description:
    """What the unit of ``package`` has, that simulates ``system`` and computes ``results``."""
    robot, n, size, memories = package.robot, package.robot.n, system.coordinates, system.states
    kinds = [robot.links[i].joint.kind for i in (*range(n), *system.coupled)]
    torque, position, speed = 1, 1 + n, 1 + n + size
    memory = speed + size
    acceleration = memory + len(memories)
    rate = acceleration + size
    parameter = rate + len(memories)
    indicator = parameter + len(package.parameters)
    accelerating = _accelerating(system, torque, position)

    def unit(array: str, k: int) -> str:
        record = array_named(array)
        return record.unit if kinds[k] == "revolute" else record.prismatic

    def moving(array: str, first: int, derivative: int | None = None) -> Iterator[Variable]:
        """A block of coordinates, velocities or accelerations."""
        holds, is_state = array_named(array).holds, array != "qdd"
        for k in range(size):
            i, is_exact = k if k < n else system.coupled[k - n], is_state and k < n
            yield Variable(
                first + k, f"{'' if k < n else 'motor_'}{array}[{i + 1}]",
                "output", "continuous", "exact" if is_exact else "calculated", unit(array, k),
                f"{holds}: {'joint' if k < n else 'motor'} {i + 1}", "0" if is_exact else None,
                None if derivative is None else derivative + k, (first + k,) if is_state else accelerating,
            )  # fmt: skip

    inputs = [
        Variable(
            torque + i, f"tau[{i + 1}]", "input", "continuous", None, unit("tau", i),
            f"torque or force of motor {i + 1}", "0",
        )
        for i in range(n)
    ]  # fmt: skip
    speeds = tuple(moving("qd", speed, position))
    accelerations = tuple(moving("qdd", acceleration, speed))
    rates = tuple(
        Variable(
            rate + k, f"der({name})", "local", "continuous", "calculated", "", f"rate of {name}",
            None, memory + k,
        )
        for k, name in enumerate(memories)
    )  # fmt: skip
    states = [
        Variable(memory + k, name, "local", "continuous", "exact", "", "internal state of an effect", "0")
        for k, name in enumerate(memories)
    ]
    uses = parameter_uses(robot)
    parameters = [
        Variable(
            parameter + k, f"parameters.{name}", "parameter", "tunable", "exact",
            _common_unit(uses.get(name, ())), ", ".join(what for what, _ in uses.get(name, ())), "0",
        )
        for k, name in enumerate(package.parameters)
    ]  # fmt: skip
    indicators = tuple(
        Variable(
            indicator + k, f"friction[{k + 1}]", "local", "continuous", None, "", f"dry friction of {e.what}"
        )
        for k, e in enumerate(system.elements)
    )
    variables = (
        Variable(0, "time", "independent", "continuous", None, "s", "time"),
        *inputs, *moving("q", position), *speeds,
        *states,
        *accelerations, *rates, *parameters, *indicators,
    )  # fmt: skip
    places = {"tau": torque, "q": position, "qd": speed}
    known: dict[Input, tuple[int, ...] | None] = {
        Input(name, i): (place + i,) for name, place in places.items() for i in range(n)
    }
    known |= {Input("qdd", i): accelerating for i in range(n)}
    outputs = _outputs(package, results, indicator + len(indicators), known)
    return Description((*variables, *outputs), (*speeds, *accelerations, *rates), indicators)


def _accelerating(system: System, torque: int, state: int) -> tuple[int, ...] | None:
    """What the accelerations follow from."""
    if system.contacts:
        return None  # from the time, too
    size = system.coordinates
    block = {"y": state, "v": state + size, "z": state + 2 * size}
    inputs = {
        x for name, p in system.programs.items() if name not in ("conserved", "rates") for x in p.inputs()
    }
    states = {block[x.array] + x.index for x in inputs if x.index is not None and x.array in block}
    speeds = {block["v"] + k for e in system.elements for k, w in enumerate(e.row) if w}
    return (*range(torque, torque + system.robot.n), *sorted(states | speeds))


def _outputs(
    package: Package, results: Sequence[Result], first: int, known: Mapping[Input, tuple[int, ...] | None]
) -> Iterator[Variable]:
    """The elements of all results, in their order."""
    behind = _programs(package)
    names = {array.name: name for name, array in arrays_of(results).items()}
    for result in results:
        inputs = [known[x] for x in behind[result.routine].inputs() if x in known]
        depends = None if None in inputs else tuple(sorted({r for refs in inputs for r in refs or ()}))
        for array, place in zip(result.routine.outputs, result.places, strict=True):
            name = names.pop(array.name, None)
            if name is None:
                continue  # another function has it, too
            for k, indices in enumerate(itertools.product(*map(range, array.shape))):
                text = ",".join(str(i + 1) for i in indices)
                yield Variable(
                    first + place + k, f"{name}[{text}]" if text else name,
                    "output", "continuous", "calculated", _unit_of(array, k, package), array.holds,
                    None, None, depends,
                )  # fmt: skip


def _unit_of(array: Argument, k: int, package: Package) -> str:
    """The unit of element ``k``, where it has one of its own."""
    record = array_named(array.name)
    kinds = [link.joint.kind for link in package.robot.links]
    unit = record.unit
    if record.prismatic and "prismatic" in kinds:
        unit = "" if record.shape != ("n",) else record.prismatic if kinds[k] == "prismatic" else unit
    return "" if base_units(unit) is None else unit


def _common_unit(uses: Iterable[tuple[str, str]]) -> str:
    """The unit of a run-time parameter, where it stands for numbers of one unit."""
    units = {unit for _, unit in uses}
    unit = units.pop() if len(units) == 1 else ""
    return unit if base_units(unit) is not None else ""
