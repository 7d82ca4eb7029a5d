"""What depends on a folder's targets: toolchain files, memory of boards, how instructions are counted."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from robodyn.emit.lines import head_of
from robodyn.emit.render import environment
from robodyn.robot.model import Robot
from robodyn.targets import Architecture, Target


def architectures(targets: Sequence[Target]) -> tuple[Architecture, ...]:
    """Those of ``targets``, each once."""
    return tuple(dict.fromkeys(target.board.architecture for target in targets if target.board))


def image_context(targets: Sequence[Target]) -> dict[str, Any]:
    """What the templates of an image are told."""
    return {
        "targets": targets,
        "architectures": architectures(targets),
        "toolchain_files": [f"{architecture.toolchain}.cmake" for architecture in architectures(targets)],
        "memory_files": [f"{target.name}.ld" for target in targets],
    }


def ticks(targets: Sequence[Target]) -> str:
    """How instructions are counted in the emulators, in words."""
    boards = [target.board for target in targets if target.board]
    return " and ".join(
        dict.fromkeys(
            f"-icount shift={board.architecture.shift} {board.architecture.counter} counts {board.ticks:g} "
            "an instruction"
            for board in boards
        )
    )


def image_files(robot: Robot, targets: Sequence[Target], context: Mapping[str, Any]) -> dict[str, str]:
    """A toolchain file for each compiler, and for each target the memory of its board; text by name."""
    files = {}
    for architecture in architectures(targets):
        own = [target for target in targets if target.board and target.board.architecture is architecture]
        names = ", ".join(target.name for target in own)
        head = head_of(robot, [f"A toolchain file: {architecture.compiler.name} for {names}."])
        text = environment().get_template("firmware/toolchain.cmake.j2")
        files[f"{architecture.toolchain}.cmake"] = text.render(
            context, targets=own, architecture=architecture, head=head
        )
    for target in targets:
        assert target.board
        words = f"Memory of {target.board.machine}, which qemu has: another board needs other addresses here."
        text = environment().get_template("firmware/memory.ld.j2")
        files[f"{target.name}.ld"] = text.render(board=target.board, head=head_of(robot, [words]))
    return files
