"""A serial chain out of a tree: fixed joints merged, branches locked and lumped into what carries them.

Joints that do not move stand as locked, as their leaders, at 0 or at the limit next to it. Joints of the
chain that follow others of it are its couplings.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import PurePath

from robodyn.errors import InputError, Place
from robodyn.formats.chain import Chain, ChainJoint, Pose, composed, lumped, moved
from robodyn.formats.conversion import joint_of, printable
from robodyn.formats.topology import Topology
from robodyn.formats.tree import MOVING, Tree, TreeJoint, names, no_such
from robodyn.robot.account import Origin
from robodyn.robot.keys import LINKS
from robodyn.robot.names import TEXT_LENGTH, shown
from robodyn.robot.numbers import shortest
from robodyn.robot.parts import Coupling


class Positions:
    """Positions [rad or m] of the joints of a tree that are locked.

    Raises
    ------
    InputError: a lock names no joint, or a position that the joint cannot take.
    """

    def __init__(self, topology: Topology, locks: Mapping[str, float]) -> None:
        self._topology, self._locks = topology, locks
        self._joints = {joint.name: joint for joint in topology.tree.joints}
        for name, value in locks.items():
            self._check_lock(name, value)
        self._at_root = {
            joint.name
            for joint in topology.tree.joints
            if joint.kind == "floating"
            and all(above.kind == "fixed" for above in topology.path(joint.parent))
        }

    def moves(self, joint: TreeJoint) -> bool:
        """Whether ``joint`` moves unless it is beside the chain: neither fixed nor locked.

        A floating joint at the root holds the base, which does not move here.
        """
        if joint.kind == "fixed" or joint.name in self._at_root or joint.name in self._locks:
            return False
        seen = set()
        while joint.mimic is not None and joint.name not in seen:
            seen.add(joint.name)
            if joint.mimic.leader in self._locks or joint.mimic.stands:
                return False
            joint = self._joints.get(joint.mimic.leader, joint)
        return joint.kind != "fixed"

    def is_of_chains(self, joint: TreeJoint) -> bool:
        """Whether a chain may go through ``joint``: what it follows is above or below it."""
        if joint.kind not in MOVING or joint.mimic is None:
            return joint.kind in MOVING
        leader = self._joints.get(joint.mimic.leader)
        return leader is not None and (
            leader in self._topology.path(joint.parent) or joint in self._topology.path(leader.parent)
        )

    def of(self, joint: TreeJoint) -> float:
        """The position at which ``joint`` is locked."""
        followers: list[TreeJoint] = []
        while joint.name not in self._locks and joint.mimic is not None:
            followers.append(joint)
            seen = {each.name for each in followers}
            leader = self._joints.get(joint.mimic.leader)
            if leader is None or leader.name in seen:
                how = "is not there" if leader is None else "follows it"
                what = f"joint {shown(joint.name)} follows a joint that {how}"
                others = (name for name in self._joints if name not in seen)
                raise no_such("joint", what, joint.mimic.leader, others, joint.where)
            joint = leader
        lower, upper = joint.limits.lower or 0.0, joint.limits.upper or 0.0
        position = self._locks.get(joint.name, lower if lower > 0 else min(upper, 0.0))
        for follower in reversed(followers):
            assert follower.mimic is not None
            position = follower.mimic.position(position)
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
            if leader in chain and not any(joint.mimic.curve):
                return
            found = f"powers of {shown(leader)} in what it follows: no constant ratio"
            if leader not in chain:
                found = f"{shown(leader)} beside the chain, whose inertia moves with this joint"
            raise InputError(
                f"the joint {shown(joint.name)} of the chain follows the joint {shown(leader)}",
                where=joint.where,
                found=found,
                expected="joints that move by themselves, or follow others of the chain by a constant ratio",
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
            remarks.append(f"locked here, though they follow a joint of the chain: {names(followers)}")
        if locked:
            remarks.insert(0, f"locked, and lumped into the links that carry them: {names(locked)}")
        return remarks

    def _check_lock(self, name: str, value: float) -> None:
        joint = self._joints.get(name)
        if joint is None:
            what, where = "there is no joint of the name after --lock", Place(self._topology.tree.file)
            raise no_such("joint", what, name, self._joints, where)
        lower, upper = joint.limits.lower, joint.limits.upper
        unit = " m" if joint.kind == "prismatic" else " rad"
        if joint.kind not in MOVING:
            lower, upper, unit = 0.0, 0.0, ""
        if (lower is not None and value < lower) or (upper is not None and value > upper):
            ends = ("-inf" if lower is None else f"{lower:g}", "inf" if upper is None else f"{upper:g}")
            raise InputError(
                f"the joint {shown(name)}, {joint.kind}, cannot be locked there",
                where=joint.where,
                found=f"--lock {name}={value:g}",
                expected=" to ".join(ends if unit else ["0"]) + unit,
            )


@dataclass(frozen=True, slots=True)
class Serial:
    """A chain, and what was decided on the way to it."""

    chain: Chain
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
        another kind, follows one beside it or by a curve, or is in a closed loop.
    """
    topology = Topology(tree)
    positions = Positions(topology, locks or {})
    start = topology.chosen_link(base, "--base") if base else topology.base()
    remarks = list(tree.remarks)
    if tip:
        end = topology.chosen_link(tip, "--tip")
    else:
        end, others = topology.tip(start, positions.moves, positions.is_of_chains)
        if others:
            remarks.append(f"the tool frame is that of {end}; --tip chooses another: {names(others)}")
    moving = [joint for joint in topology.path_between(start, end) if positions.moves(joint)]
    in_chain = {joint.name for joint in moving}
    for joint in moving:
        positions.check_in_chain(joint, in_chain)
    if not 1 <= len(moving) <= LINKS:
        raise InputError(
            f"between {shown(start)} and {shown(end)} {'nothing moves' if not moving else 'too much moves'}",
            where=topology.links[end].where,
            found=f"{len(moving)} moving joints",
            expected=f"1 to {LINKS}",
        )
    frames = _Frames(topology, positions, start, moving)
    joints: list[ChainJoint] = []
    left_out: dict[str, list[str]] = {}
    for index, joint in enumerate(moving, 1):
        converted, unlike = joint_of(joint)
        for remark in unlike:
            left_out.setdefault(remark, []).append(joint.name)
        pose = composed(frames.pose[joint.parent], composed(joint.origin, joint.motion(0.0)))
        converted = replace(frames.with_body(converted, index), pose=pose)
        where = topology.links[joint.child].where
        joints.append(replace(converted, origins=replace(converted.origins, where=where)))
    remarks += [f"{remark}: {names(of)}" for remark, of in left_out.items()]
    remarks += frames.massless()
    remarks += positions.remarks(frames.carrier, in_chain)
    couplings = _couplings(moving)
    if couplings:
        pairs = (f"{moving[x.joint - 1].name} ({moving[x.of - 1].name})" for x in couplings)
        remarks.append(f"follow others, and have no torque of their own: {names(pairs)}")
    pose = Pose()
    for joint in topology.path(start):
        pose = composed(
            composed(composed(pose, joint.origin), joint.motion(positions.of(joint))), joint.child_pose
        )
    title, source = f"{tree.name or 'robot'}, {start} to {end}", f"{PurePath(tree.file).name} ({tree.format})"
    title, source = (printable(text)[:TEXT_LENGTH] for text in (title, source))
    chain = Chain(name, tuple(joints), title, source, tree.gravity, pose, frames.pose[end], couplings)
    return Serial(chain, tuple(dict.fromkeys(remarks)))


def _couplings(moving: Sequence[TreeJoint]) -> tuple[Coupling, ...]:
    """How joints of the chain follow others of it."""
    numbers = {joint.name: i for i, joint in enumerate(moving, 1)}
    return tuple(
        Coupling(i, numbers[mimic.leader], shortest(mimic.multiplier), shortest(mimic.offset))
        for i, mimic in enumerate((joint.mimic for joint in moving), 1)
        if mimic is not None
    )


class _Frames:
    """Links in the frames of the chain's joints that carry them: ``carrier`` 0 is the base, i the i-th joint.

    ``pose`` is that of a link in its carrier's frame.

    Raises
    ------
    InputError: something ties links together that move apart.
    """

    def __init__(self, topology: Topology, positions: Positions, base: str, moving: list[TreeJoint]) -> None:
        self._links, self._moving = topology.links, moving
        index = {joint.name: i for i, joint in enumerate(moving, 1)}
        self.carrier, self.pose = {base: 0}, {base: Pose()}
        for joint in topology.joints_below(base):
            if joint.name in index:
                self.carrier[joint.child] = index[joint.name]
                self.pose[joint.child] = joint.child_pose
            else:
                step = composed(joint.origin, joint.motion(positions.of(joint)))
                self.carrier[joint.child] = self.carrier[joint.parent]
                self.pose[joint.child] = composed(self.pose[joint.parent], composed(step, joint.child_pose))
        for loop in topology.tree.loops:
            if len({self.carrier.get(link, 0) for link in loop.links}) > 1:
                raise InputError(
                    f"{loop.what} closes a loop through the chain",
                    where=loop.where,
                    found=f"it ties {shown(loop.links[0])} to {shown(loop.links[1])}",
                    expected="a tree: robodyn has no closed loops",
                    remedy="delete it, or choose a --tip before the loop",
                )

    def with_body(self, joint: ChainJoint, index: int) -> ChainJoint:
        """``joint``, the one of that ``index``, with what it carries before the next one as one body.

        One that is partly assumed is assumed. Links without inertia have an unknown one, but for a mere frame
        between two joints, such as makes a universal joint of them.
        """
        links = [self._links[name] for name, i in self.carrier.items() if i == index]
        # What is partly left to meshes is unknown as a whole.
        bodies = [] if any(link.unread for link in links) else [link for link in links if link.body]
        origin: Origin = "assumed" if any(link.assumed for link in bodies) else "stated"
        unknown = any(link.is_point for link in bodies)
        if not bodies:
            origin, unknown = "absent", index == len(self._moving) or any(link.shape for link in links)
        inertia: Origin = "absent" if unknown else origin
        origins = replace(joint.origins, mass=origin, com=origin, inertia=inertia, unknown=unknown)
        body = lumped(moved(self.pose[link.name], link.body) for link in bodies if link.body)
        return replace(joint, body=body, origins=origins)

    def massless(self) -> list[str]:
        """Which links that move have no inertia in the file though they are more than frames, and which
        joints carry nothing at all."""
        links = [self._links[name] for name, index in self.carrier.items() if index]
        loaded = {self.carrier[link.name] for link in links if link.body}
        without = {
            "links without inertia, and so without mass": [
                x.name for x in links if x.body is None and x.shape
            ],
            "links with a mass and no inertia": [link.name for link in links if link.is_point],
            "joints that carry no mass": [x.name for i, x in enumerate(self._moving, 1) if i not in loaded],
        }
        return [f"{words}: {names(of)}" for words, of in without.items() if of]
