"""What the kernels of a firmware folder are generated with, which robots it is not for, and what depends on
its targets: toolchain files, memory of boards, how instructions are counted."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any

from robodyn.dynamics.functions import function_named
from robodyn.emit.head import head_of
from robodyn.emit.render import environment
from robodyn.emit.unit import FREESTANDING, OF_LIBM
from robodyn.errors import InputError
from robodyn.firmware.digest import DRAWN
from robodyn.ir.signature import ScalarType
from robodyn.kernels.generate import Generated, Options
from robodyn.robot.model import Robot
from robodyn.targets import Architecture, Target, firmware_targets, target_named

#: What a controller calls; more of them make the code larger.
FUNCTIONS = ("inverse_dynamics",)

#: What the C library has, and only that.
_LIBRARY = sorted(OF_LIBM - FREESTANDING)


def targets_named(names: Sequence[str]) -> tuple[Target, ...]:
    """The processors called ``names``; all that have a board where there is no name.

    Raises
    ------
    InputError: one is unknown, has no board, or is named twice.
    """
    known = firmware_targets()
    named = tuple(target_named(name, known, what="there is no firmware for the target") for name in names)
    if len({target.name for target in named}) != len(named):
        raise InputError("a target is named twice", found=", ".join(names))
    return named or known


def firmware_options(
    options: Options, targets: Sequence[str], *, scalar: ScalarType | None = None, trig: str | None = None
) -> Options:
    """``options`` for the processors called ``targets``, none for all: built-in sine and cosine; inverse
    dynamics alone unless functions are named, and ``all`` without those that cannot be tested; float, unless
    ``scalar`` says otherwise or every processor has a floating-point unit for double.

    Raises
    ------
    InputError: a processor is unknown, or ``trig`` asks for other sines.
    """
    named = targets_named(targets)
    if trig not in (None, "builtin"):
        raise InputError(
            f"a firmware folder has sines and cosines of its own, and --trig asks for {trig}",
            expected="builtin",
            remedy="leave out --trig",
        )
    if scalar is None:
        scalar = "double" if all("double" in target.hardware for target in named) else "float"
    functions = options.functions or FUNCTIONS
    options = dataclasses.replace(options, functions=functions, scalar=scalar, trig="builtin")
    without = []
    for name in options.function_names:
        function, asked = function_named(name), options.insists_on(name)
        unknown = sorted(set(function.input_names) - DRAWN)  # there is no telling what to test them with
        if unknown and asked:
            raise InputError(
                f"no firmware tests {name}",
                found=f"its input {', '.join(unknown)}, of which no joint has limits",
                remedy="leave it out of --functions, or out of --firmware",
            )
        # Of a pose: only by name, since not every arm has one that can be tested.
        if unknown or (function.of_pose and not asked):
            without.append(name)
    return dataclasses.replace(options, without=tuple(without))


def check_firmware(generated: Generated) -> None:
    """:class:`InputError` where a self-test cannot say what the kernel must give: it remembers from call to
    call, repeats a step, or calls the C library."""
    name = generated.unit.robot.name
    for interface, program in generated.unit.functions:
        if interface.states:
            raise InputError(
                f"{interface.symbol} remembers from call to call, and the firmware's self-test is for single "
                "states",
                found=", ".join(interface.states),
                remedy="leave out the effects with memory, or use robodyn gen without --firmware",
            )
        program.straight("self-tests of firmware are")
        called = [op for op in _LIBRARY if any(operation.op == op for operation in program.operations)]
        if called:
            raise InputError(
                f"{interface.symbol} calls {', '.join(called)} of the C library, whose bits differ from "
                "one library to the next",
                expected="a kernel that needs no library",
                remedy=f"choose friction_at_rest: exact and plainer effects in {name}, or use robodyn gen "
                "without --firmware",
            )


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
    ways = (
        f"-icount shift={b.architecture.shift} {b.architecture.counter} counts {b.ticks:g} an instruction"
        for target in targets
        if (b := target.board)
    )
    return " and ".join(dict.fromkeys(ways))


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
