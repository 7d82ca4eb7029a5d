"""From a map and a file to columns: which column of which stream each joint's are."""

from __future__ import annotations

import re
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass

from robodyn.errors import InputError, Place
from robodyn.logs.mapping import Channel, LogMap
from robodyn.logs.recording import RECEIVED, Recording, Stream, candidates, find
from robodyn.robot.model import Robot
from robodyn.robot.names import shown

#: Number of the joint in a pattern, with leading zeros or without.
_NUMBER = re.compile(r"%(0[1-9])?d")
_RANGE = re.compile(r"(?P<head>.*?)(?P<first>[0-9]{1,4})\.\.(?P<again>.*?)(?P<last>[0-9]{1,4})\Z", re.DOTALL)
#: How the columns of a group are called where a map says nothing of them.
USUAL = {"t": ("t",), "q": ("q%d", "q"), "tau": ("tau%d", "tau")}

#: Fields of sensor_msgs/JointState, and the groups that they are.
JOINT_STATE = {"q": "position", "qd": "velocity", "tau": "effort"}
#: Names of joints that many arms have, base to tip: where no numbers say their order.
_USUAL_ORDER = ("pan", "lift", "elbow", "wrist_1", "wrist_2", "wrist_3")
_LAST_NUMBER = re.compile(r".*?([0-9]+)(?=[^0-9]*\Z)", re.DOTALL)


@dataclass(frozen=True, slots=True)
class Source:
    """A ``column`` of a ``stream``, of the ``joint`` (from 0; 0 of t)."""

    stream: Stream
    column: str
    joint: int


def joints_of(recording: Recording, mapping: LogMap) -> int:
    """How many joints the columns of q are for.

    Raises
    ------
    InputError: there are no such columns.
    """
    channel = channel_of(recording, mapping, "q")
    if mapping.joints:
        return len(mapping.joints)
    if len(channel.columns) > 1:
        return len(channel.columns)
    return len(_names(recording, mapping, channel, None))


def channel_of(recording: Recording, mapping: LogMap, group: str) -> Channel:
    """The channel of ``group``: as the map says, else columns with the usual names.

    Raises
    ------
    InputError: the map says nothing, and there are no such columns.
    """
    if group in mapping.groups:
        return mapping.groups[group]
    where = Place(recording.file)
    for pattern in USUAL[group]:
        channel = Channel((pattern,), where)
        with suppress(InputError):
            if _names(recording, mapping, channel, None):
                return channel
    listed = [stream.full(column) for stream in recording.streams for column in stream.columns]
    more = f", ... ({len(listed)} columns)" if len(listed) > 6 else ""
    raise InputError(
        f"which columns of the file are {group} is not known",
        where=where,
        found=", ".join(map(shown, listed[:6])) + more,
        expected=f"{USUAL[group][0].replace('%d', '1')}, or a map that says it",
        remedy=f"robodyn logs {recording.file} -o map.yaml proposes one; give it with --map map.yaml",
    )


def sources(
    recording: Recording, mapping: LogMap, group: str, channel: Channel, n: int
) -> tuple[Source, ...]:
    """The columns of ``group``, joint by joint; joints without one are left out.

    Raises
    ------
    InputError: there are no such columns, or not as many.
    """
    joints = [0] if group == "t" else [j - 1 for j in channel.joints] or list(range(n))
    if max(joints) >= n:
        raise InputError(
            "the map has a joint that the robot has not",
            where=channel.place,
            found=f"joint {max(joints) + 1}",
            expected=f"1 to {n}",
        )
    names: Sequence[str] = channel.columns
    if len(names) == 1 and group != "t":
        names = _names(recording, mapping, channel, joints)
    if len(names) != len(joints):
        raise InputError(
            f"{group} has another number of columns than the arm of joints",
            where=channel.place,
            found=f"{len(names)}: {', '.join(map(shown, names[:8]))}",
            expected=str(len(joints)),
            remedy="name a column for each joint, base to tip",
        )
    return tuple(
        Source(*find(recording, name, mapping.topic, channel.place), joint)
        for joint, name in zip(joints, names, strict=True)
        if name
    )


def _names(
    recording: Recording, mapping: LogMap, channel: Channel, joints: Sequence[int] | None
) -> tuple[str, ...]:
    """The names that the one pattern of ``channel`` stands for; ``joints`` (from 0), None: as many as there
    are."""
    pattern = channel.columns[0]
    if "%s" in pattern:
        return _by_name(mapping, channel, pattern, joints)
    if _NUMBER.search(pattern):
        return _by_number(recording, mapping, channel, pattern, joints)
    match = _RANGE.match(pattern)
    if match and match["again"] in ("", match["head"]):
        first, last = int(match["first"]), int(match["last"])
        return tuple(f"{match['head']}{k}" for k in range(first, min(last, first + 999) + 1))
    if not candidates(recording, pattern, mapping.topic):
        try:
            return _by_number(recording, mapping, channel, f"{pattern}.%d", joints)
        except InputError:
            find(recording, pattern, mapping.topic, channel.place)  # names what there is
    return (pattern,)


def _by_name(
    mapping: LogMap, channel: Channel, pattern: str, joints: Sequence[int] | None
) -> tuple[str, ...]:
    if not mapping.joints:
        raise InputError(
            "%s stands for the name of a joint, and the joints have no names",
            where=channel.place,
            found=shown(pattern),
            remedy="write joints: [NAME, NAME, ...] at the top of the map, base to tip",
        )
    chosen = range(len(mapping.joints)) if joints is None else joints
    if max(chosen) >= len(mapping.joints):
        raise InputError(
            "the map names fewer joints than the robot has",
            where=channel.place,
            found=str(len(mapping.joints)),
            expected=f"{max(chosen) + 1} or more",
        )
    return tuple(pattern.replace("%s", mapping.joints[j]) for j in chosen)


def _by_number(
    recording: Recording, mapping: LogMap, channel: Channel, pattern: str, joints: Sequence[int] | None
) -> tuple[str, ...]:
    """Joints may be numbered from 1 or, where there is a number 0 and not as many, from 0."""

    def name(index: int) -> str:
        return _NUMBER.sub(lambda match: f"{index:{match[1] or ''}d}", pattern)

    def there(index: int) -> bool:
        return bool(candidates(recording, name(index), mapping.topic))

    if joints is None:
        first = 0 if there(0) else 1
        last = first
        while there(last):
            last += 1
        if last == first:
            find(recording, name(1), mapping.topic, channel.place)
        return tuple(name(k) for k in range(first, last))
    from_one, from_zero = all(there(j + 1) for j in joints), all(there(j) for j in joints)
    if from_one and from_zero:
        raise InputError(
            "the columns are numbered from 0, and there is one too many",
            where=channel.place,
            found=", ".join(shown(name(k)) for k in range(max(joints) + 2)),
            expected=f"{len(joints)} columns",
            remedy="list the columns, or write a range: " + f"{name(0)}..{name(max(joints))}",
        )
    if not from_one and not from_zero:
        base = 0 if there(0) and not there(len(joints)) else 1
        missing = next(j for j in joints if not there(j + base))
        find(recording, name(missing + base), mapping.topic, channel.place)
    return tuple(name(j + (1 if from_one else 0)) for j in joints)


def stamp_of(channel: Channel | None, stream: Stream, where: Place) -> str | None:
    """Which of the stamps of ``stream`` are its times; None where a column or a rate has them.

    Raises
    ------
    InputError: the map wants stamps that the stream has not.
    """
    if not stream.stamps:
        return None
    if channel is None:
        return stream.stamps[0]
    if channel.rate is not None:
        return None
    name = channel.columns[0]
    for stamp in stream.stamps:
        if name in (stamp, stream.full(stamp)):
            return stamp
    if name == RECEIVED:
        raise InputError("the stream has no times of recording", where=where, found=stream.name)
    return None


# --- maps of files that need none -------------------------------------------------------------------------


def usual_map(recording: Recording, robot: Robot | None) -> LogMap:
    """The map of ``recording`` where its own names say all.

    Raises
    ------
    InputError: several topics have joint states, or the order of their joints is not known.
    """
    states = [stream for stream in recording.streams if joints_in(stream)]
    columns = {column for stream in recording.streams for column in stream.columns}
    where = Place(recording.file)
    groups: dict[str, Channel] = {}
    if not states:
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
    full = [s for s in states if any(column.startswith("effort.") for column in s.columns)] or states
    if len(full) > 1:
        raise InputError(
            "several topics have joint states",
            where=where,
            found=", ".join(shown(stream.name) for stream in full[:6]),
            expected="one",
            remedy=f"say which in a map (topic: {full[0].name}); robodyn logs FILE -o map.yaml",
        )
    (stream,) = full
    names = joints_in(stream)
    order, _ = base_to_tip(names, robot)
    if order is None or (robot is not None and len(order) != robot.n):
        expected = "joint1, joint2, ..." if robot is None else f"{robot.n}, numbered, or called as its links"
        raise InputError(
            "which joints are the robot's, base to tip, is not known",
            where=where,
            found=", ".join(map(shown, names[:12])),
            expected=expected,
            remedy="write joints: [NAME, NAME, ...] in a map; robodyn logs FILE -o map.yaml proposes one",
        )
    groups = {
        group: Channel((f"{field}.%s",), where)
        for group, field in JOINT_STATE.items()
        if all(f"{field}.{name}" in stream.columns for name in order)
    }
    return LogMap(groups, order, stream.name)


def joints_in(stream: Stream) -> tuple[str, ...]:
    """Names of the joints of a topic of joint states, in its order; none if it is something else."""
    if not stream.kind.endswith("/JointState"):
        return ()
    return tuple(c.removeprefix("position.") for c in stream.columns if c.startswith("position."))


def base_to_tip(names: Sequence[str], robot: Robot | None) -> tuple[tuple[str, ...] | None, str]:
    """The joints ``names`` in the order of the robot's, and by what it is known; None if it is not."""
    if robot is not None:
        links = [link.name for link in robot.links]
        if all(link in names for link in links):
            return tuple(links), "named as the robot's links"
    matches = [match for match in map(_LAST_NUMBER.match, names) if match]
    around = {(match.string[: match.start(1)], match.string[match.end(1) :]) for match in matches}
    if len(matches) == len(names) and len(around) == 1:
        numbers = {int(match[1]): match.string for match in matches}
        values = sorted(numbers)
        if values == list(range(values[0], values[0] + len(names))):
            return tuple(numbers[value] for value in values), "numbered"
    if len(names) == len(_USUAL_ORDER):
        fits = [[name for name in names if word in name] for word in _USUAL_ORDER]
        if all(len(fit) == 1 for fit in fits):
            return tuple(fit[0] for fit in fits), "pan, lift, elbow, wrists, as such arms have them"
    return (tuple(names), "one joint") if len(names) == 1 else (None, "")
