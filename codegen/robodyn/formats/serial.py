"""A serial chain out of a tree: fixed joints merged, branches locked and lumped into what carries them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from robodyn.errors import InputError, Place
from robodyn.formats.chain import Chain, ChainJoint, Pose
from robodyn.formats.conversion import joint_of, title_of
from robodyn.formats.limits import NAMES_SHOWN
from robodyn.formats.positions import Positions
from robodyn.formats.rigid import carried, composed, lumped, motion
from robodyn.formats.topology import Topology
from robodyn.formats.tree import MOVING, Tree, TreeJoint, names
from robodyn.robot.keys import LINKS
from robodyn.robot.names import shown
from robodyn.robot.origins import Origin


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
