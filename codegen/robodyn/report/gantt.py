"""Schedules and task graphs as pictures: who does what when, and which task waits for which. SVG, the same
bytes at any time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from robodyn.draw.curves import Curve, Panel, figure
from robodyn.draw.markup import markup_template
from robodyn.report.schedule_sources import Source
from robodyn.schedule import Solved
from robodyn.thesis.printed_tasks import TIMES_OTHERS, TIMES_STANFORD

_CELL, _ROW, _LEFT, _TOP = 34, 26, 60, 70
#: Pixels of the longest schedule.
_WIDEST: Final = 13600
_BOX, _STEP = (36, 18), (46, 40)
#: Colours of links, again from the first where there are more.
_PALE: Final = ("#c6d8ec", "#f6dfc5", "#cfe8d8", "#f0c9cd", "#dddddd", "#e4d7ef", "#d3ecec", "#eeeac0")


def gantt_svg(source: Source, solved: Solved) -> str:
    """The schedule: a row a processor, a box a task, coloured by link."""
    table, graph = solved.timetable, source.graph
    scale = min(_CELL, _WIDEST / max(1, table.span))
    boxes = [
        {
            "x": f"{scale * one.start:.1f}",
            "y": _ROW * one.processor,
            "width": f"{max(0.5, scale * (one.finish - one.start) - 1):.1f}",
            "fill": _PALE[(graph.link(one.task) - 1) % len(_PALE)],
            "label": str(one.task) if scale * (one.finish - one.start) >= 24 else "",
            "middle": f"{scale * (one.start + one.finish) / 2:.1f}",
        }
        for one in table.placements
    ]
    p = table.machine.processors
    every = max(1, -(-table.span // 30))
    unit = "levels" if table.machine.synchronised else "units of time"
    return markup_template("gantt.svg.j2").render(
        width=_LEFT + round(scale * table.span) + 30,
        height=_TOP + _ROW * p + 50,
        left=_LEFT,
        top=_TOP,
        row=_ROW - 2,
        title=f"{source.name}: {len(graph)} tasks on {p} processors",
        note=f"{table.levels} {unit}, speed-up {solved.speedup:.3f}, "
        f"efficiency {100 * solved.efficiency:.2f} %; colours are links",
        boxes=boxes,
        rows=[{"y": _ROW * k + _ROW / 2, "label": f"P{k + 1}"} for k in range(p)],
        ticks=[{"x": f"{scale * t:.1f}", "label": str(t)} for t in range(0, table.span + 1, every)],
        span=f"{scale * table.span:.1f}",
        bottom=_ROW * p,
    )


def layers_svg(source: Source) -> str:
    """The layered graph: tasks in the earliest layer that they can be in, lines to what they wait for."""
    graph = source.graph
    level = graph.levels()
    rows: list[list[int]] = [[] for _ in range(graph.critical_path)]
    for task in graph.tasks:
        rows[level[task] - 1].append(task)
    widest = max(map(len, rows), default=1)
    at: dict[int, tuple[float, float]] = {}
    for k, row in enumerate(rows):
        shift = (widest - len(row)) * _STEP[0] / 2
        for i, task in enumerate(row):
            at[task] = (shift + i * _STEP[0], k * _STEP[1])
    lines = [
        {
            "x1": at[other][0] + _BOX[0] / 2,
            "y1": at[other][1] + _BOX[1],
            "x2": at[task][0] + _BOX[0] / 2,
            "y2": at[task][1],
        }
        for task, needed in graph.after.items()
        for other in sorted(needed)
    ]
    return markup_template("layers.svg.j2").render(
        width=_LEFT + widest * _STEP[0] + 30,
        height=_TOP + len(rows) * _STEP[1] + 20,
        left=_LEFT,
        top=_TOP,
        title=f"{source.name}: layered graph",
        note=f"{len(graph)} {source.tasks} in {len(rows)} layers, at most {widest} in one; colours are links",
        lines=lines,
        boxes=[
            {"x": x, "y": y, "fill": _PALE[(graph.link(task) - 1) % len(_PALE)], "label": str(task)}
            for task, (x, y) in at.items()
        ],
        box={"width": _BOX[0], "height": _BOX[1]},
        rows=[{"y": k * _STEP[1] + _BOX[1] / 2, "label": str(k + 1)} for k in range(len(rows))],
    )


def sweep_svg(source: Source, solutions: Sequence[Solved], others: Sequence[Solved] = ()) -> str:
    """Figures 4.11 to 4.13 redrawn: time, speed-up and efficiency by processors, ours beside the printed.

    ``others``: the same machines by another method. The thesis's own drawings are not at hand; this is what
    its tables support. Of a source with friction, ``others`` are the same machines without it.
    """
    p = [one.timetable.machine.processors for one in solutions]
    if len(p) == 1:
        p, solutions, others = p * 2, [*solutions] * 2, [*others] * 2
    # The printed levels are those of the printed tasks.
    work = source.graph.work if source.figures is None else source.figures["tasks"]
    rubbing = source.plain is not None
    own = "with friction" if rubbing else f"{solutions[0].method}"
    times: list[Curve] = [Curve(own, p, [one.timetable.span for one in solutions])]
    speed = [Curve(own, p, [one.speedup for one in solutions])]
    share = [Curve(own, p, [100 * one.efficiency for one in solutions])]
    if others:
        name = "without friction" if rubbing else f"{others[0].method}"
        times.append(Curve(name, p, [one.timetable.span for one in others]))
        speed.append(Curve(name, p, [one.speedup for one in others]))
        share.append(Curve(name, p, [100 * one.efficiency for one in others]))
    printed = [(k, source.printed[k][0]) for k in sorted(set(p)) if k in source.printed]
    if len(printed) > 1:
        at = [k for k, _ in printed]
        times.append(Curve("printed levels", at, [levels for _, levels in printed], dashed=True))
        speed.append(Curve("printed levels", at, [work / levels for _, levels in printed], dashed=True))
        share.append(
            Curve("printed levels", at, [100 * work / levels / k for k, levels in printed], dashed=True)
        )
    speed.append(Curve("a task a processor and level", p, [float(k) for k in p], dashed=True))
    panels = [
        Panel("Processing time", "levels by processors", tuple(times)),
        Panel("Speed-up", "by processors", tuple(speed)),
        Panel("Efficiency", "% by processors", tuple(share)),
    ]
    if source.figures is not None:
        panels.append(_of_others())
    note = f"{source.name}, {len(source.graph)} tasks; dashed: from the printed tables, or the ideal"
    return figure("Figures 4.11 to 4.13, redrawn", note, panels)


def _of_others() -> Panel:
    """Table 4.8's columns."""
    columns = {"Dhanaraj 1990": TIMES_STANFORD, **TIMES_OTHERS}
    return Panel(
        "Processing time, Table 4.8",
        "ms by processors, as printed",
        tuple(
            Curve(name, sorted(times), [times[k] for k in sorted(times)], dashed=True)
            for name, times in columns.items()
        ),
    )
