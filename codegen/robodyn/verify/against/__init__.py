"""A robot against its original file, which another library reads: MuJoCo an MJCF, Pinocchio a URDF.

Nothing of robodyn's readers has a part in what the robot is compared with, but that macros of a xacro file
are expanded by the package ``xacro``, and Pinocchio reads the text that comes out.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Final
from xml.dom import expatbuilder
from xml.parsers.expat import ExpatError

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.files import MIB, label, read_bytes
from robodyn.formats.conversion import spring_of
from robodyn.formats.limits import FILE_MIB
from robodyn.robot.model import EffectEntry, Robot
from robodyn.robot.names import shown
from robodyn.robot.values import ZERO
from robodyn.verify.against.arm import Frames, PeerArm
from robodyn.verify.against.by_mujoco import MujocoFile
from robodyn.verify.against.by_pinocchio import PinocchioFile
from robodyn.verify.check import TOLERANCE
from robodyn.verify.judging import relative_to
from robodyn.verify.reference import Reference
from robodyn.verify.report import Comparison, VerifyReport
from robodyn.verify.sample import Sample, draw

_DOUBLE = np.dtype(np.float64)
#: What the row of the tool is called.
TOOL: Final = "tool frame"


def read_original(path: Path) -> MujocoFile | PinocchioFile:
    """The file at ``path`` as the library for its format reads it; a xacro file with the arguments of
    :func:`.how_files_are_read`.

    Raises
    ------
    InputError: there is no such file, no library here reads its format, or it refuses the file.
    ToolError: the library is not installed.
    """
    name, expanded = label(path), None
    if name.lower().endswith(".xacro"):
        from robodyn.formats.arm import stated_arguments
        from robodyn.formats.xacro import expanded as expansion

        expanded = expansion(path, stated_arguments()).text.encode()
    original = expanded or read_bytes(str(path), FILE_MIB * MIB, "URDF or MJCF", name)
    # Python's parser takes no blanks before <?xml and no -- in a comment, which both libraries do.
    head, *rest = original.split(b"<!--")
    bare = (head + b"".join(part.partition(b"-->")[2] for part in rest)).lstrip()
    try:
        root = expatbuilder.parseString(bare, namespaces=False).documentElement
    except (ExpatError, ValueError, LookupError) as error:
        raise InputError("the file is not XML", where=Place(name), found=str(error)) from None
    assert root is not None  # expat refuses a document without an element
    if root.tagName == "mujoco":
        return MujocoFile.read(path)
    if root.tagName == "robot":
        return PinocchioFile.read(path, root, expanded is not None)
    raise InputError(
        "no library that is used here reads this format",
        where=Place(name),
        found=shown(root.tagName),
        expected="<robot>: URDF or xacro, which Pinocchio reads, or <mujoco>: MJCF, which MuJoCo reads",
    )


def comparable(robot: Robot, arm: PeerArm) -> tuple[Robot, dict[str, str]]:
    """``robot`` without what the library of ``arm`` has no model of or does not read, and what that is."""
    left_out: dict[str, str] = {}

    def is_read(entry: EffectEntry) -> bool:
        return entry.definition.traits.body or (arm.springs and spring_of(entry) is not None)

    for entry in robot.effects:
        if not is_read(entry):
            joint = "" if entry.joint is None else f" of joint {robot.links[entry.joint - 1].name}"
            left_out[f"{entry.effect}{joint}"] = f"no part of {arm.title}"
    links = robot.links
    with_rotors = [link.name for link in links if link.joint.motor_inertia]
    if with_rotors and not arm.rotors:
        left_out[f"rotor inertia of {', '.join(with_rotors)}"] = f"no part of {arm.title}"
        links = tuple(replace(link, joint=replace(link.joint, motor_inertia=ZERO)) for link in links)
    if robot.rest_velocity is not None or robot.dead_band is not None:
        left_out["friction near to rest"] = "compared is that of the sign of the velocity"
    if robot.torque_side == "link":
        left_out["torques behind the gears"] = "compared are those of the motors, reflected to the joints"
    rest = replace(
        robot,
        links=links,
        effects=tuple(entry for entry in robot.effects if is_read(entry)),
        rest_velocity=None,
        dead_band=None,
        torque_side="motor",
    )
    return rest, left_out | arm.not_compared


def compare(
    robot: Robot, arm: PeerArm, *, states: int, seed: int = 0, parameters: Mapping[str, float] | None = None
) -> list[Comparison]:
    """Plain Newton-Euler of ``robot`` (:class:`.Reference`) against ``arm``: torques, mass matrix, frames
    and gears; what it takes for a kernel ``verify`` compares itself. Joints that follow others move by
    themselves here."""
    robot = robot.free
    reference, sample = Reference(robot, parameters), draw(robot, states, seed, _DOUBLE)
    torques = arm.torques(sample.q, sample.qd, sample.qdd)
    ours = reference.inverse_dynamics(sample.q, sample.qd, sample.qdd)
    matrices = arm.mass_matrix(sample.q)
    off = np.abs(reference.mass_matrix(sample.q) - matrices).max(axis=2)
    return [
        _worst(
            "inverse_dynamics", arm.title, sample, relative_to(np.abs(ours - torques), np.abs(torques).max())
        ),
        _worst("mass_matrix", arm.title, sample, relative_to(off, np.abs(matrices).max())),
        *frame_comparisons(reference, arm, sample),
        *gear_comparisons(robot, arm, sample),
    ]


def with_original(
    report: VerifyReport, robot: Robot, arm: PeerArm, left_out: Mapping[str, str]
) -> VerifyReport:
    """The ``report`` of the kernels of ``robot`` with what there is to compare beside them, frames and gears,
    and with what was ``left_out`` of the comparison."""
    reference = Reference(robot, report.parameters)
    sample = draw(robot, report.states, report.seed, _DOUBLE)
    rows = [*frame_comparisons(reference, arm, sample), *gear_comparisons(robot, arm, sample)]
    skipped = {**report.skipped, **left_out}
    if not any(row.function == TOOL for row in rows):
        skipped[TOOL] = f"{robot.name} states none, and its last frame is no frame of the file"
    return replace(report, comparisons=(*report.comparisons, *rows), skipped=skipped)


def frame_comparisons(reference: Reference, arm: PeerArm, sample: Sample) -> list[Comparison]:
    """How the links move, and where the tool is.

    A link's frame is another one in every format. What is compared is its motion in the world: the
    transformation that takes it from where it is at q = 0 to where it is in a state, which is the same for
    all frames of a body. The tool is compared with the nearest frame of what hangs on the last joint.
    Errors are entries of rotations, and of places as shares of the greatest distance from the origin.
    """
    n = sample.q.shape[1]
    q = np.vstack([np.zeros((1, n)), sample.q])
    ours, theirs = reference.frames(q), arm.frames(q)
    size = max(
        _reach(frame) for frame in (*(x for x in theirs.links if x is not None), *theirs.tips.values())
    )
    errors = np.zeros((len(sample), n))
    for i, frame in enumerate(theirs.links):
        if frame is not None:
            errors[:, i] = _difference(_motion(ours[:, i]), _motion(frame), size)
    off = np.nonzero((errors > TOLERANCE["double"]).any(axis=0))[0]
    first = errors[:, : off[0] + 1] * (np.arange(off[0] + 1) == off[0]) if len(off) else errors
    rows = [_worst("motion of links", arm.title, sample, first)]
    name, tool = _nearest(ours[:, n], theirs, size)
    error = _difference(ours[1:, n], tool[1:], size)
    if reference.robot.tool is not None or error.max() <= TOLERANCE["double"]:
        row = _worst(TOOL, f"{arm.title}, {name}", sample, error[:, None])
        rows.append(replace(row, joint=None))
    return rows


def gear_comparisons(robot: Robot, arm: PeerArm, sample: Sample) -> list[Comparison]:
    """The gear ratios that both state."""
    error = np.zeros((len(sample), robot.n))
    both = False
    for i, link in enumerate(robot.links):
        if link.joint.gear is not None and i in arm.gears:
            both = True
            error[:, i] = abs(float(link.joint.gear.ratio) - arm.gears[i]) / abs(arm.gears[i])
    return [_worst("gear ratios", arm.title, sample, error)] if both else []


def _reach(frame: Floats) -> float:
    """The greatest distance of ``[N, 3, 4]`` from the origin [m]; 1 where there is none."""
    return float(np.linalg.norm(frame[:, :, 3], axis=1).max()) or 1.0


def _motion(frame: Floats) -> Floats:
    """What takes ``frame`` ``[1 + N, 3, 4]`` from its first place to the others ``[N, 3, 4]``."""
    turn = frame[1:, :, :3] @ frame[0, :, :3].T
    shift = frame[1:, :, 3] - turn @ frame[0, :, 3]
    return np.concatenate([turn, shift[:, :, None]], axis=2)


def _difference(one: Floats, other: Floats, size: float) -> Floats:
    """``[N]`` of frames ``[N, 3, 4]``: of rotations, and of places as shares of ``size``."""
    gap = np.abs(one - other) / np.array([1.0, 1.0, 1.0, size])
    return np.asarray(gap.max(axis=(1, 2)))


def _nearest(tool: Floats, theirs: Frames, size: float) -> tuple[str, Floats]:
    """The name and the frames ``[N, 3, 4]`` of what comes nearest to ``tool``."""
    return min(theirs.tips.items(), key=lambda tip: float(_difference(tool, tip[1], size).max()))


def _worst(function: str, against: str, sample: Sample, errors: Floats) -> Comparison:
    """The row of ``errors`` ``[N, n]``, states by joints."""
    errors = np.where(np.isfinite(errors), errors, np.inf)
    state, joint = (int(i) for i in np.unravel_index(np.argmax(errors), errors.shape))
    inputs = {name: tuple(map(float, getattr(sample, name)[state])) for name in ("q", "qd", "qdd")}
    error, count = float(errors[state, joint]), len(sample)
    return Comparison(
        function, against, count, 0, error, TOLERANCE["double"], joint + 1, None, state, inputs, None
    )
