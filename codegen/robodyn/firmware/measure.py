"""The cost of a kernel on a processor: size and stack from the cross compiler, instructions from qemu.

If a tool is missing, the figures name it and say how to install it. If the self-test fails on the processor,
that is an error, because no figure would mean anything.
"""

from __future__ import annotations

import dataclasses
import re
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from robodyn.dynamics.functions import emitted_name
from robodyn.errors import CheckError, InputError, ToolError
from robodyn.targets import Board, Target
from robodyn.toolchain.compiler import first_lines
from robodyn.toolchain.running import run
from robodyn.tools import Tool

#: Flags of kernel, self-test and image. No multiply-add is fused, so results are the same on every machine.
FLAGS = (
    "-O2", "-ffp-contract=off", "-fno-math-errno", "-ffreestanding", "-ffunction-sections", "-fdata-sections",
)  # fmt: skip
#: Number of states at which the image measures each function, and of calls at each state.
STATES, REPEATED = 32, 16

_SECONDS = 120
#: Arithmetic routines of libgcc, for processors without these instructions. gcc does not report their stack.
_HELPER = re.compile(r"__(aeabi_|gnu_|[a-z]+[sd][fi][0-9]?$)")
_NODE = re.compile(r'^node: \{ title: "([^"]+)" label: "([^"]*)"', re.M)
_EDGE = re.compile(r'^edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"', re.M)
_BYTES = re.compile(r"\\n([0-9]+) bytes \(([a-z,]+)\)")


@dataclass(frozen=True, slots=True)
class Cost:
    """The cost of a call of one function: mean and largest (``most``) ``instructions``. ``stack`` [bytes] is
    the compiler's figure for the function and its callees in the kernel, without libgcc. ``stack_used``
    [bytes] was measured in qemu. ``digest`` is that of the results."""

    function: str
    stack: int | None
    instructions: float | None = None
    most: float | None = None
    stack_used: int | None = None
    digest: int | None = None


@dataclass(frozen=True, slots=True)
class Figures:
    """Measurements of a kernel on ``target``, or the ``missing`` tool that they need.

    ``sections`` are the bytes of the kernel's object by kind (text, rodata, data, bss); ``undefined`` its
    external symbols. ``not_run`` is the missing tool that a run needs.
    """

    target: Target
    missing: str | None = None
    compiler: str = ""
    sections: Mapping[str, int] = field(default_factory=dict)
    undefined: tuple[str, ...] = ()
    costs: tuple[Cost, ...] = ()
    emulator: str = ""
    not_run: str | None = None

    def to_dict(self) -> dict[str, Any]:
        """As ``--json`` prints it."""
        plain = dataclasses.asdict(self)
        return {**plain, "target": self.target.name}

    def lines(self) -> list[str]:
        """Text lines: one for the kernel, and one for each function."""
        if self.missing:
            return [f"{self.target.name}: not measured: needs {self.missing}"]
        size = self.sections["text"] + self.sections["rodata"]
        wants = f"; calls libgcc: {', '.join(self.undefined)}" if self.undefined else ""
        lines = [f"{self.target.name}: {size} B of code and constants{wants}"]
        for cost in self.costs:
            run = f"not run: needs {self.not_run}"
            if cost.instructions is not None:
                run = f"{cost.instructions:.0f} instructions a call, self-test passed in qemu"
            lines.append(f"  {cost.function}: {cost.stack} B of stack, {run}")
        return lines


def measure(name: str, files: Mapping[str, str], functions: Sequence[str], target: Target) -> Figures:
    """The figures of the kernel in ``files`` (:func:`robodyn.firmware.firmware`) of the robot ``name``.

    Raises
    ------
    ToolError: an installed tool fails.
    CheckError: the self-test fails on the processor.
    """
    tools = _board(target).architecture
    missing = _missing(tools.compiler, tools.nm, tools.size)
    if missing:
        return Figures(target, missing=missing)
    with tempfile.TemporaryDirectory(prefix="robodyn-") as temporary:
        folder = Path(temporary)
        for file, text in files.items():
            (folder / file).write_text(text, encoding="utf-8", newline="\n")
        image = _build_image(name, target, folder)
        graph = (folder / f"{name}.ci").read_text(encoding="utf-8")
        symbols = _run([tools.nm.name, "-u", f"{name}.o"], folder)
        figures = Figures(
            target,
            compiler=_run([tools.compiler.name, "--version"], folder).splitlines()[0],
            sections=_sections(_run([tools.size.name, "-A", f"{name}.o"], folder)),
            undefined=tuple(line.split()[-1] for line in symbols.splitlines()),
            costs=tuple(
                Cost(f, deepest(graph, f"{name}_{emitted_name(f, functions)}").size) for f in functions
            ),
            not_run=_missing(tools.emulator),
        )
        return figures if figures.not_run else _add_run(figures, name, image, folder)


def _board(target: Target) -> Board:
    if target.board is None:
        raise InputError(f"there is no firmware for the target {target.name!r}, which has no board")
    return target.board


def _missing(*tools: Tool) -> str | None:
    """What to install if one of ``tools`` is missing."""
    return next((tool.remedy for tool in tools if tool.path() is None), None)


def _run(command: Sequence[str], folder: Path, codes: Sequence[int] = (0,)) -> str:
    """The output of ``command``; :class:`ToolError` if its exit status is none of ``codes``."""
    try:
        result = run(command, folder=folder, seconds=_SECONDS)
    except OSError as error:
        raise ToolError(f"{command[0]} did not run", found=str(error)) from None
    if result.code not in codes:
        outcome = (
            f"exit status {result.code}" if result.code is not None else f"still running after {_SECONDS:g} s"
        )
        raise ToolError(
            f"{command[0]} failed",
            found=first_lines(result.output) or outcome,
            remedy=f"the command was: {' '.join(command)}",
        )
    return result.output


def _build_image(name: str, target: Target, folder: Path) -> str:
    """Build the image. gcc writes the call graph of the kernel to the same folder."""
    linker = [_board(target).architecture.compiler.name, *(target.flags or ())]
    compiler = [*linker, "-std=c99", *FLAGS]
    objects = []
    for source in (name, f"{name}_selftest", f"{name}_image", f"{name}_startup"):
        _run([*compiler, "-fcallgraph-info=su", "-c", f"{source}.c", "-o", f"{source}.o"], folder)
        objects.append(f"{source}.o")
    image = f"{name}.elf"
    options = ["-nostdlib", "-static", "-L", ".", "-T", f"{target.name}.ld", "-Wl,--gc-sections"]
    _run([*linker, *options, *objects, "-lgcc", "-o", image], folder)
    return image


@dataclass(frozen=True, slots=True)
class Depth:
    """Stack ``size`` [bytes] of a function and all that it calls. It is None if there is no bound; ``reason``
    says why. ``function`` is None if there was no compiler, or if it failed."""

    function: str | None
    size: int | None
    chain: tuple[str, ...]
    reason: str = ""
    #: External functions that it calls. ``size`` does not contain their stack.
    beyond: tuple[str, ...] = ()

    @property
    def only_helpers(self) -> bool:
        """Whether all external functions are arithmetic routines of libgcc."""
        return all(_HELPER.match(name) for name in self.beyond)


def deepest(graph: str, function: str) -> Depth:
    """The largest stack of ``function`` according to ``graph``, gcc's call graph in VCG format."""
    sizes = {title: _BYTES.search(label) for title, label in _NODE.findall(graph)}
    calls: dict[str, set[str]] = {}
    for source, target in _EDGE.findall(graph):
        calls.setdefault(source, set()).add(target)
    if sizes.get(function) is None:
        return Depth(function, None, (), "it is not in the call graph")
    external: set[str] = set()
    depths: dict[str, tuple[int, tuple[str, ...]]] = {}

    def depth(title: str, callers: tuple[str, ...]) -> tuple[int, tuple[str, ...]]:
        if title in callers:
            raise _UnboundedError(f"{title} calls itself")
        if title not in depths:
            size = sizes.get(title)
            if title == "__indirect_call":
                raise _UnboundedError("a call through a pointer")
            if size is None:
                external.add(title)
                return 0, ()
            if size[2] == "dynamic":
                raise _UnboundedError(f"the stack of {title} depends on its arguments")
            callee = max((depth(t, (*callers, title)) for t in sorted(calls.get(title, ()))), default=(0, ()))
            depths[title] = int(size[1]) + callee[0], (title, *callee[1])
        return depths[title]

    try:
        size, chain = depth(function, ())
    except _UnboundedError as reason:
        return Depth(function, None, (), str(reason))
    names = tuple(sorted(external))
    note = f"plus the stack of {', '.join(names)}, which gcc does not report" if names else ""
    return Depth(function, size, chain, note, names)


class _UnboundedError(Exception):
    """The stack of a function has no bound."""


def _sections(output: str) -> dict[str, int]:
    """Bytes by kind of section."""
    total = dict.fromkeys(("text", "rodata", "data", "bss"), 0)
    for kind, size in re.findall(r"^\.s?(text|rodata|data|bss)\S*\s+(\d+)", output, re.M):
        total[kind] += int(size)
    return total


def _add_run(figures: Figures, name: str, image: str, folder: Path) -> Figures:
    """``figures`` with the measurements that the image prints in qemu."""
    board = _board(figures.target)
    command = [*board.command, image]
    output = _run(command, folder, range(256))
    if "self-test passed" not in output:
        raise CheckError(
            f"the self-test of {name} fails on {figures.target.name} in qemu",
            found=" | ".join(output.split("\n")[:4]) or "no output",
            remedy="please report the robot file",
        )
    costs = []
    for cost in figures.costs:
        digest = re.search(rf"^{cost.function} digest ([0-9a-f]+)", output, re.M)
        words = rf"^measured {cost.function} calls (\d+) ticks (\d+) idle (\d+) most (\d+) stack (\d+)"
        ticks = re.search(words, output, re.M)
        assert digest
        assert ticks
        calls, total, idle, most, used = map(int, ticks.groups())
        costs.append(
            dataclasses.replace(
                cost,
                instructions=(total - idle) / calls / board.ticks,
                most=(most - idle / STATES) / REPEATED / board.ticks,
                stack_used=used,
                digest=int(digest[1], 16),
            )
        )
    version = _run([board.architecture.emulator.name, "--version"], folder).splitlines()[0]
    return dataclasses.replace(figures, costs=tuple(costs), emulator=version)
