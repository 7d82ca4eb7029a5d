"""Where the joints stand that do not move: as locked, as their leaders, at 0 or at the limit next to it."""

from __future__ import annotations

from collections.abc import Mapping

from robodyn.errors import InputError, Place
from robodyn.formats.limits import NAMES_SHOWN
from robodyn.formats.topology import Topology
from robodyn.formats.tree import MOVING, TreeJoint, names, near
from robodyn.robot.names import shown


class Positions:
    """Positions [rad or m] of the joints of a tree that are locked.

    Raises
    ------
    InputError: a lock names no joint, or a position that the joint cannot take.
    """

    def __init__(self, topology: Topology, locks: Mapping[str, float]) -> None:
        self._topology, self._locks = topology, dict(locks)
        self._joints = {joint.name: joint for joint in topology.tree.joints}
        for name, value in self._locks.items():
            self._check(name, value)
        self._at_root = {joint.name for joint in topology.tree.joints if self._is_at_root(joint)}

    def moves(self, joint: TreeJoint) -> bool:
        """Whether ``joint`` moves unless it is beside the chain: neither fixed nor locked.

        A floating joint at the root holds the base, which does not move here.
        """
        if joint.kind == "fixed" or joint.name in self._at_root or joint.name in self._locks:
            return False
        return joint.mimic is None or not self._is_locked(joint)

    def of(self, joint: TreeJoint) -> float:
        """The position at which ``joint`` is locked."""
        seen: set[str] = set()
        mimics = []
        while joint.name not in self._locks and joint.mimic is not None:
            seen.add(joint.name)
            mimic = joint.mimic
            leader = self._joints.get(mimic.leader)
            if leader is None or leader.name in seen:
                raise InputError(
                    f"joint {shown(joint.name)} follows a joint that "
                    + ("is not there" if leader is None else "follows it"),
                    where=joint.where,
                    found=shown(mimic.leader),
                    expected=near(mimic.leader, (each for each in self._joints if each not in seen), "joint"),
                )
            mimics.append(mimic)
            joint = leader
        position = self._own(joint)
        for mimic in reversed(mimics):
            position = mimic.position(position)
        return position

    def check_in_chain(self, joint: TreeJoint, chain: set[str]) -> None:
        """Refuse a joint that cannot be one of the chain's, whose names are ``chain``."""
        if joint.kind not in MOVING:
            raise InputError(
                f"the joint {shown(joint.name)} of the chain is {joint.kind}",
                where=joint.where,
                expected="revolute, continuous or prismatic joints",
                remedy=f"choose a --base behind it, or fix it with --lock {joint.name}=0",
            )
        if joint.mimic is not None:
            self.of(joint)  # says so where what it follows is not there
            leader = joint.mimic.leader
            both = "both are in the chain, and have" if leader in chain else "the two have"
            raise InputError(
                f"the joint {shown(joint.name)} of the chain follows the joint {shown(leader)}",
                where=joint.where,
                found=f"one motion of two joints: {both} one torque, which depends on the inertia of both",
                expected="joints that move by themselves, each with a torque of its own",
                remedy=f"fix it with --lock {joint.name}=VALUE, or choose a --tip before it",
            )

    def remarks(self, carrier: Mapping[str, int], chain: set[str]) -> list[str]:
        """What was locked, and where; ``carrier``: the joint of the chain that carries a link, 0 the base."""
        remarks, locked, followers = [], [], []
        for joint in self._topology.tree.joints:
            if joint.name in self._at_root:
                remarks.append(f"the base is fixed: {joint.name} is a {joint.kind} joint at the root")
            elif joint.kind != "fixed" and joint.name not in chain and carrier.get(joint.child, 0):
                locked.append(f"{joint.name} at {self.of(joint):g}")
                if joint.mimic and joint.mimic.leader in chain:
                    followers.append(f"{joint.name} ({joint.mimic.leader})")
        if followers:
            remarks.append(
                f"locked here, though they follow a joint of the chain: {names(followers, NAMES_SHOWN)}"
            )
        if locked:
            remarks.insert(
                0, f"locked, and lumped into the links that carry them: {names(locked, NAMES_SHOWN)}"
            )
        return remarks

    def _own(self, joint: TreeJoint) -> float:
        if joint.name in self._locks:
            return self._locks[joint.name]
        lower, upper = joint.limits.lower, joint.limits.upper
        if lower is not None and lower > 0:
            return lower
        if upper is not None and upper < 0:
            return upper
        return 0.0

    def _check(self, name: str, value: float) -> None:
        joint = self._joints.get(name)
        if joint is None:
            raise InputError(
                "there is no joint of the name after --lock",
                where=Place(self._topology.tree.file),
                found=shown(name),
                expected=near(name, self._joints, "joint"),
            )
        lower, upper = joint.limits.lower, joint.limits.upper
        outside = (lower is not None and value < lower) or (upper is not None and value > upper)
        if joint.kind not in MOVING:
            outside = value != 0
            lower = upper = 0.0
        if outside:
            unit = "m" if joint.kind == "prismatic" else "rad"
            ends = ("-inf" if lower is None else f"{lower:g}", "inf" if upper is None else f"{upper:g}")
            raise InputError(
                f"the joint {shown(name)}, {joint.kind}, cannot be locked there",
                where=joint.where,
                found=f"--lock {name}={value:g}",
                expected=f"{' to '.join(ends)} {unit}" if joint.kind in MOVING else "0",
            )

    def _is_locked(self, joint: TreeJoint) -> bool:
        """Whether the joint that ``joint`` follows, directly or through others, is locked."""
        seen = set()
        while joint.mimic is not None and joint.name not in seen:
            seen.add(joint.name)
            if joint.mimic.leader in self._locks:
                return True
            joint = self._joints.get(joint.mimic.leader, joint)
        return joint.kind == "fixed"

    def _is_at_root(self, joint: TreeJoint) -> bool:
        """Whether ``joint`` is a floating one with nothing that moves above it."""
        if joint.kind != "floating":
            return False
        return all(above.kind == "fixed" for above in self._topology.path(joint.parent))
