"""Rows of operation counts, as printed by ``gen`` and ``flops``."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from robodyn_cli.output import wrapped

if TYPE_CHECKING:
    from robodyn.counts import Count
    from robodyn.optimize.prune import Pruning
    from robodyn.robot import Robot


def record(
    robot: Robot,
    function: str,
    formulation: str,
    count: Count,
    rigid: Count | None = None,
    pruning: Pruning | None = None,
) -> dict[str, Any]:
    """A count as ``--json`` prints it; of a robot with effects split into the operations of the ``rigid`` arm
    and those of the effects; with the object ``prune``, if its function was pruned."""
    from robodyn.counts.thesis import beside

    printed = beside(robot, function, count, formulation)
    row: dict[str, Any] = {
        "robot": robot.name, "function": function, "formulation": formulation, **count.to_dict(),
        "thesis": None if printed is None else printed.to_dict(),
    }  # fmt: skip
    if robot.couplings:
        row["coordinates"] = [robot.links[joint].name for joint in robot.commanded]
    if rigid is not None:
        row["rigid"] = rigid.to_dict()
        row["effects"] = {kind: row[kind] - number for kind, number in rigid.to_dict().items()}
    return row if pruning is None else {**row, "prune": pruning.to_dict()}


def fused_lines(counts: Mapping[str, Count], alone: Mapping[str, Sequence[Count]]) -> list[str]:
    """What fused functions save, one line per function."""
    return [
        f"{function}: {counts[function].total} operations, {counts[function].sincos} sines and cosines; its "
        f"parts alone take {sum(part.total for part in parts)} and {sum(part.sincos for part in parts)}"
        for function, parts in alone.items()
    ]


def effect_lines(counts: Mapping[str, Count], rigid: Mapping[str, Count | None]) -> list[str]:
    """The operations that effects add to each function, one line per function."""
    lines = []
    for function, beneath in rigid.items():
        whole = counts[function]
        if beneath is not None and (whole.total, whole.other) != (beneath.total, beneath.other):
            lines += wrapped(
                f"{function}: {beneath.mul}+{beneath.add} = {beneath.total} for the rigid arm; effects "
                f"{whole.mul - beneath.mul:+}/{whole.add - beneath.add:+} mul/add, "
                f"{whole.div - beneath.div:+} div, {whole.sqrt - beneath.sqrt:+} sqrt, "
                f"{whole.other - beneath.other:+} other = {whole.total - beneath.total:+}"
            )
    return lines


def lines(robot: Robot, rows: Iterable[tuple[str, str, str, Count]]) -> list[str]:
    """A table of counts, one row per ``(heading, function, formulation, count)``, with the thesis's figure of
    that formulation; roots and other operations (arctangents, choices) where functions are of poses."""
    from robodyn.counts.thesis import beside
    from robodyn.draw.tables import aligned
    from robodyn.dynamics.functions import function_named

    rows = list(rows)
    of_poses = any(function_named(function).of_pose for _, function, _, _ in rows)
    heads: tuple[str, ...] = ("", "mul", "add", "div", "total", "minus", "sin/cos", "thesis", "verdict")
    if of_poses:
        heads = (*heads[:4], "sqrt", *heads[4:7], "other", *heads[7:])
    table: list[tuple[str, ...]] = [heads]
    notes: dict[str, None] = {}
    for heading, function, formulation, count in rows:
        printed = beside(robot, function, count, formulation)
        thesis = f"{printed.mul}+{printed.add} = {printed.total}" if printed else "-"
        numbers = [count.mul, count.add, count.div, count.total, count.neg, count.sincos]
        if of_poses:
            numbers = [*numbers[:3], count.sqrt, *numbers[3:], count.other]
        table.append((heading, *map(str, numbers), thesis, printed.verdict if printed else "-"))
        if printed:
            notes[f"thesis: Table {printed.table}, {printed.row}: {printed.note}"] = None
    words = (0, len(heads) - 2, len(heads) - 1)
    from robodyn.robot.coupling import coupling_lines

    return [
        *aligned(table, left=words),
        *(line for note in (*notes, *coupling_lines(robot)) for line in wrapped(note)),
    ]


def pruning_lines(prunings: Mapping[Any, Pruning]) -> list[str]:
    """Lines about the pruning errors, for people."""
    if not prunings:
        return []
    from robodyn.optimize.prune import notes_of

    return list(notes_of(tuple(prunings.values())))
