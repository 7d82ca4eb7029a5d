"""What differs between two robots, whatever files they come from, and by how much they move differently.

Joints correspond by their order. Frames of links may be chosen differently for the same arm, so that bodies
are compared where they are in the world when all joints are at zero, and axes as lines.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.compare import SEED, STATES, TOLERANCE
from robodyn.errors import InputError
from robodyn.formats.chain import Pose
from robodyn.formats.writers.parts import Frame, PartJoint, Parts, parts_of
from robodyn.kernels.robot_kernel import count
from robodyn.robot.coupling import followers
from robodyn.robot.masses import unknown_masses
from robodyn.robot.model import Robot
from robodyn.robot.names import shown
from robodyn.robot.values import Affine
from robodyn.verify.numbers import Parameters
from robodyn.verify.reference import Reference
from robodyn.verify.sample import Sample, draw, draw_parameters

Array = NDArray[np.float64]
#: Kinds of differences, in the order in which they are listed.
GROUPS: Final = (
    "joints", "names", "couplings", "parameters", "gravity", "axes", "links", "rotors", "friction",
    "effects", "limits", "tool", "torques",
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Difference:
    """What differs: of which ``group``, ``where`` (a joint; "" for the robot), in ``what``. ``left`` and
    ``right`` are what the two robots say, None where they say nothing; ``by``: how far apart they are, in
    ``unit``, None for what is no number."""

    group: str
    where: str
    what: str
    left: Any
    right: Any
    by: float | None = None
    unit: str = ""


@dataclass(frozen=True, slots=True)
class Comparison:
    """Two robots beside each other.

    ``torques``: the largest difference of inverse dynamics of each joint [N m or N], None where they cannot
    be compared; ``largest``: the largest torque of the first [N m or N]; ``tool``: the largest distance [m]
    and angle [rad] between their tool frames; ``operations`` of their inverse dynamics, None where one has
    unknown masses; ``not_compared``: those, and what was left out of the files although it changes torques.
    """

    names: tuple[str, str]
    differences: tuple[Difference, ...]
    operations: tuple[int, int] | None
    torques: tuple[float, ...] | None
    largest: float
    tool: tuple[float, float] | None
    not_compared: tuple[str, ...] = ()

    @property
    def same(self) -> bool:
        """Whether nothing differs."""
        return not self.differences

    @property
    def share(self) -> float | None:
        """The largest difference of torques as a share of the largest torque."""
        if self.torques is None:
            return None
        worst = max(self.torques)
        return worst / self.largest if self.largest else float(worst > 0)

    def to_dict(self) -> dict[str, Any]:
        """As ``robodyn diff --json`` prints it."""
        tool = None if self.tool is None else dict(zip(("distance", "angle"), self.tool, strict=True))
        torques = None
        if self.torques is not None:
            torques = {"share": self.share, "largest": self.largest, "joints": list(self.torques)}
        return {
            "robots": list(self.names),
            "same": self.same,
            "differences": [{**asdict(each), "where": each.where or None} for each in self.differences],
            "torques": torques,
            "tool": tool,
            "operations": None if self.operations is None else list(self.operations),
            "not_compared": list(self.not_compared),
        }


def compare(
    left: Robot,
    right: Robot,
    *,
    tolerance: float = TOLERANCE,
    ignore: Iterable[str] = (),
    parameters: Mapping[str, float] | None = None,
    states: int = STATES,
) -> Comparison:
    """``left`` beside ``right``; what is within ``tolerance``, and groups to ``ignore``, are no differences.
    Where joints follow others, torques are those of all joints, each moving by itself.

    ``parameters``: values of the run-time parameters of both; without them they are random.

    Raises
    ------
    InputError: a group is unknown, or a run-time parameter has no value, or one that is not allowed.
    """
    ignored = set(ignore)
    if wrong := sorted(ignored.difference(GROUPS)):
        what = "nothing of this name is compared"
        raise InputError(what, found=shown(wrong[0]), expected=", ".join(GROUPS))
    listed = list(_of_lists(left, right))
    arms = [_filled(robot.free, parameters) for robot in (left, right)]
    torques, largest, tool = None, 0.0, None
    unknown = [f"torques: {arm.name} has masses that nobody states" for arm in arms if unknown_masses(arm)]
    if left.n == right.n:
        pair = _Pair(arms[0], arms[1], tolerance)
        listed += pair.differences()
        sample = draw(arms[0], states, SEED, np.dtype(float))
        if not unknown:
            torques, largest, of_torques = pair.torques(sample)
            listed += of_torques
        tool, of_tools = pair.tool(sample.q)
        listed += of_tools
    by_group = [difference for group in GROUPS for difference in listed if difference.group == group]
    return Comparison(
        (left.name, right.name),
        tuple(difference for difference in by_group if difference.group not in ignored),
        None if unknown else (count(left).total, count(right).total),
        torques,
        largest,
        tool,
        (*(text for arm in arms if arm.account for text in arm.account.physics_left_out()), *unknown),
    )


def _filled(robot: Robot, parameters: Parameters | None) -> Robot:
    own = {name: value for name, value in (parameters or {}).items() if name in robot.parameters}
    values = draw_parameters(robot, own or None, SEED, np.dtype(float))
    return robot.at(values) if robot.parameters else robot


def _of_lists(left: Robot, right: Robot) -> Iterator[Difference]:
    """What differs in number, names and kinds."""
    if left.n != right.n:
        yield Difference("joints", "", "number of joints", left.n, right.n, float(abs(left.n - right.n)))
    for one, other in zip(left.links, right.links, strict=False):
        if one.joint.kind != other.joint.kind:
            yield Difference("joints", one.name, "kind", one.joint.kind, other.joint.kind)
        if one.name != other.name:
            yield Difference("names", one.name, "name", one.name, other.name)
    followed = [followers(robot) for robot in (left, right)]
    for name in dict.fromkeys(name for each in followed for name in each):
        one_text, other_text = (each.get(name) for each in followed)
        if one_text != other_text:
            yield Difference("couplings", name, "follows", one_text, other_text)
    if left.name != right.name:
        yield Difference("names", "", "name of the robot", left.name, right.name)
    if left.parameters != right.parameters:
        yield Difference(
            "parameters", "", "run-time parameters", ", ".join(left.parameters), ", ".join(right.parameters)
        )


class _Pair:
    """Two robots with as many joints and without run-time parameters."""

    def __init__(self, left: Robot, right: Robot, tolerance: float) -> None:
        self._robots, self._tolerance = (left, right), tolerance
        self._parts = parts_of(left), parts_of(right)
        self._size = max(parts.size for parts in self._parts) or 1.0
        self._names = [link.name for link in left.links]

    def differences(self) -> Iterator[Difference]:
        """What differs in the numbers of the descriptions."""
        one, other = self._parts
        yield from self._numbers("gravity", "", "gravity", (one.gravity, other.gravity), "m/s^2")
        rest = np.zeros(len(self._names))
        frames = [_frames(parts, rest) for parts in self._parts]
        mass = max(joint.body.mass for parts in self._parts for joint in parts.joints)
        moment = max(sum(joint.body.inertia[:3]) for parts in self._parts for joint in parts.joints)
        rows = zip(self._names, one.joints, other.joints, *frames, strict=True)
        for name, joint, twin, frame, counterpart in rows:
            yield from self._axis(name, joint, frame, counterpart)
            masses = (joint.body.mass, twin.body.mass)
            yield from self._numbers("links", name, "mass", masses, "kg", mass)
            com, tensor = _in_world(joint, frame)
            centre, moments = _in_world(twin, counterpart)
            if all(masses):
                yield from self._numbers("links", name, "centre of mass", (com, centre), "m", self._size)
            yield from self._numbers("links", name, "inertia", (tensor, moments), "kg m^2", moment)
            yield from self._drive(name, joint, twin)
            yield from self._limits(name, joint, twin)
        yield from self._effects()

    def _axis(self, name: str, joint: PartJoint, frame: Array, twin: Array) -> Iterator[Difference]:
        z, other = frame[:3, 2], twin[:3, 2]
        angle = float(np.arctan2(np.linalg.norm(np.cross(z, other)), z @ other))
        if angle > self._tolerance:
            yield Difference("axes", name, "direction of the axis", z.tolist(), other.tolist(), angle, "rad")
        apart = float(np.linalg.norm(np.cross(frame[:3, 3] - twin[:3, 3], other)))
        if joint.kind == "revolute" and apart > self._tolerance * self._size:
            here, there = frame[:3, 3].tolist(), twin[:3, 3].tolist()
            yield Difference("axes", name, "place of the axis", here, there, apart, "m")

    def _drive(self, name: str, joint: PartJoint, twin: PartJoint) -> Iterator[Difference]:
        mass, rate, force = (
            ("kg m^2", "N m s/rad", "N m") if joint.kind == "revolute" else ("kg", "N s/m", "N")
        )
        one, other = (None if each.gear is None else float(each.gear.ratio) for each in (joint, twin))
        rotors = (joint.motor_inertia, twin.motor_inertia)
        yield from self._numbers("rotors", name, "motor inertia", rotors, mass)
        yield from self._numbers("rotors", name, "gear ratio", (one, other), "")
        yield from self._numbers("friction", name, "viscous", (joint.viscous, twin.viscous), rate)
        yield from self._numbers("friction", name, "coulomb", (joint.coulomb, twin.coulomb), force)

    def _limits(self, name: str, joint: PartJoint, twin: PartJoint) -> Iterator[Difference]:
        unit, force = ("rad", "N m") if joint.kind == "revolute" else ("m", "N")
        units = {"position": unit, "velocity": f"{unit}/s", "acceleration": f"{unit}/s^2", "torque": force}
        for what, of in units.items():
            ends = tuple(_plain(getattr(each.limits, what)) for each in (joint, twin))
            yield from self._numbers("limits", name, what, ends, of)

    def _effects(self) -> Iterator[Difference]:
        """Effects beside those that are bodies in a link, entry by entry; and how friction is at rest."""
        left, right = (
            {
                (entry.effect, entry.joint): {name: _plain(setting) for name, setting in entry.settings}
                for entry in robot.effects
                if not entry.definition.traits.body
            }
            for robot in self._robots
        )
        for effect, joint in dict.fromkeys([*left, *right]):
            where = "" if joint is None else self._names[joint - 1]
            one, other = left.get((effect, joint)), right.get((effect, joint))
            if one != other:
                yield Difference("effects", where, effect, one, other)
        for what in ("torque_side", "rest_velocity", "dead_band"):
            one, other = (getattr(robot, what) for robot in self._robots)
            if one != other:
                yield Difference("effects", "", what, _plain(one), _plain(other))

    def torques(self, sample: Sample) -> tuple[tuple[float, ...], float, list[Difference]]:
        """Largest differences of torques, the largest torque, and which of them count."""
        states = (sample.q, sample.qd, sample.qdd)
        tau, other = (Reference(robot).inverse_dynamics(*states) for robot in self._robots)
        apart, largest = abs(tau - other).max(axis=0), float(abs(tau).max())
        differences, worst = [], int(apart.argmax())
        if apart[worst] > self._tolerance * max(largest, float(abs(other).max())):
            state = int(abs(tau - other)[:, worst].argmax())
            unit = "N m" if self._robots[0].links[worst].joint.kind == "revolute" else "N"
            sides = float(tau[state, worst]), float(other[state, worst]), float(apart[worst])
            differences.append(Difference("torques", self._names[worst], "torque", *sides, unit))
        return tuple(map(float, apart)), largest, differences

    def tool(self, q: Array) -> tuple[tuple[float, float], list[Difference]]:
        """Largest distance [m] and angle [rad] of the tools at ``q`` [N, n], and which of them count."""
        distance = angle = 0.0
        for row in q:
            one, other = (_frames(parts, row)[-1] @ _matrix(parts.tool or Frame()) for parts in self._parts)
            distance = max(distance, float(np.linalg.norm(one[:3, 3] - other[:3, 3])))
            # the chord of a unit vector: no cosine near 1, whose angle would have half the digits
            chord = float(np.linalg.norm(one[:3, :3] - other[:3, :3], 2))
            angle = max(angle, 2 * float(np.arcsin(min(chord / 2, 1.0))))
        differences = []
        if distance > self._tolerance * self._size:
            differences.append(Difference("tool", "", "place of the tool", None, None, distance, "m"))
        if angle > self._tolerance:
            differences.append(Difference("tool", "", "orientation of the tool", None, None, angle, "rad"))
        return (distance, angle), differences

    def _numbers(
        self, group: str, where: str, what: str, pair: tuple[Any, Any], unit: str, scale: float = 0.0
    ) -> Iterator[Difference]:
        """Numbers, or as many on either side; None where one says nothing."""
        one, other = (list(x) if isinstance(x, Sequence) else x for x in pair)
        if one is None or other is None:
            if one is not other:
                yield Difference(group, where, what, one, other, unit=unit)
            return
        a, b = np.atleast_1d(one), np.atleast_1d(other)
        apart = float(abs(a - b).max())
        if apart > self._tolerance * max(abs(a).max(), abs(b).max(), scale):
            yield Difference(group, where, what, one, other, apart, unit)


def _plain(setting: Any) -> Any:
    """A setting of an effect as numbers and words."""
    if isinstance(setting, tuple):
        return [_plain(part) for part in setting]
    if setting is None or isinstance(setting, str | int | Affine):
        return setting
    return float(setting)


def _frames(parts: Parts, q: Array) -> list[Array]:
    """Poses [4, 4] of the links in the world at ``q`` [n]."""
    pose = _matrix(parts.base or Frame())
    poses = []
    for joint, position in zip(parts.joints, q, strict=True):
        pose = pose @ _matrix(joint.frame)
        step = np.eye(4)
        if joint.kind == "revolute":
            c, s = np.cos(position), np.sin(position)
            step[:2, :2] = [[c, -s], [s, c]]
        else:
            step[2, 3] = position
        pose = pose @ step
        poses.append(pose)
    return poses


def _matrix(frame: Frame) -> Array:
    pose, matrix = Pose.from_rpy(frame.xyz, frame.rpy), np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = pose.rotation, pose.xyz
    return matrix


def _in_world(joint: PartJoint, frame: Array) -> tuple[list[float], list[float]]:
    """Centre of mass and tensor, ``xx yy zz xy xz yz``, of a link whose frame is at ``frame`` [4, 4]."""
    xx, yy, zz, xy, xz, yz = joint.body.inertia
    rotation = frame[:3, :3]
    com = frame[:3, 3] + rotation @ np.array(joint.body.com)
    tensor = rotation @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ rotation.T
    return com.tolist(), tensor[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]].tolist()
