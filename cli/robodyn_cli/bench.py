"""``robodyn bench``: time a call on this machine, with installed peers for comparison, and on threads."""

from __future__ import annotations

from typing import Any

import click

from robodyn_cli.decorators import option, robot_argument
from robodyn_cli.options import functions_option, load, model_options, one_function, options_of
from robodyn_cli.output import as_json, echo_json
from robodyn_cli.searching import Search


@click.command()
@robot_argument
@option("-p --processors=N", "Number of threads: 2, 2,4 or 2..4. [default: 2 to the number of cores]")
@option("--cut=K", "Operations per task.", int, default=3)
@functions_option("inverse_dynamics", "Function to time.")
@option("--states=N", "Number of states per measurement.", click.IntRange(1))
@model_options
def command(
    robot: str,
    processors: str | None,
    cut: int,
    functions: str,
    states: int | None,
    **model: Any,
) -> None:
    """Time a kernel on this machine: serial, packed, on threads, beside installed peers.

    The first table has nanoseconds and instructions per call, also for those of pin, mujoco and casadi that
    are installed and give the same torques. The second table is for threads, after a bitwise comparison: the
    synchronisation cost for every number of threads, whether threads are faster, and from how many
    operations per task (and in total) they would be.
    """
    from robodyn.bench.kernel_bench import kernel_bench
    from robodyn.bench.parallel_bench import bench
    from robodyn.dynamics.functions import function_named
    from robodyn.kernels.generate import generate
    from robodyn.report.benchmarks import bench_text, kernel_text
    from robodyn.report.schedules import processors_of
    from robodyn.schedule.cutting import cut as cut_program
    from robodyn.toolchain.program import cores
    from robodyn_cli.progress import messages

    function = one_function(functions)
    described = load(robot, strict=model["strict"])
    counts = processors_of(processors or f"2..{max(2, min(4, cores()))}")
    options = options_of((function,), model)
    options = Search(None, 0, "total", False).applied(described, options, (function,))
    ((interface, program),) = generate(described, options).unit.functions
    tasks = cut_program(program, cut)
    with messages() as tell:
        serial = None
        if function_named(function).is_recursion:
            serial = kernel_bench(described, options, tell=tell)
        threads = bench(described, interface, tasks, counts, states=states, tell=tell)
    if as_json():
        echo_json({**threads.to_dict(), **({} if serial is None else serial.to_dict())})
    else:
        if serial is not None:
            click.echo(kernel_text(serial))
        click.echo(bench_text(threads), nl=False)
