"""A page for each function that kernels may have, from its record, and its operations beside other tools'."""

from __future__ import annotations

import json
import re
from functools import cache
from typing import Any, Final

from benchmarks.functions import tables

from robodyn.dynamics.functions import FUNCTIONS, Array, Function
from robodyn_site.markdown import code, fenced, page, plain, sentence, table
from robodyn_site.outside import ROOT

FOLDER: Final = "functions"


def pages() -> dict[str, str]:
    """The pages of the functions, and the document that lists them, with links."""
    document = (ROOT / "docs" / "functions.md").read_text(encoding="utf-8")
    each = {f"{FOLDER}/{name}.md": of_function(function) for name, function in FUNCTIONS.items()}
    return {"functions.md": linked(document)} | each


def linked(document: str) -> str:
    """A document in which each function that begins a row of a table leads to its page."""

    def row(match: re.Match[str]) -> str:
        name = match[1]
        return f"| [{match[0][2:]}]({FOLDER}/{name}.md)" if name in FUNCTIONS else match[0]

    return re.sub(r"^\| `(\w+)[^`]*`", row, document, flags=re.MULTILINE)


def of_function(function: Function) -> str:
    """The page of one function."""
    written = (
        "It is written unless `--functions` names others."
        if function.by_default
        else f"It is written on request: `--functions {function.name}`."
    )
    return page(
        f"# {function.name}",
        f"{sentence(plain(function.purpose))} {written}",
        fenced(f"robodyn gen ROBOT --functions {function.name}", "sh"),
        fenced(_python(function), "python"),
        "## Arguments",
        table(
            ("argument", "shape", "what", "unit", "at a prismatic joint"),
            [_row(array, "input") for array in function.inputs]
            + [_row(array, "result") for array in function.results],
        ),
        "`n` is the number of joints, `p` that of base parameters, `b` that of branches. In C, Fortran and "
        "Rust each argument is "
        "one array, a matrix row by row; Python has arrays of these shapes, or `[N, ...]` for N states.",
        "## What it includes",
        _facts(function),
        _operations(function.name),
        "[All functions](../functions.md), and the frames that they are in.",
    )


def _python(function: Function) -> str:
    results = ", ".join(array.name for array in function.results)
    inputs = ", ".join(array.name for array in function.inputs)
    return (
        f'kernel = robodyn.compile(robot, functions=["{function.name}"])\n'
        f"{results} = kernel.{function.name}({inputs})"
    )


def _row(array: Array, role: str) -> tuple[str, ...]:
    shape = f"[{', '.join(map(str, array.shape))}]" if array.shape else "one number"
    holds = array.holds + (" (result)" if role == "result" else "")
    return code(array.name), plain(shape), plain(holds), plain(array.unit), plain(array.prismatic)


def _facts(function: Function) -> str:
    facts = []
    if function.parts:
        parts = ", ".join(f"[`{name}`]({name}.md)" for name in function.parts)
        facts.append(f"It may be put together from the best known programs of {parts}.")
    if function.solves:
        facts.append(
            "It solves for accelerations: an arm does not have it if a joint moves without inertia, or with "
            "friction that depends on the accelerations."
        )
    if function.geometric:
        facts.append(
            "It depends on the links' places and motion alone, not on friction, rotors and other effects."
        )
    elif not function.drives:
        facts.append("It is that of the rigid arm, without friction and other effects of the drives.")
    else:
        facts.append("It includes the drives: friction, rotors, and the effects of the description.")
    if function.of_pose:
        facts.append(
            "Only arms whose inverse kinematics has a closed form have it ([which, and how it is "
            "used](../inverse-kinematics.md))."
        )
        facts.append(
            "Before it is written, its program is evaluated at 60 digits: what it says of a pose must lead "
            "back there in plain forward kinematics."
        )
        return "\n".join(f"- {fact}" for fact in facts)
    facts.append(
        "Before it is written, its program is compared without rounding with "
        + ("the same by another way." if function.expected else "an equation that the results must fulfil.")
    )
    return "\n".join(f"- {fact}" for fact in facts)


@cache
def _figures() -> dict[str, Any]:
    file = ROOT / "benchmarks" / "results" / "functions.json"
    figures: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
    return figures


def _operations(name: str) -> str:
    if name not in tables.functions(_figures()):
        return ""
    return page(
        "## Operations",
        tables.of_function(_figures(), name),
        "How they were counted: [every function, beside other tools](../benchmarks/functions.md).",
    )
