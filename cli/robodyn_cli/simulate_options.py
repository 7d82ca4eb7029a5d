"""Options of ``simulate``: input, solver and sensors."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import TYPE_CHECKING

import click

from robodyn.errors import InputError
from robodyn_cli.choices import FILE, ROBOTS
from robodyn_cli.decorators import add_options, at_most_one, flag, option
from robodyn_cli.values import POSITIVE, POSITIVES, SEVERAL, SIZES, Line, Point, parameter_option

if TYPE_CHECKING:
    from robodyn.robot import Robot

DRIVES = ("torque", "trajectory", "to", "line", "excite")
CONTROLLERS = ("feedforward", "pd", "computed-torque")
RATES = ("true", "difference", "filtered", "none")


class SimulationOptions(SimpleNamespace):
    """The parsed options of :data:`simulation_options`; None where the default depends on other options."""

    rate: float
    step: float | None

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
        at_most_one({_spelled(name): getattr(self, name) for name in DRIVES})
        resolutions = ("encoder_bits", "position_resolution")
        at_most_one({_spelled(name): getattr(self, name) for name in resolutions})
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

    def _present(self, names: tuple[str, ...]) -> list[str]:
        return [name for name in names if getattr(self, name) not in (None, False)]


def _spelled(name: str) -> str:
    return "--" + name.replace("_", "-")


simulation_options = add_options(
    option("--torque=FILE.csv", "Apply torques t,tau1..taun, held between rows.", FILE),
    flag("--linear", "Interpolate between rows (with --torque)."),
    option("--trajectory=FILE.csv", "Follow a motion: t,q1..qn (qd, qdd if known).", FILE),
    option("--to=Q", "Move to Q (rad or m, separated by commas).", SEVERAL),
    option("--line=A:B", "Move a point from x,y,z to x,y,z (m) on a straight line.", Line()),
    flag("--excite", "Follow a periodic motion of all joints within their limits."),
    option(
        "--profile", "Velocity profile (with --to, --line).  [default: quintic]", ["quintic", "trapezoid"]
    ),
    option(
        "--point=X,Y,Z", "Point that follows --line, in its link's frame (m).  [default: the tool]", Point()
    ),
    option("--link=N", "Link of --point.  [default: 6, or the last]", click.IntRange(1)),
    option("--harmonics=K", "Number of harmonics (with --excite).  [default: 5]", click.IntRange(2, 1000)),
    option("--base-frequency=HZ", "Base frequency (with --excite).  [default: 1/duration]", POSITIVE),
    option("--controller", "Controller that follows the motion.  [default: pd]", CONTROLLERS),
    option("--kp=K", "Position gain, one value or one per joint.  [default: from the inertia]", SIZES),
    option("--kd=K", "Velocity gain, one value or one per joint.  [default: from the inertia]", SIZES),
    option(
        "--controller-model=ROBOT model", "Model used by the controller.  [default: the robot itself]", ROBOTS
    ),
    option("--control-rate=HZ", "Sample rate of the controller.  [default: 1000]", POSITIVE),
    option("--from=Q start", "Initial position.  [default: start of the motion]", SEVERAL),
    option("--speed=QD", "Initial velocity (rad/s or m/s).", SEVERAL),
    option("--duration=S", "Duration.  [default: that of the file; --to, --line: 2; else 10]", POSITIVE),
    option("--rate=HZ", "Sample rate of the log.", POSITIVE, default="1000"),
    option("--solver", "Solver with adaptive or fixed steps.", ["adaptive", "rk4"], default="adaptive"),
    option("--step=S", "Step of rk4, or maximum step of adaptive.  [default: 1e-3, 1e-2]", POSITIVE),
    option("--rtol=X", "Relative tolerance.  [default: 1e-8]", POSITIVE),
    option("--atol=X", "Absolute tolerance.  [default: 1e-10]", POSITIVE),
    parameter_option(),
    option("--encoder-bits=BITS", "Encoder bits per turn (revolute joints).", POSITIVES),
    option("--position-resolution=X", "Encoder step (rad or m).", SIZES),
    option(
        "--position-noise=X",
        "Standard deviation of the position noise (rad or m).",
        SIZES,
        default=(0.0,),
        show_default=False,
    ),
    option("--velocity", "Velocity in the log.", RATES, default="true"),
    option("--acceleration", "Acceleration in the log.", RATES, default="true"),
    option("--cutoff=HZ", "Cutoff frequency of the low-pass filter for filtered.", POSITIVE),
    option(
        "--torque-noise=X",
        "Standard deviation of the torque noise (N m or N).",
        SIZES,
        default=(0.0,),
        show_default=False,
    ),
    option("--torque-resolution=X", "Torque step (N m or N).", SIZES, default=(0.0,), show_default=False),
    option("--seed=N", "Seed of --excite and of the noise.", click.IntRange(0), default=0),
)
"""Add the options that :class:`SimulationOptions` holds."""


def spread(name: str, values: tuple[float, ...], robot: Robot) -> tuple[float, ...]:
    """``values`` of an option, one per joint [n]; a single value applies to all.

    Raises
    ------
    InputError: neither one nor n.
    """
    several = values * robot.n if len(values) == 1 else values
    return _fitting(name, several, robot, f"1 or {robot.n}" if robot.n > 1 else "1")


def exactly(name: str, values: tuple[float, ...] | None, robot: Robot) -> tuple[float, ...] | None:
    """``values`` of an option that must have shape [n], or None.

    Raises
    ------
    InputError: another shape.
    """
    return None if values is None else _fitting(name, values, robot, f"{robot.n}, separated by commas")


def _fitting(name: str, values: tuple[float, ...], robot: Robot, expected: str) -> tuple[float, ...]:
    if len(values) != robot.n:
        found = f"{len(values)} numbers"
        raise InputError(f"{name} does not fit {robot.name}", found=found, expected=expected)
    return values


def whole(bits: float) -> int:
    """``bits`` as an integer.

    Raises
    ------
    InputError: it is not an integer.
    """
    if not (math.isfinite(bits) and bits == int(bits)):
        raise InputError("encoder bits must be an integer", found=f"{bits:g}", expected="for instance 17")
    return int(bits)
