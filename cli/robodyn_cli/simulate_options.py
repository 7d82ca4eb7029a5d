"""Options of ``simulate``: input, solver and sensors."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

import click
from click import option

from robodyn_cli.choices import FILE, ROBOTS
from robodyn_cli.common import add_options
from robodyn_cli.values import POSITIVE, POSITIVES, SEVERAL, SIZES, Line, parameter_option

Command = TypeVar("Command", bound=Callable[..., Any])

DRIVES = ("torque", "trajectory", "to", "line", "excite")
CONTROLLERS = ("feedforward", "pd", "computed-torque")
RATES = ("true", "difference", "filtered", "none")


@dataclass(frozen=True, slots=True)
class SimulationOptions:
    """The parsed options; None where the default depends on other options."""

    torque: str | None
    linear: bool
    trajectory: str | None
    to: tuple[float, ...] | None
    line: tuple[tuple[float, ...], ...] | None
    excite: bool
    profile: str | None
    point: tuple[float, ...] | None
    link: int | None
    harmonics: int | None
    base_frequency: float | None
    controller: str | None
    kp: tuple[float, ...] | None
    kd: tuple[float, ...] | None
    model: str | None
    control_rate: float | None
    start: tuple[float, ...] | None
    speed: tuple[float, ...] | None
    duration: float | None
    rate: float
    solver: str
    step: float | None
    rtol: float | None
    atol: float | None
    param: tuple[tuple[str, float], ...]
    encoder_bits: tuple[float, ...] | None
    position_resolution: tuple[float, ...] | None
    position_noise: tuple[float, ...]
    velocity: str
    acceleration: str
    cutoff: float | None
    torque_noise: tuple[float, ...]
    torque_resolution: tuple[float, ...]
    seed: int

    @property
    def drive(self) -> str | None:
        """The last of :data:`DRIVES` on the command line; None if the motor torques are zero."""
        drives = self._present(DRIVES)
        return drives[-1] if drives else None

    @property
    def fixed_step(self) -> float:
        """The step [s] of rk4 (default: one sample, at most 1 ms), or the maximum step of adaptive (ten
        samples, at most 10 ms; nothing else limits it while all joints stick)."""
        if self.step is not None:
            return self.step
        return min(1 / self.rate, 1e-3) * (1 if self.solver == "rk4" else 10)

    @property
    def tolerances(self) -> tuple[float, float]:
        """Those of adaptive steps: relative, and absolute [rad, m and their rates]."""
        from robodyn.simulate.engine import ATOL, RTOL

        return RTOL if self.rtol is None else self.rtol, ATOL if self.atol is None else self.atol

    def check(self) -> None:
        """Refuse options that cannot be combined.

        Raises
        ------
        InputError: names the two options.
        """
        from robodyn.errors import InputError

        drives = self._present(DRIVES)
        if len(drives) > 1:
            raise InputError(
                "only one input can drive the robot",
                found=" and ".join(_spelled(name) for name in drives),
                remedy="keep one of them",
            )
        follows = self.drive not in (None, "torque")
        for names, fits, partner in (
            (("linear",), self.drive == "torque", "--torque"),
            (("profile",), self.drive in ("to", "line"), "--to or --line"),
            (("point", "link"), self.drive == "line", "--line"),
            (("harmonics", "base_frequency"), self.drive == "excite", "--excite"),
            (
                ("controller", "kp", "kd", "model", "control_rate"),
                follows,
                "a motion to follow: --trajectory, --to, --line or --excite",
            ),
            (("kp", "kd"), self.controller != "feedforward", "--controller pd or computed-torque"),
            (("rtol", "atol"), self.solver == "adaptive", "--solver adaptive"),
            (("cutoff",), "filtered" in (self.velocity, self.acceleration), "--velocity filtered"),
        ):
            for name in self._present(names):
                if not fits:
                    raise InputError(
                        f"{_spelled(name)} requires {partner}", remedy=f"remove {_spelled(name)}"
                    )
        if "filtered" in (self.velocity, self.acceleration) and self.cutoff is None:
            raise InputError("the low-pass filter has no cutoff frequency", remedy="add --cutoff HZ")
        if self.encoder_bits is not None and self.position_resolution is not None:
            raise InputError(
                "--encoder-bits and --position-resolution set the same quantity", remedy="remove one of them"
            )
        if self.duration is not None and self.duration * self.rate < 1 - 1e-9:
            raise InputError(
                "the log would have only one sample",
                found=f"{self.duration:g} s at {self.rate:g} Hz",
                remedy="use a longer --duration or a higher --rate",
            )

    def _present(self, names: tuple[str, ...]) -> list[str]:
        return [name for name in names if getattr(self, name) not in (None, False)]


def _spelled(name: str) -> str:
    return "--" + name.replace("_", "-")


simulation_options = add_options(
    option("--torque", type=FILE, metavar="FILE.csv",
           help="Apply torques t,tau1..taun, held between rows."),
    option("--linear", is_flag=True, help="Interpolate between rows (with --torque)."),
    option("--trajectory", type=FILE, metavar="FILE.csv",
           help="Follow a motion: t,q1..qn (qd, qdd if known)."),
    option("--to", type=SEVERAL, metavar="Q", help="Move to Q (rad or m, separated by commas)."),
    option("--line", type=Line(), metavar="A:B",
           help="Move a point from x,y,z to x,y,z (m) on a straight line."),
    option("--excite", is_flag=True, help="Follow a periodic motion of all joints within their limits."),
    option(
        "--profile",
        type=click.Choice(["quintic", "trapezoid"]),
        help="Velocity profile (with --to, --line).  [default: quintic]",
    ),
    option("--point", type=SEVERAL, metavar="X,Y,Z",
           help="Point that follows --line, in its link's frame (m).  [default: the tool]"),
    option("--link", type=click.IntRange(1), metavar="N",
           help="Link of --point.  [default: 6, or the last]"),
    option("--harmonics", type=click.IntRange(2, 1000), metavar="K",
           help="Number of harmonics (with --excite).  [default: 5]"),
    option("--base-frequency", type=POSITIVE, metavar="HZ",
           help="Base frequency (with --excite).  [default: 1/duration]"),
    option("--controller", type=click.Choice(CONTROLLERS),
           help="Controller that follows the motion.  [default: pd]"),
    option("--kp", type=SIZES, metavar="K",
           help="Position gain, one value or one per joint.  [default: from the inertia]"),
    option("--kd", type=SIZES, metavar="K",
           help="Velocity gain, one value or one per joint.  [default: from the inertia]"),
    option("--controller-model", "model", type=ROBOTS, metavar="ROBOT",
           help="Model used by the controller.  [default: the robot itself]"),
    option("--control-rate", type=POSITIVE, metavar="HZ",
           help="Sample rate of the controller.  [default: 1000]"),
    option("--from", "start", type=SEVERAL, metavar="Q",
           help="Initial position.  [default: start of the motion]"),
    option("--speed", type=SEVERAL, metavar="QD", help="Initial velocity (rad/s or m/s)."),
    option("--duration", type=POSITIVE, metavar="S",
           help="Duration.  [default: that of the file; --to, --line: 2; else 10]"),
    option("--rate", type=POSITIVE, metavar="HZ", default=1000.0,
           help="Sample rate of the log.  [default: 1000]"),
    option(
        "--solver",
        type=click.Choice(["adaptive", "rk4"]),
        default="adaptive",
        show_default=True,
        help="Solver with adaptive or fixed steps.",
    ),
    option("--step", type=POSITIVE, metavar="S",
           help="Step of rk4, or maximum step of adaptive.  [default: 1e-3, 1e-2]"),
    option("--rtol", type=POSITIVE, metavar="X", help="Relative tolerance.  [default: 1e-8]"),
    option("--atol", type=POSITIVE, metavar="X", help="Absolute tolerance.  [default: 1e-10]"),
    parameter_option(),
    option("--encoder-bits", type=POSITIVES, metavar="BITS",
           help="Encoder bits per turn (revolute joints)."),
    option("--position-resolution", type=SIZES, metavar="X", help="Encoder step (rad or m)."),
    option("--position-noise", type=SIZES, metavar="X", default=(0.0,),
           help="Standard deviation of the position noise (rad or m)."),
    option(
        "--velocity", type=click.Choice(RATES), default="true", show_default=True,
        help="Velocity in the log."
    ),
    option(
        "--acceleration", type=click.Choice(RATES), default="true", show_default=True,
        help="Acceleration in the log."
    ),
    option("--cutoff", type=POSITIVE, metavar="HZ",
           help="Cutoff frequency of the low-pass filter for filtered."),
    option(
        "--torque-noise", type=SIZES, metavar="X", default=(0.0,),
        help="Standard deviation of the torque noise (N m or N)."
    ),
    option("--torque-resolution", type=SIZES, metavar="X", default=(0.0,),
           help="Torque step (N m or N)."),
    option(
        "--seed",
        type=click.IntRange(0),
        metavar="N",
        default=0,
        show_default=True,
        help="Seed of --excite and of the noise.",
    ),
)  # fmt: skip
"""Add the options that :class:`SimulationOptions` holds."""


def spread(name: str, values: tuple[float, ...], n: int, robot: str) -> tuple[float, ...]:
    """``values`` of an option, one per joint [n]; a single value applies to all.

    Raises
    ------
    InputError: neither one nor n.
    """
    from robodyn.errors import InputError

    if len(values) not in (1, n):
        raise InputError(
            f"{name} does not fit {robot}",
            found=f"{len(values)} numbers",
            expected=f"1 or {n}" if n > 1 else "1",
        )
    return values if len(values) == n else values * n


def exactly(name: str, values: tuple[float, ...] | None, n: int, robot: str) -> tuple[float, ...] | None:
    """``values`` of an option that must have shape [n], or None.

    Raises
    ------
    InputError: another shape.
    """
    from robodyn.errors import InputError

    if values is not None and len(values) != n:
        raise InputError(
            f"{name} does not fit {robot}",
            found=f"{len(values)} numbers",
            expected=f"{n}, separated by commas",
        )
    return values


def whole(bits: float) -> int:
    """``bits`` as an integer.

    Raises
    ------
    InputError: it is not an integer.
    """
    from robodyn.errors import InputError

    if not (math.isfinite(bits) and bits == int(bits)):
        raise InputError("encoder bits must be an integer", found=f"{bits:g}", expected="for instance 17")
    return int(bits)
