"""How sure the numbers of an identified arm are: their covariance, from the fit to a file and back.

Torques show sums of numbers and not each of them, so shares link by link would say too much of what was
identified or too little: a mass may be open to a third while every torque of the motion is known to a
hundredth. Only the covariance says both.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
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
    """That of an identified arm as ``identify.json`` has it."""
    known = robot.covariance
    assert known is not None
    assert known.values is not None
    assert known.root is not None
    return {"values": known.values.tolist(), "root": known.root.tolist()}


def spread_of(robot: Robot, shares: Floats) -> Floats | None:
    """Rows [r, 11 n] whose squares sum to the covariance of links' and rotors' numbers, None where the
    description names no file that says it. ``shares`` [n, 10]: standard deviations about the description of
    links that are no longer as they were identified.

    Raises
    ------
    InputError: the file is not beside the description, or is of another arm.
    """
    known = robot.covariance
    if known is None:
        return None
    if known.values is None or known.root is None:
        known = _read(robot, known.file)
    assert known.values is not None
    assert known.root is not None
    links = slice(0, 10 * robot.n)
    old, new = (x[links].reshape(-1, 10) for x in (known.values, numbers(robot)))
    changed = np.array([not np.allclose(a, b) for a, b in zip(new, old, strict=True)])
    more = np.zeros((robot.n * 10, 11 * robot.n))
    more[:, links] = np.diag((shares * changed[:, None]).ravel())
    return np.concatenate([known.root, more[more.any(axis=1)]])


def _read(robot: Robot, name: str) -> Covariance:
    if robot.file is None:
        raise InputError(
            f"{robot.name} was identified, and how sure its numbers are stands in {name}, which was not read",
            remedy="give the path of the description, which lies beside that file, or delete covariance",
        )
    path = robot.file.with_name(name)
    text = read_text(path, LARGEST_FILE, _EXPECTED)
    try:
        data = json.loads(text)["covariance"]
        values, root = (_array(data, key) for key in ("values", "root"))
    except (KeyError, TypeError, ValueError, RecursionError) as error:
        what, found = (
            "this file does not say how sure an arm's numbers are",
            f"{type(error).__name__}: {error}",
        )
        raise InputError(what, where=Place(label(path)), found=found, expected=_EXPECTED) from None
    if values.shape != (11 * robot.n,) or root.ndim != 2 or root.shape[1] != 11 * robot.n:
        raise InputError(
            "this file is of another arm",
            where=Place(label(path)),
            found=f"{values.size} numbers",
            expected=f"{11 * robot.n} numbers of {robot.n} links, as in {label(robot.file)}",
            remedy="identify the arm anew, or delete covariance from the description",
        )
    return Covariance(name, values, root)


def _array(data: Mapping[str, Any], key: str) -> Floats:
    array = np.array(data[key], dtype=float)
    if not np.isfinite(array).all():
        raise ValueError(f"{key} is not finite")
    return array
