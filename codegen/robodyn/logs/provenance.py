"""Where a log comes from: the file beside it, ``LOG.csv.json``, which depends on nothing but the run."""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Mapping
from dataclasses import asdict, is_dataclass
from fractions import Fraction
from pathlib import PurePath, PureWindowsPath
from typing import Any

import numpy as np

from robodyn.robot.identity import identity
from robodyn.robot.model import Robot
from robodyn.robot.values import Affine


def provenance(
    robot: Robot,
    *,
    yaml: str | bytes | None = None,
    options: Mapping[str, Any] | None = None,
    sensors: Mapping[str, Any] | None = None,
    seed: int | None = None,
    solver: str | None = None,
    step: float | None = None,
    energy: Mapping[str, float] | None = None,
) -> dict[str, Any]:
    """What there is to say of a simulated log, ready for JSON; the same run always gives the same.

    ``yaml``: the robot's text, of which the hash is kept; ``options``: the command's, in which a path keeps
    only its last part; ``sensors``: their description; ``step`` [s]; ``energy``: the balance [J].
    """
    from importlib.metadata import version

    data = yaml.encode() if isinstance(yaml, str) else yaml
    linear = [link.joint.kind == "prismatic" for link in robot.links]
    way = ["m" if each else "rad" for each in linear]
    entries = {
        "robodyn": version("robodyn"),
        "robot": robot.name,
        "identity": identity(robot),
        "sha256": None if data is None else hashlib.sha256(data).hexdigest(),
        "options": options or {},
        "effects": [
            {"effect": entry.effect, "joint": entry.joint, **dict(entry.settings)} for entry in robot.effects
        ],
        "sensors": sensors,
        "seed": seed,
        "solver": solver,
        "step": step,
        "energy": energy,
        "units": {
            "t": "s",
            "q": way,
            "qd": [f"{unit}/s" for unit in way],
            "qdd": [f"{unit}/s^2" for unit in way],
            "tau": ["N" if each else "N m" for each in linear],
        },
    }
    plain: dict[str, Any] = _plain(entries)
    return plain


def provenance_text(data: Mapping[str, Any]) -> str:
    """``data`` as JSON, the text of the file beside a log; numbers that JSON lacks become words."""
    return json.dumps(_plain(data), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def _plain(value: Any) -> Any:
    """``value`` of what JSON has: fractions as numbers, paths by their last part, nan and inf as words."""
    if isinstance(value, Mapping):
        return {str(key): _plain(each) for key, each in value.items()}
    if isinstance(value, Affine):
        terms = [f"{float(factor)!r}*{name}" for name, factor in value.terms]
        return " + ".join([repr(float(value.constant)), *terms] if value.constant else terms)
    if is_dataclass(value) and not isinstance(value, type):
        return _plain(asdict(value))
    if isinstance(value, (np.ndarray, np.generic)):
        return _plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [_plain(each) for each in value]
    if isinstance(value, (float, Fraction)):
        converted = float(value)
        return converted if math.isfinite(converted) else repr(converted)
    if isinstance(value, PurePath):
        return value.name
    if isinstance(value, str):
        away = PurePath(value).is_absolute() or PureWindowsPath(value).is_absolute()
        return PureWindowsPath(value).name if away else value
    return value if value is None or isinstance(value, (bool, int)) else str(value)
