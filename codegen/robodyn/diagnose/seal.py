"""The answer to a blind test: sealed so that nobody reads it by accident, opened, and set beside a diagnosis.

The seal is no lock: it is JSON, compressed and in base64. One who wants to look can.
"""

from __future__ import annotations

import base64
import binascii
import json
import math
import textwrap
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from robodyn.diagnose.result import CLAIM
from robodyn.effects.catalogue import CATALOGUE
from robodyn.errors import InputError, Place

_FIRST = "robodyn sealed answer 1"
_MOST = 8_000_000  # characters of an answer
#: A gap of less than so many noise floors is none to speak of.
_GAP = 0.2
_VERDICTS = ("missing_effect", "consistent", "unexplained")

Status = Literal["right", "in the declared set", "wrong"]


def seal(answer: Mapping[str, Any]) -> str:
    """``answer`` as text that tells nothing to the eye; the same for the same answer."""
    data = json.dumps(answer, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
    body = base64.b64encode(zlib.compress(data, 9)).decode()
    return "\n".join([_FIRST, *textwrap.wrap(body, 76)]) + "\n"


def open_seal(text: str, file: str = "answer.sealed") -> dict[str, Any]:
    """The answer in ``text``.

    Raises
    ------
    InputError: this is no sealed answer, or not all of one.
    """
    lines = text.split()
    head = _FIRST.split()
    fault = None
    if lines[: len(head)] != head:
        fault = "another beginning"
    else:
        try:
            packed = base64.b64decode("".join(lines[len(head) :]), validate=True)
            unpacking = zlib.decompressobj()
            data = unpacking.decompress(packed, _MOST)
            found = json.loads(data) if unpacking.eof else None
        except (binascii.Error, zlib.error, ValueError) as error:
            fault, found = str(error), None
        if isinstance(found, dict) and isinstance(found.get("effects"), list):
            return found
    raise InputError(
        "this is not a sealed answer",
        where=Place(file),
        found=fault or "a part of one, or something else",
        expected=f"a file that begins with {_FIRST!r}",
        remedy="take the answer.sealed that robodyn hide has written",
    )


# --- the score --------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Claim:
    """A finding of a diagnosis with confidence enough; ``truth`` is what was hidden, where it is right."""

    effect: str
    joint: int | None
    status: Status
    parameters: Mapping[str, Any]
    truth: Mapping[str, Any] | None

    @property
    def name(self) -> str:
        """For people."""
        return f"{self.effect} at joint {self.joint}" if self.joint else self.effect


@dataclass(frozen=True, slots=True)
class Score:
    """How a diagnosis did: its ``claims``; how many effects were ``hidden``, how many of them ``missed``;
    ``closed``: the share of the gap on the validation log that went, of what noise leaves, None where there
    is none; ``same``: whether the diagnosis is of the logs of the test, as far as can be told."""

    verdict: str
    hidden: int
    missed: int
    claims: tuple[Claim, ...]
    closed: float | None
    same: bool

    @property
    def result(self) -> str:
        """The worst of what there is to say: ``wrong``, ``missed``, ``in the declared set`` or ``right``."""
        said = {claim.status for claim in self.claims}
        if "wrong" in said:
            return "wrong"
        if self.missed:
            return "missed"
        return "in the declared set" if "in the declared set" in said else "right"

    def to_dict(self) -> dict[str, Any]:
        """Ready for JSON."""
        return {
            "result": self.result,
            "verdict": self.verdict,
            "hidden": self.hidden,
            "missed": self.missed,
            "claims": [
                {
                    "effect": claim.effect,
                    "joint": claim.joint,
                    "status": claim.status,
                    "parameters": dict(claim.parameters),
                    "truth": None if claim.truth is None else dict(claim.truth),
                }
                for claim in self.claims
            ],
            "gap_closed": self.closed,
            "same_logs": self.same,
        }


def score(answer: Mapping[str, Any], diagnosis: Any) -> Score:
    """``diagnosis`` (what ``diagnosis.json`` holds) beside ``answer`` (:func:`open_seal`).

    A claim is right where effect and joint are those of something hidden; in the declared set where the
    hidden effect is among those that the claim says it cannot be told from; else wrong. An effect is missed
    that no claim is right about, not even by its set. A claim answers for one effect, the best that it can.

    Raises
    ------
    InputError: ``diagnosis`` is no diagnosis.
    """
    findings = _findings(diagnosis)
    hidden = list(answer["effects"])
    open_ = list(range(len(hidden)))
    found: dict[int, tuple[Status, Mapping[str, Any] | None]] = {}
    for status, fits in (("right", _is), ("in the declared set", _holds)):
        for k, finding in enumerate(findings):
            if k in found:
                continue
            match = next((i for i in open_ if fits(finding, hidden[i])), None)
            if match is not None:
                open_.remove(match)
                truth = hidden[match]["parameters"] if status == "right" else None
                found[k] = (status, truth)  # type: ignore[assignment]  # the words of Status
    claims = []
    for k, finding in enumerate(findings):
        status, truth = found.get(k, ("wrong", None))
        parameters = finding.get("parameters", {})
        claims.append(Claim(finding["effect"], finding["joint"], status, parameters, truth))
    return Score(
        diagnosis["verdict"], len(hidden), len(open_), tuple(claims), _closed(answer, diagnosis),
        _same(answer, diagnosis),
    )  # fmt: skip


def _findings(diagnosis: Any) -> list[Mapping[str, Any]]:
    """The claims among the findings."""
    verdict = diagnosis.get("verdict") if isinstance(diagnosis, Mapping) else None
    listed = diagnosis.get("findings") if verdict in _VERDICTS else None
    if not isinstance(listed, list) or not all(map(_is_finding, listed)):
        raise InputError(
            "this is not a diagnosis",
            expected="diagnosis.json of robodyn diagnose, with verdict and findings",
        )
    if verdict != "missing_effect":
        return []
    return [f for f in listed if f["confidence"] >= CLAIM]


def _is_finding(one: object) -> bool:
    return (
        isinstance(one, Mapping)
        and isinstance(one.get("effect"), str)
        and (one.get("joint") is None or isinstance(one.get("joint"), int))
        and isinstance(one.get("confidence"), (int, float))
    )


def _is(finding: Mapping[str, Any], hidden: Mapping[str, Any]) -> bool:
    return bool(finding["effect"] == hidden["effect"] and _place(finding) == _place(hidden))


def _place(one: Mapping[str, Any]) -> frozenset[Any]:
    """The joints of an effect: a motor that drives two is at both, whichever is named first."""
    other = one.get("parameters", {}).get("with")
    if isinstance(other, Mapping):
        other = other.get("value")
    return frozenset({one["joint"]} | ({int(other)} if other is not None else set()))


def _holds(finding: Mapping[str, Any], hidden: Mapping[str, Any]) -> bool:
    if hidden["effect"] not in finding.get("confounded_with", ()):
        return False
    apart = not (_wide(finding["effect"]) or _wide(hidden["effect"]))
    return not apart or bool(_place(finding) & _place(hidden))


def _wide(id: str) -> bool:
    """Whether an effect shows at other joints than its own."""
    known = CATALOGUE.get(id)
    return known is not None and (
        known.level != "joint" or known.place in ("rigid", "coupler") or id == "encoder_offset"
    )


def _closed(answer: Mapping[str, Any], diagnosis: Mapping[str, Any]) -> float | None:
    """Of all joints together, each in units of its noise, what of the gap went."""
    try:
        gap, noise = diagnosis["gap"]["validate"], [float(x) for x in answer["noise"]]

        def excess(rms: Any) -> float:
            shares = [(float(x) / of) ** 2 for x, of in zip(rms, noise, strict=True)]
            return math.sqrt(sum(shares) / len(shares)) - 1

        before, after = excess(gap["before"]), excess(gap["after"])
        return 1 - after / before if before > _GAP else None
    except (KeyError, TypeError, ValueError, ZeroDivisionError):
        return None


def _same(answer: Mapping[str, Any], diagnosis: Mapping[str, Any]) -> bool:
    """False where all logs of the diagnosis have hashes, and none of them is a log of the test's."""
    logs = diagnosis.get("logs") or ()
    hashes = [log.get("sha256") for log in logs if isinstance(log, Mapping)]
    full = [one for one in hashes if isinstance(one, str) and len(one) == 64]
    return not full or len(full) < len(hashes) or bool(set(full) & set(answer.get("logs", {}).values()))
