"""CUDA: functions for threads of a GPU, which are C++ for the host as well, and kernels over many states.

The statements are those of C. The arrays of a function are of any type that has ``[]``: pointers, or the
lane of a state in a batch, so that a kernel reads and writes memory where the function does and keeps no
copies. Sine and cosine of the library come from one call.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Final

from robodyn.emit.c_syntax import c_spelling, c_syntax, prototype, refused
from robodyn.emit.language import FunctionText, Language
from robodyn.emit.languages.c import listing_prototype, macros, repeating
from robodyn.emit.loops import COSINES, SINES
from robodyn.emit.spelling import Sines, Syntax, call
from robodyn.emit.statements import Expression
from robodyn.emit.unit import Unit, builtin_words, has_arctangents, has_sines, listing_of
from robodyn.ir.signature import Signature
from robodyn.tools import Tool, Use

#: States that stand together in memory: the threads of a warp. Threads of a block at most: each may have 255
#: registers then.
LANES, THREADS = 32, 256

NVCC: Final = Tool(
    ("nvcc",),
    Use.LANGUAGES,
    "kernels in CUDA compiled for GPUs",
    "nvidia-cuda-toolkit",
    "pip install nvidia-cuda-nvcc, https://developer.nvidia.com/cuda-downloads",
    variable="NVCC",
)


def _syntax(signature: Signature, unit: Unit) -> Syntax:
    robot, single = signature.robot, signature.scalar == "float"
    spelling = c_spelling(single=single, states=signature.states)
    if unit.builtin:
        spelling = spelling.calling(atan2=call(f"{robot}_atan2_"))
    # Without const: nvcc's front end would try to know each value beforehand, through all that it is made of
    # and again wherever it is used, which takes forever in derivatives.
    syntax = replace(
        c_syntax(spelling, f"{robot}_real"),
        declare=lambda name, value: f"{robot}_real {name} = {value};",
    )
    library = "sincosf" if single else "sincos"
    return replace(syntax, sines=_sines(f"{robot}_sincos_" if unit.builtin else library, syntax, robot))


def _sines(function: str, syntax: Syntax, robot: str) -> Sines:
    """Sines and cosines without a loop: an array with constant indices is no memory but registers."""

    def turned(angle: Expression, sine: str, cosine: str) -> list[str]:
        return syntax.line(f"{function}({syntax.spelling.text(angle)}, &{sine}, &{cosine});")

    def every(angles: Sequence[Expression]) -> list[str]:
        distinct = tuple(dict.fromkeys(angles))
        lines = [f"    {robot}_real {array}[{len(distinct)}];" for array in (SINES, COSINES)]
        for k, angle in enumerate(distinct):
            lines += turned(angle, f"{SINES}[{k}]", f"{COSINES}[{k}]")
        return lines

    def pair(array: str, angle: Expression) -> list[str]:
        return [f"    {robot}_real {array}[2];", *turned(angle, f"{array}[0]", f"{array}[1]")]

    return Sines(every, pair)


def _function(text: FunctionText) -> dict[str, Any]:
    signature, lines, real = text.signature, text.lines, f"{text.signature.robot}_real"
    arrays = (*signature.inputs, *signature.outputs)
    after = [f"const {signature.robot}_params *{{}}p"] if signature.parameters else []
    held = [f"{signature.robot}_state *state", f"{real} dt"] if signature.states else []
    taken = [f"{array}_array {array}" for array, _ in arrays]
    taken += [argument.format("") for argument in after] + held
    given = ["size_t count", *(f"const {real} *__restrict__ {array}" for array, _ in signature.inputs)]
    given += [f"{real} *__restrict__ {array}" for array, _ in signature.outputs]
    given += [argument.format("__restrict__ ") for argument in after]
    given += [f"{real} *__restrict__ state", f"{real} dt"] if signature.states else []
    lanes = [f"{signature.robot}_lane_of<{size}>({array}, k)" for array, size in arrays]
    lanes += (["p"] if after else []) + (["&now", "dt"] if held else [])
    listing = listing_of(signature)
    return {
        "template": prototype("template <", [f"class {array}_array" for array, _ in arrays]) + ">",
        "prototype": prototype(f"{signature.robot}_INLINE_ void {signature.symbol}(", taken) + ")",
        "lines": [*lines.angles, *lines.statements],
        "kernel": prototype(
            f'extern "C" __global__ void __launch_bounds__({THREADS}) {signature.symbol}_blocks(', given
        )
        + ")",
        "call": prototype(f"        {signature.symbol}(", lanes).replace("\n", "\n        ") + ");",
        "states": signature.states,
        "listing": listing,
        "listing_prototype": listing and f"{signature.robot}_INLINE_ {listing_prototype(listing, real)}",
    }


def _context(unit: Unit) -> dict[str, Any]:
    return {
        "refused": refused({"trig": has_sines(unit), "arctangent": has_arctangents(unit)}),
        "guard": f"{unit.robot.name.upper()}_CUH",
        "macros": macros(unit),
        "lanes": LANES,
        "uint": "unsigned int" if unit.single else "unsigned long long",
        "int": "int" if unit.single else "long long",
    }


def _advice(unit: Unit) -> tuple[str, ...]:
    name = unit.robot.name
    advice: tuple[str, ...] = (
        f"{name}.cuh has functions of one state, for threads and for the host, {name}.cu kernels ..._blocks "
        f"of count states, any number of them. A kernel's arrays hold blocks of {LANES} states: element j of "
        f"state k, of n a state, is [(k/{LANES}*n + j)*{LANES} + k%{LANES}], the last block is as long as "
        f"the others. Any grid does, of at most {THREADS} threads a block; results must not overlap inputs.",
    )
    if unit.builtin:
        advice += (
            f"{builtin_words(unit)}. nvcc -fmad=false: the bits of the C with -ffp-contract=off; without it "
            "products and sums are fused, which is faster.",
        )
    return advice


LANGUAGE = Language(
    name="cuda",
    title="CUDA",
    aliases=("cu",),
    suffixes=(".cu", ".cuh"),
    files={"NAME.cuh": "cuda/kernel.cuh.j2", "NAME.cu": "cuda/kernel.cu.j2"},
    spelling=lambda single: c_spelling(single=single),
    syntax=_syntax,
    function=_function,
    repeating=repeating,
    context=_context,
    advice=_advice,
    trig="builtin",
    joins_sines=True,
    takers=(NVCC,),
)
