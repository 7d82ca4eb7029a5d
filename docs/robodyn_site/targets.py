"""A page for each target, from the table of targets."""

from __future__ import annotations

import importlib
import inspect
from typing import Final

from robodyn.targets import TARGETS, processors
from robodyn.targets.target import Costs, Target
from robodyn_site.markdown import code, fenced, page, plain, table

FOLDER: Final = "targets"
_OPERATIONS: Final = ("add", "mul", "fma", "div", "sqrt", "sincos")


def pages() -> dict[str, str]:
    """The pages of the targets, and their index."""
    return {f"{FOLDER}/index.md": _index()} | {
        f"{FOLDER}/{name}.md": of_target(t) for name, t in TARGETS.items()
    }


def _index() -> str:
    rows = (
        (
            f"[`{name}`]({name}.md)",
            plain(target.title),
            target.scalar,
            "yes" if target.flags is not None else "",
            "yes" if target.board else "",
            "yes" if target.chip else "",
        )
        for name, target in TARGETS.items()
    )
    return page(
        "# Targets",
        "A target is a processor that kernels are made for: the defaults of options for it, what operations "
        "cost on it, and which emulated board has it. Each has one name in all commands.",
        table(("target", "processor", "numbers", "compiled", "firmware image", "plans"), rows),
        fenced(
            "robodyn gen ROBOT --target cortex-m4f             # defaults for a processor\n"
            "robodyn gen ROBOT --firmware --target cortex-m4f  # an image that tests itself in qemu\n"
            "robodyn flops ROBOT --objective weighted:cortex-m4f\n"
            "robodyn plan ROBOT --deadline 10us",
            "sh",
        ),
        "[Firmware](../firmware.md) has measured sizes and instructions; "
        "[Add a target](../contributing.md#add-a-target) says how to add one.",
    )


def of_target(target: Target) -> str:
    """The page of one target."""
    module = importlib.import_module(f"{processors.__name__}.{target.name.replace('-', '_')}")
    return page(
        f"# {target.name}",
        plain(inspect.getdoc(module) or ""),
        "## Defaults",
        _defaults(target),
        "## Costs",
        "Cycles of an operation, as `--objective weighted:` and plans count with them"
        + (f"; the same as those of `{target.costs_as}`." if target.costs_as else "."),
        _costs(target),
        _chip(target),
        _board(target),
    )


def _defaults(target: Target) -> str:
    rows = [
        ("also called", ", ".join(map(code, target.aliases))),
        ("numbers", code(target.scalar)),
        ("floating-point unit for", ", ".join(map(code, target.hardware)) or "none"),
        ("sine and cosine", code(target.trig)),
        (
            "products and sums are fused",
            f"{target.contraction}: {plain(target.why)}" if target.why else target.contraction,
        ),
        ("registers", str(target.registers)),
        ("sines at once", str(target.lanes) if target.lanes > 1 else ""),
        (
            "flags of gcc and clang",
            code(target.compiled(target.contraction)) if target.flags is not None else "no compiler",
        ),
    ]
    return table(("what", "value"), [row for row in rows if row[1]])


def _costs(target: Target) -> str:
    kinds = {"float": target.costs_of("float"), "double": target.costs_of("double")}

    def cells(costs: Costs) -> tuple[str, ...]:
        values = (getattr(costs, operation) for operation in _OPERATIONS)
        return tuple("-" if value is None else f"{value:g}" for value in values)

    head = ("numbers", "sum", "product", "fused", "quotient", "square root", "sine and cosine")
    return table(head, [(kind, *cells(costs)) for kind, costs in kinds.items()], " rrrrrr")


def _chip(target: Target) -> str:
    if target.chip is None:
        return ""
    chip = target.chip
    rows = [("clock", f"{chip.mhz:g} MHz"), ("cores", str(chip.cores)), ("figures from", plain(chip.source))]
    if chip.passing_ns:
        rows.append(("a value from core to core", f"{chip.passing_ns:g} ns"))
    return page("## In plans", table(("what", "value"), rows))


def _board(target: Target) -> str:
    if target.board is None:
        return ""
    board = target.board
    rows = [
        ("board of qemu", code(board.machine)),
        ("compiler", plain(board.architecture.compiler.remedy)),
        ("emulator", plain(board.architecture.emulator.remedy)),
        ("code", f"{board.code.length} from {board.code.origin:#x}"),
        ("data and stack", f"{board.data.length} from {board.data.origin:#x}"),
    ]
    return page(
        "## Firmware image", table(("what", "value"), rows), fenced(" ".join(board.command) + " IMAGE", "sh")
    )
