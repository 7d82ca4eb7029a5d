"""Contacts with something outside: those in logs, those that stand out of a model, and as findings.

What happens once in a log cannot be judged on parts of it that were left out: contacts are sought before
anything else (:mod:`robodyn.identify.contact`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.result import Estimate, Finding
from robodyn.diagnose.select.limits import (
    CONTACT_CONFIDENCE,
    CONTACT_EDGE,
    CONTACT_LOUD,
    CONTACT_NARROW,
    CONTACT_WIDE,
)
from robodyn.effects.rigid import CONTACT
from robodyn.gate.gate import Gate
from robodyn.identify.contact.contact import Contact, contacts, without_windows
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]


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

    def stands(one: Touched) -> bool:
        gate = logs[one.log]
        rows = within(gate, one.contact), beyond(gate, touched, one.log)
        if not all(each.any() for each in rows):
            return True
        loud, usual = (np.mean(left(gate)[each] ** 2, axis=0) for each in rows)
        return bool(np.any(loud > CONTACT_LOUD**2 * usual))

    return tuple(one for one in touched if stands(one))


def within(gate: Gate, contact: Contact) -> Mask:
    """The samples [K] of a log in the window of a contact."""
    return np.asarray((gate.log.t >= contact.start) & (gate.log.t <= contact.end))


def beyond(gate: Gate, touched: Sequence[Touched], log: str) -> Mask:
    """The samples [K] of the ``log``, whose hash that is, in no window of its contacts among ``touched``."""
    out = np.zeros(len(gate.log.t), dtype=bool)
    for one in touched:
        out |= within(gate, one.contact) & (one.log == log)
    return np.asarray(~out)


def contact_findings(touched: Sequence[Touched]) -> tuple[Finding, ...]:
    """The contacts as findings, in the order of time."""
    return tuple(_finding(one.contact, one.log) for one in touched)


def _direction(cone: float) -> str:
    """What is known of the direction of a contact's force by the ``cone`` [degrees] that holds it: where few
    joints feel it, or friction keeps much of it from the motors, many directions make the same torques."""
    if cone >= CONTACT_WIDE:
        return "direction not identifiable, nor its sign: joints do not show enough of the force"
    only = "" if cone <= CONTACT_NARROW else " only: joints do not show all of the force"
    return f"direction known to {max(cone, 1.0):.0f} degrees{only}"


def _finding(one: Contact, log: str) -> Finding:
    # The mean over a window is smaller where its ends are late, and by what the filter takes off the edges.
    share = 2 * CONTACT_EDGE / max(one.end - one.start, CONTACT_EDGE)
    values: dict[str, tuple[float | str, float | None]] = {
        "start": (one.start, None),
        "end": (one.end, None),
        "link": (float(one.link), None),
        "log": (log, None),
    }
    for axis, x, error in zip("xyz", one.force, one.stderr, strict=True):
        values[f"force_{axis}"] = float(x), math.hypot(error, share * x)
    parameters = {each.name: Estimate(*values[each.name], each.unit) for each in CONTACT.parameters}
    where = (
        f"link {one.link}, {'at rest' if one.at_rest else 'in motion'}, {one.start:.2f} to {one.end:.2f} s"
    )
    where += f", {_direction(one.cone)}: {CONTACT.signature}"
    gain = 100.0 * one.explained
    return Finding(CONTACT.id, None, parameters, CONTACT_CONFIDENCE, (), where, None, gain, math.inf)
