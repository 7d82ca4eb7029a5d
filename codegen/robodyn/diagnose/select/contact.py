"""Contacts with something outside: those in logs, those that stand out of a model, and as findings.

What happens once in a log cannot be judged on parts of it that were left out: contacts are sought before
anything else (:mod:`robodyn.identify.contact`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from robodyn.arrays import Floats, Mask
from robodyn.diagnose.result import Estimate, Finding
from robodyn.diagnose.select.limits import (
    CONTACT_EDGE,
    CONTACT_LOUD,
    CONTACT_NARROW,
    CONTACT_ODDS,
    CONTACT_WIDE,
    ODDS,
)
from robodyn.effects.rigid import CONTACT
from robodyn.gate.gate import Gate
from robodyn.identify.contact.contact import Contact, contacts, without_windows
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True)
class Touched:
    """A ``contact`` in the log with the hash ``log``."""

    contact: Contact
    log: str


def touches(
    robot: Robot, gates: Sequence[Gate], digests: Sequence[str]
) -> tuple[list[Gate], tuple[Touched, ...]]:
    """The contacts in logs, and the logs without the windows that are known: of a log of which the
    description of ``robot`` has windows, by its hash in ``digests``, these are left out, and none are
    sought."""
    kept, touched = [], []
    for gate, digest in zip(gates, digests, strict=True):
        known = [
            (entry.number("start"), entry.number("end"))
            for entry in robot.effects
            if entry.effect == CONTACT.id and "log" in entry and entry.text("log") == digest
        ]
        kept.append(without_windows(gate, known))
        if not known:
            touched += [Touched(one, digest) for one in contacts(robot, gate)]
    return kept, tuple(touched)


def overlap(one: Touched, other: Touched) -> bool:
    """Whether two contacts have some time in common."""
    first, second = one.contact, other.contact
    return one.log == other.log and first.start < second.end and second.start < first.end


def standing(
    touched: Sequence[Touched], logs: Mapping[str, Gate], left: Callable[[Gate], Floats]
) -> tuple[Touched, ...]:
    """The contacts in whose windows the model that was found leaves [K, n] clearly more than elsewhere: what
    an effect explains that was named since is no contact. ``logs`` by what each contact says of its own."""
    kept = []
    for one in touched:
        gate = logs[one.log]
        inside, outside = within(gate, one.contact), beyond(gate, touched, one.log)
        rest = left(gate)
        if not inside.any() or not outside.any():
            kept.append(one)
            continue
        loud, usual = (np.sqrt(np.mean(rest[rows] ** 2, axis=0)) for rows in (inside, outside))
        if np.any(loud > CONTACT_LOUD * usual):
            kept.append(one)
    return tuple(kept)


def within(gate: Gate, contact: Contact) -> Mask:
    """The samples [K] of a log in the window of a contact."""
    return np.asarray((gate.log.t >= contact.start) & (gate.log.t <= contact.end))


def beyond(gate: Gate, touched: Sequence[Touched], log: str) -> Mask:
    """The samples [K] of the ``log``, whose hash that is, in no window of its contacts among ``touched``."""
    windows = [within(gate, one.contact) for one in touched if one.log == log]
    return np.asarray(~np.any([np.zeros(len(gate.log.t), dtype=bool), *windows], axis=0))


def contact_findings(touched: Sequence[Touched]) -> tuple[Finding, ...]:
    """The contacts as findings, in the order of time."""
    return tuple(_finding(one.contact, one.log) for one in touched)


def _direction(one: Contact) -> str:
    """What is known of the direction of a contact's force: where few joints feel it, or friction keeps much
    of it from the motors, many directions make the same torques."""
    if one.cone <= CONTACT_NARROW:
        return f"direction known to {max(one.cone, 1.0):.0f} degrees"
    if one.cone < CONTACT_WIDE:
        return f"direction known to {one.cone:.0f} degrees only: joints do not show all of the force"
    return "direction not identifiable, nor its sign: joints do not show enough of the force"


def _errors(one: Contact) -> Floats:
    """Standard errors [3] of a contact's force, with what its window leaves open: the mean over it is smaller
    where the ends are late, and by what the filter takes off the edges."""
    share = 2 * CONTACT_EDGE / max(one.end - one.start, CONTACT_EDGE)
    return np.asarray(np.hypot(one.stderr, share * one.force))


def _confidence(one: Contact) -> float:
    """The share of right ones among contacts whose force is so many of its standard errors."""
    first, by_size = CONTACT_ODDS
    force, error = (float(np.linalg.norm(x)) for x in (one.force, one.stderr))
    log_odds = first + by_size * math.log(max(force, 1e-12) / max(error, 1e-12))
    return round(ODDS[-1] / (1 + math.exp(-log_odds)), 2)


def _finding(one: Contact, log: str) -> Finding:
    units = {parameter.name: parameter.unit for parameter in CONTACT.parameters}
    values: dict[str, tuple[float | str, float | None]] = {
        "start": (one.start, None),
        "end": (one.end, None),
        "link": (float(one.link), None),
        **{
            f"force_{axis}": (float(x), float(error))
            for axis, x, error in zip("xyz", one.force, _errors(one), strict=True)
        },
        "log": (log, None),
    }
    parameters = {name: Estimate(x, error, units[name]) for name, (x, error) in values.items()}
    state = "at rest" if one.at_rest else "in motion"
    where = f"link {one.link}, {state}, {one.start:.2f} to {one.end:.2f} s, {_direction(one)}"
    where += f": {CONTACT.signature}"
    gain = 100.0 * one.explained
    return Finding(CONTACT.id, None, parameters, _confidence(one), (), where, None, gain, math.inf)
