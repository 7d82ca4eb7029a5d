"""How much faster than real time a robot is simulated, and how much of it Python costs.

    python benchmarks/simulation.py [ROBOT] [-n RUNS] [--seconds S] [--check]

ROBOT (default: puma560 with viscous and Coulomb friction at every joint, which sticks and slips; and the same
with friction in bearings and gears that feels the load) follows a Fourier excitation under a PD controller at
1 kHz with Runge-Kutta steps of 1 ms, energy balance included; beside it MuJoCo, where it is installed, with
the same arm, damping and dry friction, its RK4 at the same step, let go. CPU time of one core, the median of
RUNS, all in one run of this program; Python's share is what is not spent inside the compiled engine. With
``--check`` the exit code is 1 below 100 times real time, or where Python takes half or more.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from robodyn.robot import Robot, load
from robodyn.robot.model import EffectEntry
from robodyn.simulate.engine import Engine
from robodyn.simulate.limits import with_limits
from robodyn.simulate.plant import build_plant
from robodyn.simulate.simulation import Follow, simulate
from robodyn.simulate.trajectories import fourier

WANTED = 100.0
SHARE = 0.5


@dataclass(frozen=True)
class Row:
    """Seconds of CPU for ``seconds`` of motion, in all and inside the engine."""

    what: str
    seconds: float
    total: float
    inside: float | None

    @property
    def ratio(self) -> float:
        """Real time over CPU time."""
        return self.seconds / self.total

    @property
    def share(self) -> float | None:
        """What Python takes of it."""
        return None if self.inside is None else 1 - self.inside / self.total

    def text(self) -> str:
        """A line of the table."""
        share = "-" if self.share is None else f"{100 * self.share:.0f} %"
        step = 1e6 * self.total / (1000 * self.seconds)
        return f"{self.what:44} {self.ratio:10.0f} {step:12.2f} {share:>14}"


def with_friction(robot: Robot) -> Robot:
    """``robot`` with viscous and Coulomb friction everywhere."""
    links = tuple(
        replace(link, joint=replace(link.joint, viscous=Fraction(1), coulomb=Fraction(2, 1 + i)))
        for i, link in enumerate(robot.links)
    )
    return replace(robot, links=links)


def with_loads(robot: Robot) -> Robot:
    """``robot`` with bearings and gears that feel the load at the first three joints."""
    effects = list(robot.effects)
    for joint in (1, 2, 3):
        sizes = (("mu", Fraction(1, 10)), ("radius", Fraction(8, 100)), ("span", Fraction(1, 5)))
        bearing = (("bearing", "journal"), *sizes)
        gear = (("breakaway", Fraction(3)), ("efficiency", Fraction(7, 10)), ("interpolation", "linear"))
        effects += [
            EffectEntry("load_dependent_friction", joint, bearing),
            EffectEntry("transmission_loss", joint, gear),
        ]
    return replace(robot, effects=tuple(effects))


class Clock:
    """The CPU time spent inside the engine, measured by a library in place of its own."""

    def __init__(self, library: Any) -> None:
        self.library, self.spent = library, 0.0

    def __getattr__(self, name: str) -> Any:
        function = getattr(self.library, name)
        if name != "run_advance":
            return function

        def timed(*arguments: Any) -> Any:
            start = time.process_time()
            try:
                return function(*arguments)
            finally:
                self.spent += time.process_time() - start

        return timed


def ours(what: str, robot: Robot, seconds: float, runs: int) -> Row:
    """Our simulation of ``robot``."""
    plant = build_plant(robot)
    motion = fourier(with_limits(robot)[0], 10 / seconds / 10, 5, seed=1, period=1e-3)
    totals, insides = [], []
    for k in range(runs + 1):
        clock = Clock(plant.engine.library)
        engine: Engine = replace(plant.engine, library=clock)
        start = time.process_time()
        simulation = simulate(
            robot, Follow(motion, "pd", kp=400.0, kd=40.0), plant=replace(plant, engine=engine), step=1e-3
        )
        total = time.process_time() - start
        assert simulation.record.status == "done"
        assert simulation.balance().error < 1e-3
        if k:
            totals.append(total)
            insides.append(clock.spent)
    return Row(what, motion.duration, statistics.median(totals), statistics.median(insides))


def mujoco_row(robot: Robot, seconds: float, runs: int) -> Row | None:
    """MuJoCo's time for the same arm, if it is installed."""
    try:
        import mujoco
    except ImportError:
        return None
    sys.path.insert(0, "tests")
    from peers import mujoco_peer

    model = mujoco_peer.moving_model(robot, mujoco_peer.Moving(1e-3))
    model.opt.iterations, model.opt.tolerance = 100, 1e-8  # as MuJoCo has them by itself
    times = []
    for _ in range(runs):
        data = mujoco.MjData(model)
        start = time.process_time()
        mujoco.mj_step(model, data, nstep=round(1000 * seconds))
        times.append(time.process_time() - start)
    return Row("MuJoCo, RK4, the first arm, no controller", seconds, statistics.median(times), None)


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure, print the table, and return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("robot", nargs="?", help="a bundled robot or a file")
    parser.add_argument("-n", "--runs", type=int, default=5, help="how often each is measured (default: 5)")
    parser.add_argument("--seconds", type=float, default=10.0, help="how long the motion is (default: 10)")
    parser.add_argument("--check", action="store_true", help="exit 1 where a limit is missed")
    options = parser.parse_args(arguments)
    rows: list[Row] = []
    if options.robot:
        arm = load(options.robot, warn=lambda _: None)
        rows.append(ours(options.robot, arm, options.seconds, options.runs))
    else:
        arm = with_friction(load("puma560", warn=lambda _: None))
        rows.append(ours("puma560, viscous and Coulomb friction", arm, options.seconds, options.runs))
        rows.append(
            ours("puma560, bearings and gears besides", with_loads(arm), options.seconds, options.runs)
        )
        peer = mujoco_row(arm, options.seconds, options.runs)
        rows += [peer] if peer is not None else []
    print(f"{'':44} {'x real time':>10} {'us a step':>12} {'Python share':>14}")
    for row in rows:
        print(row.text())
    first = rows[0]
    return 1 if options.check and (first.ratio < WANTED or (first.share or 0) >= SHARE) else 0


if __name__ == "__main__":
    sys.exit(main())
