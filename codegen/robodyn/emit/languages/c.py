"""C99, also valid C++."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from robodyn.emit.batch import batch_files
from robodyn.emit.body import Lines
from robodyn.emit.c_syntax import c_builtin, c_spelling, c_syntax
from robodyn.emit.freestanding import freestanding_calls, freestanding_context
from robodyn.emit.language import Compiled, FunctionText, Language
from robodyn.emit.listing import BRANCH, FLAGS, listing_of, misra_notes
from robodyn.emit.runs import Run
from robodyn.emit.sines import ANGLES, COSINES, SINES
from robodyn.emit.spelling import WIDTH
from robodyn.emit.stages import NEXT, ROW, Repeated, Stage
from robodyn.emit.statements import Expression
from robodyn.emit.syntax import Sines, Syntax
from robodyn.emit.unit import Unit, advice, has_arctangents, has_sines, needs_libm
from robodyn.ir.program import STATE
from robodyn.ir.signature import Signature
from robodyn.tools import Tool, Use


def _syntax(signature: Signature, unit: Unit) -> Syntax:
    from dataclasses import replace

    spelling = c_spelling(single=signature.scalar == "float", states=signature.states, explicit=unit.misra)
    if unit.builtin:
        spelling = spelling.calling(atan2=lambda y, x: f"{signature.robot}_atan2_({y}, {x})")
    own = {op: f"{signature.robot}_{op}_({{}})".format for op in freestanding_calls(unit)}
    spelling = spelling.calling(**own)
    syntax = c_syntax(spelling, f"{signature.robot}_real", libm=not unit.builtin)
    return replace(syntax, sines=_sines(signature.robot, syntax))


def _sines(name: str, syntax: Syntax) -> Sines:
    """``NAME_sincos_`` in C."""
    real, spelling = f"{name}_real", syntax.spelling

    def loop(angles: Sequence[Expression]) -> list[str]:
        size = len(angles)
        texts = ", ".join(spelling.text(angle) for angle in angles)
        lines = syntax.line(f"const {real} {ANGLES}[{size}] = {{{texts}}};")
        lines += [f"    {real} {SINES}[{size}];", f"    {real} {COSINES}[{size}];"]

        def call(i: str) -> str:
            return f"    {name}_sincos_({ANGLES}[{i}], &{SINES}[{i}], &{COSINES}[{i}]);"

        if size == 1:
            return [*lines, call("0")]
        return [*lines, f"    for (int i = 0; i < {size}; ++i) {{", "    " + call("i"), "    }"]

    def pair(array: str, angle: Expression) -> list[str]:
        call = f"{name}_sincos_({spelling.text(angle)}, &{array}[0], &{array}[1]);"
        return [f"    {real} {array}[2];", *syntax.line(call)]

    def run(it: Run) -> list[str]:
        size = len(it.ups)
        ups, alongs, angles = it.arrays
        lines = []
        for array, values in ((ups, it.ups), (alongs, it.alongs)):
            texts = ", ".join(spelling.text(value) for value in values)
            lines += syntax.line(f"const {real} {array}[{size}] = {{{texts}}};")
        call = spelling.functions["atan2"](f"{ups}[i]", f"{alongs}[i]")
        return [
            *lines,
            f"    {real} {angles}[{size}];",
            f"    for (int i = 0; i < {size}; ++i) {{",
            f"        {angles}[i] = {call};",
            "    }",
        ]

    return Sines(loop, pair, run)


def _repeating(it: Repeated) -> Lines:
    real, syntax = f"{it.whole.robot}_real", c_syntax(c_spelling(single=it.whole.scalar == "float"), "")
    zero = syntax.spelling.number(Fraction(0))

    def call(stage: Stage, indent: str = "", **places: str) -> list[str]:
        return [indent + line for line in syntax.line(f"{stage.call(**places)};")]

    row = STATE if it.rows == 1 else ROW
    loop = [
        f"    for (int k = 0; k < {it.most}; ++k) {{",
        f"        if ({row}[{it.size - 1}] > {zero}) {{",
        "            break;",
        "        }",
        *call(it.step, "    ", **{STATE: row}),
        f"        for (int i = 0; i < {it.size}; ++i) {{",
        f"            {row}[i] = {NEXT}[i];",
        "        }",
        "    }",
    ]
    if it.rows > 1:
        loop = [
            f"    for (int j = 0; j < {it.rows}; ++j) {{",
            f"        {real} *const {ROW} = &{STATE}[{it.size} * j];",
            *(f"    {line}" for line in loop),
            "    }",
        ]
    arrays = {STATE: it.size * it.rows, NEXT: it.size}
    declared = [f"    {real} {array}[{size}];" for array, size in arrays.items()]
    return Lines.of([*declared, *call(it.start), *loop, *call(it.finish)], arrays)


def _function(text: FunctionText) -> dict[str, Any]:
    signature, lines = text.signature, text.lines
    real = f"{signature.robot}_real"
    arguments = [f"const {real} {array}[{size}]" for array, size in signature.inputs]
    arguments += [f"{real} {array}[{size}]" for array, size in signature.outputs]
    if signature.parameters:
        arguments.append(f"const {signature.robot}_params *p")
    if signature.states:
        arguments += [f"{signature.robot}_state *state", f"{real} dt"]
    return {
        "arguments": arguments,
        "prototype": _prototype(f"{'static ' if text.stage else ''}void {signature.symbol}(", arguments),
        "lines": lines.statements,
        "results": lines.results,
        "again": text.rereads,
        "inner": _inner(signature, lines, arguments) if lines.angles else None,
        "listing": _listing(signature),
    }


def _listing(signature: Signature) -> dict[str, Any] | None:
    """The function that lists solutions, before the kernel that has all branches."""
    listing = listing_of(signature)
    if listing is None:
        return None
    real = f"{signature.robot}_real"
    arguments = [f"const {real} T[12]"]
    arguments += [f"const {real} q_near[{listing.joints}]"] if listing.near else []
    arguments += [f"{real} Q[{listing.size}]", f"int flags[{listing.branches}]"]
    arguments += [f"const {signature.robot}_params *p"] if signature.parameters else []
    zero = c_spelling(single=signature.scalar == "float").number(Fraction(0))
    return {
        "prototype": _prototype(f"int {listing.symbol}(", arguments),
        "kernel": signature.symbol,
        "near": listing.near,
        "branches": listing.branches,
        "joints": listing.joints,
        "size": listing.size,
        "parameters": bool(signature.parameters),
        "zero": zero,
        "zeros": ", ".join([zero] * listing.joints),
        "flags": {name: f"{signature.robot}_IK_{name}" for name in FLAGS},
        "branch": BRANCH,
    }


def _inner(signature: Signature, lines: Lines, arguments: list[str]) -> dict[str, Any]:
    """The part of a function that is given sines and cosines: what it is called with, and how."""
    passed = [array for array in (SINES, COSINES) if array in lines.reads]
    taken = [f"const {signature.robot}_real {array}[{lines.arrays[array]}]" for array in passed]
    outputs = {array for array, _ in signature.outputs}
    for argument in arguments:
        name = argument.split()[-1].lstrip("*").partition("[")[0]
        is_parameters = argument.endswith("_params *p")
        read = lines.parameters if is_parameters else name in lines.reads | outputs
        if read or name == "state":
            taken.append(argument)
            passed.append(name)
    symbol = f"{signature.symbol}_given_"
    return {
        "prototype": _prototype(f"{signature.robot}_APART_ void {symbol}(", taken),
        "angles": lines.angles,
        "call": f"{symbol}({', '.join(passed)});",
    }


def _prototype(head: str, arguments: list[str]) -> str:
    """``head`` with its arguments, without the closing parenthesis, in lines of moderate length."""
    line = head + ", ".join(arguments)
    if len(line) < WIDTH - 2:
        return line
    return head + (",\n" + " " * 4).join(["\n    " + arguments[0], *arguments[1:]])


def _context(unit: Unit) -> dict[str, Any]:
    name = unit.robot.name
    single = unit.functions[0][0].scalar == "float"
    return {
        **c_builtin(
            name,
            single=single,
            sines=has_sines(unit),
            arctangents=has_arctangents(unit),
        ),
        "contraction": None if unit.contraction is None else unit.contraction.upper(),
        "math": needs_libm(unit),
        "freestanding": freestanding_context(unit, c_spelling(single=single).number),
        "guard": f"{name.upper()}_H",
        "macros": _macros(unit),
    }


def _macros(unit: Unit) -> list[str]:
    """How many columns a regressor has, how many solutions a pose, and the bits of their flags, under the
    robot's name as it is and in capitals."""
    columns = max(len(interface.columns) for interface, _ in unit.functions)
    names = dict.fromkeys((unit.robot.name, unit.robot.name.upper()))
    numbers = {"REGRESSOR_COLUMNS": columns} if columns else {}
    for listing in filter(None, (listing_of(interface) for interface, _ in unit.functions)):
        numbers |= {"IK_MAX": listing.branches, **{f"IK_{name}": bit for name, bit in FLAGS.items()}}
    return [f"#define {name}_{what} {value}" for name in names for what, value in numbers.items()]


def _notes(unit: Unit) -> tuple[str, ...]:
    return misra_notes(unit) if unit.misra else ()


LANGUAGE = Language(
    name="c",
    title="C",
    default=True,
    suffixes=(".c",),
    files={"NAME.h": "c/kernel.h.j2", "NAME.c": "c/kernel.c.j2"},
    package_tests={"NAME_vectors.c": "c/vectors.c.j2"},
    spelling=lambda single: c_spelling(single=single),
    syntax=_syntax,
    function=_function,
    repeating=_repeating,
    context=_context,
    advice=advice,
    notes=_notes,
    features=frozenset({"batch", "parallel", "misra", "firmware"}),
    batch=batch_files,
    compiled=Compiled(
        compiler=Tool(
            ("cc", "gcc", "clang"),
            Use.KERNELS,
            "kernels called from Python, verify, bench, simulate",
            "gcc",
            "Fedora: dnf install gcc; macOS: xcode-select --install",
            variable="CC",
        ),
        flags=("-std=c99", "-O2", "-ffp-contract=off", "-fno-math-errno"),
        symbol=lambda signature: signature.symbol,
        header=True,
    ),
)
