"""What a kernel costs on a processor: built with the cross compiler, looked at, and run in qemu.

Where a tool is missing the figures say which, and how to get it; where the self-test fails on the processor
this is an error, because then no figure means anything.
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

#: Flags of kernel, self-test and image. Nothing is contracted, so the bits are the same everywhere.
FLAGS = (
    "-O2", "-ffp-contract=off", "-fno-math-errno", "-ffreestanding", "-ffunction-sections", "-fdata-sections",
)  # fmt: skip
#: States that the image measures each function at, and calls of each.
STATES, REPEATED = 32, 16

_SECONDS = 120
#: The compiler's own arithmetic, on machines that lack it: its stack comes on top.
_HELPER = re.compile(r"__(aeabi_|gnu_|[a-z]+[sd][fi][0-9]?$)")
_NODE = re.compile(r'^node: \{ title: "([^"]+)" label: "([^"]*)"', re.M)
_EDGE = re.compile(r'^edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"', re.M)
_BYTES = re.compile(r"\\n([0-9]+) bytes \(([a-z,]+)\)")


@dataclass(frozen=True, slots=True)
class Cost:
    """What a call of one function costs: instructions, on average and at most; bytes of stack, as the
    compiler says (with all that the kernel calls, without libgcc) and as they were used; the digest that was
    found."""

    function: str
    stack: int | None
    instructions: float | None = None
    most: float | None = None
    stack_used: int | None = None
    digest: int | None = None


@dataclass(frozen=True, slots=True)
class Figures:
    """What was measured of a kernel on ``target``, or what that ``missing`` tool it needs.

    ``sections`` are the bytes of the kernel's object by kind (text, rodata, data, bss); ``undefined`` the
    symbols that it wants from elsewhere; ``not_run``: what the figures of a run need.
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
        """For people: a line, and one a function."""
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
    """The figures of the kernel in ``files`` (:func:`robodyn.firmware.firmware_files`) of the robot ``name``.

    Raises
    ------
    ToolError: a tool is there and fails.
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
        image = _built(name, target, folder)
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
        return figures if figures.not_run else _with_run(figures, name, image, folder)


def _board(target: Target) -> Board:
    if target.board is None:
        raise InputError(f"there is no firmware for the target {target.name!r}, which has no board")
    return target.board


def _missing(*tools: Tool) -> str | None:
    """What to install, if one of ``tools`` is not there."""
    return next((tool.remedy for tool in tools if tool.path() is None), None)


def _run(command: Sequence[str], folder: Path, codes: Sequence[int] = (0,)) -> str:
    """What ``command`` says; :class:`ToolError` where it does not leave with one of ``codes``."""
    try:
        done = run(command, folder=folder, seconds=_SECONDS)
    except OSError as error:
        raise ToolError(f"{command[0]} did not run", found=str(error)) from None
    if done.code not in codes:
        ended = f"exit status {done.code}" if done.code is not None else f"no end after {_SECONDS:g} s"
        raise ToolError(
            f"{command[0]} failed",
            found=first_lines(done.output) or ended,
            remedy=f"the command was: {' '.join(command)}",
        )
    return done.output


def _built(name: str, target: Target, folder: Path) -> str:
    """The image; gcc's call graph of the kernel lies beside it."""
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
    """Stack of one function with all that it calls [bytes]; None: there is no bound, and ``reason``. No
    ``function``: there was no compiler, or it refused."""

    function: str | None
    size: int | None
    chain: tuple[str, ...]
    reason: str = ""
    #: Functions of other files on the way, whose own stack comes on top.
    beyond: tuple[str, ...] = ()

    @property
    def only_helpers(self) -> bool:
        """Whether nothing of other files is called but the compiler's own arithmetic."""
        return all(_HELPER.match(name) for name in self.beyond)


def deepest(graph: str, function: str) -> Depth:
    """The most stack that ``function`` may need by ``graph``, gcc's call graph (a text in VCG)."""
    sizes = {title: _BYTES.search(label) for title, label in _NODE.findall(graph)}
    calls: dict[str, set[str]] = {}
    for source, target in _EDGE.findall(graph):
        calls.setdefault(source, set()).add(target)
    if sizes.get(function) is None:
        return Depth(function, None, (), "it is not in the call graph")
    beyond: set[str] = set()
    known: dict[str, tuple[int, tuple[str, ...]]] = {}

    def depth(title: str, above: tuple[str, ...]) -> tuple[int, tuple[str, ...]]:
        if title in above:
            raise _UnboundedError(f"{title} calls itself")
        if title not in known:
            size = sizes.get(title)
            if title == "__indirect_call":
                raise _UnboundedError("a call by a pointer")
            if size is None:
                beyond.add(title)
                return 0, ()
            if size[2] == "dynamic":
                raise _UnboundedError(f"the stack of {title} depends on its arguments")
            below = max((depth(t, (*above, title)) for t in sorted(calls.get(title, ()))), default=(0, ()))
            known[title] = int(size[1]) + below[0], (title, *below[1])
        return known[title]

    try:
        size, chain = depth(function, ())
    except _UnboundedError as reason:
        return Depth(function, None, (), str(reason))
    names = tuple(sorted(beyond))
    on_top = f"and what {', '.join(names)} need on top, which gcc does not state" if names else ""
    return Depth(function, size, chain, on_top, names)


class _UnboundedError(Exception):
    """There is no bound."""


def _sections(output: str) -> dict[str, int]:
    """Bytes by kind of section."""
    total = dict.fromkeys(("text", "rodata", "data", "bss"), 0)
    for kind, size in re.findall(r"^\.s?(text|rodata|data|bss)\S*\s+(\d+)", output, re.M):
        total[kind] += int(size)
    return total


def _with_run(figures: Figures, name: str, image: str, folder: Path) -> Figures:
    """``figures`` with what the image says of itself in qemu."""
    board = _board(figures.target)
    command = [*board.command, image]
    output = _run(command, folder, range(256))
    if "self-test passed" not in output:
        raise CheckError(
            f"the self-test of {name} fails on {figures.target.name} in qemu",
            found=" | ".join(output.split("\n")[:4]) or "no word from it",
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
