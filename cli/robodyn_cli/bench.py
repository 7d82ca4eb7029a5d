"""``robodyn bench``: time a call on this machine, with installed peers for comparison, and on threads."""

from __future__ import annotations

import click

from robodyn_cli.common import echo_json, json_option, robot_argument
from robodyn_cli.options import functions_option, load, model_options, one_function
from robodyn_cli.searching import Search


@click.command()
@robot_argument
@click.option(
    "-p",
    "--processors",
    metavar="N",
    help="Number of threads: 2, 2,4 or 2..4. [default: 2 to the number of cores]",
)
@click.option("--cut", metavar="K", type=int, default=3, show_default=True, help="Operations per task.")
@functions_option("inverse_dynamics", "Function to time.")
@click.option("--states", metavar="N", type=int, help="Number of states per measurement.")
@model_options
@json_option
def command(
    robot: str,
    processors: str | None,
    cut: int,
    functions: str,
    states: int | None,
    formulation: str,
    optimize: str,
    no_regroup: bool,
    engine: str,
    strict: bool,
    as_json: bool,
) -> None:
    """Time a kernel on this machine: serial, packed, on threads, and compared with installed peers.

    The first table has nanoseconds and instructions per call, also for those of pin, mujoco and casadi that
    are installed and give the same torques. The second table is for threads, after a bitwise comparison: the
    synchronisation cost for every number of threads, whether threads are faster, and from how many
    operations per task (and in total) they would be.
    """
    from robodyn.bench.kernel_bench import kernel_bench
    from robodyn.bench.parallel_bench import bench
    from robodyn.dynamics.functions import function_named
    from robodyn.errors import InputError
    from robodyn.kernels.generate import Options, generate
    from robodyn.report.benchmarks import bench_text, kernel_text
    from robodyn.report.schedules import processors_of
    from robodyn.schedule.cutting import cut as cut_program
    from robodyn.toolchain.program import cores
    from robodyn_cli.progress import line

    function = one_function(functions)
    described = load(robot, strict=strict)
    if states is not None and states < 1:
        raise InputError(
            "a measurement needs at least one state", found=f"--states {states}", expected="1 or more"
        )
    counts = processors_of(processors or f"2..{max(2, min(4, cores()))}")
    options = Options((function,), formulation, optimize, not no_regroup, engine=engine)  # type: ignore[arg-type]
    options = Search(None, 0, "total", False).applied(described, options, (function,))
    ((interface, program),) = generate(described, options).unit.functions
    tasks = cut_program(program, cut)
    with line() as shown:
        beside = None
        if function_named(function).is_recursion:
            beside = kernel_bench(described, options, tell=lambda text: shown.tell(f"robodyn: {text}"))
        measured = bench(
            described,
            interface,
            tasks,
            counts,
            states=states,
            tell=lambda text: shown.tell(f"robodyn: {text}"),
        )
    if as_json:
        echo_json({**measured.to_dict(), **({} if beside is None else beside.to_dict())})
    else:
        if beside is not None:
            click.echo(kernel_text(beside))
        click.echo(bench_text(measured), nl=False)
