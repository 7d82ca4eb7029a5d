"""The C between Python and the emitted kernels: a loop over states, and a call on one block of memory.

None of it is part of what is emitted. For each function there are

``F_robodyn_batch(count, inputs..., outputs..., parameters)``
    runs F on ``count`` states that stand one after another in each array;
``F_robodyn_work(block)``
    runs F on arrays that stand in one block: inputs, outputs, parameters (see :func:`layout`).

Parameters come as an array in the order of :func:`parameters_of` and are put into ``NAME_params`` by name.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from pathlib import PurePosixPath
from typing import NamedTuple

from robodyn.emit.language import Compiled
from robodyn.emit.languages import compiled_language
from robodyn.errors import InputError
from robodyn.ir.signature import Signature


class Layout(NamedTuple):
    """Where the arrays of a function stand in its block, in numbers (not bytes): ``(name, offset, length)``
    of inputs and outputs; offsets of the parameters and of the states, after which comes the time step; and
    the block's length."""

    places: tuple[tuple[str, int, int], ...]
    parameters: int
    states: int
    length: int


def layout(signature: Signature, parameters: Sequence[str]) -> Layout:
    """The block of ``signature``: inputs, outputs, parameters, states and time step one after another."""
    arrays = (*signature.inputs, *signature.outputs)
    offsets = [0, *itertools.accumulate(length for _, length in arrays)]
    places = tuple((name, offset, length) for (name, length), offset in zip(arrays, offsets, strict=False))
    states = offsets[-1] + len(parameters)
    memory = len(signature.states) + 1 if signature.states else 0
    return Layout(places, offsets[-1], states, states + memory)


def parameters_of(signatures: Sequence[Signature]) -> tuple[str, ...]:
    """The run-time parameters of all functions together, in the order of ``NAME_params``."""
    names: dict[str, None] = {}
    for signature in sorted(signatures, key=lambda s: -len(s.parameters)):
        names.update(dict.fromkeys(signature.parameters))
    return tuple(names)


def prototypes(signatures: Sequence[Signature]) -> str:
    """C declarations of what :func:`wrapper` defines; also what cffi reads."""
    return "".join(f"void {_batch(s)};\nvoid {_work(s)};\n" for s in signatures)


def wrapper(signatures: Sequence[Signature], files: Mapping[str, str], language: str) -> str:
    """The C source.

    Where there is an emitted header it is included, so that the compiler checks the two against each other;
    else the functions are declared here.

    Raises
    ------
    InputError: the language has headers, and there is none among ``files``.
    """
    robot = signatures[0].robot
    tools = compiled_language(language)[1]
    parameters = parameters_of(signatures)
    lines = [f"/* Calls from Python into the kernels of {robot}. */", "#include <stddef.h>"]
    if tools.header:
        header = next((path for path in files if PurePosixPath(path).name == f"{robot}.h"), None)
        if header is None:
            raise InputError(
                f"the emitted files of {robot} have no header",
                found=", ".join(files) or "no file at all",
                expected=f"{robot}.h among them",
            )
        lines.append(f'#include "{header}"')
    else:
        lines += _declarations(signatures, parameters, tools)
    lines.append(prototypes(signatures))
    for signature in signatures:
        lines += _definitions(signature, parameters, tools)
    return "\n".join(lines) + "\n"


def _batch(s: Signature) -> str:
    inputs = "".join(f", const {s.scalar} *i{k}" for k in range(len(s.inputs)))
    outputs = "".join(f", {s.scalar} *o{k}" for k in range(len(s.outputs)))
    past = f", {s.scalar} *states, {s.scalar} dt" if s.states else ""
    return f"{s.function}_robodyn_batch(ptrdiff_t count{inputs}{outputs}, const {s.scalar} *parameters{past})"


def _work(s: Signature) -> str:
    return f"{s.function}_robodyn_work({s.scalar} *block)"


def _declarations(signatures: Sequence[Signature], parameters: Sequence[str], tools: Compiled) -> list[str]:
    """What an emitted header would say of the functions."""
    first = signatures[0]
    lines = []
    if parameters:
        members = " ".join(f"{first.scalar} {name};" for name in parameters)
        lines.append(f"typedef struct {{ {members} }} {first.robot}_params;")
    for s in signatures:
        if s.states:
            members = " ".join(f"{s.scalar} {name};" for name in s.states)
            lines.append(f"typedef struct {{ {members} }} {s.robot}_state;")
        arguments = [f"const {s.scalar} *"] * len(s.inputs) + [f"{s.scalar} *"] * len(s.outputs)
        if s.parameters:
            arguments.append(f"const {s.robot}_params *")
        if s.states:
            arguments += [f"{s.robot}_state *", s.scalar]
        lines.append(f"void {tools.symbol(s)}({', '.join(arguments)});")
    return lines


def _definitions(s: Signature, parameters: Sequence[str], tools: Compiled) -> list[str]:
    symbol = tools.symbol(s)
    block = layout(s, parameters)
    last = (["&p"] if s.parameters else []) + (["&state", "dt"] if s.states else [])
    steps = [f"i{k} + {length} * k" for k, (_, length) in enumerate(s.inputs)]
    steps += [f"o{k} + {length} * k" for k, (_, length) in enumerate(s.outputs)]
    places = [f"block + {offset}" for _, offset, _ in block.places]

    def fill(source: str, start: int) -> list[str]:
        if not s.parameters:
            return []
        members = [
            f"    p.{name} = {source}[{start + k}];"
            for k, name in enumerate(parameters)
            if name in s.parameters
        ]
        return [f"    {s.robot}_params p = {{0}};", *members]

    def past(source: str, start: int, *, back: bool = False) -> list[str]:
        if not s.states:
            return []
        moves = [(f"state.{name}", f"{source}[{start + k}]") for k, name in enumerate(s.states)]
        if back:
            return [f"    {there} = {here};" for here, there in moves]
        return [f"    {s.robot}_state state = {{0}};", *(f"    {here} = {there};" for here, there in moves)]

    step = block.states + len(s.states)
    return [
        f"void {_batch(s)}",
        "{",
        "    ptrdiff_t k;",
        *fill("parameters", 0),
        *past("states", 0),
        "    (void)parameters;",
        "    for (k = 0; k < count; ++k) {",
        f"        {symbol}({', '.join([*steps, *last])});",
        "    }",
        *past("states", 0, back=True),
        "}",
        "",
        f"void {_work(s)}",
        "{",
        *fill("block", block.parameters),
        *past("block", block.states),
        *([f"    {s.scalar} dt = block[{step}];"] if s.states else []),
        f"    {symbol}({', '.join([*places, *last])});",
        *past("block", block.states, back=True),
        "}",
        "",
    ]
