"""Changes that are hidden in units: when each begins, how it is drawn, and what it makes of an arm on a day.

Friction that changes is a number of the joint. Every other effect of the catalogue says itself how it is
hidden (its trait ``hidden``): it is given the size at which it shows as much as the recipe wants.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

import numpy as np
from benchmarks.fleet.arm import Day, Numbers, loaded, numbers_of, with_numbers
from benchmarks.fleet.limits import (
    LEAST_LEVEL,
    MOVING,
    SIZED_DURATION,
    SIZED_RATE,
    STIFFER_DAMPING,
    STIFFER_TEETH,
)
from benchmarks.fleet.programs import Program
from benchmarks.fleet.types import TrueType
from numpy.typing import NDArray

from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.diagnose.blind.drawn import form, places, settings, sized
from robodyn.diagnose.blind.limits import LEAST_SIZE
from robodyn.effects.catalogue import effect
from robodyn.effects.friction import COULOMB, VISCOUS
from robodyn.effects.springs import BACKLASH
from robodyn.errors import InputError
from robodyn.fleet.result import Shape
from robodyn.robot.values import parameter
from robodyn.simulate.sensors import measured_position, measured_torque
from robodyn.simulate.trajectories.trajectory import Trajectory

Floats = NDArray[np.float64]
Parameters = Mapping[str, float | str]
_PREFIX = "planted_"


@dataclass(frozen=True, slots=True)
class Change:
    """``effects`` at a ``joint`` (from 1; None: of the whole arm) that are planted in a unit, of a ``kind``.

    From ``begin`` [s since 1970; None: from before the first log] on they grow for ``growth`` [s] (0: at
    once) to their full ``size``; ``parameters`` is what they come to then, for people. ``draw`` is the seed
    of what else there is to draw of them."""

    kind: str
    effects: tuple[str, ...]
    joint: int | None
    begin: float | None
    growth: float
    size: float
    parameters: Mapping[str, float | str]
    draw: int = 0

    @property
    def shape(self) -> Shape:
        """How it comes."""
        if self.begin is None:
            return "always"
        return "drift" if self.growth else "step"

    def level(self, date: float) -> float:
        """How much of it is there on a ``date`` [s since 1970], from 0 to 1."""
        if self.begin is None:
            return 1.0
        if not self.growth:
            return float(date >= self.begin)
        return float(np.clip((date - self.begin) / self.growth, 0.0, 1.0))


@dataclass(frozen=True, slots=True)
class Window:
    """When a change may begin: ``earliest`` to ``latest`` [s since 1970]; by ``end`` it has its full size."""

    earliest: float
    latest: float
    end: float


def window(dates: Floats, growth: float) -> Window | None:
    """When a change that grows for ``growth`` [s] or more may begin in a unit with logs on ``dates`` [K]: not
    before its second log, and so that its last two show it in full. None: there is no such time."""
    earliest, end = float(dates[1]), float(dates[-2])
    latest = end - growth
    return Window(earliest, latest, end) if latest > earliest else None


def when(dates: Floats, growth: tuple[float, float], rng: np.random.Generator) -> tuple[float, float]:
    """When a change begins [s since 1970] and how long it grows [s], ``growth`` from least to most; ``dates``
    have a :func:`window` for it."""
    open_ = window(dates, growth[0])
    assert open_ is not None
    begin = float(round(rng.uniform(open_.earliest, open_.latest)))
    most = min(growth[1], open_.end - begin)
    return begin, float(round(rng.uniform(growth[0], most))) if most else 0.0


# --- on a day ---------------------------------------------------------------------------------------------


def changed(change: Change | None, level: float, true: TrueType, numbers: Numbers) -> Day:
    """An arm of ``numbers`` with as much of the ``change`` as ``level`` says."""
    if change is None or not level:
        return Day(numbers)
    if change.kind in (PROGRAM, CLOCK_RUNS, DATE_LOST):
        return Day(numbers)
    if change.kind == FRICTION:
        return Day(_rubbing(numbers, change, level))
    return _with_effect(change, max(level, LEAST_LEVEL), true, numbers)


#: Kinds of changes that are none of the arm.
PROGRAM, CLOCK_RUNS, DATE_LOST = "program", "clock", "date"


# --- friction ---------------------------------------------------------------------------------------------

FRICTION = "friction"


def draw_friction(
    true: TrueType,
    size: tuple[float, float],
    one_law: float,
    when: tuple[float | None, float],
    rng: np.random.Generator,
) -> Change:
    """Friction of one joint that changes by a share within ``size``; in the share ``one_law`` of the cases
    its viscous part only, in as many its Coulomb part only."""
    joint, share, which = int(rng.integers(true.robot.n)) + 1, float(rng.uniform(*size)), rng.random()
    shares = {
        COULOMB.id: share * (which >= one_law),
        VISCOUS.id: share * (which < 1 - one_law),
    }
    share = float(f"{share:.4g}")
    effects = tuple(id for id, part in shares.items() if part)
    return Change(FRICTION, effects, joint, *when, share, {"share": share})


def _rubbing(numbers: Numbers, change: Change, level: float) -> Numbers:
    assert change.joint is not None
    factor = np.ones(len(numbers.mass))
    factor[change.joint - 1] += level * change.size
    viscous = numbers.viscous * factor if VISCOUS.id in change.effects else numbers.viscous
    coulomb = numbers.coulomb * factor if COULOMB.id in change.effects else numbers.coulomb
    return replace(numbers, viscous=viscous, coulomb=coulomb)


# --- any effect -------------------------------------------------------------------------------------------


def draw_effect(
    id: str,
    kind: str,
    true: TrueType,
    numbers: Numbers,
    program: Program,
    size: tuple[float, float],
    when: tuple[float | None, float],
    rng: np.random.Generator,
    cache: Path | None,
) -> Change:
    """The effect ``id`` at a joint where it shows within ``size`` noise floors more on ``program`` when it is
    fully there than when it begins, in an arm of ``numbers``.

    Raises
    ------
    InputError: it shows so at no joint, or it cannot be planted.
    """
    motion = program.motion(SIZED_DURATION, 1.0, rng)
    wanted, seed = float(rng.uniform(*size)), int(rng.integers(1 << 31))
    for joint in _tried(id, true, rng):
        trial = Change(kind, (id,), joint, *when, 1.0, {}, seed)

        def shows(x: float, trial: Change = trial) -> float:
            whole, hardly = (
                _left(replace(trial, size=x), level, true, numbers, motion, cache)
                for level in (1.0, LEAST_LEVEL)
            )
            more = np.sqrt(np.nanmean((whole - hardly) ** 2, axis=0))
            return max(float((more / true.noise).max()), 1e-9)

        x, ratio = sized(form(id, joint, true.usual, np.random.default_rng(seed)), wanted, shows)
        if ratio >= LEAST_SIZE * wanted:
            x = float(f"{x:.4g}")
            return replace(trial, size=x, parameters=_parameters(replace(trial, size=x), 1.0, true))
    raise InputError(
        f"{id} shows {wanted:.2g} times the noise at no joint of {true.robot.name}",
        remedy="a smaller size in the recipe, or less noise",
    )


def _left(
    change: Change, level: float, true: TrueType, numbers: Numbers, motion: Trajectory, cache: Path | None
) -> Floats:
    """What logs of ``motion`` show at a ``level`` of the change beside a rigid arm of ``numbers`` [K, n], NaN
    where a joint hardly moves."""
    day = _with_effect(change, level, true, numbers)
    log = true.arm(day, cache).log(motion, day.numbers, SIZED_RATE, day.values)
    assert log.qd is not None
    q, tau = measured_position(log.q, day.sensors), measured_torque(log.tau, log.t, day.sensors)
    rigid = true.arm(Day(numbers), cache).torque(replace(log, q=q), numbers)
    return np.where(np.abs(log.qd).min(axis=1, keepdims=True) > MOVING, tau - rigid, np.nan)


def _tried(id: str, true: TrueType, rng: np.random.Generator) -> list[int | None]:
    """The joints at which the effect ``id`` may be, by chance, those first at which it usually shows."""
    usual = places(id, true.usual)
    if usual == [None]:
        return [None]
    others = [joint for joint in range(1, true.robot.n + 1) if joint not in usual]
    return [at[k] for at in (usual, others) for k in rng.permutation(len(at))]


def _parameters(change: Change, level: float, true: TrueType) -> Parameters:
    """The parameters of its effect at a ``level``."""
    (id,) = change.effects
    drawn = form(id, change.joint, true.usual, np.random.default_rng(change.draw))
    parameters = settings(drawn.build(change.size * level), {})
    if id == BACKLASH.id:  # so stiff that what is new are the gaps, not the spring
        teeth = {"stiffness": STIFFER_TEETH, "damping": STIFFER_DAMPING}
        parameters |= {name: float(f"{float(parameters[name]) * by:.6g}") for name, by in teeth.items()}
    return parameters


def _with_effect(change: Change, level: float, true: TrueType, numbers: Numbers) -> Day:
    (id,) = change.effects
    known = effect(id)
    amendment = Amendment(id, change.joint, _parameters(change, level, true))
    if known.traits.body:
        mass, *com = (float(amendment.parameters[name]) for name in ("mass", "com_x", "com_y", "com_z"))
        return Day(loaded(numbers, mass, np.array(com)))
    robot = replace(true.robot, effects=())
    if known.traits.fold is not None and known.traits.fold.into in ("joint", "link"):
        return Day(numbers_of(amended(with_numbers(robot, numbers), [amendment])))
    (entry,) = amended(robot, [amendment]).effects
    if known.traits.channel is not None:
        return Day(numbers, sensors=(entry,))
    if known.coupler is None:
        raise InputError(
            f"{id} cannot be planted in a fleet",
            expected="an effect of sensors, of a joint's elasticity, or of the arm's own numbers",
        )
    run_time = {name: value for name, value in entry.settings if isinstance(value, Fraction)}
    with_names = tuple(
        (name, parameter(_PREFIX + name) if name in run_time else value) for name, value in entry.settings
    )
    values = {_PREFIX + name: float(value) for name, value in run_time.items()}
    return Day(numbers, replace(entry, settings=with_names), values)
