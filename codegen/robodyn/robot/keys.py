"""The keys of the robot description, one table (``templates/description_keys.yaml``), from which the reader
and the JSON Schema are made. What may stand at a key: bounds of numbers, and the words that messages have for
it."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from string import Template
from typing import Any, Literal

from robodyn.resources import data_dir
from robodyn.robot.names import ROBOT_NAME_LENGTH, TEXT_LENGTH

Kind = Literal[
    "name", "text", "texts", "choice", "number", "angle", "vector", "angles", "range", "group", "list",
    "rest", "efficiency", "origins", "joint", "effects of a joint", "effects of the robot",
]  # fmt: skip
Sign = Literal["any", "nonzero", "nonnegative", "positive", "share"]


@dataclass(frozen=True, slots=True)
class Key:
    """One key: what may stand there, in which unit, and what is assumed where it is left out.

    ``names``: a run-time parameter may stand for the number. ``default`` is the text of the assumed
    value, for people; ``members`` are the keys of a group or of each entry of a list. ``choices`` are the
    words that may stand there, of a number those that may stand in its place. ``others``: what other formats
    call it.
    """

    name: str
    kind: Kind
    doc: str
    unit: str = ""
    required: bool = False
    names: bool = False
    sign: Sign = "any"
    default: str = ""
    choices: tuple[str, ...] = ()
    members: tuple[Key, ...] = ()
    others: tuple[str, ...] = ()


#: Most links a robot may have.
LINKS = 100
#: The numbers that lead from one link's frame to the next, if no pose does.
ROW = ("alpha", "a", "b", "d", "theta")
#: Most effects a robot may have, all lists together.
EFFECTS = 1000
#: Fewest and most knots of a table of efficiencies.
KNOTS = (2, 64)
#: The velocity of ``smooth`` and of ``dead_band`` where none is given.
REST_VELOCITY = "1e-3"

#: Bounds of a number: what is said of one that breaks them, and what was expected.
SIGNS = {
    "nonzero": ("is 0", "any number but 0"),
    "nonnegative": ("is negative", "0{unit} or more"),
    "positive": ("is not positive", "more than 0{unit}"),
    "share": ("is not a share", "more than 0 and at most 1"),
}


def _tables() -> dict[str, tuple[Key, ...]]:
    """The groups of keys in ``templates/description_keys.yaml``."""
    import yaml  # not at the top: lean files do without

    numbers = {
        "LINKS": LINKS, "REST_VELOCITY": REST_VELOCITY, "ROBOT_NAME_LENGTH": ROBOT_NAME_LENGTH,
        "TEXT_LENGTH": TEXT_LENGTH,
    }  # fmt: skip
    text = (data_dir("templates") / "description_keys.yaml").read_text(encoding="utf-8")
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    groups = yaml.load(Template(text).substitute(numbers), Loader=loader)

    def key(fields: dict[str, Any]) -> Key:
        lists: dict[str, Any] = {
            name: tuple(fields[name]) for name in ("choices", "others") if name in fields
        }
        members = tuple(map(key, groups[fields["members"]])) if "members" in fields else ()
        return Key(**{**fields, **lists, "members": members})

    return {name: tuple(map(key, group)) for name, group in groups.items() if name != "shared"}


_TABLES = _tables()
INERTIA, LIMITS, FRICTION = _TABLES["inertia"], _TABLES["limits"], _TABLES["friction"]
LINK, ROBOT, COUPLING = _TABLES["link"], _TABLES["robot"], _TABLES["coupling"]


def allowed(value: Fraction, sign: Sign) -> bool:
    """Whether ``value`` is within the bounds that ``sign`` names."""
    if sign == "any":
        return True
    if sign == "nonnegative":
        return value >= 0
    if sign == "nonzero":
        return value != 0
    return value > 0 and (sign == "positive" or value <= 1)


def expectation(key: Key) -> str:
    """What should stand at ``key``, for the "expected" of a message."""
    if key.kind == "choice":
        return " or ".join(key.choices)
    unit = f" [{key.unit}]" if key.unit else ""
    words = {
        "name": "a name",
        "text": "text",
        "number": " or ".join(["a number" + (", or a name" if key.names else ""), *key.choices]),
        "angle": "an angle, such as -pi/2",
        "vector": "three numbers [x, y, z]",
        "angles": "three angles [roll, pitch, yaw]",
        "range": "[lowest, highest]",
        "list": "a list",
        "texts": "a list of lines of text",
        "group": "a mapping",
        "rest": "exact, or smooth: {velocity: 1e-3}, or dead_band: {velocity: 1e-3}",
        "efficiency": "a number, or a table [[load fraction, efficiency], ...]",
        "origins": f"{' or '.join(key.choices)}, or a mapping such as {{inertial: synthetic}}",
        "joint": "the number of a joint",
        "effects of a joint": "a list of effects, such as [{effect: backlash, gap: 1e-3}]",
        "effects of the robot": "a list of effects, such as [{effect: payload, mass: 2}]",
    }
    return words[key.kind] + unit
