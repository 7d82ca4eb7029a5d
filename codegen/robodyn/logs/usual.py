"""The map of a file that needs none: usual names, or the one topic of joint states."""

from __future__ import annotations

import re
from collections.abc import Sequence

from robodyn.errors import InputError, Place
from robodyn.logs.mapping import Channel, LogMap
from robodyn.logs.recording import Recording, Stream
from robodyn.robot.model import Robot
from robodyn.robot.names import shown

#: Fields of sensor_msgs/JointState, and the groups that they are.
JOINT_STATE = {"q": "position", "qd": "velocity", "tau": "effort"}
#: Names of joints that many arms have, base to tip: where no numbers say their order.
_USUAL_ORDER = ("pan", "lift", "elbow", "wrist_1", "wrist_2", "wrist_3")
_LAST_NUMBER = re.compile(r".*?([0-9]+)(?=[^0-9]*\Z)", re.DOTALL)


def usual_map(recording: Recording, robot: Robot | None) -> LogMap:
    """The map of ``recording`` where its own names say all.

    Raises
    ------
    InputError: several topics have joint states, or the order of their joints is not known.
    """
    states = [stream for stream in recording.streams if joints_in(stream)]
    columns = {column for stream in recording.streams for column in stream.columns}
    where = Place(recording.file)
    if not states:
        groups: dict[str, Channel] = {}
        for group in ("qd", "qdd", "ql"):
            numbered = [
                int(c[len(group) :]) for c in columns if re.fullmatch(rf"{group}[1-9][0-9]{{0,2}}", c)
            ]
            if numbered and group == "ql":
                names = tuple(f"ql{j}" for j in sorted(numbered))
                groups[group] = Channel(names, where, joints=tuple(sorted(numbered)))
            elif f"{group}1" in columns:
                groups[group] = Channel((f"{group}%d",), where)
            elif group in columns or f"{group}.0" in columns:
                groups[group] = Channel((group,), where)
        return LogMap(groups)
    full = [stream for stream in states if _has(stream, "effort")]
    if len(full or states) > 1:
        raise InputError(
            "several topics have joint states",
            where=where,
            found=", ".join(shown(stream.name) for stream in (full or states)[:6]),
            expected="one",
            remedy=f"say which in a map (topic: {(full or states)[0].name}); robodyn logs FILE -o map.yaml",
        )
    return joint_state_map(recording, (full or states)[0], robot)


def joint_state_map(recording: Recording, stream: Stream, robot: Robot | None) -> LogMap:
    """The map of a topic of joint states.

    Raises
    ------
    InputError: the order of the joints is not known, or they are not as many as the robot's.
    """
    names = joints_in(stream)
    order, _ = base_to_tip(names, robot)
    if robot is not None and order is not None and len(order) != robot.n:
        order = None
    if order is None:
        expected = "joint1, joint2, ..." if robot is None else f"{robot.n}, numbered, or called as its links"
        raise InputError(
            "which joints are the robot's, base to tip, is not known",
            where=Place(recording.file),
            found=", ".join(map(shown, names[:12])),
            expected=expected,
            remedy="write joints: [NAME, NAME, ...] in a map; robodyn logs FILE -o map.yaml proposes one",
        )
    place = Place(recording.file)
    groups = {
        group: Channel((f"{field}.%s",), place)
        for group, field in JOINT_STATE.items()
        if all(f"{field}.{name}" in stream.columns for name in order)
    }
    return LogMap(groups, order, stream.name)


def joints_in(stream: Stream) -> tuple[str, ...]:
    """Names of the joints of a topic of joint states, in its order; none if it is something else."""
    if not stream.kind.endswith("/JointState"):
        return ()
    return tuple(c.removeprefix("position.") for c in stream.columns if c.startswith("position."))


def _has(stream: Stream, field: str) -> bool:
    return any(column.startswith(f"{field}.") for column in stream.columns)


def base_to_tip(names: Sequence[str], robot: Robot | None) -> tuple[tuple[str, ...] | None, str]:
    """The joints ``names`` in the order of the robot's, and by what it is known; None if it is not."""
    if robot is not None:
        links = [link.name for link in robot.links]
        if all(link in names for link in links):
            return tuple(links), "named as the robot's links"
    numbers = []
    for name in names:
        match = _LAST_NUMBER.match(name)
        numbers.append((name[: match.start(1)], int(match[1]), name[match.end(1) :]) if match else None)
    listed = [parts for parts in numbers if parts is not None]
    if len(listed) == len(names) and len({(head, tail) for head, _, tail in listed}) == 1:
        values = sorted(value for _, value, _ in listed)
        if values == list(range(values[0], values[0] + len(values))):
            pairs = sorted(zip((value for _, value, _ in listed), names, strict=True))
            return tuple(name for _, name in pairs), "numbered"
    if len(names) == len(_USUAL_ORDER):
        fits = [[name for name in names if word in name] for word in _USUAL_ORDER]
        if all(len(fit) == 1 for fit in fits):
            return tuple(fit[0] for fit in fits), "pan, lift, elbow, wrists, as such arms have them"
    return (tuple(names), "one joint") if len(names) == 1 else (None, "")
