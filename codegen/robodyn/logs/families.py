"""Families of columns, one a joint, and what their names say that they are."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final

_INTEGER: Final = re.compile(r"[0-9]+")
_TOKEN: Final = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[0-9]+")

#: Words in names, and how much each speaks for a group.
_WORDS: Final = {
    "q": {
        "q": 5, "pos": 6, "position": 6, "positions": 6, "angle": 5, "angles": 5, "theta": 4, "phi": 4,
        "joint": 1, "encoder": 4, "enc": 4, "winkel": 5, "lage": 4,
    },
    "qd": {
        "qd": 7, "dq": 7, "vel": 7, "velocity": 7, "velocities": 7, "speed": 7, "omega": 5, "qp": 6,
        "rate": 2, "geschwindigkeit": 7,
    },
    "qdd": {"qdd": 8, "ddq": 8, "acc": 7, "accel": 7, "acceleration": 7, "accelerations": 7, "qpp": 7},
    "tau": {
        "tau": 7, "torque": 7, "torques": 7, "trq": 7, "effort": 6, "moment": 5, "current": 5, "currents": 5,
        "cur": 4, "curr": 4, "load": 3, "force": 4, "amp": 3, "drehmoment": 7, "strom": 5, "nm": 3,
    },
}  # fmt: skip
#: Second encoders: these beside those of positions.
_LINK: Final = {"se", "secondary", "link", "ql", "output", "outer", "loadside"}
#: What is wanted and not what is, or what was made of it: never proposed where there is something else.
_WANTED: Final = {
    "ref", "reference", "des", "desired", "cmd", "command", "commanded", "target", "goal", "set", "setpoint",
    "error", "err", "ext", "external", "friction", "temp", "temperature", "ff", "feedforward", "dot", "std",
    "model", "estimate", "est", "gravity", "g", "c", "rel", "relative", "volt", "volts", "voltage", "limit",
}  # fmt: skip
#: Switches and states: never a quantity.
_STATES: Final = {"enable", "enabled", "status", "mode", "flag", "id", "valid"}
_MEASURED: Final = {"act", "actual", "meas", "measured", "msr", "is", "ist", "mot", "motor", "rec", "abs"}
_UNITS: Final = {
    ("deg", "per", "s"): "deg/s", ("rad", "per", "s"): "rad/s", ("rad", "s"): "rad/s", ("deg", "s"): "deg/s",
    ("rpm",): "rpm", ("deg",): "deg", ("degrees",): "deg", ("rad",): "rad", ("nm",): "N m",
    ("m", "nm"): "mN m", ("mnm",): "mN m", ("ma",): "mA", ("a",): "A", ("amps",): "A", ("amp",): "A",
    ("ms",): "ms", ("us",): "us",
    ("ns",): "ns", ("s",): "s", ("sec",): "s", ("mm",): "mm", ("ticks",): "ticks", ("counts",): "ticks",
    ("usec",): "us", ("msec",): "ms", ("nsec",): "ns", ("percent",): "%", ("permille",): "permille",
}  # fmt: skip
TIMES: Final = (
    "t", "time", "timestamp", "times", "stamp", "zeit", "sec", "seconds", "clock", "tick", "ms", "us",
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Family:
    """Columns that differ by a number: the ``pattern`` with %d for it, and the ``members`` in their order.
    A column by itself is a family of one, without %d."""

    pattern: str
    members: tuple[str, ...]

    @property
    def tokens(self) -> tuple[str, ...]:
        """The words of its name, in small letters."""
        return tokens_of(self.pattern.replace("%d", " ").replace("%02d", " "))

    def score(self, group: str) -> int:
        """How much its name speaks for ``group``; 0: nothing does."""
        words = self.tokens
        known = _WORDS["q" if group == "ql" else group]
        # The last part of a path says most: rec.act_pos.
        best = max((known.get(word, 0) for word in words), default=0)
        if not best or _STATES & set(words):
            return 0
        others = (
            max((table.get(w, 0) for w in words), default=0)
            for g, table in _WORDS.items()
            if table is not known
        )
        if max(others) > best:
            return 0
        linked = bool(_LINK & set(words))
        if linked != (group == "ql") and group in ("q", "ql"):
            return 0
        score = 10 * best + 3 * len(_MEASURED & set(words)) - 20 * len(_WANTED & set(words)) - len(words)
        return max(score, 1)


def tokens_of(name: str) -> tuple[str, ...]:
    """The words of a name, in small letters: of camel case, and between marks."""
    return tuple(word.lower() for word in _TOKEN.findall(name) if not word.isdigit())


def unit_in(name: str) -> str:
    """The unit with which a name ends; "" if it ends with none."""
    words = tokens_of(name)
    for length in (3, 2, 1):
        if len(words) > length and words[-length:] in _UNITS:
            return _UNITS[words[-length:]]
    return ""


def families_of(columns: Iterable[str], n: int | None) -> list[Family]:
    """The families of ``columns`` that have ``n`` members; None: of any size above one. Numbers rise by one
    from 0 or 1; of several numbers in a name, the one that makes the largest family is that of the joint."""
    listed = list(columns)
    by_pattern: dict[str, dict[int, str]] = {}
    for name in listed:
        for match in _INTEGER.finditer(name):
            digits = match[0]
            if len(digits) > 3:
                continue
            form = f"%0{len(digits)}d" if len(digits) > 1 and digits[0] == "0" else "%d"
            pattern = name[: match.start()] + form + name[match.end() :]
            by_pattern.setdefault(pattern, {})[int(digits)] = name
    families = []
    for pattern, members in by_pattern.items():
        first = 0 if 0 in members else 1
        run: list[str] = []
        while first + len(run) in members:
            run.append(members[first + len(run)])
        if len(run) > 1 and (n is None or len(run) == n):
            families.append(Family(pattern, tuple(run)))
    if n in (None, 1):
        families += [Family(name, (name,)) for name in listed]
    return families


def best_size(families: Sequence[Family]) -> int | None:
    """How many joints there are: the size at which positions and torques both have families."""
    sizes = sorted({len(family.members) for family in families}, reverse=True)
    for size in sizes:
        some = [family for family in families if len(family.members) == size]
        if all(any(family.score(group) > 1 for family in some) for group in ("q", "tau")):
            return size
    return None
