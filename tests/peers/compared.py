"""What test_peers compares with."""

from __future__ import annotations

import functools
import importlib
import importlib.util
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import ModuleType
from typing import Any, Final

import numpy as np

import robodyn
import robodyn.robot
from peers.numbers import Array
from robodyn.robot.model import Robot
from robodyn_testing import require_module
from robodyn_testing.random_robots import States, random_states

PEERS: Final = ("pinocchio", "mujoco")
STATES: Final = 24
DOUBLE: Final = 1e-10
WORST_CONDITION: Final = 1e8

TORQUES: Final = ("inverse_dynamics", "gravity", "bias")
ALL_BUT_FORWARD: Final = (*TORQUES, "mass_matrix")


@dataclass(frozen=True, slots=True)
class Reference:
    """What one peer says of one robot in some states, by kernel function; ``qdd`` where M is regular."""

    peer: str
    states: States
    answers: Mapping[str, Array]
    qdd: Array | None

    @property
    def functions(self) -> tuple[str, ...]:
        """The kernel functions that can be held against this reference."""
        return ALL_BUT_FORWARD if self.qdd is None else (*ALL_BUT_FORWARD, "forward_dynamics")

    def scale(self, function: str) -> float:
        """What differences in ``function`` are shares of."""
        return float(np.abs(self.answers["mass_matrix" if function == "mass_matrix" else TORQUES[0]]).max())


def peer_module(name: str) -> ModuleType:
    """The converter for ``name``; the library must be there."""
    return importlib.import_module(f"peers.{name}_peer")


def reference(peer: str, robot: Robot, states: States) -> Reference:
    """Ask ``peer`` for everything at ``states``."""
    module = peer_module(peer)
    model = getattr(module, f"{peer}_model")(robot)
    q, qd, qdd = states
    M = module.mass_matrix(model, robot, q)
    answers = {
        "inverse_dynamics": module.torques(model, robot, q, qd, qdd),
        "gravity": module.gravity(model, robot, q),
        "bias": module.bias(model, robot, q, qd),
        "mass_matrix": M,
    }
    accelerations = None
    if worst_condition(M) <= WORST_CONDITION:
        accelerations = module.forward_dynamics(model, robot, q, qd, answers["inverse_dynamics"])
    return Reference(peer, states, answers, accelerations)


def worst_condition(M: Array) -> float:
    """The largest condition number of the mass matrices [N, n, n], each scaled to a unit diagonal."""
    diagonal = np.einsum("nii->ni", M)
    if not (diagonal > 1e-12 * np.abs(M).max()).all():
        return float("inf")
    root = np.sqrt(diagonal)
    return float(np.linalg.cond(M / root[:, :, None] / root[:, None, :]).max())


@functools.cache
def peers() -> tuple[str, ...]:
    """The peers that are installed, at least one; ``test_peer_is_installed`` complains of any other."""
    found = tuple(name for name in PEERS if importlib.util.find_spec(name))
    return found or (require_module(PEERS[0]).__name__,)


def references(robot: Robot, seed: int = 0) -> list[Reference]:
    """What every installed peer says of ``robot``."""
    states = random_states(robot, STATES, seed)
    return [reference(peer, robot, states) for peer in peers()]


def complaint(what: str, got: Array, expected: Array, scale: float, tolerance: float) -> str | None:
    """None where ``got`` is ``expected`` to ``tolerance * scale``; else what, where and by how much."""
    if got.shape != expected.shape:
        return f"{what}: shape {got.shape}, expected {expected.shape}"
    difference = np.abs(got - expected)
    place = np.unravel_index(int(np.argmax(difference)), difference.shape)  # the first NaN, if any
    if difference[place] <= tolerance * scale:
        return None
    state, *entry = (int(i) for i in place)
    return (
        f"{what}: off by {difference[place] / scale if scale else difference[place]:.2e} of the largest, "
        f"{scale:.6g} (allowed {tolerance:.0e}), in state {state}, entry {[i + 1 for i in entry]}: "
        f"{got[place]!r}, expected {expected[place]!r}"
    )


def complaints(kernel: Any, ref: Reference, functions: Sequence[str], tolerance: float) -> list[str]:
    """Everything in which ``functions`` of ``kernel`` differ from ``ref`` by more than ``tolerance``."""
    inputs = {"inverse_dynamics": 3, "gravity": 1, "bias": 2, "mass_matrix": 1}
    texts = []
    for name in functions:
        if name == "forward_dynamics":
            texts.append(_residual(kernel, ref, tolerance))
            continue
        answer = getattr(kernel, name)(*ref.states[: inputs[name]])
        texts.append(
            complaint(f"{name} by {ref.peer}", answer, ref.answers[name], ref.scale(name), tolerance)
        )
    return [text for text in texts if text is not None]


def _residual(kernel: Any, ref: Reference, tolerance: float) -> str | None:
    """Put the kernel's accelerations back into the equation of motion; the module's head has the reasons."""
    q, qd, _ = ref.states
    tau, M, b = (ref.answers[f] for f in ("inverse_dynamics", "mass_matrix", "bias"))
    assert ref.qdd is not None
    x = np.asarray(kernel.forward_dynamics(q, qd, tau))
    if x.shape != tau.shape:
        return f"forward_dynamics: shape {x.shape}, expected {tau.shape}"
    back = (M @ x[..., None])[..., 0] + b
    inertial = (np.abs(M) @ np.abs(ref.qdd)[..., None]).max()
    scale = float(inertial + np.abs(b).max() + np.abs(tau).max())
    return complaint(f"torque of forward_dynamics by {ref.peer}", back, tau, scale, tolerance)


def kernel_of(robot: Robot, functions: Sequence[str], **options: Any) -> Any:
    """Compile ``functions`` of ``robot``, the quick way to load; the options are ``robodyn.compile``'s."""
    return robodyn.compile(robot, functions=tuple(functions), mode="abi", **options)
