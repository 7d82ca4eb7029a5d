"""The layered graph of tasks as a picture: a lane a link, a row a layer, and what each task waits for last.

A task stands in the earliest layer that it can be in: below the layer of what it waits for last. Drawn are
these waits, which make the layers what they are; whatever else a task waits for is done by then. One chain of
them from the first layer to the last is the critical path. SVG, the same bytes at any time.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any, Final

from robodyn.draw import style
from robodyn.draw.markup import markup_template
from robodyn.report.gantt import colour_of
from robodyn.report.schedule_sources import Source
from robodyn.schedule.graph import TaskGraph

#: A box, from one to the next beside it and below it, and what is between layers and between lanes, in px.
_BOX, _STEP, _LAYER, _LANE = (34, 18), (40, 23), 24, 22
_LEFT, _TOP = 52, 96
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
        width=max(_LEFT + right + 20, style.head_width(title, note)),
        height=_TOP + bottom + 10,
        left=_LEFT, top=_TOP, bottom=bottom,
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
