"""How sure the numbers of an identified arm are: their covariance, from the fit to a file and back.

Torques show sums of numbers and not each of them, so shares link by link would say too much of what was
identified or too little: a mass may be open to a third while every torque of the motion is known to a
hundredth. Only the covariance says both.
"""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any, Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.files import label, read_text
from robodyn.identify.fit import Fit
from robodyn.identify.limits import LARGEST_FILE, RANK
from robodyn.identify.prior import number_of
from robodyn.kernels.array_dynamics import Model
from robodyn.robot.model import Covariance, Robot

#: The file that says it, beside the description.
DATA_FILE: Final = "identify.json"
_EXPECTED: Final = "what `robodyn identify` wrote beside the description"


def with_covariance(robot: Robot, fit: Fit) -> Robot:
    """``robot``, which has the numbers of a fit, with their covariance."""
    n = robot.n
    at = np.concatenate([fit.layout.link(k) for k in range(n)])
    if "rotor" in fit.layout.own:
        at = np.concatenate([at, fit.layout.joint("rotor")])
    spread = fit.covariance[np.ix_(at, at)]
    size = np.sqrt(np.maximum(np.diag(spread), 1e-300))
    shares, ways = np.linalg.eigh(spread / np.outer(size, size))
    is_open = shares > RANK * shares.max()
    root = np.zeros((int(is_open.sum()), 11 * n))
    root[:, : len(at)] = (ways[:, is_open] * np.sqrt(shares[is_open])).T * size
    return replace(robot, covariance=Covariance(DATA_FILE, numbers(robot), root))


def numbers(robot: Robot) -> Floats:
    """Ten standard parameters of each link, then the rotors [11 n]."""
    rotors = [number_of(link.joint.motor_inertia) for link in robot.links]
    return np.concatenate([Model(robot).standard_parameters().ravel(), rotors])


def covariance_to_dict(robot: Robot) -> dict[str, Any]:
    """The covariance of an identified arm as ``identify.json`` has it."""
    values, root = _covariance(robot)
    return {"values": values.tolist(), "root": root.tolist()}


def covariance_text(robot: Robot) -> str | None:
    """A file like ``identify.json`` with the covariance alone; None where ``robot`` has none."""
    return None if robot.covariance is None else json.dumps({"covariance": covariance_to_dict(robot)}) + "\n"


def with_covariance_read(robot: Robot) -> Robot:
    """``robot`` with the covariance that its description names, if it names one.

    Raises
    ------
    InputError: the file is not beside the description, is of another arm, or does not say it.
    """
    if robot.covariance is None or robot.covariance.root is not None:
        return robot
    if robot.file is None:
        raise InputError(
            f"how sure the numbers of {robot.name} are stands in a file beside its description",
            found=f"a description without a path, which names {robot.covariance.file}",
            remedy="give the path of the description, or delete covariance from it",
        )
    path = robot.file.with_name(robot.covariance.file)
    return with_covariance_of(robot, read_text(path, LARGEST_FILE, _EXPECTED), label(path))


def with_covariance_of(robot: Robot, text: str, source: str) -> Robot:
    """``robot``, whose description names a covariance, with that in the ``text`` of a file; messages call the
    file ``source``.

    Raises
    ------
    InputError: it is of another arm, or does not say it.
    """
    assert robot.covariance is not None
    size = 11 * robot.n
    try:
        data = json.loads(text)
        if not isinstance(data, dict) or not isinstance(data.get("covariance"), dict):
            raise ValueError("no object `covariance`")
        data = data["covariance"]
        values, root = (np.array(data[key], dtype=float) for key in ("values", "root"))
        most = np.finfo(np.float32).max  # a square is finite
        if not all(np.all(np.abs(x) < most) for x in (values, root)):
            raise ValueError("a number is not finite, or too large")
    except (KeyError, TypeError, ValueError, ArithmeticError, RecursionError) as error:
        raise InputError(
            "this file does not say how sure an arm's numbers are",
            where=Place(source),
            found=f"{type(error).__name__}: {error}",
            expected=_EXPECTED,
        ) from None
    if values.shape != (size,) or root.ndim != 2 or root.shape[1] != size or len(root) > size:
        raise InputError(
            "this file is of another arm",
            where=Place(source),
            found=f"{values.size} numbers and a root of the shape {list(root.shape)}",
            expected=f"{size} numbers of {robot.n} links, and at most as many rows of them",
            remedy="identify the arm anew, or delete covariance from the description",
        )
    return replace(robot, covariance=replace(robot.covariance, values=values, root=root))


def spread_of(robot: Robot, shares: Floats) -> Floats | None:
    """Rows [r, 11 n] whose squares sum to the covariance of links' and rotors' numbers, None where the
    description names none. ``shares`` [n, 10]: standard deviations about the description of links that are no
    longer as they were identified."""
    if robot.covariance is None:
        return None
    values, root = _covariance(robot)
    links = slice(0, 10 * robot.n)
    old, new = (x[links].reshape(-1, 10) for x in (values, numbers(robot)))
    changed = np.array([not np.allclose(a, b) for a, b in zip(new, old, strict=True)])
    more = np.zeros((robot.n * 10, 11 * robot.n))
    more[:, links] = np.diag((shares * changed[:, None]).ravel())
    return np.concatenate([root, more[more.any(axis=1)]])


def _covariance(robot: Robot) -> tuple[Floats, Floats]:
    known = robot.covariance
    assert known is not None, "only of an arm that was identified"
    assert known.values is not None, "with_covariance_read comes first"
    assert known.root is not None
    return known.values, known.root
