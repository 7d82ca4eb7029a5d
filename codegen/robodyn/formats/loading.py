"""Robots by path or name, whatever the format: descriptions, bundled ones, URDF, MJCF, SDF and xacro."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Final

from robodyn.files import label
from robodyn.robot import bundled
from robodyn.robot.masses import unknown_masses
from robodyn.robot.model import Robot
from robodyn.robot.reader import Warn, doubtful

#: Endings of files in other formats.
SUFFIXES: Final = (".urdf", ".xacro", ".xml", ".mjcf", ".sdf")


def load(
    spec: str | os.PathLike[str],
    *,
    model: str = "",
    without: Iterable[str] = (),
    massless: bool = False,
    strict: bool = False,
    warn: Warn | None = None,
    note: Warn | None = None,
) -> Robot:
    """The robot in the file ``spec``, or the bundled robot of that name.

    A file whose name ends in .urdf, .xml, .mjcf, .sdf or .xacro is imported (:mod:`robodyn.formats.arm`): it
    must have one tip; ``model`` is the one that is read of an SDF file with several. What such a file states
    that changes torques and that is not modelled is refused, unless it is named ``without``. With
    ``massless`` masses and inertias that nobody knows are 0: torques are refused otherwise. Physically
    doubtful numbers are told to ``warn``, one line of text each (by default they become a warning), and the
    lines of the robot's :class:`~robodyn.robot.account.Account` to ``note``, or else to ``warn`` (of a
    description, and by default, those that may change numbers; the rest is in ``robot.account``); ``strict``
    refuses doubtful numbers.

    Raises
    ------
    InputError: no such file or name, or one that cannot be read.
    ToolError: the package that reads the format is not installed.
    """
    foreign = _is_foreign(spec)
    if not foreign:
        if model:
            from robodyn.formats.arm import no_model_to_choose

            raise no_model_to_choose(label(spec))
        robot = bundled.load(spec, strict=strict, warn=warn)
        if unknown_masses(robot):
            from robodyn.formats.arm import taken_as_massless

            robot = taken_as_massless(robot, massless)
    else:
        from robodyn.formats.arm import import_arm

        imported = import_arm(spec, model=model, without=without, massless=massless, strict=strict)
        robot = imported.robot
        for where, words in imported.implausible:
            (warn or doubtful)(f"{where}: {words}")
    if robot.account is not None:
        tell = note or warn
        for line in robot.account.lines() if tell and foreign else robot.account.risks():
            (tell or doubtful)(f"{label(spec)}: {line}")
    return robot


def _is_foreign(spec: str | os.PathLike[str]) -> bool:
    """Whether ``spec`` is a file in another format; their readers are imported only then."""
    return os.fspath(spec).lower().endswith(SUFFIXES) and os.path.exists(spec)  # noqa: PTH110 (never raises)


def robot_of(robot: Robot | str | os.PathLike[str]) -> Robot:
    """``robot`` itself, or what :func:`load` reads at that path or under that name."""
    return robot if isinstance(robot, Robot) else load(robot)


def text_of(spec: str | os.PathLike[str]) -> str:
    """The text of the description that :func:`load` reads for ``spec``.

    Raises
    ------
    InputError: there is no such file or robot.
    """
    if not _is_foreign(spec):
        return bundled.text_of(spec)
    from robodyn.formats.arm import description_text, import_arm

    return description_text(import_arm(spec))
