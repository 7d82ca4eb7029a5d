"""The arm as a model of Pinocchio, of MuJoCo, and as a function of CasADi; and what a call costs from Python,
ours and the peers': in one process, blocks in turn."""

from __future__ import annotations

import itertools
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import Any, Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.bench.peers.numbers import LinkNumbers, Numbers, hold_against, numbers_of
from robodyn.dynamics.arm import JointAngle, build_arm, build_motion
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.robot.model import Robot

#: States of a batch.
BATCH: Final = 10_000

#: q, qd, qdd of many states, [N, n] each.
States = tuple[Floats, Floats, Floats]


@dataclass(frozen=True, slots=True)
class Call:
    """A way to call from Python: ``once`` computes ``states`` states, ``torque`` is what it gives in state
    k."""

    key: str
    title: str
    once: Callable[[], Any]
    states: int
    torque: Callable[[int], Any]


def own_calls(robot: Robot, states: States, **build: Any) -> list[Call]:
    """Ours: through a workspace, through the method, and batches; ``build`` goes to the compiler."""
    from robodyn.kernels.robot_kernel import compile as compiled

    kernel = compiled(robot, functions=("inverse_dynamics",), trig="builtin", **build)
    workspace: Any = kernel.workspace()
    function: Any = kernel.inverse_dynamics
    q, qd, qdd = states

    def torque(k: int) -> Any:
        workspace.q, workspace.qd, workspace.qdd = q[k], qd[k], qdd[k]
        workspace()
        return workspace.tau.copy()

    calls = [
        Call("workspace", "robodyn, Workspace()", workspace, 1, torque),
        Call(
            "function",
            "robodyn, kernel.inverse_dynamics(q, qd, qdd)",
            lambda: function(q[0], qd[0], qdd[0]),
            1,
            lambda k: function(q[k], qd[k], qdd[k]),
        ),
    ]
    columns = [np.asfortranarray(np.resize(x, (BATCH, robot.n))) for x in states]
    rows = [np.ascontiguousarray(x) for x in columns]
    for key, title, arrays in (("F", "column by column", columns), ("C", "row by row", rows)):
        once = partial(kernel.batch, *arrays, out=np.empty_like(arrays[0]))
        title = f"robodyn, batch of {BATCH}, {title}"
        calls.append(Call(f"batch-{key}", title, once, BATCH, partial(_of_batch, once)))
    return calls


def _of_batch(once: Callable[[], Any], k: int) -> Any:
    return once()[k].copy()


def pinocchio_call(robot: Robot, states: States) -> Call:
    """``pin.rnea``."""
    import pinocchio as pin

    model = pinocchio_model(numbers_of(robot))
    data = model.createData()
    rnea, (q, qd, qdd) = pin.rnea, (x[0].copy() for x in states)
    return Call(
        "pin.rnea",
        "pin.rnea",
        lambda: rnea(model, data, q, qd, qdd),
        1,
        lambda k: rnea(model, data, *(x[k] for x in states)).copy(),
    )


def casadi_call(robot: Robot, states: States) -> Call:
    """The textbook over SX, in CasADi's virtual machine."""
    title = "CasADi, FunctionBuffer, in its virtual machine"
    return buffered("casadi", title, casadi_function(robot), states)


def buffered(key: str, title: str, function: Any, states: States) -> Call:
    """A function of CasADi through its ``FunctionBuffer``, the cheapest way to call it."""
    buffer, run = function.buffer()
    arrays: list[Any] = [x[0].copy() for x in states]
    tau: Any = np.zeros(states[0].shape[1])
    for i, array in enumerate(arrays):
        buffer.set_arg(i, memoryview(array))
    buffer.set_res(0, memoryview(tau))
    kept = (function, buffer, arrays)  # `run` points into them and does not hold them

    def torque(k: int, kept: Any = kept) -> Any:
        for array, values in zip(arrays, states, strict=True):
            array[:] = values[k]
        run()
        return tau.copy()

    return Call(key, title, run, 1, torque)


def mujoco_call(robot: Robot, states: States) -> Call:
    """``mujoco.mj_inverse``."""
    import mujoco

    model = mujoco_model(numbers_of(robot))
    data = mujoco.MjData(model)
    inverse = mujoco.mj_inverse
    mujoco.set_mju_user_warning(lambda _: None)  # of singular mass matrices, which it does not need
    data.qpos[:], data.qvel[:], data.qacc[:] = (x[0] for x in states)

    def torque(k: int) -> Any:
        data.qpos[:], data.qvel[:], data.qacc[:] = (x[k] for x in states)
        inverse(model, data)
        return data.qfrc_inverse.copy()

    return Call("mj_inverse", "mujoco.mj_inverse", lambda: inverse(model, data), 1, torque)


#: The peers that can be called from Python, by the module that each needs.
PEERS: Final[dict[str, Callable[[Robot, States], Call]]] = {
    "pinocchio": pinocchio_call,
    "mujoco": mujoco_call,
    "casadi": casadi_call,
}


def checked(call: Call, wanted: Floats, count: int = 32) -> float:
    """The worst difference to the torques ``wanted`` [N, n].

    Raises
    ------
    Disagreement: it is too large.
    """
    torques = np.array([call.torque(k) for k in range(min(count, len(wanted)))])
    return hold_against(call.title, wanted[: len(torques)], torques)


def raced(calls: Sequence[Call], rounds: int, block_s: float = 1e-3) -> Floats:
    """Nanoseconds a state [rounds, calls], of this thread's processor time."""
    repeats = [max(1, round(block_s / _seconds(call.once, 5))) for call in calls]
    times = np.empty((rounds, len(calls)))
    for k in range(rounds):
        for i in range(len(calls)):
            j = (i + k) % len(calls)
            call = calls[j]
            call.once()
            times[k, j] = 1e9 * _seconds(call.once, repeats[j]) / call.states
    return times


def _seconds(once: Callable[[], Any], repeats: int) -> float:
    start = time.thread_time_ns()
    for _ in itertools.repeat(None, repeats):
        once()
    return max(1e-9, 1e-9 * (time.thread_time_ns() - start) / repeats)


# --- models -----------------------------------------------------------------------------------------------


def pinocchio_model(arm: Numbers) -> Any:
    """A model of ``pin``: one joint about or along z a link, rotors as ``armature``."""
    import pinocchio as pin

    model = pin.Model()
    model.name = arm.name
    model.gravity = pin.Motion(arm.gravity, np.zeros(3))
    parent = 0
    for i, link in enumerate(arm.links):
        kind = pin.JointModelRZ() if link.revolute else pin.JointModelPZ()
        parent = model.addJoint(parent, kind, pin.SE3(link.rotation, link.position), f"joint{i + 1}")
        body = pin.Inertia(link.mass, link.com, link.inertia)
        model.appendBodyToJoint(parent, body, pin.SE3.Identity())
    model.armature = np.array([link.rotor for link in arm.links])
    return model


_HEAD = """<mujoco model="{name}">
<compiler angle="radian" autolimits="false"/>
<option gravity="{gravity}">
<flag contact="disable" constraint="disable" equality="disable" limit="disable" frictionloss="disable"
 actuation="disable"/>
</option>
<worldbody>
"""


def mujoco_model(arm: Numbers) -> Any:
    """A model of ``mujoco`` with nothing but the arm in it, contacts and constraints switched off.

    Its compiler refuses links without mass or that break the triangle inequality, though its arithmetic
    handles them: every link passes the compiler with a stand-in, and the link's own numbers are written over
    it.
    """
    import mujoco

    parts = [_HEAD.format(name=arm.name, gravity=_spelled(arm.gravity))]
    for link in arm.links:
        axes = _spelled([*link.rotation[:, 0], *link.rotation[:, 1]])
        kind = "hinge" if link.revolute else "slide"
        parts.append(
            f'<body pos="{_spelled(link.position)}" xyaxes="{axes}">'
            f'<joint type="{kind}" axis="0 0 1" armature="{link.rotor!r}"/>'
            '<inertial pos="0.1 0.2 0.3" quat="0.5 0.1 0.2 0.3" mass="1" diaginertia="1 1.1 1.2"/>\n'
        )
    text = "".join(parts) + "</body>" * arm.n + "</worldbody></mujoco>"
    model = mujoco.MjModel.from_xml_string(text)
    for body, link in enumerate(arm.links, 1):
        model.body_mass[body], model.body_ipos[body] = link.mass, link.com
        model.body_inertia[body], model.body_iquat[body] = _principal(link)
    total = model.body_mass.copy()
    for body in range(arm.n, 0, -1):
        total[body - 1] += total[body]
    model.body_subtreemass[:] = total
    return model


def _principal(link: LinkNumbers) -> tuple[Any, Any]:
    """Principal moments [3] and their axes as a quaternion [4]."""
    import mujoco

    moments, axes = np.linalg.eigh(link.inertia)
    if np.linalg.det(axes) < 0:
        axes[:, 0] = -axes[:, 0]
    turn = np.zeros(4)
    mujoco.mju_mat2Quat(turn, axes.ravel())
    return moments, turn


def _spelled(numbers: Any) -> str:
    return " ".join(repr(float(x)) for x in numbers)


def casadi_function(robot: Robot, name: str = "inverse_dynamics") -> Any:
    """Plain Newton-Euler as a function of ``casadi`` over SX, equal nodes merged (``casadi.cse``)."""
    import casadi

    def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
        ((joint, _),) = angle.terms
        whole = q[joint] + angle.offset.radians
        return casadi.cos(whole), casadi.sin(whole)

    symbols = [casadi.SX.sym(array, robot.n) for array in ("q", "qd", "qdd")]
    q, qd, qdd = (casadi.vertsplit(symbol) for symbol in symbols)
    arm = build_arm(robot, _plain, float)  # there are no run-time parameters
    tau = newton_euler(arm, build_motion(arm, q, qd, qdd, trigonometry, _plain))
    return casadi.Function(name, symbols, [casadi.cse(casadi.vertcat(*tau))])


def _plain(x: Fraction) -> float:
    """A number; 0, 1 and -1 as integers, which the recursion leaves out."""
    return int(x) if x in (0, 1, -1) else float(x)
