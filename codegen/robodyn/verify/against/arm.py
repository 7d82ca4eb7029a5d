"""An arm as another library reads it out of a file: what it has to say to be compared with."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import PurePath
from typing import Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.formats.tree import names as names_shown
from robodyn.formats.tree import near
from robodyn.robot.model import Robot
from robodyn.robot.names import shown

#: Begins what a joint is called that has no name in the file.
NAMELESS: Final = "joint without a name "


@dataclass(frozen=True, slots=True)
class Follower:
    """A joint that follows the joint ``leader``: ``q = polynomial(q_leader)``, lowest power first."""

    leader: str
    polynomial: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Resting:
    """Where the joints of a file stand that the robot does not have.

    A joint stands where it is locked, where its leader puts it, else at 0 or at the limit next to 0:
    docs/import.md says so of what ``robodyn import`` lumps. ``ranges``: lower and upper limits [rad or m] of
    all joints that move in one direction; infinite where there are none.
    """

    ranges: Mapping[str, tuple[float, float]]
    followers: Mapping[str, Follower] = field(default_factory=dict)
    locks: Mapping[str, float] = field(default_factory=dict)

    def position(self, joint: str, behind: frozenset[str] = frozenset()) -> float:
        """The position [rad or m] of ``joint``; ``behind``: those that follow it."""
        if joint in self.locks:
            return self.locks[joint]
        follower = self.followers.get(joint)
        if follower is not None and follower.leader not in behind:
            leader = self.position(follower.leader, behind | {joint})
            return sum(c * leader**power for power, c in enumerate(follower.polynomial))
        lower, upper = self.ranges.get(joint, (-np.inf, np.inf))
        return max(lower, 0.0) if lower > 0 else min(upper, 0.0)


@dataclass(frozen=True, slots=True)
class Frames:
    """Frames ``[R p]`` in the file's root frame at N states: ``links`` ``[N, 3, 4]`` of the bodies behind the
    joints, None where the library has none, and by name those of what hangs on the last joint."""

    links: Sequence[Floats | None]
    tips: Mapping[str, Floats]


class PeerArm(ABC):
    """The joints of a robot in a file that another library has read.

    Attributes
    ----------
    title: the library, its version and the file.
    joints: names of the joints in the file, base to tip.
    springs, rotors: whether the library reads springs and rotor inertias of joints out of such a file.
    gears: by joint (from 0) the gear ratios that it reads.
    not_compared: what of the file has no part in the comparison, and why.
    """

    title: str
    joints: tuple[str, ...]
    springs: bool
    rotors: bool
    gears: Mapping[int, float]
    not_compared: dict[str, str]

    @abstractmethod
    def torques(self, q: Floats, qd: Floats, qdd: Floats) -> Floats:
        """Torques ``[N, n]`` [N m or N] at states ``[N, n]``; all other joints stand still."""

    @abstractmethod
    def mass_matrix(self, q: Floats) -> Floats:
        """``[N, n, n]``, rotors included as far as the library knows of them."""

    @abstractmethod
    def frames(self, q: Floats) -> Frames:
        """The frames at positions ``[N, n]``."""


def joints_in_file(
    robot: Robot, joints: Iterable[str], locks: Mapping[str, float], file: str
) -> tuple[str, ...]:
    """The names in the file of the joints of ``robot``, whose links are called like them. In the order of the
    file come those without a name (:data:`NAMELESS`), and all of them where no name is the same, if there
    are as many.

    Raises
    ------
    InputError: a joint, or one of those in ``locks``, is not there.
    """
    names, there = [link.name for link in robot.links], list(joints)
    for name in locks:
        if name not in there:
            raise InputError(
                "there is no joint of the name after --lock",
                where=Place(file),
                found=shown(name),
                expected=near(name, there, "joint"),
            )
    missing = [name for name in names if name not in there]
    nameless = [name for name in there if name.startswith(NAMELESS)]
    in_order = there if len(missing) == len(names) == len(there) else nameless
    if not missing or len(missing) == len(in_order):
        others = iter(in_order)
        return tuple(name if name in there else next(others) for name in names)
    raise InputError(
        f"the file has no joint {shown(missing[0])}, which {robot.name} has",
        where=Place(file),
        found=names_shown(there),
        expected=f"the {robot.n} joints of {robot.name}, matched by name, or as many joints as it has",
        remedy=f"name the links of {robot.name} as the file names its joints",
    )


def title_of(library: str, version: str, path: str) -> str:
    """``MuJoCo 3.3.4 reading arm.xml``."""
    return f"{library} {version} reading {PurePath(path).name}"
