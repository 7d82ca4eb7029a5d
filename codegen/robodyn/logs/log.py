"""Logs: what a robot's controller, or a simulation in its place, records of a motion.

As text: ``t,q1..qn,qd1..qdn,qdd1..qddn,tau1..taun`` in SI units, a line a sample; velocities and
accelerations may be absent. Parquet has the same columns. Where a log comes from is told by the file beside
it, ``LOG.csv.json``, which depends on nothing but the run: no time of day, no place in a file system.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, is_dataclass
from fractions import Fraction
from pathlib import Path, PurePath, PureWindowsPath
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.files import label, parsed_json, read_bytes
from robodyn.logs.csv_file import read_csv, write_csv
from robodyn.logs.parquet_file import read_parquet, write_parquet
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot
from robodyn.robot.values import Affine

Floats = NDArray[np.float64]

_PARQUET = (".parquet", ".pq")
_PROVENANCE = 1 << 24  # bytes of the file beside a log, at most


@dataclass(frozen=True, slots=True, eq=False)
class Log:
    """Samples of a motion: ``t`` [K] (s); ``q``, ``qd``, ``qdd`` [K, n] (rad or m, per second, per second
    squared), the rates None where they were not recorded; ``tau`` [K, n] (N m or N).

    ``provenance`` is what :func:`provenance` says of a run; ``ignored`` are the columns of a file that were
    not read. NaN and infinity may stand anywhere.

    Raises
    ------
    InputError: the arrays do not fit together.
    """

    t: Floats
    q: Floats
    qd: Floats | None
    qdd: Floats | None
    tau: Floats
    provenance: Mapping[str, Any] = field(default_factory=dict)
    ignored: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        for name in ("t", "q", "qd", "qdd", "tau"):
            value = getattr(self, name)
            if value is not None:
                object.__setattr__(self, name, np.asarray(value, dtype=np.float64))
        shape = self.q.shape
        fits = len(shape) == 2 and shape[0] > 0 and shape[1] > 0 and self.t.shape == shape[:1]
        if not fits or any(array.shape != shape for _, array in self._groups()):
            columns = [("t", self.t), *self._groups()]
            raise InputError(
                "the arrays of a log do not fit together",
                found=", ".join(f"{name} {list(array.shape)}" for name, array in columns),
                expected="t [K] and all others [K, n], K and n at least 1",
            )

    @property
    def n(self) -> int:
        """Number of joints."""
        return int(self.q.shape[1])

    @property
    def samples(self) -> int:
        """Number of samples, K."""
        return len(self.t)

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of its columns, in the order of the text."""
        joints = range(1, self.n + 1)
        return ("t", *(f"{name}{i}" for name, _ in self._groups() for i in joints))

    def arrays(self) -> list[Floats]:
        """Its columns, [K] each."""
        return [self.t, *(array[:, i] for _, array in self._groups() for i in range(self.n))]

    def csv(self) -> str:
        """Its text: shortest numbers that read back as the same doubles, lines that end in a newline."""
        return write_csv(self.columns, self.arrays())

    def parquet(self) -> bytes:
        """The bytes of a Parquet file of the same columns.

        Raises
        ------
        ToolError: pyarrow is missing.
        """
        return write_parquet(self.columns, self.arrays())

    def files(self, name: str) -> dict[str, str | bytes]:
        """The log called ``name`` (by its ending text or Parquet), and ``NAME.json`` with its provenance.

        Raises
        ------
        ToolError: it is to be Parquet, and pyarrow is missing.
        """
        content = self.parquet() if name.lower().endswith(_PARQUET) else self.csv()
        return {name: content, f"{name}.json": provenance_text(self.provenance)}

    def _groups(self) -> list[tuple[str, Floats]]:
        groups = (("q", self.q), ("qd", self.qd), ("qdd", self.qdd), ("tau", self.tau))
        return [(name, array) for name, array in groups if array is not None]


# --- where a log comes from -------------------------------------------------------------------------------


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


def read_provenance(path: str | os.PathLike[str]) -> dict[str, Any] | None:
    """What the file beside the log at ``path`` says, or None where there is none.

    Raises
    ------
    InputError: there is a file, and it is no JSON object.
    """
    beside = Path(f"{os.fspath(path)}.json")
    if not beside.is_file():
        return None
    data = read_bytes(beside, _PROVENANCE, "the provenance of a log")
    try:
        entries = parsed_json(data)
    except ValueError as error:
        entries = str(error)
    if not isinstance(entries, dict):
        raise InputError(
            "this is not the provenance of a log",
            where=Place(label(beside)),
            found=entries if isinstance(entries, str) else "other JSON",
            expected="a JSON object",
            remedy="delete it, or write the log again",
        )
    return entries


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


# --- reading ----------------------------------------------------------------------------------------------


def read_log(path: str | os.PathLike[str], n: int | None = None) -> Log:
    """The log in the file ``path``: Parquet if its name ends in .parquet or .pq, else text.

    ``n``: how many joints are read; None: as many as the columns number. Columns are found by name, in any
    order; all others are listed in ``ignored``. NaN and infinity are read, words are not.

    Raises
    ------
    InputError: no such file, or not such a log; with file, line and column of what is wrong.
    ToolError: it is Parquet, and pyarrow is missing.
    """
    name = os.fspath(path)
    file, place = label(name), Path(name)
    if n is not None and n < 1:
        raise InputError("a log is of one joint or more", found=f"n = {n}")
    try:
        read = read_parquet if name.lower().endswith(_PARQUET) else read_csv
        layout, tables = read(place, file, n)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise InputError("the log cannot be read", where=Place(file), found=reason.lower()) from None
    except MemoryError:
        raise InputError(
            "the log does not fit into memory",
            where=Place(file),
            remedy="take a part of it, or fewer samples a second",
        ) from None
    return Log(
        tables["t"][:, 0], tables["q"], tables.get("qd"), tables.get("qdd"), tables["tau"], {}, layout.ignored
    )
