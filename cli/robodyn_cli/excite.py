"""``robodyn excite``: design a motion that distinguishes effects."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import click

from robodyn.errors import InputError
from robodyn_cli import progress
from robodyn_cli.choices import FILE, SEVERAL_EFFECTS
from robodyn_cli.decorators import at_most_one, option, robot_argument
from robodyn_cli.hide import placed
from robodyn_cli.output import as_json, printable, show, talk
from robodyn_cli.output_files import output_folder, write_file
from robodyn_cli.robot_files import load_robot
from robodyn_cli.values import POSITIVE

if TYPE_CHECKING:
    from robodyn.diagnose.excite import Design, EffectAt
    from robodyn.simulate.trajectories import Trajectory

#: Below this separation a log cannot distinguish two effects.
_NONE = 0.02
_LARGEST = 5_000_000  # samples times joints


@click.command()
@robot_argument
@option("--tell=A,B[@JOINT]", "Effects to distinguish.  [default: the whole catalogue]", SEVERAL_EFFECTS)
@option("--duration=S", "Duration of the motion.", POSITIVE, default="10")
@option("--harmonics=N", "Number of harmonics of the motion.", click.IntRange(2, 50), default=5)
@option("--rate=HZ", "Sample rate of the file.", POSITIVE, default="100")
@option("--seed=S", "Seed of the random motions.", click.IntRange(0), default=0)
@option("--tries=N", "Number of motions to try.", click.IntRange(1, 10_000), default=20)
@option("-o --output=TRAJ.csv", "Output file, - for stdout.", FILE, required=True)
def command(robot: str, tell: str | None, output: str, rate: float, **options: Any) -> None:
    """Design a motion within the limits that distinguishes effects.

    The command tries several random periodic motions and writes the best one: the one on which the torques of
    the effects of --tell differ most, for any parameter values, and after everything that errors of the arm's
    parameters within their confidence may explain. A joint given with one effect applies to all of them;
    without a joint, all joints are considered. Without --tell, all effects of the catalogue are considered.
    The file has the columns t, q.., qd.. and qdd.., as read by simulate --trajectory and hide --trajectory.
    """
    from robodyn.diagnose.excite import design

    described = load_robot(robot)
    at_most_one({"--json": as_json(), "-o -": output == "-"})
    samples = options["duration"] * rate
    if not 20 <= samples <= _LARGEST / described.n:
        raise InputError(
            "the motion would have too few or too many samples",
            found=f"{options['duration']:g} s at {rate:g} Hz",
            expected=f"20 to {_LARGEST // described.n}",
        )
    head = f"robodyn: {described.name}:"
    with progress.line() as shown:

        def count(done: int) -> None:
            shown.tell(f"{head} {done} of {options['tries']} motions")

        best = design(described, _effects_at(tell), period=1 / rate, progress=count, **options)
    text = _csv(best.trajectory)
    if output == "-":
        click.echo(text, nl=False)
        for line in _lines(best):
            talk(line)
    else:
        write_file(output_folder(output), text)
        size = f"{best.trajectory.duration:g} s, {len(best.trajectory)} samples"
        show(
            lambda: _summary(best, [str(output_folder(output))]),
            lambda: (f"{printable(output)}: {size}", *_lines(best)),
        )
    if best.tell and best.separation < _NONE and not as_json():
        talk(f"robodyn: warning: no motion distinguishes {best.pair}; see which other data to record")


def _effects_at(text: str | None) -> list[EffectAt]:
    """Effects and joints; if only one joint is named, it applies to all joint effects."""
    from robodyn.effects.catalogue import effect

    if text is None:
        return []
    pairs = [placed(part) for part in text.split(",")]
    joints = {joint for _, joint in pairs if joint is not None}
    if len(joints) != 1:
        return pairs
    (one,) = joints
    return [(id, one if effect(id).level != "robot" else joint) for id, joint in pairs]


def _csv(motion: Trajectory) -> str:
    from robodyn.logs.log import write_csv

    kinds = (("q", motion.q), ("qd", motion.qd), ("qdd", motion.qdd))
    names = [f"{kind}{i + 1}" for kind, _ in kinds for i in range(motion.n)]
    columns = [values[:, i] for _, values in kinds for i in range(motion.n)]
    return write_csv(["t", *names], [motion.t, *columns])


def _summary(design: Design, files: list[str]) -> dict[str, Any]:
    numbers = {name: getattr(design, name) for name in ("separation", "typical")}
    more = {"worst": design.pair, "tries": design.tries, "experiments": design.experiments}
    effects = [{"effect": id, "joint": joint} for id, joint in design.tell]
    return {"files": files, "tell": effects, **numbers, **more, "motion": design.trajectory.describe()}


def _lines(design: Design) -> Iterator[str]:
    from math import asin, degrees

    if not design.tell:
        yield f"independence of the catalogue: {design.separation:.3g}, typically {design.typical:.3g}"
        return
    best, typical = (degrees(asin(min(x, 1.0))) for x in (design.separation, design.typical))
    yield f"{design.pair}: {best:.1f} degrees apart, on a typical motion {typical:.1f}"
    yield from (f"to identify {id}: {text}" for id, text in design.experiments.items())
