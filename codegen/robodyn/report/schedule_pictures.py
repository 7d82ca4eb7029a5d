"""Schedules as pictures, in SVG that is the same bytes at any time: who does what when, what more processors
bring, and the layered graph of tasks.

In the graph a lane is a link and a row a layer. A task stands in the earliest layer that it can be in: below
the layer of what it waits for last. Drawn are these waits, which make the layers what they are; whatever else
a task waits for is done by then. One chain of them from the first layer to the last is the critical path.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any, Final

from robodyn.draw import style
from robodyn.draw.markup import markup_template
from robodyn.draw.panels import Curve, Panel, figure
from robodyn.report.schedule_sources import Source
from robodyn.schedule import Solved
from robodyn.schedule.graph import TaskGraph
from robodyn.thesis.printed_tasks import TIMES_OTHERS, TIMES_STANFORD

#: A unit of time, a row, what is left of the rows and above them, a colour of the key, in px.
_CELL, _ROW, _LEFT, _TOP, _SWATCH = 34, 26, 50, 92, 70
_PROCESSORS: Final = "processors"
#: Pixels of the longest schedule.
_WIDEST: Final = 13600


def colour_of(link: int) -> str:
    """The colour of a box that belongs to ``link`` (from 1): again the first where there are more."""
    return style.pale(style.SERIES[(link - 1) % len(style.SERIES)])


def gantt_svg(source: Source, solved: Solved) -> str:
    """The schedule: a row a processor, a box a task, coloured by link."""
    table, graph = solved.timetable, source.graph
    scale = min(_CELL, _WIDEST / max(1, table.span))
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
    p = table.machine.processors
    every = max(1, -(-table.span // 30))
    links = sorted({graph.link(task) for task in graph.tasks})
    unit = "levels" if table.machine.synchronised else "units of time"
    key = _key(links)
    title = f"{source.name}: {len(graph)} tasks on {p} processors"
    note = f"{table.levels} {unit}, speed-up {solved.speedup:.3f}, efficiency {100 * solved.efficiency:.2f} %"
    return markup_template("gantt.svg.j2").render(
        style=style,
        width=max(
            _LEFT + max(round(scale * table.span), _SWATCH * len(key)) + 30, style.head_width(title, note)
        ),
        height=_TOP + _ROW * p + 56,
        key=key,
        unit=f"time [{unit}]",
        left=_LEFT,
        top=_TOP,
        row=_ROW - 2,
        title=title,
        note=note,
        boxes=boxes,
        rows=[{"y": _ROW * k + _ROW / 2, "label": f"P{k + 1}"} for k in range(p)],
        ticks=[{"x": f"{scale * t:.1f}", "label": str(t)} for t in range(0, table.span + 1, every)],
        span=f"{scale * table.span:.1f}",
        bottom=_ROW * p,
    )


def _key(links: Sequence[int]) -> list[dict[str, Any]]:
    """Colours and the links that have them."""
    by_colour: dict[str, list[str]] = {}
    for link in links:
        by_colour.setdefault(colour_of(link), []).append(str(link))
    return [
        {
            "x": _SWATCH * k,
            "fill": fill,
            "label": f"link {some[0]}"
            if len(some) == 1
            else f"{some[0]}, {some[1]}" + " ..." * (len(some) > 2),
        }
        for k, (fill, some) in enumerate(by_colour.items())
    ]


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
    speed.append(Curve("ideal", p, [float(k) for k in p], dashed=True))
    unit = "levels" if solutions[0].timetable.machine.synchronised else "units of time"
    panels = [
        Panel("Processing time", _PROCESSORS, f"time [{unit}]", tuple(times)),
        Panel("Speed-up", _PROCESSORS, "speed-up over one processor", tuple(speed)),
        Panel("Efficiency", _PROCESSORS, "efficiency [%]", tuple(share)),
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
        _PROCESSORS,
        "time [ms], as printed",
        tuple(
            Curve(name, sorted(times), [times[k] for k in sorted(times)], dashed=True)
            for name, times in columns.items()
        ),
    )


#: A box, from one to the next beside it and below it, and what is between layers and between lanes, in px.
_BOX, _STEP, _LAYER, _LANE = (34, 18), (40, 23), 24, 22
_LANES_LEFT, _LANES_TOP = 52, 96
#: Boxes beside each other in a lane; more of a layer stand below them.
_BESIDE: Final = 4


def layers_svg(source: Source) -> str:
    """The layered graph of ``source``."""
    graph = source.graph
    layers = [sorted(layer) for layer in _layers(graph)]
    links = sorted({graph.link(task) for task in graph.tasks})
    cells = [{link: [t for t in layer if graph.link(t) == link] for link in links} for layer in layers]
    wide = {link: min(_BESIDE, max(len(cell[link]) for cell in cells)) for link in links}
    lanes, right = {}, 0
    for link in links:
        lanes[link] = right
        right += wide[link] * _STEP[0] + _LANE
    rows, bottom = [], 0
    at: dict[int, tuple[float, float]] = {}
    for k, cell in enumerate(cells, 1):
        deep = max(-(-len(tasks) // _BESIDE) for tasks in cell.values())
        rows.append({"y": bottom + (_STEP[1] * (deep - 1) + _BOX[1]) / 2, "label": str(k)})
        for link, tasks in cell.items():
            at.update(_places(tasks, lanes[link], wide[link], bottom))
        bottom += _STEP[1] * (deep - 1) + _BOX[1] + _LAYER
    level = graph.levels()
    waits = [(a, b) for b in graph.tasks for a in sorted(graph.after[b]) if level[a] == level[b] - 1]
    widest = max(map(len, layers), default=0)
    chain = critical_chain(graph)
    steps = set(pairwise(chain))
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
                "x": lanes[link] - _LANE / 2, "width": wide[link] * _STEP[0] + _LANE - 6,
                "fill": style.pale(colour_of(link), 0.35), "label": f"link {link}",
                "middle": lanes[link] + (wide[link] * _STEP[0] - _STEP[0] + _BOX[0]) / 2,
            }
            for link in links
        ],
        lines=[_line(at[a], at[b], (a, b) in steps) for a, b in sorted(waits, key=steps.__contains__)],
        boxes=[
            {
                "x": x, "y": y, "fill": colour_of(graph.link(task)), "label": str(task),
                "thick": task in chain,
                "name": f"task {task}, link {graph.link(task)}, layer {level[task]}"
                + (f", after {', '.join(map(str, sorted(graph.after[task])))}" if graph.after[task] else ""),
            }
            for task, (x, y) in at.items()
        ],
        box={"width": _BOX[0], "height": _BOX[1]},
        rows=rows,
    )  # fmt: skip


def _layers(graph: TaskGraph) -> list[list[int]]:
    """Tasks by the earliest layer that they can be in."""
    level = graph.levels()
    layers: list[list[int]] = [[] for _ in range(graph.critical_path)]
    for task in graph.tasks:
        layers[level[task] - 1].append(task)
    return layers


def critical_chain(graph: TaskGraph) -> list[int]:
    """Tasks of a longest chain, a task a layer from the first to the last."""
    level = graph.levels()
    chain: list[int] = []
    waits = {task for task in graph.tasks if level[task] == graph.critical_path}
    while waits:
        chain.insert(0, min(waits))
        waits = {other for other in graph.after[chain[0]] if level[other] == level[chain[0]] - 1}
    return chain


def _places(tasks: Sequence[int], left: float, wide: int, top: float) -> Mapping[int, tuple[float, float]]:
    """The corner of each box of a cell, rows in the middle of their lane."""
    places = {}
    for k, task in enumerate(tasks):
        row, column = divmod(k, _BESIDE)
        in_row = min(_BESIDE, len(tasks) - row * _BESIDE)
        places[task] = (left + (wide - in_row) * _STEP[0] / 2 + column * _STEP[0], top + row * _STEP[1])
    return places


def _line(above: tuple[float, float], below: tuple[float, float], thick: bool) -> dict[str, Any]:
    """From the bottom of one box to the top of another."""
    return {
        "x1": above[0] + _BOX[0] / 2, "y1": above[1] + _BOX[1],
        "x2": below[0] + _BOX[0] / 2, "y2": below[1], "thick": thick,
    }  # fmt: skip
