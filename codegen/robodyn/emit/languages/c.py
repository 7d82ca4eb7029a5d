"""C99, also valid C++."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from robodyn.emit.body import Lines
from robodyn.emit.c_syntax import c_spelling, c_syntax, prototype, refused
from robodyn.emit.language import Compiled, FunctionText, Language
from robodyn.emit.loops import ANGLES, COSINES, SINES, Run
from robodyn.emit.spelling import Sines, Syntax, call
from robodyn.emit.stages import NEXT, ROW, Repeated, Stage
from robodyn.emit.statements import Expression
from robodyn.emit.unit import (
    Listing,
    Unit,
    advice,
    freestanding_calls,
    has_arctangents,
    has_sines,
    listing_of,
    misra_notes,
    needs_libm,
)
from robodyn.ir.program import STATE
from robodyn.ir.signature import Signature
from robodyn.tools import Tool, Use


def _syntax(signature: Signature, unit: Unit) -> Syntax:
    spelling = c_spelling(single=signature.scalar == "float", states=signature.states, explicit=unit.misra)
    ours = freestanding_calls(unit) | ({"atan2"} if unit.builtin else set())
    spelling = spelling.calling(**{op: call(f"{signature.robot}_{op}_") for op in ours})
    syntax = c_syntax(spelling, f"{signature.robot}_real")
    return replace(syntax, sines=_sines(signature.robot, syntax))


def _sines(name: str, syntax: Syntax) -> Sines:
    """``NAME_sincos_`` in C."""
    real, spelling = f"{name}_real", syntax.spelling

    def filled(array: str, values: Sequence[Expression]) -> list[str]:
        return syntax.line(f"const {real} {array}[{len(values)}] = {{{spelling.row(values)}}};")

    def loop(size: int, statement: str) -> list[str]:
        if size == 1:
            return [f"    {statement.replace('[i]', '[0]')}"]
        return [f"    for (int i = 0; i < {size}; ++i) {{", f"        {statement}", "    }"]

    def every(angles: Sequence[Expression]) -> list[str]:
        size = len(angles)
        results = [f"    {real} {array}[{size}];" for array in (SINES, COSINES)]
        turn = f"{name}_sincos_({ANGLES}[i], &{SINES}[i], &{COSINES}[i]);"
        return [*filled(ANGLES, angles), *results, *loop(size, turn)]

    def pair(array: str, angle: Expression) -> list[str]:
        turn = f"{name}_sincos_({spelling.text(angle)}, &{array}[0], &{array}[1]);"
        return [f"    {real} {array}[2];", *syntax.line(turn)]

    def run(it: Run) -> list[str]:
        size = len(it.ups)
        ups, alongs, angles = it.arrays
        turn = spelling.functions["atan2"](f"{ups}[i]", f"{alongs}[i]")
        return [
            *filled(ups, it.ups),
            *filled(alongs, it.alongs),
            f"    {real} {angles}[{size}];",
            *loop(size, f"{angles}[i] = {turn};"),
        ]

    return Sines(every, pair, run)


def repeating(it: Repeated, syntax: Syntax) -> Lines:
    """The lines of a function that repeats a step."""
    real, zero = f"{it.whole.robot}_real", syntax.spelling.number(Fraction(0))

    def called(stage: Stage, indent: str = "", **places: str) -> list[str]:
        return [indent + line for line in syntax.line(f"{stage.call(**places)};")]

    row = STATE if it.rows == 1 else ROW
    loop = [
        f"    for (int k = 0; k < {it.most}; ++k) {{",
        f"        if ({row}[{it.size - 1}] > {zero}) {{",
        "            break;",
        "        }",
        *called(it.step, "    ", **{STATE: row}),
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
    declared = [f"    {real} {array}[{size}];" for array, size in it.arrays.items()]
    return Lines([*declared, *called(it.start), *loop, *called(it.finish)], it.arrays)


def _function(text: FunctionText) -> dict[str, Any]:
    signature, real = text.signature, f"{text.signature.robot}_real"
    arguments = {array: f"const {real} {array}[{size}]" for array, size in signature.inputs}
    arguments |= {array: f"{real} {array}[{size}]" for array, size in signature.outputs}
    if signature.parameters:
        arguments["p"] = f"const {signature.robot}_params *p"
    if signature.states:
        arguments |= {"state": f"{signature.robot}_state *state", "dt": f"{real} dt"}
    listing = listing_of(signature)
    static = "static " if text.stage else ""
    return {
        "arguments": list(arguments.values()),
        "prototype": prototype(f"{static}void {signature.symbol}(", list(arguments.values())),
        "lines": text.lines.statements,
        "inner": _inner(signature, text.lines, arguments) if text.lines.angles else None,
        "listing": listing,
        "listing_prototype": listing and listing_prototype(listing, real),
    }


def listing_prototype(listing: Listing, real: str) -> str:
    """The head of a list of solutions, without its closing parenthesis."""
    arguments = [f"const {real} T[12]"]
    arguments += [f"const {real} q_near[{listing.joints}]"] if listing.near else []
    arguments += [f"{real} Q[{listing.size}]", f"int flags[{listing.branches}]"]
    arguments += [f"const {listing.kernel.robot}_params *p"] if listing.kernel.parameters else []
    return prototype(f"int {listing.symbol}(", arguments)


def _inner(signature: Signature, lines: Lines, arguments: dict[str, str]) -> dict[str, Any]:
    """The part of a function that is given sines and cosines: what it is called with, and how."""
    read = {"p" if x.index is None else x.array for x in lines.inputs}
    used = read | {array for array, _ in signature.outputs} | {"state"}
    given = {
        array: f"const {signature.robot}_real {array}[{lines.arrays[array]}]"
        for array in (SINES, COSINES)
        if array in read
    }
    given |= {name: argument for name, argument in arguments.items() if name in used}
    symbol = f"{signature.symbol}_given_"
    return {
        "prototype": prototype(f"{signature.robot}_APART_ void {symbol}(", list(given.values())),
        "angles": lines.angles,
        "call": f"{symbol}({', '.join(given)});",
    }


def _context(unit: Unit) -> dict[str, Any]:
    builtin = {"trig": has_sines(unit), "arctangent": has_arctangents(unit)}
    return {
        "refused": refused(builtin),
        "contraction": None if unit.contraction is None else unit.contraction.upper(),
        "math": needs_libm(unit),
        "freestanding": _freestanding(unit),
        "guard": f"{unit.robot.name.upper()}_H",
        "macros": macros(unit),
    }


#: Where the compiler has an instruction for the square root of a float (True), of a double.
_INSTRUCTION = {
    True: "(defined(__ARM_FP) && ((__ARM_FP & 4) != 0)) || defined(__riscv_fsqrt)",
    False: "(defined(__ARM_FP) && ((__ARM_FP & 8) != 0)) || (defined(__riscv_fsqrt) && (__riscv_flen >= 64))",
}


def _freestanding(unit: Unit) -> dict[str, Any] | None:
    """What the template of absolute values and square roots without a library is told, to the same bits
    (IEEE 754 rounds both correctly); None where nothing of it is called."""
    called = freestanding_calls(unit)
    if not called:
        return None
    number = c_spelling(single=unit.single).number
    # Digits behind the first, and the power of two (twice an even one) that makes a subnormal number normal.
    digits, power, bias = (23, 24, 127) if unit.single else (52, 54, 1023)
    return {
        "called": called,
        "suffix": "f" if unit.single else "",
        "instruction": f"defined(__SSE2__) || defined(__aarch64__) || {_INSTRUCTION[unit.single]}",
        "digits": digits,
        "bias": bias,
        "size": f"0x7{'f' * (7 if unit.single else 15)}u",
        "unit": f"{1 << digits:#x}u",
        "fraction": f"{(1 << digits) - 1:#x}u",
        "infinite": f"{(2 * bias + 1) << digits:#x}u",
        "zero": number(Fraction(0)),
        "one": number(Fraction(1)),
        "up": number(Fraction(2) ** power),
        "down": number(Fraction(1, 2 ** (power // 2))),
    }


def macros(unit: Unit) -> list[str]:
    """How many columns a regressor has, how many solutions a pose, and the bits of their flags, under the
    robot's name as it is and in capitals."""
    columns = max(len(interface.columns) for interface, _ in unit.functions)
    names = dict.fromkeys((unit.robot.name, unit.robot.name.upper()))
    numbers = {"REGRESSOR_COLUMNS": columns} if columns else {}
    for listing in filter(None, (listing_of(interface) for interface, _ in unit.functions)):
        numbers |= {"IK_MAX": listing.branches, **{f"IK_{name}": bit for name, bit in listing.flags.items()}}
    return [f"#define {name}_{what} {value}" for name in names for what, value in numbers.items()]


def _batch(unit: Unit) -> dict[str, str]:
    from robodyn.emit.batch import batch_files

    return batch_files(unit)


LANGUAGE = Language(
    name="c",
    title="C",
    suffixes=(".c",),
    files={"NAME.h": "c/kernel.h.j2", "NAME.c": "c/kernel.c.j2"},
    package_tests={"NAME_vectors.c": "c/vectors.c.j2"},
    spelling=lambda single: c_spelling(single=single),
    syntax=_syntax,
    function=_function,
    repeating=repeating,
    context=_context,
    advice=lambda unit: (misra_notes(unit) if unit.misra else ()) + advice(unit),
    features=frozenset({"batch", "misra", "firmware"}),
    batch=_batch,
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
