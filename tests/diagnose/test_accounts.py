"""A burst is a contact only if no effect that is looked for in it explains more of it than a force does."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from benchmarks.blind_arms.arms import bare
from benchmarks.blind_arms.logs import effect, hidden_log
from benchmarks.blind_arms.pushed import pushed_log

from identify.exact import log_of
from peers.numbers import Array
from robodyn.diagnose import accounts
from robodyn.diagnose.accounts import Account, accounted, explained_share
from robodyn.diagnose.judgement import rms
from robodyn.diagnose.run import diagnose
from robodyn.diagnose.select.contact import Touched
from robodyn.diagnose.select.scope import EVERYTHING
from robodyn.diagnose.settle import Logs
from robodyn.gate.gate import Gate, inspect
from robodyn.identify.contact.contact import Contact, without_windows

ARM = bare("puma560_3dof")
#: What a force explains of each of the windows.
SHARE = 0.8
WINDOWS = ((1.0, 1.4), (2.0, 2.5))


@pytest.fixture(scope="module")
def gate() -> Gate:
    return inspect(log_of(ARM, noise=0.01, seconds=4.0), ARM)


def touched(*, at_rest: bool = False) -> list[Touched]:
    one = Contact(1.0, 1.4, 2, np.ones(3), np.ones(3), 10.0, SHARE, at_rest)
    return [Touched(replace(one, start=start, end=end), "log 1") for start, end in WINDOWS]


Left = Callable[[int], Array]
Seek = Callable[[object, Gate, Array], tuple[Contact, ...]]


@pytest.fixture
def account(gate: Gate, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Account]:
    """The account of a log of which a search that has as many of the windows left out leaves [K, n] what a
    function says, in which contacts are sought as another says."""

    def windows_out(fitted: list[Gate]) -> int:
        return sum(len(one.segments) for one in fitted) - 1

    def settled(robot: object, named: object, cuts: int, *_: object) -> SimpleNamespace:
        return SimpleNamespace(own=SimpleNamespace(robot=cuts))

    monkeypatch.setattr(accounts, "search", lambda robot, fitted, *_: windows_out(fitted))
    monkeypatch.setattr(accounts, "findings_of", lambda *_, is_doubtful: ())
    monkeypatch.setattr(accounts, "settled", settled)

    def run(contacts: list[Touched], left: Left, seek: Seek = lambda *_: ()) -> Account:
        monkeypatch.setattr(accounts, "contacts", seek)
        logs = Logs([gate], 1, ["log 1"], {"log 1": gate})
        lacks: object = lambda cuts, _: left(cuts)  # noqa: E731
        return accounted(ARM, logs, contacts, EVERYTHING, lacks, lambda _: None)  # type: ignore[arg-type]

    return run


def left(gate: Gate, *sizes: float, elsewhere: float = 1.0) -> Array:
    """What is left [K, n]: of these sizes in the windows."""
    rest = np.full(gate.log.tau.shape, elsewhere)
    for (start, end), size in zip(WINDOWS, sizes, strict=True):
        rest[(gate.log.t >= start) & (gate.log.t <= end)] = size
    return rest


def starts(one: Account) -> list[float]:
    return [each.contact.start for each in one.contacts]


def test_what_no_effect_explains_stays_a_contact(gate: Gate, account: Callable[..., Account]) -> None:
    result = account(touched(), lambda cuts: left(gate, 9.0, 9.0))
    assert starts(result) == [1.0, 2.0]
    assert result.outcome == 2  # type: ignore[comparison-overlap]


def test_what_an_effect_explains_better_is_none(gate: Gate, account: Callable[..., Account]) -> None:
    result = account(touched(), lambda cuts: left(gate, 9.0, 9.0) if cuts else left(gate, 1.1, 2.5))
    assert starts(result) == []
    assert result.outcome == 0  # type: ignore[comparison-overlap]


def test_of_two_the_one_that_is_left_is_left_out_again(gate: Gate, account: Callable[..., Account]) -> None:
    after = {2: (9.0, 9.0), 0: (2.0, 7.0), 1: (1.0, 9.0)}
    result = account(touched(), lambda cuts: left(gate, *after[cuts]))
    assert starts(result) == [2.0]
    assert result.outcome == 1  # type: ignore[comparison-overlap]


def test_beside_what_an_effect_explains_there_may_be_a_push(
    gate: Gate, account: Callable[..., Account]
) -> None:
    """One window reaches over a drive at its limit and a push, which stands out once the limit is known."""
    wide, push = touched()
    wide = replace(wide, contact=replace(wide.contact, end=2.5))
    effect_only, with_push = left(gate, 1.0, 9.0), left(gate, 9.0, 9.0)

    def seek(arm: object, log: Gate, rest: Array) -> tuple[Contact, ...]:
        assert rest is effect_only
        return (push.contact, replace(touched()[0].contact, at_rest=True))

    wide = replace(wide, contact=replace(wide.contact, explained=0.1))
    result = account([wide], lambda cuts: with_push if cuts else effect_only, seek)
    assert starts(result) == [2.0]


def test_an_effect_that_spoils_the_rest_explains_no_contact(
    gate: Gate, account: Callable[..., Account]
) -> None:
    result = account(
        touched(), lambda cuts: left(gate, 9.0, 9.0) if cuts else left(gate, 1.0, 1.0, elsewhere=1.2)
    )
    assert starts(result) == [1.0, 2.0]


def test_an_arm_that_rests_does_nothing_by_itself(gate: Gate, account: Callable[..., Account]) -> None:
    result = account(
        touched(at_rest=True), lambda cuts: left(gate, 9.0, 9.0) if cuts else left(gate, 1.0, 1.0)
    )
    assert starts(result) == [1.0, 2.0]


def test_a_share_is_of_what_stands_out() -> None:
    before, after = np.full((5, 2), 3.0), np.tile([1.0, 2.0], (5, 1))
    assert explained_share(before, after, np.ones(2)) == pytest.approx(1 - 3 / 16)
    assert explained_share(before, before, np.ones(2)) == 0
    assert explained_share(np.ones((5, 2)), after, np.ones(2)) == 0


def test_ends_where_a_motion_is_cut_off_do_not_count(gate: Gate) -> None:
    cut = without_windows(gate, [(2.0, 2.5)])
    first, second = cut.segments
    rest = np.ones_like(cut.log.tau)
    for part in (first, second):
        rest[part.start : part.start + 3] = rest[part.stop - 3 : part.stop] = 50.0
    np.testing.assert_array_equal(rms(lambda *_: rest, ARM, [cut]), np.ones(ARM.n))  # type: ignore[arg-type]


@pytest.mark.slow
def test_a_drive_at_its_limit_is_no_contact() -> None:
    """Held at its limit for two seconds, once, where a force on one link would explain nine tenths of it."""
    limit = effect("torque_saturation", 2, limit=152.4, clips="drive")
    hidden = hidden_log("stanford", [limit], seed=112, noise_share=0.01, friction=False)
    result = diagnose(hidden.given, [hidden.train], hidden.validate)
    assert [(one.effect, one.joint) for one in result.findings] == [("torque_saturation", 2)]


@pytest.mark.slow
def test_pushes_in_motion_stay_contacts() -> None:
    """Nothing is known of friction, and inertial numbers are 30 % off."""
    made = pushed_log("puma560_3dof", "full", 1)
    result = diagnose(made.given, [made.log])
    pushed = [one for one in result.findings if one.effect == "external_contact"]
    assert len(pushed) == len(made.pushes)
