"""``robodyn schedule``: schedule the dynamics on several processors; write pictures and parallel C."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from robodyn.outputs import check_outputs, write_files
from robodyn_cli.choices import ROBOTS
from robodyn_cli.options import load, model_options, options_of
from robodyn_cli.output import as_json, echo_json, printable, show, talk
from robodyn_cli.output_files import output_folder, picture_file, write_file
from robodyn_cli.progress import messages
from robodyn_cli.schedule_options import ScheduleOptions, schedule_options
from robodyn_cli.searching import Search

if TYPE_CHECKING:
    from robodyn.ir.signature import Signature
    from robodyn.report.schedules import Source
    from robodyn.robot import Robot
    from robodyn.schedule import Solved, TaskGraph
    from robodyn.schedule.friction_tasks import Friction


@click.command()
@click.argument("robot", type=ROBOTS, metavar="[ROBOT]", required=False)
@schedule_options
@model_options
def command(robot: str | None, **options: Any) -> None:
    """Split the dynamics into tasks and schedule them on processors.

    Without --cut the tasks are those of the thesis, three operations each, for ROBOT or for any revolute arm
    of --links N. With --cut K a kernel of ROBOT is cut into tasks of at most K operations. A separate
    validator checks every schedule. -p 2..13 sweeps over the number of processors. -o DIR writes parallel
    C (tasks of --cut 3 by default) and the serial kernel, which gives the same bits. --thesis TABLE compares
    a printed schedule (4.3, 4.7, C.1 to C.15, or all) or Table 4.8 with ours and lists every violation.

    With --json: {"robot", "method", "processors", "tasks", "levels", "critical_path", "lower_bound",
    "optimal", "speedup", "efficiency", "slots", "thesis", ...}, a list of them for a sweep.
    """
    settings = ScheduleOptions.of(robot, options)
    if settings.thesis is not None:
        _thesis(settings.thesis)
    elif settings.forms:
        _forms(settings)
    else:
        _schedule(settings)


def _thesis(table: str) -> None:
    from robodyn.thesis.tables import make, to_text
    from robodyn.thesis.tables.schedules import one_table

    tables = make("schedules") if table == "all" else one_table(table)
    show(tables.to_dict, lambda: to_text(tables).splitlines())


def _forms(settings: ScheduleOptions) -> None:
    from robodyn.thesis.logarithmic import compare_forms, forms_text

    with messages() as tell:
        comparison = compare_forms(settings.links or 16, tell)
    show(lambda: comparison, lambda: forms_text(comparison).splitlines())


def _schedule(settings: ScheduleOptions) -> None:
    from robodyn.report.schedule_pictures import gantt_svg, layers_svg, sweep_svg
    from robodyn.report.schedules import processors_of, sweep_text, to_dict, to_text
    from robodyn.schedule import Machine, solve
    from robodyn.schedule.methods import SEARCHES
    from robodyn.schedule.tree import MOST_NODES

    model, source, signature = _source(settings)
    names = (settings.picture, settings.layers)
    picture, layers = (None if name is None else picture_file(name) for name in names)
    if settings.fewest:
        _fewest(settings, source)
        return
    counts = processors_of(settings.processors)
    settings.check(len(counts))
    machines = [Machine(p, settings.communication, not settings.no_levels) for p in counts]

    limits = {
        "seconds": settings.seconds, "seed": settings.seed, "nodes": settings.nodes or MOST_NODES,
    }  # fmt: skip

    def solve_all(method: Any, graph: TaskGraph) -> list[Solved]:
        return [solve(graph, machine, method, **limits) for machine in machines]

    with messages() as tell:
        if settings.method in SEARCHES:
            tell(f"{source.name}: searching, {settings.seconds:g} s at most")
        solutions = solve_all(settings.method, source.graph)
    pictures: dict[Path, str] = {}
    if picture is not None and len(solutions) == 1:
        pictures[picture] = gantt_svg(source, solutions[0])
    elif picture is not None and source.plain is not None:
        pictures[picture] = sweep_svg(source, solutions, solve_all(settings.method, source.plain))
    elif picture is not None:
        other = "thesis" if settings.method != "thesis" else "critical-path"
        pictures[picture] = sweep_svg(source, solutions, solve_all(other, source.graph))
    if layers is not None:
        pictures[layers] = layers_svg(source)
    folder, files = _parallel_files(settings, model, source, signature, solutions[0])
    for file in pictures:
        check_outputs(file.parent, [file.name], named=True)
    paths = (*pictures, *write_files(folder, files))
    for file, text in pictures.items():
        write_file(file, text)
    if as_json():
        records = [to_dict(source, one) for one in solutions]
        echo_json(records[0] if len(records) == 1 else records)
    else:
        click.echo(
            to_text(source, solutions[0]) if len(solutions) == 1 else sweep_text(source, solutions), nl=False
        )
    for path in paths:
        talk(f"robodyn: wrote {printable(path)}")


def _source(settings: ScheduleOptions) -> tuple[Robot | None, Source, Signature | None]:
    """The task graph to schedule; for a kernel also the robot and the signature."""
    from robodyn.report.schedules import Source, cut_source, links_source, robot_source
    from robodyn.schedule.cutting import cut, parse_costs
    from robodyn.schedule.friction_tasks import chosen_friction

    costs = None if settings.cost is None else parse_costs(settings.cost)
    if settings.form is not None:
        from robodyn.thesis.logarithmic import general_program

        k = settings.operations or 1
        tasks = cut(general_program(settings.form, settings.links), k, costs)
        return None, cut_source(f"{settings.links} links, {settings.form}", tasks, k), None
    if settings.links is not None:
        friction = None if settings.friction is None else chosen_friction(settings.friction)
        source = links_source(settings.links, as_printed=settings.as_printed, costs=costs, friction=friction)
        return None, source, None
    model = load(settings.robot, strict=settings.strict)
    if settings.operations is None and settings.emit is None:
        by_joint = _friction(settings.friction, model)
        return model, robot_source(model, as_printed=settings.as_printed, friction=by_joint), None
    if settings.operations is None:
        from robodyn.optimize.programs import signature
        from robodyn.schedule.task_program import task_program

        tasks = task_program(model)
        source = Source(model.name, "tasks of Table 4.1 that this arm needs", tasks.graph, cut=tasks)
        return model, source, signature(model, "inverse_dynamics")
    from robodyn.kernels.generate import generate

    options = options_of((settings.function,), vars(settings))
    options = Search(None, settings.seed, "total", False).applied(model, options, (settings.function,))
    ((interface, program),) = generate(model, options).unit.functions
    tasks = cut(program, settings.operations, costs)
    return model, cut_source(model.name, tasks, settings.operations), interface


def _friction(text: Any, robot: Robot) -> dict[int, Friction] | None:
    """The friction that --friction asks for, by joint; None to use the friction of the robot."""
    from robodyn.schedule.friction_tasks import chosen_friction

    if text is None:
        return None
    kinds = [link.joint.kind == "revolute" for link in robot.links]
    by_joint = {joint: chosen_friction(text, revolute=kind) for joint, kind in enumerate(kinds, 1)}
    return {joint: friction for joint, friction in by_joint.items() if friction is not None}


def _fewest(settings: ScheduleOptions, source: Source) -> None:
    from robodyn.schedule.optimum import fewest_for_critical_path

    with messages() as tell:
        fewest = fewest_for_critical_path(source.graph, seconds=settings.seconds, tell=tell)
    if as_json():
        numbers = {name: getattr(fewest, name) for name in ("processors", "at_least", "proven")}
        slots = [list(row) for row in fewest.timetable.slots]
        head = {"robot": source.name, "tasks": len(source.graph), "critical_path": fewest.span}
        echo_json({**head, **numbers, "slots": slots})
        return
    least = "fewer" if fewest.proven else f"fewer than {fewest.at_least}"
    click.echo(f"{source.name}: {len(source.graph)} {source.tasks}, critical path {fewest.span}")
    click.echo(
        f"{fewest.processors} processors suffice for {fewest.span} levels; {least} are proven to be too few"
    )


def _parallel_files(
    settings: ScheduleOptions,
    model: Robot | None,
    source: Source,
    signature: Signature | None,
    solution: Solved,
) -> tuple[Path, dict[str, str]]:
    """The folder and the files of the parallel C; no files without ``-o``."""
    if settings.emit is None:
        return Path(), {}
    from robodyn.emit.parallel import schedule_files

    assert model is not None
    assert signature is not None
    assert source.cut is not None
    folder = output_folder(settings.emit)
    return folder, schedule_files(
        model, signature, source.cut, solution.timetable, waiting=settings.sync, vector=settings.packed
    )
