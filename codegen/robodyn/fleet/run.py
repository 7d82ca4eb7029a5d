"""A fleet from its logs to what is said of it: what is new is digested, all is judged, some is diagnosed."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Any, Final, Literal

from robodyn.cluster import Cluster, Done, Security, open_cluster
from robodyn.cluster.work import WrongWorker, one_thread
from robodyn.errors import InputError
from robodyn.fleet.digest import DIGEST_VERSION
from robodyn.fleet.limits import FALSE_NAMES
from robodyn.fleet.pool.judge import judge
from robodyn.fleet.result import FleetResult, Unused
from robodyn.fleet.sources.fleet import Fleet
from robodyn.fleet.store import Refused, Store, key_of, open_store
from robodyn.fleet.units import Maker, completed, diagnosed
from robodyn.fleet.work import Changed, digest_log, digested, hash_here, unreadable, why
from robodyn.logs.content import digest, files_of, signature

#: What is told of a stage: its name, how much of it is done, and of how much.
Progress = Callable[[str, int, int], object]
#: The file of results in the folder of a fleet.
STORE: Final = "store.sqlite"
READING: Final = "looking for new logs"
DIGESTING: Final = "digesting logs"
DIAGNOSING: Final = "diagnosing units"
_DATELESS: Final = "nothing says when it was recorded: state it in the manifest, or in the name of its file"


def run_fleet(
    fleet: Fleet,
    folder: Path,
    on: str,
    *,
    diagnose: Literal["named", "all", "none"] = "named",
    files_of: Maker | None = None,
    false_names: float = FALSE_NAMES,
    security: Security | None = None,
    progress: Progress | None = None,
) -> FleetResult:
    """What is said of ``fleet``; what was worked out before is in ``folder``, and what is worked out now
    will be. Work runs ``on`` what :func:`~robodyn.cluster.open_cluster` takes, with its ``security``.

    Units that are named (or ``all``, or ``none``) are diagnosed if there is a ``files_of``, which makes the
    files of a diagnosis, by their names; they lie in ``folder`` by :func:`robodyn.fleet.result.unit_folder`.
    At most the share ``false_names`` of names is false, in the mean.
    The same logs come to the same result, wherever and in however many processes the work ran.

    Raises
    ------
    InputError: no log can be used, another run holds the folder, or ``on`` is no place.
    OutputError: there is no room in ``folder``; what is done stays done.
    ToolError: there is nothing to work with, or no longer.
    """
    tell = progress or (lambda *_: None)
    with ExitStack() as stack:
        stack.enter_context(one_thread())  # also where nothing is left to be worked out
        store = stack.enter_context(open_store(folder / STORE))
        opened: list[Cluster] = []

        def work(
            stage: str, function: Callable[..., bytes], tasks: Mapping[str, tuple[Any, ...]]
        ) -> dict[str, str]:
            """Have what is not in the store yet worked out where it is asked for."""
            new = {key: task for key, task in tasks.items() if not store.has(key)}
            if new and not opened:
                opened.append(stack.enter_context(open_cluster(on, security=security)))
            return _worked_out(store, opened, function, new, lambda done: tell(stage, done, len(new)))

        hashes, reasons = _contents(fleet, store, tell)
        arms = {log.source: fleet.types[log.type] for log in fleet.logs if log.source not in reasons}
        keys = {
            source: key_of("digest", DIGEST_VERSION, hashes[source], arm.text, arm.mapping or "")
            for source, arm in arms.items()
        }
        tasks = {keys[source]: (arm, (_absolute(source),), (hashes[source],)) for source, arm in arms.items()}
        failed = work(DIGESTING, digest_log, tasks)
        for source, key in keys.items():
            reason = failed.get(key) or store.refusal(key)
            if reason is not None:
                reasons[source] = reason
        undated = [log.source for log in fleet.logs if math.isnan(log.date) and log.source not in reasons]
        fleet = fleet.dated({source: digested(store.value(keys[source]))[0] for source in undated})
        reasons = {log.source: _DATELESS for log in fleet.logs if math.isnan(log.date)} | reasons
        unused = [
            Unused(log.source, log.type, log.unit, reasons[log.source])
            for log in fleet.logs
            if log.source in reasons
        ]
        unused = [*fleet.missing, *unused]
        used = replace(fleet, logs=tuple(log for log in fleet.logs if log.source not in reasons))
        if not used.logs:
            raise _nothing(fleet, unused)
        result = judge(
            used, lambda source: digested(store.value(keys[source]))[1], unused=unused,
            false_names=false_names, progress=lambda stage: tell(stage, 0, 0),
        )  # fmt: skip
        if files_of is None or diagnose == "none":
            return result
        named = [unit for unit in result.units if unit.claims or diagnose == "all"]
        logs = {_absolute(log.source): log for log in used.logs}
        contents = {path: hashes[log.source] for path, log in logs.items()}
        new = diagnosed(
            fleet.types, logs, contents, named, store, folder, files_of,
            lambda tasks, function: work(DIAGNOSING, function, tasks),
        )  # fmt: skip
        units = tuple(completed(unit, new) for unit in result.units)
        return replace(result, units=units)


def _absolute(source: str) -> str:
    """``source`` with absolute paths, whatever folder a worker was started in."""
    return "+".join(str(Path(part).absolute()) for part in files_of(source))


def _contents(fleet: Fleet, store: Store, tell: Progress) -> tuple[dict[str, str], dict[str, str]]:
    """The hashes of the content of logs, and why some of them do not count, by their sources; what was read
    before and is unchanged is not read again."""
    hashes, reasons = dict[str, str](), dict[str, str]()
    first = dict[tuple[str, str], str]()
    for k, log in enumerate(fleet.logs, 1):
        path = _absolute(log.source)
        try:
            here, youngest = signature(path)
            content = store.content(path, here)
            if content is None:
                content = digest(path)
                store.saw(path, here, youngest, content)
                tell(READING, k, len(fleet.logs))
        except OSError as error:
            named = f"; {log.named} names it" if log.named else ""
            reasons[log.source] = f"the file cannot be read: {unreadable(error)}{named}"
            continue
        hashes[log.source] = content
        original = first.setdefault((log.type, content), log.source)
        if original != log.source:  # it would count twice
            reasons[log.source] = f"it is a copy of {original}"
    return hashes, reasons


def _worked_out(
    store: Store,
    opened: Sequence[Cluster],
    function: Callable[..., bytes],
    tasks: Mapping[str, tuple[Any, ...]],
    tell: Callable[[int], object],
) -> dict[str, str]:
    """Keep in the ``store`` what ``function`` makes of ``tasks`` by their keys, each an arm, paths of logs,
    their hashes and more; why some come to nothing. What is no fault of a log is tried again in the next run.

    Raises
    ------
    WrongWorker: a worker does not see the logs that this process sees.
    """
    if not tasks:
        return {}
    tell(0)
    reasons = {}
    for k, (key, outcome) in enumerate(opened[0].each(function, tasks.items()), 1):
        if isinstance(outcome, Done):
            store.keep(key, outcome.value)
        else:
            _, paths, hashes, *_ = tasks[key]
            reasons[key] = why(outcome.error, paths)
            if isinstance(outcome.error, InputError):
                store.keep(key, Refused(reasons[key]))
            elif isinstance(outcome.error, Changed) and [hash_here(path)[0] for path in paths] == list(
                hashes
            ):
                raise WrongWorker(
                    f"a worker does not see the same file as this process: {', '.join(paths)}",
                    found=reasons[key],
                    expected="the same file under the same path for this process and all workers",
                    remedy="put the logs on a file system that all of them share, such as a network drive",
                )
        tell(k)
    return reasons


def _nothing(fleet: Fleet, unused: Sequence[Unused]) -> InputError:
    """The error of a fleet that has no log that can be used."""
    if not fleet.logs:
        return InputError(f"the fleet {fleet.name} has no logs")
    return InputError(
        f"no log of the fleet {fleet.name} can be used",
        found=f"{len(unused)} that cannot, the first {unused[0].source}: {unused[0].why}",
        remedy="mend the logs, their map, or the description of their type",
    )
