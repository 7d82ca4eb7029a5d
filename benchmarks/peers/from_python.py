"""What a call costs from Python: those of ``robodyn bench``, and what only this benchmark installs."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from benchmarks.peers.building import NATIVE, Lacking, Source, library, version
from benchmarks.peers.candidates import Missing
from benchmarks.peers.numbers_in_c import check_rows

from robodyn.bench.peers.calls import (
    Call,
    States,
    buffered,
    casadi_call,
    casadi_function,
    mujoco_call,
    own_calls,
    pinocchio_call,
)
from robodyn.bench.peers.numbers import numbers_of
from robodyn.robot import Robot


def calls(robot: Robot, states: States) -> tuple[list[Call], list[Missing]]:
    """All that can be called here, each given the same states; and what cannot."""
    results = own_calls(robot, states, flags="-std=c99 " + " ".join(NATIVE))
    missing = []
    for title, package, make in _PEERS:
        try:
            version(package)
            results.append(make(robot, states))
        except Lacking as lacking:
            missing.append(Missing(title, title, str(lacking)))
    return results, missing


def _casadi_compiled(robot: Robot, states: States) -> Call:
    """The C that CasADi writes, compiled with the flags of the native race."""
    import casadi

    function = casadi_function(robot)
    with tempfile.TemporaryDirectory() as folder:
        text = casadi.CodeGenerator("casadi_sx.c")
        text.add(function)
        source = Path(folder) / "casadi_sx.c"
        source.write_text(text.dump(), encoding="utf-8")
        built = library(source.with_suffix(".so"), Source((source,)), NATIVE)
        loaded = casadi.external(function.name(), str(built))
        return buffered("casadi-c", "CasADi, FunctionBuffer, its C compiled", loaded, states)


def _toolbox(arm: Robot, states: States) -> Call:
    import roboticstoolbox as rtb

    numbers, links = numbers_of(arm), []
    check_rows(numbers)
    for link in numbers.links:
        kind = rtb.RevoluteMDH if link.revolute else rtb.PrismaticMDH
        place = (
            {"d": link.d, "offset": link.theta[0]}
            if link.revolute
            else {"theta": link.theta[0], "offset": link.d}
        )
        mass = {"m": link.mass, "r": link.com, "I": link.inertia, "Jm": link.rotor, "G": 1.0}
        links.append(kind(a=link.a, alpha=link.alpha[0], **place, **mass))
    robot = rtb.DHRobot(links)
    q, qd, qdd = states

    def once(k: int = 0) -> Any:
        return robot.rne(q[k], qd[k], qdd[k], gravity=numbers.gravity)

    return Call("toolbox", "Robotics Toolbox, DHRobot.rne", once, 1, once)


_PEERS: tuple[tuple[str, str, Callable[[Robot, States], Call]], ...] = (
    ("pin.rnea", "pin", pinocchio_call),
    ("CasADi, FunctionBuffer", "casadi", casadi_call),
    ("CasADi, FunctionBuffer, its C compiled", "casadi", _casadi_compiled),
    ("mujoco.mj_inverse", "mujoco", mujoco_call),
    ("Robotics Toolbox, DHRobot.rne", "roboticstoolbox-python", _toolbox),
)
