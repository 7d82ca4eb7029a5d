"""JavaScript: a module without dependencies, for browsers and node.

Numbers are doubles and no product is fused with a sum, so a kernel with its own sine and cosine gives the
bits of the C. The functions of ``Math`` beyond ``abs`` and ``sqrt`` are an engine's own: their last bits may
differ from those of C's library and of another engine.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from robodyn.emit.body import Lines
from robodyn.emit.language import FunctionText, Language
from robodyn.emit.loops import ANGLES, COSINES, SINES
from robodyn.emit.spelling import Sines, Spelling, Syntax, call, elements, functions_of
from robodyn.emit.stages import NEXT, ROW, Repeated, Stage
from robodyn.emit.statements import Expression
from robodyn.emit.unit import BUILTIN, Unit, builtin_words, calls
from robodyn.ir.program import STATE
from robodyn.ir.signature import Signature
from robodyn.tools import Tool, Use

#: Operations whose last bits are the engine's; sine and cosine too unless they are built in.
_INEXACT = frozenset({"exp", "pow", "tanh"})


def _spelling(states: Sequence[str] = ()) -> Spelling:
    return Spelling(
        literal=lambda digits: digits,
        element=elements(states, "state.{}", "{}[{}]"),
        member=lambda name: f"p.{name}",
        functions={
            **functions_of("Math.{}"),
            "select": lambda c, a, b: f"({c} > 0.0 ? {a} : {b})",
            # Math.sign keeps the sign of -0, which C's comparison does not.
            "sign": lambda x: f"({x} > 0.0 ? 1.0 : {x} < 0.0 ? -1.0 : 0.0)",
        },
        single=False,
        times=" * ",
    )


def _syntax(signature: Signature, unit: Unit) -> Syntax:
    spelling = _spelling(signature.states)
    if unit.builtin:
        spelling = spelling.calling(atan2=call("atan2"))
    syntax = Syntax(
        spelling,
        comment="// %s",
        declare=lambda name, text: f"const {name} = {text};",
        assign=lambda target, text: f"{target} = {text};",
    )
    return replace(syntax, sines=_sines(syntax))


def _sines(syntax: Syntax) -> Sines:
    """``sincos`` of an angle is the array of both."""
    spelling = syntax.spelling

    def every(angles: Sequence[Expression]) -> list[str]:
        size = len(angles)
        arrays = [f"    const {array} = new Float64Array({size});" for array in (SINES, COSINES)]
        if size == 1:
            return [*arrays, *syntax.line(f"[{SINES}[0], {COSINES}[0]] = sincos({spelling.row(angles)});")]
        return [
            *syntax.line(f"const {ANGLES} = [{spelling.row(angles)}];"),
            *arrays,
            f"    for (let i = 0; i < {size}; ++i) [{SINES}[i], {COSINES}[i]] = sincos({ANGLES}[i]);",
        ]

    return Sines(every, lambda array, x: syntax.line(f"const {array} = sincos({spelling.text(x)});"))


def _repeating(it: Repeated, syntax: Syntax) -> Lines:
    def called(stage: Stage, indent: str = "", **places: str) -> list[str]:
        return [indent + line for line in syntax.line(f"{stage.call(**places)};")]

    row = STATE if it.rows == 1 else ROW
    loop = [
        f"    for (let k = 0; k < {it.most} && !({row}[{it.size - 1}] > 0.0); ++k) {{",
        *called(it.step, "    ", **{STATE: row}),
        f"        {row}.set({NEXT});",
        "    }",
    ]
    if it.rows > 1:
        loop = [
            f"    for (let j = 0; j < {it.rows}; ++j) {{",
            f"        const {ROW} = {STATE}.subarray({it.size} * j, {it.size} * (j + 1));",
            *(f"    {line}" for line in loop),
            "    }",
        ]
    declared = [f"    const {array} = new Float64Array({size});" for array, size in it.arrays.items()]
    return Lines([*declared, *called(it.start), *loop, *called(it.finish)], it.arrays)


def _function(text: FunctionText) -> dict[str, Any]:
    signature, lines = text.signature, text.lines
    arguments = [array for array, _ in (*signature.inputs, *signature.outputs)]
    arguments += ["p"] if signature.parameters else []
    arguments += ["state", "dt"] if signature.states else []
    return {
        "name": signature.called,
        "arguments": ", ".join(arguments),
        "lines": [*lines.angles, *lines.statements],
    }


def _advice(unit: Unit) -> tuple[str, ...]:
    advice: tuple[str, ...] = (
        "Arrays are those of the caller: any that can be indexed, results are written into them.",
    )
    if unit.builtin:
        words = f"{builtin_words(unit)}. The same bits in every engine, and those of the C with "
        advice += (f"{words}-ffp-contract=off.",)
    if calls(unit) & (_INEXACT if unit.builtin else _INEXACT | BUILTIN):
        advice += (
            "Functions of Math are called; but for sqrt and abs their last bits are the engine's own.",
        )
    return advice


LANGUAGE = Language(
    name="javascript",
    title="JavaScript",
    aliases=("js",),
    suffixes=(".mjs",),
    files={"NAME.mjs": "javascript/kernel.mjs.j2"},
    tests={"NAME.test.mjs": "javascript/vectors.mjs.j2"},
    spelling=lambda single: _spelling(),
    syntax=_syntax,
    function=_function,
    repeating=_repeating,
    advice=_advice,
    type_name=lambda robot, kind: {"params": "p"}.get(kind, kind),
    trig="builtin",
    scalars=("double",),
    takers=(Tool(("node",), Use.LANGUAGES, "tests of JavaScript modules", "nodejs", "https://nodejs.org"),),
)
