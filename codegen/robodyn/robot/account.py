"""What is to be known of a robot beyond its numbers: where these come from (stated, measured, assumed,
invented, or not there at all), and what the reading of a file in another format came upon."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import Any, Final, Literal, Protocol

from robodyn.errors import Place

Origin = Literal["stated", "measured", "assumed", "synthetic", "absent"]
#: Groups of numbers that a description gives one origin: what of :class:`Origins` each of them is.
GROUPS: Final[Mapping[str, tuple[str, ...]]] = {
    "geometry": ("geometry",),
    "inertial": ("mass", "com", "inertia"),
    "motor_inertia": ("motor_inertia",),
    "friction": ("friction",),
    "limits": ("limits",),
}
_NAMES: Final = {
    "geometry": "geometry",
    "mass": "mass",
    "com": "centre of mass",
    "inertia": "inertia",
    "motor_inertia": "rotor inertia",
    "friction": "friction",
    "limits": "limits",
}
_MEANINGS: Final[Mapping[str, str]] = {
    "stated": "stated by the description",
    "measured": "measured on the arm",
    "assumed": "assumed",
    "synthetic": "synthetic (invented, not those of a real arm)",
    "absent": "absent, taken as 0",
    "unknown": "absent and unknown, so that no torque rests on it",
}
_NO_LIMITS: Final = "absent, so without bounds"


@dataclass(frozen=True, slots=True)
class Origins:
    """Where the numbers of a link and of its joint come from."""

    geometry: Origin = "stated"
    mass: Origin = "stated"
    com: Origin = "stated"
    inertia: Origin = "stated"
    motor_inertia: Origin = "absent"
    friction: Origin = "absent"
    limits: Origin = "absent"
    #: Whether mass, centre of mass and inertia that are absent are unknown, and not 0.
    unknown: bool = False
    #: The place of the link in its description.
    where: Place | None = field(default=None, compare=False)

    def with_stated(self, names: Iterable[str]) -> Origins:
        """These, what is absent of the numbers called ``names`` stated."""
        stated: dict[str, Any] = {name: "stated" for name in names if getattr(self, name) == "absent"}
        return replace(self, **stated) if stated else self


class LinkWithOrigins(Protocol):
    """What is asked of a :class:`~robodyn.robot.parts.Link` here."""

    @property
    def name(self) -> str: ...
    @property
    def origins(self) -> Origins: ...
    @property
    def confidence(self) -> object: ...


def origins_to_state(link: LinkWithOrigins) -> dict[str, Origin]:
    """The origins that a description of ``link`` has to state, by group: of numbers that are there, and other
    than the usual ones."""
    usual: dict[str, Origin] = {"inertial": "assumed"} if link.confidence == "unknown" else {}
    words = {}
    for group, names in GROUPS.items():
        origins = [origin for name in names if (origin := getattr(link.origins, name)) != "absent"]
        if group == "inertial" and link.origins.unknown:
            origins = ["absent"]
        if origins and origins[0] != usual.get(group, "stated"):
            words[group] = origins[0]
    return words


def origins_to_dicts(links: Sequence[LinkWithOrigins]) -> list[dict[str, str]]:
    """The origins of each link's numbers by name, base to tip, for JSON."""
    return [{"link": link.name, **{name: getattr(link.origins, name) for name in _NAMES}} for link in links]


def inertial_origin(links: Sequence[LinkWithOrigins]) -> str:
    """The origin of the masses and inertias of ``links``, several where they have several, without what is
    absent."""
    origins = {getattr(link.origins, name): None for link in links for name in ("mass", "inertia")}
    return ", ".join(origin for origin in origins if origin != "absent")


def origins_in_words(links: Sequence[LinkWithOrigins]) -> list[str]:
    """A line for each origin that numbers of ``links`` have, for people: which numbers, of which joints."""
    joints_of: dict[tuple[str, str], list[int]] = {}  # by meaning and name
    for name in _NAMES:
        for i, link in enumerate(links, 1):
            origin: str = getattr(link.origins, name)
            if origin == "absent" and name in GROUPS["inertial"] and link.origins.unknown:
                origin = "unknown"
            meaning = _NO_LIMITS if (origin, name) == ("absent", "limits") else _MEANINGS[origin]
            joints_of.setdefault((meaning, name), []).append(i)
    meanings = [text for origin, text in _MEANINGS.items() if origin != "unknown"]
    lines = []
    for meaning in (*meanings, _NO_LIMITS, _MEANINGS["unknown"]):
        of_meaning = {name: tuple(j) for (text, name), j in joints_of.items() if text == meaning}
        if of_meaning:
            lines.append(f"{_listed(of_meaning, len(links))}: {meaning}")
    return lines


def _listed(joints_of: Mapping[str, tuple[int, ...]], n: int) -> str:
    """``mass, inertia; friction (joints 2, 3)``: those of all joints first."""
    names_of: dict[tuple[int, ...], list[str]] = {}
    for name, joints in joints_of.items():
        names_of.setdefault(joints, []).append(_NAMES[name])
    parts = []
    for joints, names in sorted(names_of.items(), key=lambda item: (-len(item[0]), item[0])):
        word = "joint" if len(joints) == 1 else "joints"
        place = "" if len(joints) == n else f" ({word} {_ranges(joints)})"
        parts.append(", ".join(names) + place)
    return "; ".join(parts)


def _ranges(joints: tuple[int, ...]) -> str:
    """``1 to 3, 5``."""
    runs: list[list[int]] = []
    for joint in joints:
        if runs and joint == runs[-1][-1] + 1:
            runs[-1].append(joint)
        else:
            runs.append([joint])
    words = {1: "{0}", 2: "{0}, {1}"}
    return ", ".join(words.get(len(run), "{0} to {1}").format(run[0], run[-1]) for run in runs)


# --- files in other formats ---------------------------------------------------------------------------------

#: The parts of an :class:`Account` that are lines of text.
PARTS: Final = ("warnings", "left_out", "decided", "not_used")


@dataclass(frozen=True, slots=True)
class Account:
    """What the reading of ``file``, in that ``format``, came upon, in lines of text: ``warnings``, what the
    format does not allow and was read all the same; what was ``left_out`` and changes torques; how the arm
    was taken out of the file (``decided``); what the file says beyond (``not_used``)."""

    file: str
    format: str
    warnings: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()
    decided: tuple[str, ...] = ()
    not_used: tuple[str, ...] = ()

    def risks(self) -> Iterator[str]:
        """What may make the numbers others than those that the file means, for people."""
        yield from self.warnings
        yield from (f"left out, although it changes torques: {text}" for text in self.left_out)

    def lines(self) -> Iterator[str]:
        """All of it for people: risks first, what is not used on one line."""
        yield from self.risks()
        yield from self.decided
        if self.not_used:
            yield f"not used: {'; '.join(self.not_used)}"

    def physics_left_out(self) -> Iterator[str]:
        """What changes torques and is not in the robot, for people who compare it with another."""
        yield from (f"left out of {self.file}: {text}" for text in self.left_out)

    def to_dict(self) -> dict[str, Any]:
        """For JSON, and the key ``imported`` of a description."""
        values = ((each.name, getattr(self, each.name)) for each in fields(self))
        return {name: list(value) if isinstance(value, tuple) else value for name, value in values}


class RobotWithAccount(Protocol):
    """What is asked of a :class:`~robodyn.robot.model.Robot` here."""

    @property
    def name(self) -> str: ...
    @property
    def links(self) -> Sequence[LinkWithOrigins]: ...
    @property
    def account(self) -> Account | None: ...


def account_lines(robot: RobotWithAccount) -> Iterator[str]:
    """What is known of ``robot`` and its numbers, for people."""
    for line in origins_in_words(robot.links):
        yield f"Origin of numbers: {line}"
    if robot.account is not None:
        yield f"Imported from {robot.account.file} ({robot.account.format})"
        yield from robot.account.lines()


def account_to_dict(robot: RobotWithAccount) -> dict[str, Any]:
    """What is known of ``robot`` and its numbers, for JSON: the :class:`Account` of the file that it was
    imported from, None where it comes from no such file, and the origin of each link's numbers."""
    return {
        "robot": robot.name,
        "imported": None if robot.account is None else robot.account.to_dict(),
        "origins": origins_to_dicts(robot.links),
    }
