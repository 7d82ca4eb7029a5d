"""Pushes, simulated by MuJoCo, are found in time and with their force; nothing else is taken for one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from benchmarks.blind_arms.arms import bare
from benchmarks.blind_arms.pushed import Kind, Push, Pushed, pushed_log

from peers.numbers import Array
from robodyn.diagnose.run import diagnose
from robodyn.diagnose.select.contact import Touched, contact_findings, touches
from robodyn.diagnose.settle import Logs
from robodyn.dynamics.kinematics import frames
from robodyn.effects.catalogue import CATALOGUE
from robodyn.gate.gate import inspect
from robodyn.identify.contact.bursts import _level
from robodyn.identify.contact.contact import Contact, contacts, without_rows
from robodyn.identify.contact.force import Push as Pressed
from robodyn.identify.contact.force import Window, push_in
from robodyn.kernels.array_dynamics import Model
from robodyn.robot.model import EffectEntry

#: A push is found if it begins and ends within so much [s].
IN_TIME = 0.2
ARMS = ("puma560_3dof", "puma560", "ur10", "stanford")


def matched(made: Pushed, seen: tuple[Contact, ...]) -> Iterator[tuple[Push, Contact | None]]:
    """Each push and the contact that is found of it."""
    for push in made.pushes:
        near = (one for one in seen if abs(one.start - push.start) + abs(one.end - push.end) < 2 * IN_TIME)
        yield push, next(near, None)


def angle(push: Push, force: Array) -> float:
    """Between a force and that which was found [degrees], as far as joints show it."""
    _, size, way = np.linalg.svd(push.columns)
    shown = way[: len(size)][size > 0.15 * size.max()]
    a, b = shown @ push.force, shown @ force
    return float(np.degrees(np.arccos(np.clip(a @ b / np.linalg.norm(a) / np.linalg.norm(b), -1, 1))))


@cache
def found(arm: str, kind: Kind, seed: int, *, pushes: int = 3) -> tuple[Pushed, tuple[Contact, ...]]:
    made = pushed_log(arm, kind, seed, pushes=pushes)
    return made, contacts(made.given, inspect(made.log, made.given))


@pytest.mark.parametrize("kind", ["rest", "full"])
def test_pushes_are_found_though_the_model_is_wrong(kind: Kind) -> None:
    """Masses, centres and inertias 30 % off, friction unknown."""
    made, seen = found("puma560_3dof", kind, 1)
    assert len(seen) == 3
    for push, contact in matched(made, seen):
        assert contact is not None, push
        assert angle(push, contact.force) < 45
        assert contact.at_rest == (kind == "rest")


def test_what_stands_out_at_the_ends_of_a_log_hides_no_push() -> None:
    """As a joint does that sticks before it sets out: no contact is looked for there."""
    made, seen = found("puma560_3dof", "full", 1)
    gate = inspect(made.log, made.given)
    tau = gate.log.tau + 300.0 * ((gate.log.t > 0.2) & (gate.log.t < 0.3))[:, None]
    again = contacts(made.given, replace(gate, log=replace(gate.log, tau=tau)))
    assert [round(one.start, 1) for one in again] == [round(one.start, 1) for one in seen]


@pytest.mark.parametrize("kind", ["rest", "stops"])
def test_an_arm_that_nobody_pushes_is_not_touched(kind: Kind) -> None:
    assert found("puma560_3dof", kind, 2, pushes=0)[1] == ()


def test_windows_are_left_out_and_known_the_next_time() -> None:
    made, _ = found("puma560_3dof", "rest", 1)
    gate = inspect(made.log, made.given)
    free, touched = touches(made.given, [gate], ["ab"])
    assert free == [gate]
    (rest,) = Logs(free, 1, ["ab"], {"ab": gate}).without(touched).fitted
    assert len(rest.segments) == 4
    for one in touched:
        inside = (rest.log.t > one.contact.start) & (rest.log.t < one.contact.end)
        assert not inside.any()
    assert rest.resting.shape == rest.log.tau.shape
    assert len(rest.rows) == rest.log.samples
    parameters = [one.parameters for one in contact_findings(touched)]
    assert [row["log"].value for row in parameters] == ["ab"] * 3
    entries = tuple(
        EffectEntry(
            "external_contact",
            None,
            tuple(
                (name, x if isinstance(x := each.value, str) else Fraction(repr(x)))
                for name, each in row.items()
            ),
        )
        for row in parameters
    )
    known = replace(made.given, effects=entries)
    both, news = touches(known, [gate, gate], ["ab", "cd"])
    assert [one.log for one in news] == ["cd"] * 3
    again, other = Logs(both, 2, ["ab", "cd"], {"ab": gate, "cd": gate}).without(news).fitted
    np.testing.assert_array_equal(again.log.t, rest.log.t)
    np.testing.assert_array_equal(other.log.t, rest.log.t)


def test_a_finding_says_how_well_the_direction_is_known() -> None:
    one = Contact(1.0, 2.0, 3, np.ones(3), np.ones(3), 12.0, 0.9, True)
    cones = (12.0, 60.0, 120.0)
    touched = [Touched(replace(one, cone=cone), "ab") for cone in cones]
    texts = [finding.where for finding in contact_findings(touched)]
    assert "direction known to 12 degrees:" in texts[0]
    assert "direction known to 60 degrees only" in texts[1]
    assert "not identifiable, nor its sign" in texts[2]


def test_rows_that_are_left_out_cut_the_log() -> None:
    made = pushed_log("puma560_3dof", "rest", 1, pushes=0, duration=4.0)
    gate = inspect(made.log, made.given)
    out = np.zeros(gate.log.samples, dtype=bool)
    out[:10] = out[700:800] = True
    cut = without_rows(gate, out)
    assert cut.segments == (slice(0, 690), slice(690, gate.log.samples - 110))
    np.testing.assert_array_equal(cut.log.tau, gate.log.tau[~out])
    np.testing.assert_array_equal(cut.rows, gate.rows[~out])


def pressed(link: int, place: float, force: Array, q: Array) -> Pressed:
    """What is found of a force on a link of the UR10 that shows exactly."""
    model = Model(bare("ur10"))
    zeros = np.zeros((1, 6))
    at = frames(model.arm, model.motion(q[None], zeros, zeros))
    ends = [
        np.array([float(x[0]) if np.ndim(x) else float(x) for x in at[k].origin]) for k in (link - 1, link)
    ]
    point = ends[0] + place * (ends[1] - ends[0])
    torque = np.zeros(6)
    for j in range(link):
        axis, origin = (np.array([float(np.ravel(x)[0]) for x in v]) for v in (at[j].z, at[j].origin))
        torque[j] = -np.cross(axis, point - origin) @ force
    K = 40
    noise = 0.05 * np.random.default_rng(1).standard_normal((K, 6))
    window = Window(np.tile(q, (K, 1)), torque + noise, np.full((K, 6), 0.05), zeros[0], zeros[0], 0.02)
    return push_in(model, window)


def test_a_direction_is_known_only_where_the_joints_show_it() -> None:
    q = np.array([0.3, -1.0, 1.2, -0.6, 0.9, 0.4])
    force = np.array([10.0, -20.0, 15.0])
    far = pressed(5, 1.0, force, q)
    cosine = far.force @ force / np.linalg.norm(far.force) / np.linalg.norm(force)
    assert np.degrees(np.arccos(cosine)) < 15
    assert far.cone < 40
    # Two joints do not show three components.
    near = pressed(2, 0.8, force, q)
    assert near.link == 2
    assert near.cone > 45
    assert near.stderr.max() > 5


def test_what_stiction_holds_after_a_push_is_not_of_its_window() -> None:
    """Pushed for half a second; what stays for a second after it is less, and ends as suddenly."""
    gate = inspect(pushed_log("puma560_3dof", "rest", 1, pushes=0).log, bare("puma560_3dof"))
    tau = gate.log.tau.copy()
    t = gate.log.t
    for start, end, size in ((2.0, 2.5, 30.0), (2.5, 3.5, 10.0), (6.0, 6.5, 30.0)):
        tau[(t >= start) & (t < end)] += size * np.array([1.0, 0.5, 0.3])
    seen = contacts(bare("puma560_3dof"), replace(gate, log=replace(gate.log, tau=tau)))
    assert [(round(one.start, 1), round(one.end, 1)) for one in seen] == [(2.0, 2.5), (6.0, 6.5)]


@pytest.mark.thorough
def test_a_diagnosis_of_an_arm_at_rest_names_contacts_and_no_friction() -> None:
    made, seen = found("puma560_3dof", "rest", 1)
    result = diagnose(made.given, [made.log])
    effects = [one.effect for one in result.findings]
    assert effects.count("external_contact") == len(seen) == 3
    assert not [id for id in effects if CATALOGUE[id].dissipative]
    assert [window.what for window in result.windows] == ["contact"] * 3


@pytest.mark.slow
def test_how_often_pushes_are_found() -> None:
    """Of 72 pushes with shares of the joints' torques nearly all, and forces as near as is said of them."""
    right: dict[str, list[bool]] = {}
    for arm in ARMS:
        for kind in ("rest", "full", "stops"):
            for seed in (0, 1):
                made, seen = found(arm, kind, seed)
                pairs = list(matched(made, seen))
                hits = [(push, one) for push, one in pairs if one is not None]
                right.setdefault(kind, []).extend(one is not None for _, one in pairs)
                right.setdefault("nothing else", []).append(len(seen) <= len(hits))
                right.setdefault("sign", []).extend(
                    angle(push, one.force) < 90 for push, one in hits if one.cone < 90
                )
                right.setdefault("direction", []).extend(
                    angle(push, one.force) < max(20, one.cone) for push, one in hits
                )
    shares = {name: float(np.mean(each)) for name, each in right.items()}
    least = {
        "rest": 0.95,
        "full": 0.75,
        "stops": 0.9,
        "nothing else": 0.9,
        "sign": 1.0,
        "direction": 0.95,
    }
    assert {name for name, x in shares.items() if x < least[name]} == set(), shares


def test_a_stretch_at_rest_may_be_a_single_row() -> None:
    """Its level is what that row says."""
    assert _level(np.array([3.0])) == 3.0
    assert _level(np.array([1.0, 3.0])) == 2.0
