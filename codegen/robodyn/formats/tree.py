"""A mechanism as other formats state it: links, joints of every kind, and what the file says beyond them.

SI units; numbers are floats whose shortest text is that of the file. Nothing is left out or decided here:
:mod:`robodyn.formats.serial` takes a serial chain out of a tree.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.formats.chain import Body, Pose, Spring, Vector, about_axis, scaled
from robodyn.formats.limits import GREATEST, LINES_SHOWN, LINKS, NAMES_SHOWN
from robodyn.robot.names import TEXT_LENGTH, shown
from robodyn.robot.numbers import shortest

#: What the names of files end in whose macros are expanded: lines are those of the expanded text.
EXPANDED: Final = " (expanded)"
#: Kinds that a chain's joint can be.
TURNING: Final = frozenset({"revolute", "continuous"})
MOVING: Final = TURNING | {"prismatic"}


@dataclass(frozen=True, slots=True)
class JointLimits:
    """Limits of a joint as written, None where nothing is stated: positions [rad or m], velocity and
    acceleration [per s, per s^2], ``effort`` [N m or N]."""

    lower: float | None = None
    upper: float | None = None
    velocity: float | None = None
    acceleration: float | None = None
    effort: float | None = None


@dataclass(frozen=True, slots=True)
class Mimic:
    """A joint that follows another: ``q = multiplier * q_leader + offset``, and of ``q_leader - middle`` the
    second and higher powers times ``curve``."""

    leader: str
    multiplier: float = 1.0
    offset: float = 0.0
    curve: tuple[float, ...] = ()
    middle: float = 0.0

    @property
    def stands(self) -> bool:
        """Whether it stays where it is wherever the leader is."""
        return not self.multiplier and not any(self.curve)

    def position(self, leader: float) -> float:
        """Where it is [rad or m] if the leader is there."""
        curved = sum(c * (leader - self.middle) ** power for power, c in enumerate(self.curve, 2))
        return self.multiplier * leader + self.offset + curved


@dataclass(frozen=True, slots=True)
class TreeLink:
    """A link. ``body``: in the link's frame, None where the file states no inertia; ``shape``: whether the
    link has geometry, and so is more than a frame; ``assumed``: whether the body comes from shapes or from a
    default of the format; ``is_point``: whether the file states its mass and not its inertia;
    ``unread``: whether it leaves both to meshes, which are not opened."""

    name: str
    where: Place
    body: Body | None = None
    shape: bool = False
    assumed: bool = False
    is_point: bool = False
    unread: bool = False


@dataclass(frozen=True, slots=True)
class TreeJoint:
    """A joint between two links; ``kind``: revolute, continuous, prismatic, fixed, floating, planar, ball,
    universal, screw or other.

    The child's frame is ``origin * motion(axis, q - reference) * child_pose`` in the parent's frame;
    ``axis`` is a unit vector in the joint's frame. ``damping`` [N m s/rad or N s/m], ``friction`` [N m or N],
    ``armature``: rotor inertia reflected to the joint [kg m^2 or kg]; ``ratio`` of the gear; None where
    nothing is stated.
    """

    name: str
    kind: str
    parent: str
    child: str
    where: Place
    origin: Pose = field(default_factory=Pose)
    child_pose: Pose = field(default_factory=Pose)
    axis: Vector = (0.0, 0.0, 1.0)
    reference: float = 0.0
    limits: JointLimits = field(default_factory=JointLimits)
    damping: float | None = None
    friction: float | None = None
    armature: float | None = None
    ratio: float | None = None
    spring: Spring | None = None
    mimic: Mimic | None = None

    def motion(self, position: float) -> Pose:
        """The frame behind it in the frame before it at ``position`` [rad or m]; joints of other kinds than
        revolute, continuous and prismatic are where the file puts them."""
        displacement = float(shortest(position) - shortest(self.reference))
        if self.kind in TURNING:
            return Pose(rotation=about_axis(self.axis, displacement))
        return Pose(scaled(displacement, self.axis)) if self.kind == "prismatic" else Pose()


@dataclass(frozen=True, slots=True)
class Loop:
    """Something that ties two links together beside the joints of the tree, and so closes a loop."""

    what: str
    links: tuple[str, str]
    where: Place


@dataclass(frozen=True, slots=True)
class Unused:
    """Something that a file says and that is not used; ``lines`` where it says so, ascending."""

    what: str
    file: str
    lines: tuple[int, ...] = ()

    def text(self, file: str = "") -> str:
        """On one line, with the first few places; without the name of the file where that is ``file``."""
        name = {file: "", file + EXPANDED: EXPANDED.strip(" ()")}.get(self.file, self.file)
        more = len(self.lines) - LINES_SHOWN
        word = "" if not self.lines else "line " if len(self.lines) == 1 else "lines "
        places = word + ", ".join(map(str, self.lines[:LINES_SHOWN])) + (f" and {more} more" * (more > 0))
        place = ": ".join(filter(None, (name, places)))
        return f"{self.what} ({place})" if place else self.what


_PHYSICS: Final = (Path(__file__).parent / "elements_of" / "physics.txt").read_text(encoding="utf-8")
#: What of a file changes torques and is not modelled: names by which the command line leaves it out.
PHYSICS: Final = {
    name: words
    for name, _, words in (line.partition(": ") for line in _PHYSICS.splitlines() if not line.startswith("#"))
}


@dataclass(frozen=True, slots=True)
class Physics:
    """Something that a file says, that changes torques, and that is not modelled: its ``name`` in
    :data:`PHYSICS`, what it is of, and where it stands."""

    name: str
    of: str
    where: Place


def physics_text(name: str, of: Iterable[str]) -> str:
    """The physics of that ``name`` on one line, with what it is ``of``, as far as that is stated."""
    stated = names(filter(None, of))
    return f"{name}: {PHYSICS[name]}" + (f" ({stated})" if stated else "")


@dataclass(frozen=True, slots=True)
class Tree:
    """A mechanism. ``joints`` name their links; the world, where the format has one, is a link of it.

    ``gravity`` [m/s^2] is in the root's frame. ``unused`` is what the file says and nothing here holds,
    ``physics`` what of it changes torques;
    ``left_out``: what of it was left out as the user said;
    ``remarks``: what was understood in one of several ways; ``warnings``: what its format does not allow and
    was read all the same, with the places.
    """

    name: str
    format: str
    file: str
    links: tuple[TreeLink, ...]
    joints: tuple[TreeJoint, ...]
    gravity: Vector = (0.0, 0.0, -9.81)
    loops: tuple[Loop, ...] = ()
    unused: tuple[Unused, ...] = ()
    remarks: tuple[str, ...] = ()
    physics: tuple[Physics, ...] = ()
    left_out: tuple[str, ...] = ()
    warnings: tuple[tuple[Place, str], ...] = ()


class Leftovers:
    """Collects what a file says and a reader does not use, each thing with all its lines."""

    def __init__(self, file: str) -> None:
        self._file = file
        self._lines: dict[tuple[str, str], set[int]] = {}
        self.physics: list[Physics] = []

    def add(self, what: str, line: int | None, file: str = "") -> None:
        """Note ``what`` at ``line``."""
        self._lines.setdefault((what, file or self._file), set()).update([line] if line else [])

    def changes_torques(self, name: str, of: str, where: Place) -> None:
        """Note what is of that ``name`` in :data:`PHYSICS`."""
        self.physics.append(Physics(name, of, where))

    def unused(self) -> tuple[Unused, ...]:
        """All of it, in the order in which it was first noted."""
        return tuple(Unused(what, file, tuple(sorted(lines))) for (what, file), lines in self._lines.items())


def names(words: Iterable[str]) -> str:
    """``a, b, c`` and how many more, for a message."""
    listed = [shown(word, TEXT_LENGTH)[1:-1] for word in words]
    more = len(listed) - NAMES_SHOWN
    return ", ".join(listed[:NAMES_SHOWN]) + (f" and {more} more" if more > 0 else "")


def checked(tree: Tree) -> Tree:
    """``tree`` itself: its names are unique, joints name links that are there, and have numbers of joints.

    Raises
    ------
    InputError: they are not, or there are too many.
    """
    if max(len(tree.links), len(tree.joints)) > LINKS:
        raise InputError("too many links or joints", where=Place(tree.file), found=f"more than {LINKS}")
    links = _by_name("link", tree.links)
    _by_name("joint", tree.joints)
    for joint in tree.joints:
        of = f"joint {shown(joint.name)}"
        for role, link in (("parent", joint.parent), ("child", joint.child)):
            if link not in links:
                raise no_such(
                    "link", f"{of}: there is no link of the name of its {role}", link, links, joint.where
                )
        numbers = {"damping": joint.damping, "friction": joint.friction, "rotor inertia": joint.armature}
        for what, value in {**numbers, "reduction": joint.ratio}.items():
            least = 0.0 if what in numbers else -GREATEST
            if value is not None and not least <= value <= GREATEST:
                what = f"{of}: the {what} is {'negative' if value < 0 else 'too large'}"
                expected = f"{least:g} to {GREATEST:g}"
                raise InputError(what, where=joint.where, found=f"{value:g}", expected=expected)
    return tree


def _by_name(what: str, items: Sequence[TreeLink] | Sequence[TreeJoint]) -> dict[str, Place]:
    places: dict[str, Place] = {}
    for item in items:
        if item.name in places:
            what, remedy = f"two {what}s have the same name", f"the first is in line {places[item.name].line}"
            found, expected = shown(item.name), "another name"
            raise InputError(what, where=item.where, found=found, expected=expected, remedy=remedy)
        places[item.name] = item.where
    return places


def no_such(kind: str, what: str, word: str, words: Iterable[str], where: Place) -> InputError:
    """The error that ``what`` is wrong: there is no link or joint, the ``kind``, of the name ``word``."""
    return InputError(what, where=where, found=shown(word), expected=near(word, words, kind))


def near(word: str, words: Iterable[str], what: str) -> str:
    """What was probably meant by ``word``, or what there is, for the "expected" of a message."""
    import difflib

    words = list(words)
    close = difflib.get_close_matches(word[:TEXT_LENGTH], words, 3)
    if close:
        return f"did you mean {' or '.join(map(shown, close))}?"
    return f"one of the {what}s {names(words)}" if words else f"a {what}, and there is none"
