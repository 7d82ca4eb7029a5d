"""A described arm in Pinocchio, for its regressor: none of our dynamics is in it."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from robodyn.robot.model import Inertia, Joint, Robot
from robodyn.robot.values import Affine, Value

Floats = NDArray[np.float64]

#: Random states from which the columns that can be told apart are found.
_STATES = 200
_DEPENDENT = 1e-7


def pinocchio_model(robot: Robot) -> pin.Model:
    """The links of ``robot`` without rotors and effects; friction is not known to Pinocchio's regressor."""
    model = pin.Model()
    model.gravity = pin.Motion(np.array([float(g) for g in robot.gravity]), np.zeros(3))
    parent = 0
    for k, link in enumerate(robot.links):
        kind = pin.JointModelRZ() if link.joint.kind == "revolute" else pin.JointModelPZ()
        parent = model.addJoint(parent, kind, pin.SE3(*mount(link.joint)), f"joint{k + 1}")
        com = np.array([plain(c) for c in link.com])
        model.appendBodyToJoint(
            parent, pin.Inertia(plain(link.mass), com, tensor(link.inertia)), pin.SE3.Identity()
        )
    return model


def mount(joint: Joint) -> tuple[Floats, Floats]:
    """Rotation [3, 3] and place [3] (m) of a joint's frame at q = 0 in the frame of the link before it."""
    ca, sa = float(joint.alpha.cos), float(joint.alpha.sin)
    ct, st = float(joint.theta.cos), float(joint.theta.sin)
    about_x = np.array([[1, 0, 0], [0, ca, -sa], [0, sa, ca]])
    about_z = np.array([[ct, -st, 0], [st, ct, 0], [0, 0, 1]])
    return about_x @ about_z, about_x @ [plain(joint.a), plain(joint.b), plain(joint.d)]


def tensor(i: Inertia) -> Floats:
    """Inertia [3, 3] (kg m^2) about the centre of mass."""
    rows = (i.xx, i.xy, i.xz), (i.xy, i.yy, i.yz), (i.xz, i.yz, i.zz)
    return np.array([[plain(x) for x in row] for row in rows])


def plain(value: Value) -> float:
    """A number of a description; a run-time parameter raises ValueError."""
    if isinstance(value, Affine):
        raise ValueError(f"a peer needs numbers, not the run-time parameters {value.terms}")
    return float(value)


def regressor(model: pin.Model, q: Floats, qd: Floats, qdd: Floats) -> Floats:
    """Torques [K, n, 10 n] by unit inertial parameters of each link."""
    data = model.createData()
    rows = [
        np.array(pin.computeJointTorqueRegressor(model, data, *state))
        for state in zip(q, qd, qdd, strict=True)
    ]
    return np.array(rows).reshape(len(q), model.nv, 10 * model.nv)


def base_columns(model: pin.Model) -> NDArray[np.int_]:
    """The columns of :func:`regressor` that no motion at all shows to be sums of those before them."""
    from scipy.linalg import qr

    rng = np.random.default_rng(0)
    states = (rng.uniform(-3, 3, (_STATES, model.nv)) for _ in range(3))
    Y = regressor(model, *states).reshape(-1, 10 * model.nv)
    _, R, order = qr(Y, mode="economic", pivoting=True)
    size = np.abs(np.diag(R))
    return np.sort(order[: int((size > _DEPENDENT * size[0]).sum())])
