"""``robodyn simulate``: simulate a robot with all its effects."""

from __future__ import annotations

import time
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import click

from robodyn.errors import InputError
from robodyn.outputs import check_outputs, write_files
from robodyn_cli import progress
from robodyn_cli.choices import FILE
from robodyn_cli.decorators import at_most_one, flag, option, robot_argument
from robodyn_cli.log_files import spare_inputs
from robodyn_cli.output import as_json, echo_json, printable, talk
from robodyn_cli.output_files import output_folder, picture_file
from robodyn_cli.robot_files import load_robot, parameter_values
from robodyn_cli.simulate_options import SimulationOptions, exactly, simulation_options, spread, whole

if TYPE_CHECKING:
    from robodyn.logs.log import Log
    from robodyn.robot import Robot
    from robodyn.simulate.sensors import Sensors
    from robodyn.simulate.simulation import Simulation
    from robodyn_cli.driving import Driven

_LOGS: Final = (".csv", ".parquet", ".pq")
_PICTURES: Final = (".svg", ".png")
#: Maximum size of a log: samples times joints.
_LARGEST: Final = 50_000_000
#: Runs longer than this [s] show their progress on a terminal.
_LONG: Final = 1.0
#: Relative energy error above which the command warns.
_ENERGY_TOLERANCE: Final = 1e-3


@click.command()
@robot_argument
@option("-o --output=LOG", "Output log: .csv, .parquet, or - (CSV on stdout).  [default: NAME.csv]", FILE)
@simulation_options
@option("--picture=FILE", "Plot positions, velocities and torques to .svg or .png.", FILE)
@flag("--strict", "Refuse physically implausible values.")
def command(robot: str, output: str | None, picture: str | None, strict: bool, **options: Any) -> None:
    """Simulate a robot with all its effects, and write the log.

    Give one of --torque, --trajectory, --to, --line and --excite; without them the motor torques are zero.
    The log has the columns t, q1.., qd1.., qdd1.., tau1.. in SI units, as measured by the robot's sensors.
    LOG.json beside it documents the origin of the log. The command prints the energy balance and a summary of
    the motion for each joint. The same command gives the same bytes.
    """
    settings = SimulationOptions(**options)
    settings.check()
    robot_model = load_robot(robot, strict=strict)
    target = _target(robot_model, output)
    picture_path = None if picture is None else picture_file(picture, _PICTURES)
    at_most_one({"--json": as_json(), "-o -": target is None})
    inputs = (robot, settings.torque, settings.trajectory, settings.model)
    spare_inputs(
        (file for file in (target, picture_path) if file is not None), [name for name in inputs if name]
    )
    exactly("--from", settings.start, robot_model)
    exactly("--speed", settings.speed, robot_model)
    for name_, positions in (("--from", settings.start), ("--to", settings.to)):
        _check_turns(robot_model, name_, positions, strict)
    values = parameter_values(robot_model, settings.param)
    sensors = _sensors(robot_model, settings)
    run, setup = _run(robot_model, settings, values)
    log = _log(run, sensors, settings, setup, robot)
    from robodyn.report.run import to_text, warnings_of

    files: dict[str, str | bytes] = {} if target is None else log.files(str(target))
    pictures: dict[str, str | bytes] = {}
    if picture_path is not None:
        from robodyn.report.run import motion_picture

        pictures[str(picture_path)] = motion_picture(
            robot_model, log, picture_path.suffix[1:].lower(), setup.reference
        )
    check_outputs(Path(), pictures, named=True)
    write_files(Path(), files, named=output is not None)
    write_files(Path(), pictures, named=True)
    summary = _summary(run, log, settings, setup, [*files, *pictures])
    if target is None:
        click.echo(log.csv(), nl=False)
    if as_json():
        echo_json(summary)
    else:
        for line in to_text(summary):
            click.echo(line, err=target is None)
    for text in warnings_of(run, _ENERGY_TOLERANCE, setup.reference):
        talk(f"robodyn: warning: {text}")


# --- before the run ---------------------------------------------------------------------------------------


def _target(robot: Robot, output: str | None) -> Path | None:
    """The path of the log; None for stdout."""
    if output == "-":
        return None
    path = Path(f"{robot.name}.csv") if output is None else output_folder(output)
    if path.suffix.lower() not in _LOGS:
        raise InputError(
            "the name of the log has no known extension",
            found=printable(path),
            expected=f"one of {', '.join(_LOGS)}, or -",
        )
    return path


def _check_turns(robot: Robot, option: str, positions: tuple[float, ...] | None, strict: bool) -> None:
    """Warn about revolute positions beyond one turn, which may be degrees; refuse them if ``strict``."""
    from robodyn.simulate.limits import beyond_a_turn

    if positions is None or len(positions) != robot.n:
        return
    joints = beyond_a_turn(robot, positions)
    if not joints:
        return
    degrees = [f"{x:g}*pi/180" if i in joints else f"{x:g}" for i, x in enumerate(positions, 1)]
    error = InputError(
        f"{option}: more than one turn",
        found=", ".join(f"joint {i}: {positions[i - 1]:g} rad" for i in joints),
        remedy=f"positions are in rad: {option} {','.join(degrees)} if degrees are meant",
    )
    if strict:
        raise error
    talk(f"robodyn: warning: {error}")


def _sensors(robot: Robot, settings: SimulationOptions) -> Sensors:
    from robodyn.simulate.sensors import Sensors, resolution_of

    resolution = (0.0,) * robot.n
    if settings.position_resolution is not None:
        resolution = spread("--position-resolution", settings.position_resolution, robot)
    elif settings.encoder_bits is not None:
        linear = [i for i, link in enumerate(robot.links) if link.joint.kind == "prismatic"]
        bits = spread("--encoder-bits", settings.encoder_bits, robot)
        resolution = tuple(
            0.0 if i in linear else resolution_of(whole(width)) for i, width in enumerate(bits)
        )
        if linear:
            talk(
                "robodyn: note: --encoder-bits does not apply to prismatic joints "
                f"({', '.join(str(i + 1) for i in linear)}): their positions are logged without rounding; "
                "use --position-resolution to set the resolution of each joint"
            )
    noise: dict[str, Any] = {
        name: spread(f"--{name.replace('_', '-')}", getattr(settings, name), robot)
        for name in ("position_noise", "torque_resolution", "torque_noise")
    }
    rates = {name: getattr(settings, name) for name in ("velocity", "acceleration", "cutoff")}
    return Sensors(position_resolution=resolution, **noise, **rates)


# --- the run ----------------------------------------------------------------------------------------------


def _run(robot: Robot, settings: SimulationOptions, values: Mapping[str, float]) -> tuple[Simulation, Driven]:
    from robodyn.simulate.simulation import simulate
    from robodyn_cli.driving import driven

    setup = driven(robot, settings, values)
    samples = setup.duration * settings.rate
    for words, count, unit in (
        ("a log", samples, "samples"),
        ("a run", setup.duration / settings.fixed_step, "steps"),
    ):
        if count * robot.n > _LARGEST:
            raise InputError(
                f"{words} of {count:.3g} {unit} is too long",
                expected=f"at most {_LARGEST // robot.n} for {robot.n} joints",
                remedy="use a shorter --duration, a lower --rate or a longer --step",
            )
    if samples < 1 - 1e-9:
        raise InputError(
            "the log would have one sample",
            found=f"{setup.duration:g} s at {settings.rate:g} Hz",
            remedy="use a longer --duration or a higher --rate",
        )
    rtol, atol = settings.tolerances
    start_time = time.monotonic()
    with progress.line() as progress_line:

        def show_progress(reached: float) -> None:
            if time.monotonic() - start_time > _LONG:
                progress_line.tell(f"robodyn: {robot.name}: {reached:.3f} of {setup.duration:g} s")

        run = simulate(
            robot, setup.drive, duration=setup.duration, sample_period=1 / settings.rate, plant=setup.plant,
            start=settings.start if settings.drive != "line" else None, speed=settings.speed,
            method=settings.solver, step=settings.fixed_step, rtol=rtol, atol=atol, parameters=values,
            progress=show_progress,
        )  # fmt: skip
    return run, setup


def _log(run: Simulation, sensors: Sensors, settings: SimulationOptions, setup: Driven, spec: str) -> Log:
    """The log as the sensors measure the run, with its provenance."""
    from dataclasses import replace

    from robodyn.formats.loading import text_of
    from robodyn.logs.provenance import provenance

    robot = run.plant.robot
    options = {
        "drive": setup.description, "from": run.q[0], "speed": run.qd[0], "duration": setup.duration,
        "rate": settings.rate, "parameters": run.parameters,
    }  # fmt: skip
    if settings.solver == "adaptive":
        options["rtol"], options["atol"] = settings.tolerances
    origin = provenance(
        robot, yaml=text_of(spec).encode(), options=options, sensors=sensors.describe(), seed=settings.seed,
        solver=settings.solver, step=settings.fixed_step, energy=run.balance().to_dict(),
    )  # fmt: skip
    return replace(run.log(sensors, seed=settings.seed), provenance=origin)


# --- after the run ----------------------------------------------------------------------------------------


def _summary(
    run: Simulation, log: Log, settings: SimulationOptions, setup: Driven, files: list[str]
) -> dict[str, Any]:
    """The run as ``--json`` prints it."""
    from robodyn.report.run import joint_rows

    return {
        "robot": run.plant.robot.name,
        "files": files,
        "duration": setup.duration,
        "samples": log.samples,
        "rate": settings.rate,
        "drive": {key: value for key, value in setup.description.items() if key != "trajectory"},
        "solver": {"method": settings.solver, **run.record.counters},
        "energy": run.balance().to_dict(),
        "joints": joint_rows(run, setup.reference),
    }
