"""What the other rooms ask of an effect beside its equation: at rest, in a file, in a log, in a picture.

Each effect states its traits with its definition, and nobody else knows it by name. What a trait does not
need to say follows from the definition: where it acts (``place``), whether it is dry (its equation follows
the direction of motion), whether it remembers (``memory``) or lies between motor and link (``coupler``),
whether it gives back what it takes (``potential``), in which parameters it is linear. First, what an equation
may read (:class:`Site`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal


@dataclass(frozen=True, slots=True)
class Site:
    """What an equation may read at a joint, over any scalar.

    ``q, qd, qdd``: position, velocity and acceleration on its side of the drive [rad or m, per second];
    ``direction``: sgn(qd), by whatever rule holds near rest; ``tau``: the torque that has come so far [N m or
    N]; ``f`` [3] (N) and ``n`` [3] (N m): force and moment of the rigid arm through the joint, about the
    origin and along the axes of the link's frame, z the joint's. ``revolute``: the kind of joint.
    """

    revolute: bool
    q: Any = 0
    qd: Any = 0
    qdd: Any = 0
    direction: Any = 0
    tau: Any = 0
    f: tuple[Any, Any, Any] = (0, 0, 0)
    n: tuple[Any, Any, Any] = (0, 0, 0)


#: Parameters as a diagnosis states them.
Estimates = dict[str, float | str]
#: Of coefficients [c] and of the values of what is not linear: the catalogue's parameters.
Read = Callable[[Any, Mapping[str, float]], Estimates]


# --- in a description -------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Fold:
    """Numbers of a description that take the effect, so that no entry is left of it.

    ``joint``: the ``parameter`` is added to the joint's ``key``, which stands in ``group`` of a link (""; in
    the link itself). ``link``: mass, centre of mass and inertia take parameters ``delta_...``. ``gravity``:
    it is turned by ``tilt_x`` and ``tilt_y``.
    """

    into: Literal["joint", "link", "gravity"]
    key: str = ""
    parameter: str = ""
    group: str = ""


#: How two of an effect at one place are one: by the parameters that it is linear in, or as springs side by
#: side, waves of one length, bearings of one kind, balancers of one shape.
Combination = Literal["by parameter", "springs", "waves", "bearings", "balancers"]


# --- in what is measured ----------------------------------------------------------------------------------


Acts = Literal["position", "delay", "gain", "bias", "limit"]


@dataclass(frozen=True, slots=True)
class Channel:
    """What is done to a channel of a log, by the ``parameter``: the ``position`` is shifted, the torque comes
    late (``delay``), is scaled (``gain``), shifted (``bias``) or cut off (``limit``; ``who`` is the parameter
    that says by whom, ``drive`` or ``sensor``)."""

    acts: Acts
    parameter: str
    who: str = ""

    @property
    def is_torque(self) -> bool:
        """Whether it is the channel of the torque."""
        return self.acts != "position"


# --- candidates for diagnosis -----------------------------------------------------------------------------


def anything(x: Any) -> bool:
    """No bounds."""
    return True


def between(rng: Any, low: float, high: float) -> float:
    """A random number between two, its logarithm evenly spread."""
    return math.exp(rng.uniform(math.log(low), math.log(high)))


#: Joints at which something can be.
JointKind = Literal["any", "revolute", "prismatic"]


def any_speed(values: Mapping[str, float], top: float) -> bool:
    """Whatever the joint's top speed."""
    return True


@dataclass(frozen=True, slots=True)
class Law:
    """A torque at one joint that is linear in some numbers.

    ``columns`` gives the torques by those numbers, of the values of what is not linear and a site over
    arrays; ``signs`` are +1 for a number that must not be negative, 0 for any; ``read`` makes the catalogue's
    parameters of the numbers. ``order``: of two that explain alike the lower one is the simpler. ``grid``:
    values of what is not linear that are tried, where ``suits`` them the top speed of the joint; steps of
    their refinement begin at the factor ``spread[0]`` and end at ``spread[1]``. ``kind``: of the joint.
    ``balances``: only at joints that carry gravity.
    """

    columns: Callable[[Mapping[str, float], Site], Sequence[Any]]
    signs: tuple[int, ...]
    read: Read
    order: int
    grid: tuple[Mapping[str, float], ...] = ({},)
    suits: Callable[[Mapping[str, float], float], bool] = any_speed
    spread: tuple[float, float] = (1.5, 1.03)
    feasible: Callable[[Any], bool] = anything
    kind: JointKind = "any"
    balances: bool = False


@dataclass(frozen=True, slots=True)
class Line:
    """A straight line over the joint's position, fitted about the middle of the motion: ``read`` is given
    slope, torque in the middle, and ``middle``."""

    read: Read
    order: int


@dataclass(frozen=True, slots=True)
class Wave:
    """A wave over the joint's position, of lengths that stand out of the log: ``read`` is given the parts in
    phase with sine and cosine, and ``cycles`` a radian or metre."""

    read: Read
    order: int
    spread: tuple[float, float]


@dataclass(frozen=True, slots=True)
class Dahl:
    """Dahl friction, by the travel since reversals: ``deflections`` [rad or m] at which it starts to slide
    are tried that are longer than the travel between two samples. The
    parameters ``level``, ``stiffness`` and ``damping`` (of the deflection's rate)."""

    level: str
    stiffness: str
    damping: str
    deflections: tuple[float, ...]
    read: Read
    order: int


@dataclass(frozen=True, slots=True)
class Twist:
    """A link behind its motor, on springs with these natural frequencies (``hertz``), and with each of
    ``more``; ``fixed`` values go along. ``ahead``: with the encoder at the link, unit values at which the
    motor's lead is linear in one number, and how that is read. ``reach``: how far steps of refinement go;
    ``likely``: larger values are so unlikely that they are no name, unless nothing else explains the log."""

    hertz: tuple[float, ...]
    reach: Mapping[str, float]
    ahead: tuple[Mapping[str, float], ...]
    read_ahead: Read
    order: int
    more: tuple[Mapping[str, float], ...] = ({},)
    fixed: Mapping[str, float] = field(default_factory=dict)
    likely: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Shown:
    """What the ``channel`` does, what the pair of joints adds (by its equation), what the rigid arm's numbers
    change: ``order`` at a joint, and of the whole robot; ``feasible``: whether a pair may have these
    numbers."""

    order: int
    of_all: int | None = None
    feasible: Callable[[Any], bool] = anything


Candidates = Law | Line | Wave | Dahl | Twist | Shown


@dataclass(frozen=True, slots=True)
class Limit:
    """Where the effect is no more than another one, ``id``: ``when`` its parameters say so; ``parameters`` of
    the other, of its own and the joint's usual speed."""

    id: str
    when: Callable[[Mapping[str, Any]], bool]
    parameters: Callable[[Mapping[str, Any], float], Estimates]


# --- blind tests ------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Usual:
    """What is usual of a joint on a motion: RMS torque ``tau`` and largest torque ``peak`` [N m or N], RMS
    ``speed`` and ``rate`` of acceleration, the speed below which a tenth of the time is spent (``slow``), the
    inertia that the joint's spring carries (``weight``), the ``middle`` of the motion [rad or m], its
    ``duration`` [s]; the ``mass`` of the link; ``joint`` (from 1) of so many ``joints``; the largest torque
    of ``gravity`` over the joint's position, and the position ``upright`` [rad] from which it tips."""

    joint: int
    joints: int
    revolute: bool
    mass: float
    duration: float
    tau: float
    peak: float
    speed: float
    rate: float
    slow: float
    weight: float
    middle: float
    gravity: float = 0.0
    upright: float = 0.0


@dataclass(frozen=True, slots=True)
class Form:
    """An effect of any size: its parameters by the scale x; a first guess ``start`` of x; what is physically
    likely, ``least`` and ``most``."""

    build: Callable[[float], Estimates]
    start: float
    least: float = 1e-9
    most: float = float("inf")


@dataclass(frozen=True, slots=True)
class Hidden:
    """How a blind test hides the effect: its ``form``, of what is usual of the joint, a random sense (-1.0 or
    1.0) and a generator of random numbers (numpy's); the joint must carry something (``load``), against
    gravity (``gravity``), if ``needs`` says so. ``at_joint``: what may be of all joints is hidden at one.
    ``kind``: of the joint."""

    form: Callable[[Usual, float, Any], Form]
    needs: Literal["", "load", "gravity"] = ""
    at_joint: bool = False
    kind: JointKind = "any"


# --- all of them ------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True, eq=False)
class Traits:
    """What is to be known of an effect; what is not stated is not so.

    At rest
        ``levels``: parameters that hold the Coulomb level, of which a joint has one. ``one_way``: what it is
        in a joint that moves one way only, a constant ``level`` or nearly one. ``steady``: the effect, and
        its parameters, that takes the place of one that remembers.

    In a description
        ``fold``: numbers that take it. ``body``: it is a body fixed to the last link (``mass``, ``com``,
        ``inertia``). ``in_files``: the parameters of what MJCF and SDF call the spring of a joint, stiffness
        and position at which it is slack. ``several``: it may stand more than once at a joint. ``of_all``:
        one entry in the robot's list may stand for all joints. ``combines``: how two are one; ``adds``:
        parameters that add up although the torque is not linear in them. ``absorbs``: effects that are a part
        of it, so that one joint does not have both.

    In a log
        ``channel``: what it does to what is measured. ``candidates``: how it is looked for. ``contains``:
        effects that it has as special cases, so that a tie with them says nothing. ``one_law_with``: effects
        that make one law with it at a joint. ``reevaluate``: it changes the columns of all others.
        ``both_ways``: it cannot be told of motion in one direction. ``chosen``: parameters that are choices,
        not sizes. ``shape``: sizes that shape its curve, free in the last fit only. ``wide``: it shows at
        other joints than its own. ``limit``: where it is another effect.
        ``twist``: the parameter that a second encoder, on the link, shows directly.
        ``wears``: the parameter that grows as teeth wear. ``hidden``: how a blind test hides it.

    In a picture
        ``noun``: what it is in a sentence, with its article, where the title is no such word; ``over``: what
        it is drawn over; ``cycles``: the parameter that says how often it repeats in a turn;
        ``nothing``: values that mean nothing is there, where that is not 0.
    """

    levels: tuple[str, ...] = ()
    one_way: Literal["", "level", "nearly"] = ""
    steady: tuple[str, tuple[str, ...]] | None = None
    fold: Fold | None = None
    body: bool = False
    in_files: tuple[str, ...] = ()
    several: bool = False
    of_all: bool = False
    combines: Combination = "by parameter"
    adds: tuple[str, ...] = ()
    absorbs: tuple[str, ...] = ()
    channel: Channel | None = None
    candidates: tuple[Candidates, ...] = ()
    contains: tuple[str, ...] = ()
    one_law_with: tuple[str, ...] = ()
    reevaluate: bool = False
    both_ways: bool = False
    chosen: tuple[str, ...] = ()
    shape: tuple[str, ...] = ()
    wide: bool = False
    twist: str = ""
    wears: str = ""
    limit: Limit | None = None
    hidden: Hidden | None = None
    noun: str = ""
    over: str = ""
    cycles: str = ""
    nothing: Mapping[str, float] = field(default_factory=dict)
