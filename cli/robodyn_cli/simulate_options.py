"""Options of ``simulate``: what drives the robot, how it is solved, what its sensors are."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import click

if TYPE_CHECKING:
    _Type = click.ParamType[Any]
else:
    _Type = click.ParamType  # generic for type checkers only

Command = TypeVar("Command", bound=Callable[..., Any])

DRIVES = ("torque", "trajectory", "to", "line", "excite")
CONTROLLERS = ("feedforward", "pd", "computed-torque")
RATES = ("true", "difference", "filtered", "none")


class Numbers(_Type):
    """Numbers with commas between them, each as a robot file may have it (``pi/2``); positive ones, or such
    that are not negative, if ``sign`` says so."""

    name = "numbers"

    def __init__(self, sign: str = "any", *, single: bool = False) -> None:
        self.sign, self.single = sign, single

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        from robodyn.errors import InputError
        from robodyn.robot.numbers import number

        if not isinstance(value, str):  # a default
            return value
        parts = [value] if self.single else value.split(",")
        try:
            found = tuple(float(number(part)) for part in parts)
        except InputError as error:
            self.fail(str(error), param, ctx)
        for x in found:
            if (self.sign == "positive" and not x > 0) or (self.sign == "size" and x < 0):
                expected = "more than 0" if self.sign == "positive" else "0 or more"
                self.fail(f"{x:g} is not {expected}", param, ctx)
        return found[0] if self.single else found


class Line(_Type):
    """``x,y,z:x,y,z``, a line from a point to a point; or its end alone."""

    name = "line"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        points = [Numbers().convert(part, param, ctx) for part in value.split(":")]
        if not 1 <= len(points) <= 2 or any(len(point) != 3 for point in points):
            self.fail(f"{value!r} is not x,y,z:x,y,z, or x,y,z alone, in m", param, ctx)
        return tuple(points)


class Parameter(_Type):
    """``name=value``."""

    name = "parameter"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        name, equals, text = value.partition("=")
        if not equals:
            self.fail(f"{value!r} is not NAME=VALUE", param, ctx)
        return name.strip(), Numbers(single=True).convert(text, param, ctx)


ONE, POSITIVE, SIZE = Numbers(single=True), Numbers("positive", single=True), Numbers("size", single=True)
SEVERAL, POSITIVES, SIZES = Numbers(), Numbers("positive"), Numbers("size")


@dataclass(frozen=True, slots=True)
class Asked:
    """What the options say; None where nothing is said and the default depends on other options."""

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
        """Which of :data:`DRIVES` is asked for, the last of them; None: the motors do nothing."""
        given = self._given(DRIVES)
        return given[-1] if given else None

    @property
    def fixed_step(self) -> float:
        """The step [s] of rk4 (by default a sample, at most 1 ms), or the longest one of adaptive (ten
        samples, at most 10 ms: while everything is stuck nothing else keeps it short)."""
        if self.step is not None:
            return self.step
        return min(1 / self.rate, 1e-3) * (1 if self.solver == "rk4" else 10)

    def check(self) -> None:
        """Refuse options that do not go together.

        Raises
        ------
        InputError: with the two that do not.
        """
        from robodyn.errors import InputError

        drives = self._given(DRIVES)
        if len(drives) > 1:
            raise InputError(
                "only one thing can drive the robot",
                found=" and ".join(_spelled(name) for name in drives),
                remedy="leave all but one of them out",
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
            for name in self._given(names):
                if not fits:
                    raise InputError(
                        f"{_spelled(name)} goes with {partner}", remedy="leave one of the two out"
                    )
        if "filtered" in (self.velocity, self.acceleration) and self.cutoff is None:
            raise InputError("the low-pass has no cutoff", remedy="give --cutoff HZ")
        if self.encoder_bits is not None and self.position_resolution is not None:
            raise InputError("--encoder-bits and --position-resolution say the same", remedy="leave one out")
        if self.duration is not None and self.duration * self.rate < 1 - 1e-9:
            raise InputError(
                "the log would have one sample",
                found=f"{self.duration:g} s at {self.rate:g} Hz",
                remedy="a longer --duration, or a higher --rate",
            )

    def _given(self, names: tuple[str, ...]) -> list[str]:
        return [name for name in names if getattr(self, name) not in (None, False)]


def _spelled(name: str) -> str:
    return "--" + name.replace("_", "-")


def simulation_options(command: Command) -> Command:
    """Add the options of which :class:`Asked` is made."""
    option = click.option
    every = (
        option("--torque", metavar="FILE.csv", help="Torques t,tau1..taun, held between the rows."),
        option("--linear", is_flag=True, help="With --torque: straight lines between the rows."),
        option("--trajectory", metavar="FILE.csv", help="A motion to follow: t,q1..qn (qd, qdd if known)."),
        option("--to", type=SEVERAL, metavar="Q", help="Go to Q (rad or m, with commas) and stop there."),
        option("--line", type=Line(), metavar="A:B", help="Lead a point from x,y,z to x,y,z (m), straight."),
        option("--excite", is_flag=True, help="A periodic motion of all joints, inside their limits."),
        option(
            "--profile",
            type=click.Choice(["quintic", "trapezoid"]),
            help="Speed of --to and --line.  [default: quintic]",
        ),
        option("--point", type=SEVERAL, metavar="X,Y,Z", help="The point of --line in its link's frame (m)."),
        option("--link", type=click.IntRange(1), metavar="N", help="Its link.  [default: 6, or the last]"),
        option("--harmonics", type=click.IntRange(2, 1000), metavar="K", help="Of --excite.  [default: 5]"),
        option("--base-frequency", type=POSITIVE, metavar="HZ", help="Of --excite.  [default: 1/duration]"),
        option("--controller", type=click.Choice(CONTROLLERS), help="What follows.  [default: pd]"),
        option("--kp", type=SIZES, metavar="K", help="Its gain on position, one or one a joint."),
        option("--kd", type=SIZES, metavar="K", help="Its gain on velocity.  [default: from the inertia]"),
        option("--model", metavar="ROBOT", help="What it takes the robot for.  [default: what it is]"),
        option("--control-rate", type=POSITIVE, metavar="HZ", help="How often it acts.  [default: 1000]"),
        option("--from", "start", type=SEVERAL, metavar="Q", help="Start here.  [default: as the motion]"),
        option("--speed", type=SEVERAL, metavar="QD", help="Start at these speeds (rad/s or m/s)."),
        option("--duration", type=POSITIVE, metavar="S", help="[default: the file's; --to, --line: 2; 10]"),
        option("--rate", type=POSITIVE, metavar="HZ", default=1000.0, help="Of the log.  [default: 1000]"),
        option(
            "--solver",
            type=click.Choice(["adaptive", "rk4"]),
            default="adaptive",
            show_default=True,
            help="Steps as long as the tolerances allow, or all alike.",
        ),
        option("--step", type=POSITIVE, metavar="S", help="Of rk4 (1e-3); adaptive: longest (1e-2)."),
        option("--rtol", type=POSITIVE, metavar="X", help="Relative tolerance.  [default: 1e-8]"),
        option("--atol", type=POSITIVE, metavar="X", help="Absolute tolerance.  [default: 1e-10]"),
        option("--param", type=Parameter(), multiple=True, metavar="NAME=VALUE", help="Of the robot."),
        option("--encoder-bits", type=POSITIVES, metavar="BITS", help="A turn, of the revolute joints."),
        option("--position-resolution", type=SIZES, metavar="X", help="Step of the encoders (rad or m)."),
        option("--position-noise", type=SIZES, metavar="X", default=(0.0,), help="Standard deviation."),
        option(
            "--velocity", type=click.Choice(RATES), default="true", show_default=True, help="In the log."
        ),
        option("--acceleration", type=click.Choice(RATES), default="true", show_default=True, help="In it."),
        option("--cutoff", type=POSITIVE, metavar="HZ", help="Of the low-pass that makes filtered rates."),
        option("--torque-noise", type=SIZES, metavar="X", default=(0.0,), help="Deviation (N m or N)."),
        option("--torque-resolution", type=SIZES, metavar="X", default=(0.0,), help="Step (N m or N)."),
        option(
            "--seed",
            type=click.IntRange(0),
            metavar="N",
            default=0,
            show_default=True,
            help="Of --excite and the noise.",
        ),
    )  # fmt: skip
    for each in reversed(every):
        command = each(command)
    return command


def spread(name: str, values: tuple[float, ...], n: int, robot: str) -> tuple[float, ...]:
    """``values`` of an option as one a joint [n]; a single one is for all.

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
    """``values`` of an option that must be [n], or None.

    Raises
    ------
    InputError: they are not.
    """
    from robodyn.errors import InputError

    if values is not None and len(values) != n:
        raise InputError(
            f"{name} does not fit {robot}", found=f"{len(values)} numbers", expected=f"{n}, with commas"
        )
    return values


def whole(bits: float) -> int:
    """``bits`` as a whole number.

    Raises
    ------
    InputError: it is not.
    """
    from robodyn.errors import InputError

    if not (math.isfinite(bits) and bits == int(bits)):
        raise InputError("bits of an encoder come whole", found=f"{bits:g}", expected="such as 17")
    return int(bits)
