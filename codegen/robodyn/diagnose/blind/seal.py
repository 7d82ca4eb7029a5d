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

from robodyn.diagnose.blind.json_part import Part
from robodyn.diagnose.blind.limits import LONGEST_ANSWER
from robodyn.diagnose.limits import CLAIM
from robodyn.effects.catalogue import CATALOGUE
from robodyn.errors import InputError, Place
from robodyn.files import parsed_json

_FIRST = "robodyn sealed answer 1"
_REMEDY = "take the answer.sealed that robodyn hide has written"
_VERDICTS = ("missing_effect", "consistent", "unexplained")

Status = Literal["right", "in the declared set", "wrong"]


def seal(answer: Mapping[str, Any]) -> str:
    """``answer`` as text that tells nothing to the eye; the same for the same answer."""
    data = json.dumps(answer, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
    body = base64.b64encode(zlib.compress(data, 9)).decode()
    return "\n".join([_FIRST, *textwrap.wrap(body, 76)]) + "\n"


def open_seal(text: str, file: str = "answer.sealed") -> dict[str, Any]:
    """The answer to a blind test of one arm in ``text``.

    Raises
    ------
    InputError: this is no sealed answer, or not all of one.
    """
    return checked(unsealed(text, file))


def unsealed(text: str, file: str = "answer.sealed") -> Part:
    """What is sealed in ``text``, whatever test it answers.

    Raises
    ------
    InputError: this is no sealed answer, or not all of one.
    """
    lines = text.split()
    head = _FIRST.split()
    if lines[: len(head)] != head:
        fault: str = "another beginning"
    else:
        try:
            packed = base64.b64decode("".join(lines[len(head) :]), validate=True)
            unpacking = zlib.decompressobj()
            data = unpacking.decompress(packed, LONGEST_ANSWER)
            if unpacking.eof and not unpacking.unused_data:
                return Part(parsed_json(data), file, "a sealed answer", _REMEDY)
            fault = "a part of one, or more than one"
        except (binascii.Error, zlib.error, ValueError) as error:
            fault = str(error)
    raise InputError(
        "this is not a sealed answer",
        where=Place(file),
        found=fault,
        expected=f"a file that begins with {_FIRST!r}",
        remedy=_REMEDY,
    )


def checked(whole: Part) -> dict[str, Any]:
    """The answer to a blind test of one arm, all of it that is used of the right kind.

    Raises
    ------
    InputError: it is none.
    """
    for one in whole.need("effects", "the effects that are hidden").each():
        one.need("effect", "the name of an effect").name()
        joint = one.get("joint")
        if joint is not None:
            joint.joint()
        _hidden_values(one.need("parameters", "parameters by name"))
    noise, logs = whole.get("noise"), whole.get("logs")
    for each in noise.each() if noise is not None else []:
        each.number(0)
    for key in logs.object() if logs is not None else ():
        logs.need(key, "the hash of a log").text()  # type: ignore[union-attr]
    answer: dict[str, Any] = whole.value
    return answer


def _hidden_values(parameters: Part) -> None:
    for name, part in parameters.items():
        if isinstance(part.value, str):
            part.text()
        elif name == "with":
            part.joint()
        else:
            part.number()


# --- the score --------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Claim:
    """A finding of a diagnosis with confidence enough; ``truth`` is what was hidden, where it is right;
    ``answers``: the index of the hidden effect that it answers for, None where it is wrong."""

    effect: str
    joint: int | None
    status: Status
    parameters: Mapping[str, Any]
    truth: Mapping[str, Any] | None
    answers: int | None = None

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
        statuses = {claim.status for claim in self.claims}
        if "wrong" in statuses:
            return "wrong"
        if self.missed:
            return "missed"
        return "in the declared set" if "in the declared set" in statuses else "right"

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


def score(answer: Mapping[str, Any], diagnosis: Any, file: str = "diagnosis.json") -> Score:
    """``diagnosis`` (what ``diagnosis.json`` holds) beside ``answer`` (:func:`open_seal`).

    A claim is right where effect and joint are those of something hidden; in the declared set where the
    hidden effect is among those that the claim says it cannot be told from; else wrong. An effect is missed
    that no claim is right about, not even by its set. A claim answers for one effect, the best that it can.
    ``file`` is what messages call the diagnosis.

    Raises
    ------
    InputError: ``diagnosis`` is no diagnosis; with the part of it that is wrong.
    """
    whole = Part(diagnosis, file, "a diagnosis", "take the diagnosis.json that robodyn diagnose has written")
    verdict = whole.need("verdict", f"one of {', '.join(_VERDICTS)}")
    if verdict.value not in _VERDICTS:
        raise verdict.wrong(f"one of {', '.join(_VERDICTS)}")
    listed = [_finding(part) for part in whole.need("findings", "a list of findings").each()]
    findings = [f for f in listed if f["confidence"] >= CLAIM and verdict.value == "missing_effect"]
    closed, same = _closed(answer, whole), _same(answer, whole)
    hidden = list(answer["effects"])
    open_ = list(range(len(hidden)))
    matches: dict[int, tuple[Status, Mapping[str, Any] | None, int]] = {}
    for status, fits in (("right", _is), ("in the declared set", _holds)):
        for k, finding in enumerate(findings):
            if k in matches:
                continue
            match = next((i for i in open_ if fits(finding, hidden[i])), None)
            if match is not None:
                open_.remove(match)
                truth = hidden[match]["parameters"] if status == "right" else None
                matches[k] = (status, truth, match)  # type: ignore[assignment]  # the words of Status
    claims = []
    for k, finding in enumerate(findings):
        place = finding["effect"], finding["joint"]
        if k in matches:
            status, truth, answers = matches[k]
            claims.append(Claim(*place, status, finding["parameters"], truth, answers))
        else:
            claims.append(Claim(*place, "wrong", finding["parameters"], None))
    return Score(verdict.value, len(hidden), len(open_), tuple(claims), closed, same)


def _finding(part: Part) -> dict[str, Any]:
    """A finding, all of it that is used of the right kind; what may be left out is there."""
    joint, others, parameters = (part.get(key) for key in ("joint", "confounded_with", "parameters"))
    values = list(parameters.items()) if parameters is not None else []
    return {
        "effect": part.need("effect", "the name of an effect").name(),
        "joint": None if joint is None else joint.joint(),
        "confidence": part.need("confidence", "a number from 0 to 1").number(0, 1),
        "confounded_with": [] if others is None else [other.name() for other in others.each()],
        "parameters": {name: _estimate(name, value) for name, value in values},
    }


def _estimate(name: str, part: Part) -> dict[str, Any]:
    """A parameter of a finding: its value, where it has one its standard error, and its unit."""
    value, error, unit = (part.get(key) for key in ("value", "stderr", "unit"))
    claimed: float | str | None = None
    if value is not None:
        plain = value.joint if name == "with" else value.number
        claimed = value.text() if isinstance(value.value, str) else plain()
    return {
        "value": claimed,
        "stderr": None if error is None else error.number(0),
        "unit": "" if unit is None else unit.text(),
    }


def _is(finding: Mapping[str, Any], hidden: Mapping[str, Any]) -> bool:
    return bool(finding["effect"] == hidden["effect"] and _place(finding) == _place(hidden))


def _place(one: Mapping[str, Any]) -> frozenset[Any]:
    """The joints of an effect: a motor that drives two is at both, whichever is named first."""
    other = one["parameters"].get("with")
    if isinstance(other, Mapping):
        other = other["value"]
    return frozenset({one.get("joint")} | ({int(other)} if isinstance(other, (int, float)) else set()))


def _holds(finding: Mapping[str, Any], hidden: Mapping[str, Any]) -> bool:
    if hidden["effect"] not in finding["confounded_with"]:
        return False
    apart = not (_wide(finding["effect"]) or _wide(hidden["effect"]))
    return not apart or bool(_place(finding) & _place(hidden))


def _wide(id: str) -> bool:
    """Whether an effect shows at other joints than its own."""
    known = CATALOGUE.get(id)
    return known is not None and known.traits.wide


def _closed(answer: Mapping[str, Any], diagnosis: Part) -> float | None:
    """:func:`gap_closed` on the validation log, by the test's own noise; None where a number is missing."""
    import numpy as np  # not at the top: opening and sealing do without

    from robodyn.diagnose.result import gap_closed

    gap = diagnosis.get("gap")
    validate = None if gap is None else gap.get("validate")
    sides = [None if validate is None else validate.get(key) for key in ("before", "after")]
    before, after = (np.array([] if side is None else _gaps(side)) for side in sides)
    noise = np.array([float(x) for x in answer.get("noise") or ()])
    if not len(noise) or not noise.min() or not len(before) == len(after) == len(noise):
        return None
    share = gap_closed(before, after, noise)
    return share if share is not None and math.isfinite(share) else None


def _gaps(listed: Part) -> list[float]:
    """The numbers of a list, none where one of them is null, as what cannot be known is."""
    rms = [None if part.value is None else part.number(0) for part in listed.each()]
    return [] if None in rms else [x for x in rms if x is not None]


def _same(answer: Mapping[str, Any], diagnosis: Part) -> bool:
    """False where all logs of the diagnosis have hashes, and none of them is a log of the test's."""
    logs = diagnosis.get("logs")
    parts = [log.get("sha256") for log in (logs.each() if logs is not None else [])]
    hashes = [part.text() for part in parts if part is not None]
    full = [one for one in hashes if len(one) == 64]
    return not full or len(full) < len(parts) or bool(set(full) & set((answer.get("logs") or {}).values()))
