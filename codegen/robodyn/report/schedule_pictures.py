"""Schedules as pictures, in SVG that is the same bytes at any time: who does what when, what more processors
bring, and the layered graph of tasks.

In the graph a lane is a link and a row a layer. A task stands in the earliest layer that it can be in: below
the layer of what it waits for last. Drawn are these waits, which make the layers what they are; whatever else
a task waits for is done by then. One chain of them from the first layer to the last is the critical path.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Final

from robodyn.draw import style
from robodyn.draw.markup import markup_template
from robodyn.draw.panels import Curve, Panel, figure
from robodyn.report.schedules import Source
from robodyn.schedule import Solved
from robodyn.schedule.graph import TaskGraph
from robodyn.thesis.printed import TIMES_OTHERS, TIMES_STANFORD

#: A unit of time, a row, what is left of the rows and above them, a colour of the key, in px.
_CELL, _ROW, _LEFT, _TOP, _SWATCH = 34, 26, 50, 92, 70
#: Pixels of the longest schedule.
_WIDEST: Final = 13600


def colour_of(link: int) -> str:
    """The colour of a box that belongs to ``link`` (from 1): again the first where there are more."""
    return style.pale(style.SERIES[(link - 1) % len(style.SERIES)])


def gantt_svg(source: Source, solved: Solved) -> str:
    """The schedule: a row a processor, a box a task, coloured by link."""
    table, graph = solved.timetable, source.graph
    p, end = table.machine.processors, table.span
    scale = min(_CELL, _WIDEST / max(1, end))
    boxes = [
        {
            "x": f"{scale * one.start:.1f}",
            "y": _ROW * one.processor,
            "width": f"{max(0.5, scale * (one.finish - one.start) - 1):.1f}",
            "fill": colour_of(graph.link(one.task)),
            "name": f"task {one.task}, link {graph.link(one.task)}, P{one.processor + 1}, "
            f"{one.start} to {one.finish}",
            "label": str(one.task) if scale * (one.finish - one.start) >= 24 else "",
            "middle": f"{scale * (one.start + one.finish) / 2:.1f}",
        }
        for one in table.placements
    ]
    by_colour: dict[str, list[str]] = {}
    for link in sorted({graph.link(task) for task in graph.tasks}):
        by_colour.setdefault(colour_of(link), []).append(str(link))
    unit = "levels" if table.machine.synchronised else "units of time"
    title = f"{source.name}: {len(graph)} tasks on {p} processors"
    note = f"{table.levels} {unit}, speed-up {solved.speedup:.3f}, efficiency {100 * solved.efficiency:.2f} %"
    return markup_template("gantt.svg.j2").render(
        style=style,
        width=max(
            _LEFT + max(round(scale * end), _SWATCH * len(by_colour)) + 30, style.head_width(title, note)
        ),
        height=_TOP + _ROW * p + 56,
        key=[
            {"x": _SWATCH * k, "fill": fill, "label": _links_text(links)}
            for k, (fill, links) in enumerate(by_colour.items())
        ],
        unit=f"time [{unit}]",
        left=_LEFT,
        top=_TOP,
        row=_ROW - 2,
        title=title,
        note=note,
        boxes=boxes,
        rows=[{"y": _ROW * k + _ROW / 2, "label": f"P{k + 1}"} for k in range(p)],
        ticks=[(f"{scale * t:.1f}", t) for t in range(0, end + 1, max(1, -(-end // 30)))],
        span=f"{scale * end:.1f}",
        bottom=_ROW * p,
    )


def _links_text(links: Sequence[str]) -> str:
    """The links that have a colour."""
    return ", ".join(links[:2]) + " ..." * (len(links) > 2) if len(links) > 1 else f"link {links[0]}"


def sweep_svg(source: Source, solutions: Sequence[Solved], others: Sequence[Solved] = ()) -> str:
    """Figures 4.11 to 4.13 redrawn: time, speed-up and efficiency by processors, ours beside the printed.

    ``others``: the same machines by another method. The thesis's own drawings are not at hand; this is what
    its tables support. Of a source with friction, ``others`` are the same machines without it.
    """
    p = [one.timetable.machine.processors for one in solutions]
    # The printed levels are those of the printed tasks.
    work = source.graph.work if source.figures is None else source.figures["tasks"]
    names = ("with friction", "without friction") if source.plain is not None else ("", "")
    series = [  # by processors time, speed-up and efficiency in percent
        (name or some[0].method, p, [(one.timetable.span, one.speedup, 100 * one.efficiency) for one in some])
        for name, some in zip(names, (solutions, others), strict=True)
        if some
    ]
    levels = {k: source.printed[k][0] for k in sorted(set(p)) if k in source.printed}
    if len(levels) > 1:
        rows = [(level, work / level, 100 * work / level / k) for k, level in levels.items()]
        series.append(("printed levels", list(levels), rows))
    curves = [
        [
            Curve(name, at, [row[k] for row in rows], dashed=name == "printed levels")
            for name, at, rows in series
        ]
        for k in range(3)
    ]
    curves[1].append(Curve("ideal", p, [float(k) for k in p], dashed=True))
    unit = "levels" if solutions[0].timetable.machine.synchronised else "units of time"
    labels = {
        "Processing time": f"time [{unit}]",
        "Speed-up": "speed-up over one processor",
        "Efficiency": "efficiency [%]",
    }
    if source.figures is not None:
        labels["Processing time, Table 4.8"] = "time [ms], as printed"
        columns = {"Dhanaraj 1990": TIMES_STANFORD, **TIMES_OTHERS}
        curves.append(
            [
                Curve(name, sorted(times), [times[k] for k in sorted(times)], dashed=True)
                for name, times in columns.items()
            ]
        )
    panels = [
        Panel(title, "processors", label, tuple(some))
        for (title, label), some in zip(labels.items(), curves, strict=True)
    ]
    note = f"{source.name}, {len(source.graph)} tasks; dashed: from the printed tables, or the ideal"
    return figure("Figures 4.11 to 4.13, redrawn", note, panels)


#: A box, from one to the next beside it and below it, and what is between layers and between lanes, in px.
_BOX, _STEP, _LAYER, _LANE = (34, 18), (40, 23), 24, 22
_LANES_LEFT, _LANES_TOP = 52, 96
#: Boxes beside each other in a lane; more of a layer stand below them.
_BESIDE: Final = 4


def layers_svg(source: Source) -> str:
    """The layered graph of ``source``."""
    graph, level = source.graph, source.graph.levels()
    links = sorted({graph.link(task) for task in graph.tasks})
    layers = [
        {link: [t for t in sorted(graph.tasks) if (level[t], graph.link(t)) == (k, link)] for link in links}
        for k in range(1, graph.critical_path + 1)
    ]
    lanes, right = [], 0
    for link in links:
        wide = min(_BESIDE, max(len(layer[link]) for layer in layers))
        lanes.append((link, right, wide * _STEP[0]))
        right += wide * _STEP[0] + _LANE
    rows, bottom = [], 0
    at: dict[int, tuple[float, float]] = {}
    for k, layer in enumerate(layers, 1):
        deep = max(-(-len(tasks) // _BESIDE) for tasks in layer.values())
        rows.append({"y": bottom + (_STEP[1] * (deep - 1) + _BOX[1]) / 2, "label": k})
        for link, left, width in lanes:
            for place, task in enumerate(layer[link]):
                row, column = divmod(place, _BESIDE)
                in_row = min(_BESIDE, len(layer[link]) - row * _BESIDE)
                x = left + (width - in_row * _STEP[0]) / 2 + column * _STEP[0]
                at[task] = (x, bottom + row * _STEP[1])
        bottom += _STEP[1] * (deep - 1) + _BOX[1] + _LAYER
    waits = [(a, b) for b in graph.tasks for a in sorted(graph.after[b]) if level[a] == level[b] - 1]
    chain = critical_chain(graph)
    steps = set(pairwise(chain))
    widest = max(sum(map(len, layer.values())) for layer in layers)
    title = f"{source.name}: layered graph"
    note = (
        f"{len(graph)} {source.tasks} in {len(layers)} layers, at most {widest} in one; "
        "lines: what a task waits for last; thick: a critical path"
    )
    return markup_template("layers.svg.j2").render(
        style=style,
        width=max(_LANES_LEFT + right + 20, style.head_width(title, note)),
        height=_LANES_TOP + bottom + 10,
        left=_LANES_LEFT, top=_LANES_TOP, bottom=bottom,
        title=title,
        note=note,
        lanes=[
            {
                "x": left - _LANE / 2, "width": width + _LANE - 6,
                "fill": style.pale(colour_of(link), 0.35), "label": f"link {link}",
                "middle": left + (width - _STEP[0] + _BOX[0]) / 2,
            }
            for link, left, width in lanes
        ],
        lines=[(*at[a], *at[b], (a, b) in steps) for a, b in sorted(waits, key=steps.__contains__)],
        boxes=[
            {
                "x": x, "y": y, "fill": colour_of(graph.link(task)), "label": task, "thick": task in chain,
                "name": f"task {task}, link {graph.link(task)}, layer {level[task]}"
                + (f", after {', '.join(map(str, sorted(graph.after[task])))}" if graph.after[task] else ""),
            }
            for task, (x, y) in at.items()
        ],
        box={"width": _BOX[0], "height": _BOX[1]},
        rows=rows,
    )  # fmt: skip


def critical_chain(graph: TaskGraph) -> list[int]:
    """Tasks of a longest chain, a task a layer from the first to the last."""
    level = graph.levels()
    chain: list[int] = []
    waits = {task for task in graph.tasks if level[task] == graph.critical_path}
    while waits:
        chain.insert(0, min(waits))
        waits = {other for other in graph.after[chain[0]] if level[other] == level[chain[0]] - 1}
    return chain
