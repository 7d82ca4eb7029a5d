"""The blind tests themselves: their logs obey the reference dynamics with the true effects, and only so."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from benchmarks.blind_arms.arms import ARMS, bare
from benchmarks.blind_arms.cases import Case, cases
from benchmarks.blind_arms.logs import Hidden, effect, hidden_log, outsider

from peers.numbers import Array
from robodyn.robot.folding import folded
from robodyn.robot.model import EffectEntry, Robot
from robodyn.simulate.kinematics import Kinematics
from robodyn.verify.effects import settings
from robodyn.verify.reference import Reference
from robodyn.verify.stateful import bristle_step, twist
from robodyn_testing import sampled

#: What may be left over, as a share of the gap: steps of 0.25 ms, not the law.
_LEFT = 0.02
#: Reversals take this speed [rad/s or m/s]: nearer to rest the sign is anyone's.
_SLOW = 0.02

_CURVE = ((0.1, 0.6), (0.5, 0.9))
#: Effects of which the motor's torque is the reference's, sensors aside.
_PLAIN: list[tuple[str, EffectEntry]] = [
    ("puma560_3dof", effect("viscous_friction", 2, coefficient=6.0)),
    ("stanford", effect("coulomb_friction", 3, level=6.0)),
    ("puma560_3dof", effect("asymmetric_friction", 3, positive=4.0, negative=2.0)),
    ("ur10", effect("stribeck_friction", 3, level=3.0, static=5.0, velocity=0.2)),
    ("puma560", effect("payload", None, mass=2.0, com=(0.02, 0.01, 0.08))),
    ("puma560_3dof", effect("inertial_error", 2, delta_mass=2.0, delta_com_x=0.02, delta_zz=0.1)),
    ("puma560_3dof", effect("rotor_inertia", 1, inertia=1.0)),
    ("stanford", effect("base_tilt", None, tilt_x=0.05, tilt_y=-0.03)),
    ("puma560_3dof", effect("spring", 2, stiffness=10.0, rest=0.2, cubic=3.0)),
    ("ur10", effect("gas_spring", 2, torque=80.0, dead_center=0.4, ratio=0.3, rise=0.5)),
    ("ur10", effect("power_law_friction", 3, level=5.0, exponent=0.6)),
    ("puma560_3dof", effect("torque_ripple", 1, amplitude=2.0, cycles_per_rev=40.0, phase=0.3)),
    ("ur10", effect("motor_coupling", 6, **{"with": 5}, ratio=-1.0, inertia=0.1, viscous=0.2, coulomb=0.3)),
    ("puma560_3dof", effect("load_dependent_friction", 2, bearing="torque", mu=0.1)),
    ("ur10", effect("load_dependent_friction", 2, bearing="journal", mu=0.1, radius=0.1, span=0.2)),
    ("puma560_3dof", effect("load_dependent_friction", 3, bearing="radial", mu_r=0.03)),
    ("puma560_3dof", effect("load_dependent_friction", 1, bearing="thrust", mu_r=0.03)),
    ("stanford", effect("load_dependent_friction", 3, bearing="linear", mu=0.05, span=0.3)),
    ("puma560_3dof", effect("transmission_loss", 2, efficiency=0.8, breakaway=1.0)),
    ("puma560_3dof", effect("transmission_loss", 3, efficiency=_CURVE, rated_torque=30.0)),
]


def short(arm: str, *entries: EffectEntry, **more: Any) -> Hidden:
    """Three seconds, one log."""
    return hidden_log(arm, entries, seed=3, duration=3.0, validation=False, **more)


def rates(made: Hidden) -> tuple[Array, Array, Array, Array]:
    log = made.truth.clean
    assert log.qd is not None
    assert log.qdd is not None
    return log.q, log.qd, log.qdd, log.tau


def model(robot: Robot, made: Hidden) -> Array:
    """Torques [K, n] of ``robot`` by the reference, on the motion of the log without noise."""
    q, qd, qdd, _ = rates(made)
    return Reference(robot).inverse_dynamics(q, qd, qdd)


def share_left(made: Hidden, left: Array) -> float:
    """RMS of ``left`` [K, n] where the joints move, at worst, as a share of the largest gap [noise]."""
    _, qd, _, _ = rates(made)
    moving = np.abs(qd) > _SLOW
    assert moving.mean() > 0.5
    rms = np.sqrt((left**2 * moving).sum(axis=0) / moving.sum(axis=0))
    return float((rms / made.truth.noise).max() / made.truth.ratio.max())


@pytest.mark.parametrize(
    ("arm", "entry"), sampled(_PLAIN, every=3), ids=lambda x: x if isinstance(x, str) else x.effect
)
def test_logs_obey_the_reference_with_the_effect_and_not_without(arm: str, entry: EffectEntry) -> None:
    made = short(arm, entry)
    tau = made.truth.clean.tau
    left = tau - model(made.truth.robot, made)
    if entry.effect == "motor_coupling":
        # Its direction is that of both joints together.
        _, qd, _, _ = rates(made)
        left = left * (np.abs(qd[:, [5]] - qd[:, [4]]) > _SLOW)
    assert share_left(made, left) < _LEFT
    assert share_left(made, tau - model(made.given, made)) > 0.5


@pytest.mark.parametrize("arm", ARMS)
def test_without_effects_nothing_is_missing(arm: str) -> None:
    made = hidden_log(arm, [], seed=3, duration=2.0, friction=True, validation=False)
    assert made.truth.robot == made.given
    assert made.truth.ratio.max() < 0.1
    left = (made.truth.clean.tau - model(made.given, made))[np.abs(rates(made)[1]) > _SLOW]
    assert np.abs(left).max() < 0.02 * made.truth.noise.max()


def test_sensors() -> None:
    made = short(
        "puma560_3dof",
        effect("torque_bias", 1, bias=3.0),
        effect("torque_gain", 2, gain=0.1),
        effect("time_delay", 3, delay=0.01),
        effect("encoder_offset", 2, offset=0.05),
    )
    q, qd, qdd, tau = rates(made)
    true = Reference(made.given).inverse_dynamics(q - [0, 0.05, 0], qd, qdd)
    shown = np.column_stack([true[10:, 0] + 3, 1.1 * true[10:, 1], true[:-10, 2]])
    assert share_left(made, np.vstack([np.zeros((10, 3)), tau[10:] - shown])) < _LEFT


@pytest.mark.parametrize("who", ["drive", "sensor"])
def test_saturation(who: str) -> None:
    made = short("puma560_3dof", effect("torque_saturation", 2, limit=40.0, clips=who))
    tau, true = made.truth.clean.tau[:, 1], model(made.given, made)[:, 1]
    clipped = np.abs(true) > 39.999 if who == "drive" else np.abs(tau) == 40.0
    assert 0.01 < clipped.mean() < 0.8
    assert np.abs(np.clip(tau, -40, 40) - np.clip(true, -40, 40)).max() < 0.05
    assert (np.abs(tau).max() > 41) == (who == "drive")
    assert (np.abs(true).max() > 41) == (who == "sensor")


def test_contact_does_the_work_of_its_force() -> None:
    made = short(
        "puma560", effect("external_contact", None, start=1.0, end=1.6, link=5, force_x=20.0, force_z=-9.0)
    )
    q, qd, _, tau = rates(made)
    t = made.truth.clean.t
    left = tau - model(made.given, made)
    pushed = (t > 0.9995) & (t < 1.5995)
    # Just before the window the velocity of the log looks half a step ahead.
    assert np.abs(left[~pushed]).max() < 0.02 * np.abs(left).max()
    _, places = _frames(made.given, q)
    speed = np.gradient(places[:, 4], t, axis=0)
    power = -speed @ [20.0, 0.0, -9.0]
    inner = pushed & (t > 1.01) & (t < 1.59)
    error = (left * qd).sum(axis=1)[inner] - power[inner]
    assert np.abs(error).max() < 0.02 * np.abs(power[inner]).max()


def _frames(robot: Robot, q: Array) -> tuple[Array, Array]:
    """Rotations [K, n, 3, 3] and origins [K, n, 3] of the links' frames."""
    rotations, places = Kinematics(robot).frames(q)
    return (rotations, places) if rotations.ndim > places.ndim else (places, rotations)


@pytest.mark.parametrize(
    "entry",
    [
        effect("joint_elasticity", 2, stiffness=4000.0),
        effect("backlash", 2, gap=0.01, stiffness=20_000.0, damping=0.0),
    ],
    ids=lambda entry: entry.effect,
)
def test_links_follow_motors_through_what_is_soft(entry: EffectEntry) -> None:
    """The torque that the rotor leaves over is that of the arm, where the twist puts the link."""
    made = short("puma560_3dof", entry, rate=4000.0)
    q, _, qdd, tau = rates(made)
    t = made.truth.clean.t
    j = 1
    rotor = float(bare("puma560_3dof").links[j].joint.motor_inertia)  # type: ignore[arg-type]
    passed = tau[:, j] - rotor * qdd[:, j]
    place = q.copy()
    place[:, j] -= twist(entry.effect, settings(entry, {}), passed)
    speed = np.gradient(place, t, axis=0)
    rate = np.vstack([np.zeros((1, 3)), np.diff(place, 2, axis=0) / (t[1] - t[0]) ** 2, np.zeros((1, 3))])
    known = Reference(made.given).inverse_dynamics(place, speed, rate)
    wanted = tau.copy()
    wanted[:, j] = passed + rotor * rate[:, j]
    inner = slice(50, -50)
    gap = np.sqrt(np.mean((tau - model(made.given, made))[inner] ** 2, axis=0))
    left = np.sqrt(np.mean((wanted - known)[inner] ** 2, axis=0))
    assert left[j] < 0.1 * gap[j]


def test_bristles() -> None:
    entry = effect("presliding_hysteresis", 2, stiffness=800.0, level=5.0, damping=2.0)
    made = short("puma560_3dof", entry, rate=4000.0)
    _, qd, qdd, tau = rates(made)
    step = 2.5e-4
    went_by = qd[:, 1] - qdd[:, 1] * step / 2
    bend, held = np.zeros(1), np.empty(len(qd))
    for k, speed in enumerate(went_by):
        bend, torque = bristle_step(settings(entry, {}), np.array([speed]), bend, step)
        held[k] = torque[0]
    left = tau - model(made.given, made)
    assert np.sqrt(np.mean((left[:, 1] - held) ** 2)) < 0.05 * np.sqrt(np.mean(left[:, 1] ** 2))
    # It is no Coulomb friction.
    assert np.sqrt(np.mean((left[:, 1] - 5 * np.sign(qd[:, 1])) ** 2)) > 0.2 * np.sqrt(
        np.mean(left[:, 1] ** 2)
    )


def test_outsiders() -> None:
    made = short("puma560_3dof", outsider("random_offset", 2, level=6.0, dwell=0.5))
    left = (made.truth.clean.tau - model(made.given, made))[:, 1]
    assert np.abs(np.abs(left) - 3).max() < 0.05
    assert 1 <= np.count_nonzero(np.diff(np.sign(left))) <= 30

    made = short("puma560_3dof", outsider("acceleration_friction", 2, coefficient=2.0))
    _, qd, qdd, tau = rates(made)
    left = tau - model(made.given, made)
    left[:, 1] -= 2 * np.abs(qdd[:, 1]) * np.sign(qd[:, 1])
    assert share_left(made, left) < 0.1


def test_a_swinging_tool_is_no_payload() -> None:
    made = short("puma560_3dof", outsider("swinging_tool", None, mass=1.5, length=0.2))
    gap = made.truth.clean.tau - model(made.given, made)
    loads = [(1.0, (0, 0, 0)), *((1.0, tuple(0.5 * row)) for row in np.eye(3))]
    columns = []
    for mass, com in loads:
        load = effect("payload", None, mass=mass, com=tuple(map(float, com)))
        loaded = folded(replace(made.given, effects=(load,)))
        columns.append((model(loaded, made) - model(made.given, made)).ravel())
    found, *_ = np.linalg.lstsq(np.array(columns).T, gap.ravel(), rcond=None)
    left = gap.ravel() - np.array(columns).T @ found
    assert 0.02 < np.mean(left**2) / np.mean(gap**2) < 1


def test_noise_and_what_is_given() -> None:
    entry = effect("viscous_friction", 2, coefficient=6.0)
    made = hidden_log(
        "puma560_3dof", [entry], seed=5, duration=2.0, ratio=4.0, friction=True, inertia_error=0.03,
        encoder_bits=17, rates="velocity",
    )  # fmt: skip
    truth, train = made.truth, made.train
    assert truth.ratio.max() == pytest.approx(4)
    assert np.argmax(truth.ratio) == 1
    assert train.qd is not None
    assert train.qdd is None
    noise = (train.tau - truth.clean.tau).std(axis=0)
    np.testing.assert_allclose(noise, truth.noise, rtol=0.1)
    step = 2 * np.pi / 2**17
    assert np.abs(train.q - truth.clean.q).max() <= step / 2 + 1e-12
    np.testing.assert_allclose(train.q / step, np.round(train.q / step), atol=1e-6)
    shares = [
        float(a.mass / b.mass) - 1 for a, b in zip(made.given.links, truth.robot.links, strict=True) if b.mass
    ]
    assert 1e-3 < max(map(abs, shares)) < 0.15
    assert all(float(link.confidence) == 0.03 for link in made.given.links)
    # The true arm has the given friction and the hidden one; another motion validates.
    known = made.given.links[1].joint.viscous
    assert truth.robot.links[1].joint.viscous == known + 6
    assert np.abs(made.validate.q - train.q).max() > 0.1
    again = hidden_log(
        "puma560_3dof", [entry], seed=5, duration=2.0, ratio=4.0, friction=True, inertia_error=0.03,
        encoder_bits=17, rates="velocity",
    )  # fmt: skip
    assert (again.given, again.train.csv()) == (made.given, train.csv())


def test_poor_motions() -> None:
    made = short("puma560_3dof", motion="one_way")
    _, qd, _, _ = rates(made)
    assert (qd.min(axis=0) > -5e-3).all() or (qd.max(axis=0) < 5e-3).all()
    narrow = short("puma560_3dof", motion="narrow").train.q
    assert np.ptp(narrow, axis=0).max() < 0.3


def test_cases_are_listed_and_made() -> None:
    clear = list(cases("clear"))
    assert len({case.name for case in clear}) == len(clear) == 4 * 22
    assert all(3 <= case.ratio <= 8 for case in clear)
    assert len(list(cases("nothing", seeds=3))) == 60
    made = Case("puma560_3dof", (("coulomb_friction", 1),), 1, 4.0, duration=2.0).make()
    assert made.truth.ratio.max() == pytest.approx(4)
    # The size was sought for the usual noise.
    size = np.sqrt(np.mean(made.truth.clean.tau[:, 0] ** 2))
    assert 0.5 < made.truth.noise[0] / (0.015 * size) < 2


@pytest.mark.slow
@pytest.mark.parametrize("level", ["clear", "faint", "nothing", "pairs", "outside", "poor"])
def test_every_case_can_be_made(level: Any) -> None:
    for case in cases(level):
        made = case.make()
        assert np.isfinite(made.train.tau).all(), case.name
        assert np.isfinite(made.validate.tau).all(), case.name
        if len(case.hidden) == 1:
            assert made.truth.ratio.max() == pytest.approx(case.ratio), case.name
        for log in (made.train, made.validate):
            bounds = np.array(
                [[float(x) for x in link.joint.limits.position or ()] for link in made.given.links]
            )
            slack = 0.25 * (bounds[:, 1] - bounds[:, 0])
            assert (log.q > bounds[:, 0] - slack).all(), case.name
            assert (log.q < bounds[:, 1] + slack).all(), case.name
