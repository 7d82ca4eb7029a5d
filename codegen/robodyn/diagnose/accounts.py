"""Accounts of logs: bursts as contacts first, then as what effects do, and of the two what explains more.

A force at an unknown place, that lasts as long as it must, explains much of any burst: of a drive at its
limit, or of a gear whose teeth change sides. Nor can a search name an effect of logs without the bursts in
which it shows. So there are two searches where a burst in motion may be a contact: one with the windows of
contacts left out, and one with what happens in motion put back. What its effects explain better than a force
is no contact; what they leave is looked through for contacts once more.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.evidence import doubtful
from robodyn.diagnose.findings import findings_of
from robodyn.diagnose.judgement import Lacking
from robodyn.diagnose.refit import no_worse
from robodyn.diagnose.select.contact import Touched, beyond, overlap, standing, within
from robodyn.diagnose.select.outcome import Outcome
from robodyn.diagnose.select.scope import Scope
from robodyn.diagnose.select.search import search
from robodyn.diagnose.settle import Logs, Settled, settled
from robodyn.identify.contact.contact import contacts
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True, eq=False)
class Account:
    """The ``outcome`` of a search in ``logs``, what it comes to ``by_torque``, and the ``contacts`` that
    stand out of that."""

    outcome: Outcome
    by_torque: Settled
    logs: Logs
    contacts: tuple[Touched, ...]


def accounted(
    robot: Robot, logs: Logs, touched: Sequence[Touched], scope: Scope, lacks: Lacking,
    tell: Callable[[str], object],
) -> Account:  # fmt: skip
    """What ``robot`` lacks to explain ``logs``, in which bursts may be the contacts ``touched``."""

    def account(apart: Sequence[Touched]) -> Account:
        rest = logs.without(apart)
        outcome = search(robot, rest.fitted, tell, scope.at_rest() if rest.stand else scope)
        tell("validating the result")
        named = findings_of(robot, outcome, is_doubtful=doubtful(rest.fitted))
        tell("fitting the arm's own numbers")
        by_torque = settled(robot, named, outcome, rest, lacks)
        still = standing(apart, rest.whole, lambda gate: lacks(by_torque.own.robot, gate))
        return Account(outcome, by_torque, rest, still)

    first = account(touched)
    resting = [one for one in first.contacts if one.contact.at_rest]
    if len(resting) == len(first.contacts):
        return first
    whole = account(resting)
    windows = [one for one in first.contacts if one in resting or not _is_explained(one, first, whole, lacks)]
    if len(windows) == len(first.contacts):
        return first
    # A window that an effect explains may have hidden a push, or have reached over one.
    arm = whole.by_torque.own.robot
    beside = [
        one
        for one in _moving(arm, logs, lacks)
        if not any(overlap(one, other) for other in windows) and not _is_explained(one, first, whole, lacks)
    ]
    return account([*windows, *beside]) if len(windows) + len(beside) > len(resting) else whole


def _moving(arm: Robot, logs: Logs, lacks: Lacking) -> list[Touched]:
    """The contacts in motion in what ``arm`` leaves of logs; of those of which windows are known, none."""
    return [
        Touched(one, digest)
        for gate, digest in zip(logs.gates, logs.digests, strict=True)
        if gate is logs.whole[digest]
        for one in contacts(arm, gate, lacks(arm, gate))
        if not one.at_rest
    ]


def _is_explained(one: Touched, first: Account, whole: Account, lacks: Lacking) -> bool:
    """Whether effects that were found in the ``whole`` logs explain more of a contact's window than its
    force, and no less of the rest of the log than those of the ``first`` account."""
    gate = whole.logs.whole[one.log]
    inside, outside = within(gate, one.contact), beyond(gate, first.contacts, one.log)
    before, after = (lacks(each.by_torque.own.robot, gate) for each in (first, whole))
    if not inside.any() or not outside.any() or not no_worse(_rms(before[outside]), _rms(after[outside])):
        return False
    usual = np.minimum(_rms(before[outside]), _rms(after[outside]))
    return explained_share(before[inside], after[inside], usual) > one.contact.explained


def explained_share(before: Floats, after: Floats, usual: Floats) -> float:
    """Of the squares by which ``before`` [K, n] stands out of the ``usual`` [n], the share that ``after``
    [K, n] has not; 0 where nothing stood out."""

    def excess(rest: Floats) -> float:
        return float(np.maximum((_rms(rest) / np.maximum(usual, 1e-300)) ** 2 - 1, 0).sum())

    stood_out = excess(before)
    return 1 - excess(after) / stood_out if stood_out else 0.0


def _rms(rest: Floats) -> Floats:
    return np.asarray(np.sqrt(np.mean(rest**2, axis=0)))
