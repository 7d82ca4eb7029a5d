"""CasADi: external functions in its C interface, with Jacobians from the kernels of derivatives.

CasADi stores matrices by columns and leaves out elements that are always zero; a pattern is rows, columns,
where each column begins, and the rows of its elements, or 1 in place of both where no element is left out.
Source: the code that CasADi 3.8 generates, and its header ``casadi/mem.h``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import prod

from robodyn.dynamics.functions import function_named
from robodyn.emit.languages.c import LANGUAGE as C
from robodyn.errors import InputError
from robodyn.kernels.with_effects import is_affine
from robodyn.packages.format import Argument, Files, Format, Package, Routine
from robodyn.packages.writing import arithmetic_flags, readme, rendered

_TEMPLATES = {"NAME_casadi.c": "externals.c.j2", "Makefile": "Makefile.j2"}


@dataclass(frozen=True, slots=True)
class Slot:
    """An input or output of an external function, by its name in CasADi; ``pattern`` as CasADi has it."""

    name: str
    pattern: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class External:
    """A function of the interface: its symbol, what it is, its inputs and outputs, how many numbers of
    working memory it needs, and the lines of its body."""

    symbol: str
    purpose: str
    inputs: tuple[Slot, ...]
    outputs: tuple[Slot, ...]
    work: int
    body: tuple[str, ...]


def _files(package: Package) -> Files:
    if package.scalar != "double":
        raise InputError(
            "CasADi computes in double", found=f"--scalar {package.scalar}", remedy="leave it out"
        )
    externals = tuple(_externals(package))
    slots = [slot for external in externals for slot in (*external.inputs, *external.outputs)]
    patterns = tuple(dict.fromkeys(slot.pattern for slot in slots))
    more = {
        "externals": externals,
        "patterns": patterns,
        "pattern_of": {pattern: k for k, pattern in enumerate(patterns)},
        "longest": max(array.size for routine in package.routines for array in routine.inputs),
        "of_frames": any("frame(" in line for external in externals for line in external.body),
        "flags": arithmetic_flags(package),
    }
    named = [external for external in externals if not external.symbol.startswith("jac_")]
    return {
        **readme(package, example=named[0].symbol, symbols=[external.symbol for external in named]),
        **rendered(package, _TEMPLATES, **more),
        **package.kernel(),
    }


def _externals(package: Package) -> Iterator[External]:
    """Each function, and its Jacobian where the package has what that is made of."""
    routines = {routine.name: routine for routine in package.routines}
    affine = is_affine(package.robot)
    for routine in package.routines:
        yield _function(package, routine)
        derivatives = function_named(routine.name).derivatives
        are_there = all(d.function in routines and (affine or not d.affine) for d in derivatives)
        if derivatives and are_there:
            yield _jacobian(package, routine, routines)


def _function(package: Package, routine: Routine) -> External:
    body, work = _call(routine, routine, [f"res[{k}]" for k in range(len(routine.outputs))])
    for k, array in enumerate(routine.outputs):
        if _is_matrix(array):
            body += _taken(f"res[{k}]", array.name, _by_columns(*_plane(array)))
    symbol = f"{package.robot.name}_casadi_{routine.name}"
    inputs, outputs = (tuple(map(_slot, arrays)) for arrays in (routine.inputs, routine.outputs))
    return External(symbol, routine.purpose, inputs, outputs, work, tuple(body))


def _slot(array: Argument) -> Slot:
    return Slot(array.name, (*_plane(array), 1))


def _jacobian(package: Package, routine: Routine, routines: dict[str, Routine]) -> External:
    """``jac_F``, of the inputs of F and of its outputs, which it does not read: the derivative of each output
    by each input."""
    (result,) = routine.outputs
    body: list[str] = []
    outputs: list[Slot] = []
    derivatives = function_named(routine.name).derivatives
    work = 0
    for name in dict.fromkeys(derivative.function for derivative in derivatives):
        wanted = [k for k, derivative in enumerate(derivatives) if derivative.function == name]
        lines, size = _call(routines[name], routine)
        for k in wanted:
            array = next(a for a in routines[name].outputs if a.name == derivatives[k].array)
            rows, columns = result.size, routine.inputs[k].size
            title = f"jac_{result.name}_{routine.inputs[k].name}"
            if derivatives[k].of_frame:
                more, extra = _call(routine, routine, start=size)
                lines += [*more, f"if (res[{k}]) frame(res[{k}], {result.name}, {array.name}, {columns});"]
                size += extra
                outputs.append(Slot(title, (rows, columns, 1)))
            else:
                zeros = package.generated.zeros[name].get(array.name, ())
                places = _by_columns(rows, columns, zeros)
                outputs.append(Slot(title, _pattern(rows, columns, places)))
                lines += _taken(f"res[{k}]", array.name, places)
        condition = " || ".join(f"res[{k}]" for k in wanted)
        body += [f"if ({condition}) {{", *(f"    {line}" for line in lines), "}"]
        work = max(work, size)
    rows, columns = _plane(result)
    inputs = (*map(_slot, routine.inputs), Slot(f"out_{result.name}", (rows, columns, *(0,) * (columns + 1))))
    symbol = f"jac_{package.robot.name}_casadi_{routine.name}"
    return External(symbol, f"derivatives of {routine.name}", inputs, tuple(outputs), work, tuple(body))


def _call(
    called: Routine, caller: Routine, results: Sequence[str] = (), start: int = 0
) -> tuple[list[str], int]:
    """The lines that call ``called`` with the arguments of ``caller``, zero where that has none, and how many
    numbers of the working memory from ``start`` they take. Vectors go to ``results`` where these are."""
    names = [array.name for array in caller.inputs]
    lines, arguments, size = [], [], 0
    for array in called.inputs:
        place = f"arg[{names.index(array.name)}]" if array.name in names else ""
        source = f"{place} ? {place} : zero" if place else "zero"
        if _is_matrix(array):
            lines.append(f"double *{array.name} = w + {start + size};")
            lines += _taken(array.name, source, _by_rows(*_plane(array)))
            source, size = array.name, size + array.size
        arguments.append(source)
    for k, array in enumerate(called.outputs):
        room = f"w + {start + size}"
        direct = bool(results) and not _is_matrix(array)
        lines.append(f"double *{array.name} = {f'{results[k]} ? {results[k]} : ' if direct else ''}{room};")
        arguments.append(array.name)
        size += array.size
    lines.append(f"{called.symbol}({', '.join(arguments)});")
    return lines, size


def _taken(target: str, source: str, places: Sequence[int]) -> list[str]:
    """The lines that copy the elements ``places`` of ``source`` to ``target``, if that is wanted."""
    listed = ", ".join(map(str, places))
    return [
        f"if ({target}) {{",
        f"    static const int places[] = {{{listed or 0}}};",
        f"    take({target}, {source}, places, {len(places)});",
        "}",
    ]


def _plane(array: Argument) -> tuple[int, int]:
    """Rows and columns: what has more axes has its slices side by side."""
    return (array.shape[0], prod(array.shape[1:])) if array.shape else (1, 1)


def _is_matrix(array: Argument) -> bool:
    return min(_plane(array)) > 1


def _by_columns(rows: int, columns: int, zeros: Sequence[int] = ()) -> list[int]:
    """Elements of a matrix that is stored by rows, in the order of one that is stored by columns."""
    every = (row * columns + column for column in range(columns) for row in range(rows))
    return [place for place in every if place not in set(zeros)]


def _by_rows(rows: int, columns: int) -> list[int]:
    """Elements of a matrix that is stored by columns, in the order of one that is stored by rows."""
    return [column * rows + row for row in range(rows) for column in range(columns)]


def _pattern(rows: int, columns: int, places: Sequence[int]) -> tuple[int, ...]:
    """The pattern with these elements, in CasADi's order."""
    if len(places) == rows * columns:
        return (rows, columns, 1)
    before = [sum(place % columns < column for place in places) for column in range(columns + 1)]
    return (rows, columns, *before, *(place // columns for place in places))


FORMAT = Format(
    name="casadi",
    title="a library of CasADi's external functions",
    tool="CasADi 3.6 or newer, and what takes its C, acados for one",
    language=C,
    files=_files,
    take="make -C {folder}",
    functions=("inverse_dynamics", "forward_dynamics", "forward_kinematics"),
    lacks=frozenset({"parameters", "memory", "given sines"}),
    derivatives=True,
)
