"""Files of a schedule: the serial kernel, its parallel form, and its packed form."""

from __future__ import annotations

from robodyn.emit import Unit, render
from robodyn.emit.packed import packed_files
from robodyn.emit.parallel import Parallel, parallel_files
from robodyn.ir.signature import Signature
from robodyn.robot.model import Robot
from robodyn.schedule.cutting import Cut
from robodyn.schedule.lanes import Waiting
from robodyn.schedule.machine import Timetable
from robodyn.schedule.packing import pack


def schedule_files(
    robot: Robot,
    signature: Signature,
    cut: Cut,
    timetable: Timetable,
    *,
    waiting: Waiting | None = None,
    lanes: int | None = None,
    notes: tuple[str, ...] = (),
) -> dict[str, str]:
    """All files of a schedule of ``cut``: text by file name; with ``lanes`` the packed form too.

    ``waiting``: barriers where the timetable has levels, counters where it has none, unless told.

    Raises
    ------
    InputError: the function remembers between calls, or barriers are asked for where there are no levels.
    """
    how = waiting or ("barrier" if timetable.machine.synchronised else "counters")
    unit = Unit(robot, ((signature, cut.program),), notes=notes)
    files = render(unit, ("c",)) | parallel_files(
        Parallel(robot, signature, cut, timetable, how, notes, lanes is not None)
    )
    if lanes is not None:
        files |= packed_files(robot, signature, pack(cut.program, lanes))
    return files
