"""Worst-case stack: what gcc says of each function, along the longest chain of calls."""

from __future__ import annotations

import platform
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from robodyn.certify.plan import Finding, ProofOptions, Subject, Tell, last_lines, not_run, run, version
from robodyn.emit.unit import freestanding_calls
from robodyn.firmware.measure import Depth, deepest
from robodyn.targets import firmware_targets
from robodyn.toolchain.compiler import C_FLAGS
from robodyn.tools import Tool
from robodyn.tools.programs import GCC

#: A folder with what a kernel includes of the C library, for compilers that come without one.
STAND_IN = "stand_in"
MATH_H = "".join(
    f"{real} {name}{end}({real}{', ' + real if name in ('pow', 'atan2') else ''});\n"
    for name in ("sin", "cos", "tanh", "sqrt", "fabs", "exp", "pow", "atan2")
    for real, end in (("double", ""), ("float", "f"))
)
#: gcc has a <stdint.h> of its own, but leaves it to the library.
HEADERS = {"math.h": MATH_H, "stdint.h": "#include <stdint-gcc.h>\n"}


@dataclass(frozen=True, slots=True)
class Machine:
    """A compiler with the flags of a processor."""

    name: str
    tool: Tool
    flags: tuple[str, ...]


#: Without the red zone, which gcc does not count.
_HERE = ("-mno-red-zone",) if platform.machine() in ("x86_64", "AMD64") else ()


def machines(*, freestanding: bool = False) -> tuple[Machine, ...]:
    """This machine, and every target that a firmware image is made for; ``freestanding``: those compile a
    kernel that does without a C library."""
    without = ("-ffreestanding",) if freestanding else ()
    boards = [(target, target.board) for target in firmware_targets() if target.board is not None]
    others = [
        Machine(f"{t.name}, gcc -O2", board.architecture.compiler, (*C_FLAGS, *without, *(t.flags or ())))
        for t, board in boards
    ]
    return (Machine("this machine, gcc -O2", GCC, (*C_FLAGS, *_HERE)), *others)


def command(machine: Machine, source: str) -> list[str]:
    """What compiles ``source`` and writes what each function needs."""
    options = ["-idirafter", STAND_IN, "-fcallgraph-info=su", "-c", source, "-o", "stack.o"]
    return [machine.tool.name, *machine.flags, *options]


def measure(machine: Machine, source: str, functions: Iterable[str], folder: Path) -> list[Depth]:
    """The stack of ``functions`` of ``source`` in ``folder``; one depth that says why where there is none."""
    done = run([machine.tool.needed(), *command(machine, source)[1:]], folder, 300)
    graph = folder / "stack.ci"
    if done.code != 0 or not graph.is_file():
        no_graph = "the compiler wrote no call graph (gcc 10 or newer does)"
        reason = last_lines(done.output, 1) if done.code else no_graph
        return [Depth(None, None, (), f"not compiled: {reason}")]
    text = graph.read_text(encoding="utf-8", errors="replace")
    return [deepest(text, function) for function in functions]


def prove_stack(subject: Subject, proofs: ProofOptions, folder: Path, tell: Tell) -> Finding:
    """The most stack a call needs, machine by machine."""
    every = machines(freestanding=bool(freestanding_calls(subject.generated.unit)))
    if all(machine.tool.path() is None for machine in every):
        return not_run("stack", GCC)
    source = f"{subject.generated.unit.robot.name}.c"
    symbols = [s.symbol for s in subject.generated.signatures]
    lines, rows, commands = list[str](), list[dict[str, Any]](), list[str]()
    tools: dict[str, None] = {}
    measured: list[Depth] = []
    stand_ins = {f"{STAND_IN}/{name}": text for name, text in HEADERS.items()}
    (folder / STAND_IN).mkdir()
    for name, text in stand_ins.items():
        (folder / name).write_text(text, encoding="utf-8", newline="\n")
    for machine in every:
        if machine.tool.path() is None:
            depths = [Depth(None, None, (), f"needs {machine.tool.remedy}")]
            lines.append(f"{machine.name}: not run, {depths[0].reason}")
        else:
            tell(f"stack, {machine.name}")
            depths = measure(machine, source, symbols, folder)
            tools[version(machine.tool)] = None
            commands.append(" ".join(command(machine, source)))
            lines += [f"{machine.name}: {_depth_text(depth)}" for depth in depths]
            measured += depths
        rows += [
            {
                "machine": machine.name,
                "function": depth.function,
                "bytes": depth.size,
                "chain": list(depth.chain),
                "beyond": list(depth.beyond),
                "reason": depth.reason,
            }
            for depth in depths
        ]
    some = any(depth.size is not None and not depth.beyond for depth in measured)
    all_known = all(depth.size is not None and depth.only_helpers for depth in measured)
    return Finding(
        "stack",
        "proved" if some and all_known else "failed",
        "The most stack that a call needs, with all that it calls: no recursion, no call by a pointer, no "
        "array of a length that is known only at run time.",
        tuple(lines),
        {"stack": rows},
        tuple(tools),
        tuple(commands),
        stand_ins,
    )


def _depth_text(depth: Depth) -> str:
    if depth.function is None:
        return depth.reason
    size = "no bound" if depth.size is None else f"{depth.size} B"
    return f"{depth.function} {size}{f' ({depth.reason})' if depth.reason else ''}"
