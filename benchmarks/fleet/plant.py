"""A whole simulated fleet: logs of many units, and what is planted in some of them."""

from __future__ import annotations

import hashlib
import json
import shutil
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Final, Literal

import numpy as np
from benchmarks.fleet.changes import CLOCK_RUNS, DATE_LOST, FRICTION, PROGRAM, Change
from benchmarks.fleet.recipe import Recipe
from benchmarks.fleet.types import TrueType, draw_type
from benchmarks.fleet.units import LOAD, PLAY, Moved, draw_unit, log_of_day, moved, shown_temperature

from robodyn.cluster import Cluster, Failed
from robodyn.cluster.cluster import ThisProcess
from robodyn.diagnose.blind.seal import seal
from robodyn.errors import InputError
from robodyn.files import cannot_write
from robodyn.fleet.as_json import day
from robodyn.robot.model import Robot

Format = Literal["csv", "parquet"]
#: Says which recipe a folder is being filled by; gone when it is full.
_BEGUN: Final = "planting.json"
#: What to do where a log cannot be written.
_AGAIN: Final = "make room and run it again: it goes on where it was"
#: What the folder has at last, beside the logs.
FLEET, MANIFEST, ANSWER = "fleet.toml", "manifest.csv", "answer.sealed"


@dataclass(frozen=True, slots=True)
class Place:
    """A unit of the fleet: the index of its type, its name, what is planted (None: nothing), its seed."""

    type: int
    name: str
    kind: str | None
    seed: int


@dataclass(frozen=True, slots=True)
class LogOfUnit:
    """A log that was written: its path in the fleet's folder, when it was recorded [s since 1970], and the
    temperature that it states [deg C]."""

    path: str
    date: float
    temperature: float


@dataclass(frozen=True, slots=True)
class Planted:
    """A fleet whose logs are written: ``files`` by name that go with them, and the ``answer``; how many
    ``units``, ``logs`` and ``changes`` there are."""

    files: dict[str, str]
    answer: dict[str, Any]
    units: int
    logs: int
    changes: int


def plant_fleet(
    robots: Sequence[Robot],
    recipe: Recipe,
    folder: Path,
    *,
    format: Format = "parquet",
    cluster: Cluster | None = None,
    progress: Callable[[int, int], object] = lambda done, all: None,
    cache: Path | None = None,
    by: Moved = moved,
) -> Planted:
    """Logs of a fleet of types modelled on ``robots`` into ``folder``, written by processes of ``cluster``
    (None: this one); the same bytes wherever that is. Arms are moved ``by`` a function that processes can
    import.

    Where a run with the same recipe was broken off, only the rest is written. :func:`finish` writes what goes
    with the logs.

    Raises
    ------
    InputError: a robot cannot be simulated, two have one name, something cannot be planted, or the folder has
        logs of something else.
    ToolError: no C compiler; no pyarrow for Parquet; a process has ended.
    OutputError: the disk is full.
    """
    names = [robot.name for robot in robots]
    if len(set(names)) < len(names):
        raise InputError("two types of the fleet have one name", found=", ".join(names))
    streams = np.random.SeedSequence(recipe.seed).spawn(len(robots) + 1)
    types = [
        draw_type(robot, recipe, np.random.default_rng(stream), cache)
        for robot, stream in zip(robots, streams, strict=False)
    ]
    places = _places(names, recipe, np.random.default_rng(streams[-1]))
    _begin(folder, _key(types, recipe, format))
    rows: dict[int, tuple[tuple[LogOfUnit, ...], Change | None]] = {}
    tasks = (
        (k, (types[place.type], place, recipe, folder.absolute(), format, cache, by))
        for k, place in enumerate(places)
    )
    for k, result in (cluster or ThisProcess()).each(_write_unit, tasks):
        if isinstance(result, Failed):
            raise result.error
        rows[k] = result.value
        progress(len(rows), len(places))
    listed = [(place, *rows[k]) for k, place in enumerate(places)]
    lines = ["source,type,unit,date" + (",temperature" if recipe.temperature else "")]
    for place, logs, _ in listed:
        for log in logs:
            line = f"{log.path},{names[place.type]},{place.name},{day(log.date)}"
            lines.append(f"{line},{log.temperature:.1f}" if recipe.temperature else line)
    sheets = {f"types/{name}.yaml": true.sheet for name, true in zip(names, types, strict=True)}
    files = {**sheets, MANIFEST: "\n".join(lines) + "\n", FLEET: _toml(names)}
    planted = [
        {"type": names[place.type], "unit": place.name, **_described(change)}
        for place, _, change in listed
        if change is not None
    ]
    units = {name: [p.name for p in places if names[p.type] == name] for name in names}
    answer = {"fleet": units, "planted": planted, "recipe": asdict(recipe)}
    return Planted(files, answer, len(places), sum(len(logs) for _, logs, _ in listed), len(planted))


def _places(names: Sequence[str], recipe: Recipe, rng: np.random.Generator) -> list[Place]:
    """The units, types in turn, with what is planted where."""
    shares = [
        (FRICTION, recipe.friction_units),
        (PLAY, recipe.play_units),
        (LOAD, recipe.payload_units),
        (PROGRAM, recipe.program_units),
        (CLOCK_RUNS, recipe.clock_units),
        (DATE_LOST, recipe.date_units),
        *recipe.effects,
    ]
    kinds: list[str | None] = [kind for kind, share in shares for _ in range(round(share * recipe.units))]
    if len(kinds) > recipe.units:
        raise InputError("more is planted than there are units", found=f"{len(kinds)} of {recipe.units}")
    kinds += [None] * (recipe.units - len(kinds))
    order = rng.permutation(recipe.units)
    digits = len(str(-(-recipe.units // len(names))))
    return [
        Place(
            k % len(names),
            f"{names[k % len(names)]}-{k // len(names) + 1:0{digits}d}",
            kinds[order[k]],
            int(rng.integers(1 << 62)),
        )
        for k in range(recipe.units)
    ]


def _write_unit(
    true: TrueType, place: Place, recipe: Recipe, folder: Path, format: Format, cache: Path | None, by: Moved
) -> tuple[tuple[LogOfUnit, ...], Change | None]:
    """Write the logs of a unit, all of them or none; what was written."""
    unit = draw_unit(place.kind, true, recipe, place.seed, cache)
    target = folder / "logs" / true.robot.name / place.name
    logs = []
    for k, date in enumerate(unit.dates.tolist()):
        name = f"{day(date).replace(':', '')}.{format}"
        path = f"logs/{true.robot.name}/{place.name}/{name}"
        logs.append(LogOfUnit(path, unit.stated_date(k), shown_temperature(unit, k, recipe)))
    if target.exists():
        return tuple(logs), unit.change
    part = target.with_name(f".{place.name}.part")
    try:
        shutil.rmtree(part, ignore_errors=True)
        part.mkdir(parents=True)
        for k, log in enumerate(logs):
            recorded = log_of_day(unit, k, true, recipe, cache, by)
            content = recorded.parquet() if format == "parquet" else recorded.csv().encode()
            (part / Path(log.path).name).write_bytes(content)
        part.rename(target)
    except OSError as error:
        raise cannot_write(str(target), error, _AGAIN) from None
    return tuple(logs), unit.change


def _key(types: Sequence[TrueType], recipe: Recipe, format: Format) -> str:
    """What the bytes of the logs depend on."""
    whole = [asdict(recipe), format, [true.sheet for true in types]]
    return hashlib.sha256(json.dumps(whole, sort_keys=True).encode()).hexdigest()


def _begin(folder: Path, key: str) -> None:
    begun = folder / _BEGUN
    if begun.exists():
        if json.loads(begun.read_text(encoding="utf-8")).get("recipe") == key:
            return
        present = "logs of another recipe, broken off"
    elif (folder / "logs").exists():
        present = "logs"
    else:
        try:
            folder.mkdir(parents=True, exist_ok=True)
            begun.write_text(json.dumps({"recipe": key}) + "\n", encoding="utf-8")
        except OSError as error:
            raise cannot_write(str(folder), error, "choose another folder with -o") from None
        return
    raise InputError(
        f"{folder.name} is not empty", found=present, remedy="choose another folder, or delete this one"
    )


def finish(folder: Path, fleet: Planted) -> None:
    """Write what goes with the logs of a ``fleet`` in ``folder``, and its sealed answer."""
    for name, text in {**fleet.files, ANSWER: seal(fleet.answer)}.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    (folder / _BEGUN).unlink(missing_ok=True)


def _toml(names: Sequence[str]) -> str:
    lines = ['name = "simulated"', ""]
    for name in names:
        lines += [f"[types.{name}]", f'robot = "types/{name}.yaml"', ""]
    lines += ["[[logs]]", f'manifest = "{MANIFEST}"', ""]
    return "\n".join(lines)


def _described(change: Change) -> dict[str, Any]:
    """A change as the answer has it."""
    full = None if change.begin is None else day(change.begin + change.growth)
    return {
        "kind": change.kind,
        "effects": list(change.effects),
        "joint": change.joint,
        "shape": change.shape,
        "since": None if change.begin is None else day(change.begin),
        "full": full,
        "parameters": dict(change.parameters),
    }
