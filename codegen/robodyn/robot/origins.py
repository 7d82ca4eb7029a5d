"""Where the numbers of a description come from: stated, measured, assumed, invented, or not there at all."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Final, Literal, Protocol

from robodyn.errors import Place

Origin = Literal["stated", "measured", "assumed", "synthetic", "absent"]
#: What a description may say of numbers that it states; of inertial ones also that those left out are absent.
STATEABLE: Final[tuple[Origin, ...]] = ("stated", "measured", "assumed", "synthetic")
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
    lines = []
    for origin, meaning in _MEANINGS.items():
        joints_of: dict[str, tuple[int, ...]] = {}
        for name in _NAMES:
            joints = tuple(i for i, link in enumerate(links, 1) if _origin(link, name) == origin)
            if joints:
                joints_of[name] = joints
        limits = joints_of.pop("limits", ()) if origin == "absent" else ()
        if joints_of:
            lines.append(f"{_listed(joints_of, len(links))}: {meaning}")
        if limits:
            lines.append(f"{_listed({'limits': limits}, len(links))}: {_NO_LIMITS}")
    return lines


def _origin(link: LinkWithOrigins, name: str) -> str:
    """That of the numbers called ``name``, ``unknown`` where they are not 0 by being absent."""
    origin: str = getattr(link.origins, name)
    is_unknown = origin == "absent" and name in GROUPS["inertial"] and link.origins.unknown
    return "unknown" if is_unknown else origin


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
