"""A serial chain out of a tree: fixed joints merged, branches locked and lumped into what carries them.

Joints that do not move stand as locked, as their leaders, at 0 or at the limit next to it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from robodyn.errors import InputError, Place
from robodyn.formats.chain import Chain, ChainJoint, Pose
from robodyn.formats.conversion import joint_of, title_of
from robodyn.formats.limits import NAMES_SHOWN
from robodyn.formats.rigid import carried, composed, lumped, motion
from robodyn.formats.topology import Topology
from robodyn.formats.tree import MOVING, Tree, TreeJoint, names, near
from robodyn.robot.account import Origin
from robodyn.robot.keys import LINKS
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


@dataclass(frozen=True, slots=True)
class Serial:
    """A chain, the places of the links behind its joints, and what was decided on the way to it."""

    chain: Chain
    places: tuple[Place, ...]
    remarks: tuple[str, ...]


def serial_chain(
    tree: Tree, name: str, base: str = "", tip: str = "", locks: Mapping[str, float] | None = None
) -> Serial:
    """The chain of moving joints from the link ``base`` to the link ``tip``; the robot is called ``name``.

    By default the base is the root, and the tip the only one that there is. ``locks``: positions [rad or m]
    of joints that do not move. Any other joint beside the chain is locked at 0, or at the limit next to 0.

    Raises
    ------
    InputError: there are several tips or roots, a link or joint is not there, or a joint of the chain is of
        another kind, follows another joint, or is in a closed loop.
    """
    topology = Topology(tree)
    positions = Positions(topology, locks or {})
    start = topology.link(base, "--base").name if base else topology.base()
    remarks = list(tree.remarks)
    if tip:
        end = topology.link(tip, "--tip").name
    else:
        only = topology.tip(
            start, positions.moves, lambda joint: joint.kind in MOVING and joint.mimic is None
        )
        end = only.link
        if only.others:
            remarks.append(
                f"the tool frame is that of {end}; --tip chooses another: {names(only.others, NAMES_SHOWN)}"
            )
    path = _path(topology, start, end)
    moving = [joint for joint in path if positions.moves(joint)]
    for joint in moving:
        positions.check_in_chain(joint, {each.name for each in moving})
    if not 1 <= len(moving) <= LINKS:
        raise InputError(
            f"between {shown(start)} and {shown(end)} {'nothing moves' if not moving else 'too much moves'}",
            where=topology.links[end].where,
            found=f"{len(moving)} moving joints",
            expected=f"1 to {LINKS}",
        )
    frames = _Frames(topology, positions, start, moving)
    _check_loops(tree, frames)
    joints: list[ChainJoint] = []
    left_out: dict[str, list[str]] = {}
    for index, joint in enumerate(moving, 1):
        converted, unlike = joint_of(joint)
        for remark in unlike:
            left_out.setdefault(remark, []).append(joint.name)
        pose = composed(frames.pose[joint.parent], composed(joint.origin, motion(joint, 0.0)))
        converted = replace(frames.with_body(converted, index), pose=pose)
        where = topology.links[joint.child].where
        joints.append(replace(converted, origins=replace(converted.origins, where=where)))
    remarks += [f"{remark}: {names(of, NAMES_SHOWN)}" for remark, of in left_out.items()]
    remarks += frames.massless()
    remarks += positions.remarks(frames.carrier, {joint.name for joint in moving})
    pose = Pose()
    for joint in topology.path(start):
        step = motion(joint, positions.of(joint))
        pose = composed(composed(composed(pose, joint.origin), step), joint.child_pose)
    chain = Chain(
        name,
        tuple(joints),
        title_of(tree, start, end),
        title_of(tree),
        tree.gravity,
        base=pose,
        tool=frames.pose[end],
    )
    places = tuple(topology.links[joint.child].where for joint in moving)
    return Serial(chain, places, tuple(dict.fromkeys(remarks)))


def _path(topology: Topology, start: str, end: str) -> list[TreeJoint]:
    """The joints from ``start`` down to ``end``."""
    path = topology.path(end)
    above = [joint.parent for joint in path] + [end]
    if start not in above:
        raise InputError(
            f"the link {shown(end)} does not hang on the link {shown(start)}",
            where=topology.links[end].where,
            found=f"the path {names(above, NAMES_SHOWN)}",
            expected="a tip below the base",
            remedy="choose another --base or --tip",
        )
    return path[above.index(start) :]


class _Frames:
    """Links in the frames of the chain's joints that carry them: ``carrier`` 0 is the base, i the i-th joint.

    ``pose`` is that of a link in its carrier's frame.
    """

    def __init__(self, topology: Topology, positions: Positions, base: str, moving: list[TreeJoint]) -> None:
        self._topology, self._moving = topology, moving
        index = {joint.name: i for i, joint in enumerate(moving, 1)}
        self.carrier, self.pose = {base: 0}, {base: Pose()}
        for joint in topology.joints_below(base):
            if joint.name in index:
                self.carrier[joint.child] = index[joint.name]
                self.pose[joint.child] = joint.child_pose
            else:
                step = composed(joint.origin, motion(joint, positions.of(joint)))
                self.carrier[joint.child] = self.carrier[joint.parent]
                self.pose[joint.child] = composed(self.pose[joint.parent], composed(step, joint.child_pose))

    def with_body(self, joint: ChainJoint, index: int) -> ChainJoint:
        """``joint``, the one of that ``index``, with what it carries before the next one as one body.

        One that is partly assumed is assumed. Links without inertia have an unknown one, but for a mere frame
        between two joints, such as makes a universal joint of them.
        """
        links = [self._topology.links[name] for name, i in self.carrier.items() if i == index]
        # What is partly left to meshes is unknown as a whole.
        bodies = [] if any(link.unread for link in links) else [link for link in links if link.body]
        body = lumped(carried(self.pose[link.name], link.body) for link in bodies if link.body)
        origin: Origin = "assumed" if any(link.assumed for link in bodies) else "stated"
        absent: Origin = "absent"
        if not bodies:
            between = index < len(self._moving) and not any(link.shape for link in links)
            origins = replace(joint.origins, mass=absent, com=absent, inertia=absent, unknown=not between)
            return replace(joint, origins=origins)
        origins = replace(joint.origins, mass=origin, com=origin, inertia=origin)
        if any(link.is_point for link in bodies):
            origins = replace(origins, inertia=absent, unknown=True)
        return replace(joint, body=body, origins=origins)

    def massless(self) -> list[str]:
        """Which links that move have no inertia in the file though they are more than frames, and which
        joints carry nothing at all."""
        links = [self._topology.links[name] for name, index in self.carrier.items() if index]
        remarks = []
        without = [link.name for link in links if link.body is None and link.shape]
        if without:
            remarks.append(f"links without inertia, and so without mass: {names(without, NAMES_SHOWN)}")
        points = [link.name for link in links if link.is_point]
        if points:
            remarks.append(f"links with a mass and no inertia: {names(points, NAMES_SHOWN)}")
        loaded = {self.carrier[link.name] for link in links if link.body}
        bare = [joint.name for index, joint in enumerate(self._moving, 1) if index not in loaded]
        if bare:
            remarks.append(f"joints that carry no mass: {names(bare, NAMES_SHOWN)}")
        return remarks


def _check_loops(tree: Tree, frames: _Frames) -> None:
    """Refuse what ties links together that move apart."""
    for loop in tree.loops:
        one, other = (frames.carrier.get(link, 0) for link in loop.links)
        if one != other:
            raise InputError(
                f"{loop.what} closes a loop through the chain",
                where=loop.where,
                found=f"it ties {shown(loop.links[0])} to {shown(loop.links[1])}",
                expected="a tree: robodyn has no closed loops",
                remedy="delete it, or choose a --tip before the loop",
            )
