"""Schedules as pictures: who does what when, what more processors bring. SVG, the same bytes at any time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

from robodyn.draw import style
from robodyn.draw.markup import markup_template
from robodyn.draw.panels import Curve, Panel, figure
from robodyn.report.schedule_sources import Source
from robodyn.schedule import Solved
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
