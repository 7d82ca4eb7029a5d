"""Trajectories: ends, limits on dense grids, rates against differences."""

from __future__ import annotations

import json
import math
import re
import sys
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from robodyn.errors import InputError
from robodyn.robot import load
from robodyn.robot.model import Limits, Robot
from robodyn.simulate.kinematics import Kinematics
from robodyn.simulate.trajectories import Trajectory, fourier, line, quintic, trapezoid
from robodyn.simulate.trajectories.trajectory import least_jerk
from robodyn.thesis.puma_inverse import PumaArm

START, END = [0.4, 0.1, 0.1], [0.2, 0.5, 0.3]
POSE = [0.3, -0.5, 0.2, 0.4, 0.9, 0.1]


def arm(name: str = "puma560") -> Robot:
    return load(name, warn=lambda _: None)


def limited(*rows: tuple[float, float, float]) -> Robot:
    """An arm whose joints may go to +-p, at v, with a, each row being p, v, a."""
    robot = arm()
    links = []
    for link, (p, v, a) in zip(robot.links, rows, strict=False):
        limits = Limits((Fraction(-p), Fraction(p)), Fraction(v), Fraction(a))
        links.append(replace(link, joint=replace(link.joint, limits=limits)))
    return replace(robot, links=tuple(links))


def wrist() -> Kinematics:
    return Kinematics(arm(), point=(-0.0203, -0.4331, 0), link=3)


def led(profile: str, period: float = 1e-2) -> Trajectory:
    kinematics = Kinematics(arm(), point=(0, 0, 0.1))
    point, rotation = kinematics.pose(POSE)
    end = point + np.array([0.1, 0.1, -0.1])
    return line(kinematics, point, end, 1.0, profile, rotation=rotation, start=POSE, period=period)  # type: ignore[arg-type]


MAKERS: dict[str, Callable[[], Trajectory]] = {
    "quintic": lambda: quintic([0, 1], [1, -2], 1.2345),
    "trapezoid": lambda: trapezoid([0, 1, 0], [1, -2, 0], [1, 2, 3], 4),
    "fourier": lambda: fourier(arm(), 0.5, period=1e-2),
    "line": lambda: line(wrist(), START, END, 2.0, solver=PumaArm.of(arm()).continuous, period=1e-2),
    "line with rotation": lambda: led("quintic"),
    "trapezoidal line": lambda: led("trapezoid"),
    "constant line": lambda: led("constant"),
}


@pytest.mark.parametrize("name", MAKERS)
def test_rates_are_derivatives(name: str) -> None:
    """Central differences at 997 times that are no samples; where the acceleration jumps, none is near."""
    motion = MAKERS[name]()
    h = 1e-5
    t = np.linspace(0, motion.duration, 1001)[2:-2] + 1.7e-4 * (1 - np.linspace(0, 2, 997))
    _, qd, qdd = motion.at(t)
    after, before = motion.at(t + h), motion.at(t - h)
    scale = np.abs(motion.qdd).max()
    np.testing.assert_allclose((after[0] - before[0]) / (2 * h), qd, atol=1e-8 * scale)
    np.testing.assert_allclose((after[1] - before[1]) / (2 * h), qdd, atol=1e-7 * scale)


@pytest.mark.parametrize("name", MAKERS)
def test_samples_are_the_law(name: str) -> None:
    motion = MAKERS[name]()
    for one, other in zip((motion.q, motion.qd, motion.qdd), motion.at(motion.t), strict=True):
        np.testing.assert_allclose(one, other, atol=1e-12)
    coarse = motion.sampled(5 * motion.period)
    np.testing.assert_allclose(coarse.q, motion.q[::5][: len(coarse)], atol=1e-12)
    assert motion.duration - coarse.period < coarse.duration <= motion.duration * (1 + 1e-12)
    assert coarse.describe()["samples"] == len(coarse)
    json.dumps(coarse.describe(), allow_nan=False)
    with pytest.raises(ValueError, match="read-only"):
        motion.q[0] = 0


number = st.floats(0.01, 20)


@settings(deadline=None, max_examples=60)
@given(
    way=st.lists(st.floats(-3, 3), min_size=1, max_size=4).filter(lambda w: max(map(abs, w)) > 1e-3),
    limits=st.lists(st.tuples(number, number), min_size=4, max_size=4),
)
def test_trapezoid_keeps_limits_and_wastes_nothing(
    way: list[float], limits: list[tuple[float, float]]
) -> None:
    fastest, hardest = np.array(limits[: len(way)]).T
    motion = trapezoid(np.ones(len(way)), 1 + np.array(way), fastest, hardest, period=0.01)
    t = np.linspace(0, motion.duration, 2001)
    q, qd, qdd = motion.at(t)
    assert (np.abs(qd) <= fastest * (1 + 1e-12)).all()
    assert (np.abs(qdd) <= hardest * (1 + 1e-12)).all()
    np.testing.assert_array_equal(q[[0, -1]], [np.ones(len(way)), 1 + np.array(way)])
    used = np.abs(qdd / hardest).max(axis=0)
    assert used.max() == pytest.approx(1)
    # The slowest joint alone would take as long: v / a + way / v, or 2 sqrt(way / a) if it is short.
    need = np.abs(way)
    speed = min(v / way for v, way in zip(fastest, need, strict=True) if way > 1e-100)
    rate = min(a / way for a, way in zip(hardest, need, strict=True) if way > 1e-100)
    shortest = speed / rate + 1 / speed if speed**2 < rate else 2 / math.sqrt(rate)
    assert motion.describe()["time"] == pytest.approx(shortest)


@pytest.mark.parametrize("knots", [3, 6, 100])
def test_spline_of_any_number_of_knots(knots: int) -> None:
    """A polynomial of degree five is its own spline, on uneven knots too."""
    t = np.sort(np.random.default_rng(knots).random(knots)) * 3
    t[0], t[-1] = 0, 3
    p = np.polynomial.Polynomial([1, -2, 0.5, 0.3, -0.4, 0.1])
    values, first, second = (f(t)[:, None] for f in (p, p.deriv(), p.deriv(2)))
    v, a = least_jerk(t, values, np.stack([first[0], second[0]]), np.stack([first[-1], second[-1]]))
    np.testing.assert_allclose(v, first, atol=1e-8)
    np.testing.assert_allclose(a, second, atol=1e-6)


@pytest.mark.parametrize("profile", ["quintic", "trapezoid", "constant"])
def test_line_is_straight(profile: str) -> None:
    """Path, velocity and acceleration of the point, put back through forward kinematics."""
    kinematics = wrist()
    motion = line(kinematics, START, END, 2.0, profile, solver=PumaArm.of(arm()).continuous, period=1e-2)  # type: ignore[arg-type]
    way = np.array(END) - START
    point = kinematics.position(motion.q)
    share = (point - START) @ way / (way @ way)
    np.testing.assert_allclose(point, START + share[:, None] * way, atol=1e-13)
    assert share[[0, -1]] == pytest.approx([0, 1], abs=1e-12)
    assert (np.diff(share) > 0).all()
    J, Jd = kinematics.jacobian(motion.q)[:, :3], kinematics.jacobian_rate(motion.q, motion.qd)[:, :3]
    velocity = np.einsum("kij,kj->ki", J, motion.qd)
    acceleration = np.einsum("kij,kj->ki", J, motion.qdd) + np.einsum("kij,kj->ki", Jd, motion.qd)
    np.testing.assert_allclose(np.cross(velocity, way), 0, atol=1e-12)
    np.testing.assert_allclose(np.cross(acceleration, way), 0, atol=1e-11)
    if profile == "constant":
        np.testing.assert_allclose(velocity, np.broadcast_to(way / 2, velocity.shape), atol=1e-12)
        np.testing.assert_allclose(acceleration, 0, atol=1e-11)
    numerical = line(kinematics, START, END, 2.0, profile, start=motion.q[0], period=1e-2)  # type: ignore[arg-type]
    np.testing.assert_allclose(numerical.q, motion.q, atol=1e-12)


def test_line_refuses() -> None:
    kinematics, closed = wrist(), PumaArm.of(arm()).continuous
    with pytest.raises(InputError, match="out of reach"):
        line(kinematics, START, [0.4, 0.3, 0.9], 2.0, solver=closed)
    with pytest.raises(InputError, match=r"found 6 joints; expected 3"):
        line(Kinematics(arm()), START, END, 1.0)
    with pytest.raises(
        InputError, match=r"do not meet the line; found .* off at \[0\.317153, 0\.265694, 0\.182847\]"
    ):
        line(Kinematics(arm(), link=3), START, END, 1.0, solver=closed)
    for limits, end in ((None, [0.4, 0.3, 0.9]), ((Fraction(-1, 10), Fraction(1, 10)), END)):
        within = Kinematics(_all_within(arm("puma560_3dof"), limits), point=(0, -0.4, 0))
        with pytest.raises(InputError, match=r"the point \[.*\] of the line cannot be reached"):
            line(within, START, end, 1.0, period=1e-2)
    with pytest.raises(InputError, match="no such profile; found 'cubic'"):
        line(kinematics, START, END, 1.0, "cubic", solver=closed)  # type: ignore[arg-type]
    # Straight over the axis of an arm without offset, between two samples: the Jacobian turns over there.
    bare = arm("puma560_3dof")
    bare = replace(bare, links=tuple(replace(k, joint=replace(k.joint, d=Fraction(0))) for k in bare.links))
    over = Kinematics(bare, point=(0, -0.4, 0))
    with pytest.raises(
        InputError, match=r"passes a singular place; found \[0\.00105, 0, 0\.5\] at 0\.5 s, .* 0\.0018 "
    ):
        line(over, [-0.3, 0, 0.5], [0.3021, 0, 0.5], 1.0, solver=_over_the_top, period=1e-2)


def _all_within(robot: Robot, position: tuple[Fraction, Fraction] | None) -> Robot:
    links = [replace(k, joint=replace(k.joint, limits=Limits(position))) for k in robot.links]
    return replace(robot, links=tuple(links))


def _over_the_top(path: np.ndarray) -> np.ndarray:
    """Without turning the first joint: the branch changes as the point passes the axis."""
    arms = PumaArm(0.0, 0.4318, 0.4)
    choices = arms.positions(path)
    rows = np.where(path[:, 0] > 0, 0, 2)
    q: np.ndarray = choices[np.arange(len(path)), rows]
    return np.column_stack([np.zeros(len(q)), q[:, 1:]])


@settings(deadline=None, max_examples=30)
@given(
    rows=st.lists(st.tuples(st.floats(0.1, 7), number, number), min_size=1, max_size=6),
    harmonics=st.integers(2, 12),
    frequency=st.floats(0.02, 2),
    seed=st.integers(0, 2**32),
)
def test_fourier_keeps_and_uses_the_limits(
    rows: list[tuple[float, float, float]], harmonics: int, frequency: float, seed: int
) -> None:
    motion = fourier(limited(*rows), frequency, harmonics, seed, share=1.0, period=0.01 / frequency)
    assert motion.law is not None
    position, velocity, acceleration = np.array(rows).T
    q, qd, qdd = motion.law(np.linspace(0, 1 / frequency, 4001))  # a grid that the maker did not use
    used = np.array(
        [np.abs(q).max(0) / position, np.abs(qd).max(0) / velocity, np.abs(qdd).max(0) / acceleration]
    )
    assert (used <= 1).all()
    assert (used.max(axis=0) > 0.999).all()
    ends = motion.law(np.array([0, 1 / frequency]))
    np.testing.assert_allclose(ends[1], 0, atol=1e-9 * velocity.max())
    np.testing.assert_allclose(ends[2], 0, atol=1e-9 * acceleration.max())
    np.testing.assert_allclose(ends[0][0], ends[0][1], atol=1e-9)


def test_fourier_is_the_same_for_the_same_seed() -> None:
    one, two, other = (fourier(arm(), seed=seed, period=0.1) for seed in (1, 1, 2))
    np.testing.assert_array_equal(one.q, two.q)
    assert one.describe() == two.describe()
    assert np.abs(one.q - other.q).max() > 0.1
    twice = fourier(arm(), seed=1, periods=2, period=0.1)
    np.testing.assert_allclose(twice.q[100:], one.q, atol=1e-9)
    np.testing.assert_allclose((one.q.max(0) + one.q.min(0)) / 2, 0, atol=0.01)


def test_arrays_that_do_not_fit() -> None:
    t, q = np.arange(3.0), np.zeros((3, 2))
    between = Trajectory(t, q + t[:, None] ** 2, q + 2 * t[:, None], q + 2)  # without a law
    np.testing.assert_allclose(between.at(np.array([0.5, 1.75]))[0], [[0.25] * 2, [3.0625] * 2])
    with pytest.raises(InputError, match=re.escape("qd of a trajectory has the wrong shape; found [3, 1]")):
        Trajectory(t, q, q[:, :1], q)
    with pytest.raises(InputError, match="qdd of a trajectory is not finite; found sample 1"):
        Trajectory(t, q, q, q + np.nan)
    with pytest.raises(InputError, match="times of a trajectory are not even"):
        Trajectory(t + 1, q, q, q)
    with pytest.raises(
        InputError, match=re.escape("outside the trajectory; found 3 to 3 s; expected 0 to 2 s")
    ):
        between.at(np.array([3.0]))


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: quintic([0], [1], 0.0), "a trajectory takes time"),
        (lambda: quintic([0], [1, 2], 1.0), "the end is not a number a joint"),
        (lambda: quintic([0], [1], 1e9), "too many samples"),
        (lambda: trapezoid([1], [1], 1, 1), "the motion has no length"),
        (lambda: trapezoid([0], [1], 0, 1), "velocity must be positive"),
        (lambda: fourier(arm("ur10")), "ur10: link 1 states no limit of position, velocity, acceleration"),
        (lambda: fourier(arm(), harmonics=1), "found 1 harmonics"),
        (lambda: fourier(arm(), 0.0), "no frequency"),
    ],
)
def test_makers_refuse(make: Callable[[], Trajectory], message: str) -> None:
    with pytest.raises(InputError, match=message):
        make()


@pytest.mark.parametrize(("name", "link"), [("puma560_3dof", 3), ("ur5", 6)])
def test_a_line_in_closed_form(name: str, link: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """An arm of a class needs no search, and comes where a search does."""
    robot = arm(name)
    kinematics = Kinematics(robot, point=(0.0, 0.3, 0.0) if link == 3 else (0.0, 0.0, 0.1), link=link)
    start = [0.3, -0.5, 0.9, 0.4, 0.9, 0.1][:link]
    place, turn = kinematics.pose(start)
    rotation = turn if link == 6 else None

    def led() -> Trajectory:
        end = place + np.array([0.05, -0.1, 0.05])
        return line(kinematics, place, end, 1.0, rotation=rotation, start=start, period=1e-2)

    with monkeypatch.context() as patched:
        patched.setattr(sys.modules[line.__module__]._Line, "followed", None)
        closed = led()
    module = sys.modules[line.__module__]
    monkeypatch.setattr(module, "along_branch", lambda *arguments: None)
    np.testing.assert_allclose(led().q, closed.q, atol=1e-9)
    np.testing.assert_allclose(closed.q[0], start, atol=1e-12)
