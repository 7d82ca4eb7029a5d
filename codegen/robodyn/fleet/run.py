"""A fleet from its logs to what is said of it: what is new is digested, all is judged, some is diagnosed."""

from __future__ import annotations

import math
from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final, Literal

from robodyn.cluster import Cluster, Done, Failed, Security, open_cluster
from robodyn.cluster.work import one_thread
from robodyn.errors import InputError
from robodyn.fleet.digest import DIGEST_VERSION, Digest
from robodyn.fleet.limits import FALSE_NAMES, HASHED
from robodyn.fleet.pool.judge import judge
from robodyn.fleet.result import FleetResult, Unused
from robodyn.fleet.sources.fleet import Fleet
from robodyn.fleet.store import Refused, Store, key_of, open_store
from robodyn.fleet.units import Maker, completed, diagnosed
from robodyn.fleet.work import (
    Changed,
    absolute_source,
    check_changed,
    check_same_file,
    contents,
    digest_log,
    digested,
    why,
)
from robodyn.logs.content import signature

#: What is told of a stage: its name, how much of it is done, and of how much.
Progress = Callable[[str, int, int], object]
#: The file of results in the folder of a fleet.
STORE: Final = "store.sqlite"
READING: Final = "looking for new logs"
DIGESTING: Final = "digesting logs"
DIAGNOSING: Final = "diagnosing units"
_DATELESS: Final = "nothing says when it was recorded: state it in the manifest, or in the name of its file"


class Digests(Mapping[str, Digest]):
    """Digests by the source of their log, taken out of the ``store`` one at a time: they need not fit into
    memory together. ``keys_of``: the key of each."""

    def __init__(self, store: Store, keys_of: Mapping[str, str]) -> None:
        self._store, self._keys = store, keys_of

    def __getitem__(self, source: str) -> Digest:
        return self._of(source)[1]

    def began(self, source: str) -> float:
        """When a log began [s since 1970, UTC; nan: it does not say]."""
        return self._of(source)[0]

    def _of(self, source: str) -> tuple[float, Digest]:
        data = self._store.result(self._keys[source])
        if not isinstance(data, bytes):
            raise KeyError(source)
        return digested(data)

    def without(self, sources: Container[str]) -> Digests:
        """These but those of ``sources``."""
        return Digests(self._store, {source: k for source, k in self._keys.items() if source not in sources})

    def __contains__(self, source: object) -> bool:
        return source in self._keys

    def __iter__(self) -> Iterator[str]:
        return iter(self._keys)

    def __len__(self) -> int:
        return len(self._keys)


@dataclass(frozen=True, slots=True)
class _Logs:
    """Of logs, by their source, the hash of the content; why others cannot be used."""

    hashes: Mapping[str, str]
    unused: Mapping[str, str]


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

        def cluster() -> Cluster:
            """What works, once it is needed."""
            if not opened:
                opened.append(stack.enter_context(open_cluster(on, security=security)))
            return opened[0]

        logs = _distinct(fleet, _read(fleet, store, cluster, tell))
        digests, refused = _digested(fleet, logs, store, cluster, tell)
        undated = [log.source for log in fleet.logs if math.isnan(log.date) and log.source in digests]
        fleet = fleet.completed({source: digests.began(source) for source in undated}, {})
        dateless = {log.source: _DATELESS for log in fleet.logs if math.isnan(log.date)}
        digests = digests.without(dateless)
        reasons = {**dateless, **logs.unused, **refused}
        unused = [
            *fleet.missing,
            *(
                Unused(log.source, log.type, log.unit, reasons[log.source])
                for log in fleet.logs
                if log.source in reasons
            ),
        ]
        if not digests:
            raise _nothing(fleet, unused)
        result = judge(
            fleet, digests, unused=unused, false_names=false_names, progress=lambda stage: tell(stage, 0, 0)
        )
        if files_of is None or diagnose == "none":
            return result
        named = [unit for unit in result.units if unit.claims or diagnose == "all"]
        pages = diagnosed(
            fleet, named, {source: logs.hashes[source] for source in digests}, store, cluster, folder,
            files_of, lambda done, of: tell(DIAGNOSING, done, of),
        )  # fmt: skip
        units = tuple(completed(unit, pages.get((unit.type, unit.unit))) for unit in result.units)
        return replace(result, units=units)


def _read(fleet: Fleet, store: Store, cluster: Callable[[], Cluster], tell: Progress) -> _Logs:
    """The content of all logs; what was read before and is unchanged is not read again."""
    hashes, unused, new = dict[str, str](), dict[str, str](), list[str]()
    paths = {log.source: absolute_source(log.source) for log in fleet.logs}
    signatures = {source: _signature(path) for source, path in paths.items()}
    for source, path in paths.items():
        here = signatures[source]
        content = None if here is None else store.content(path, here)
        if content is None:
            new.append(source)
        else:
            hashes[source] = content
    if new:
        tell(READING, len(hashes), len(fleet.logs))
        parts = [new[k : k + HASHED] for k in range(0, len(new), HASHED)]
        tasks = ((k, ([paths[source] for source in part],)) for k, part in enumerate(parts))
        for k, outcome in cluster().each(contents, tasks):
            if isinstance(outcome, Failed):
                raise outcome.error
            for source, read in zip(parts[k], outcome.value, strict=True):
                path, here = paths[source], signatures[source]
                if isinstance(read, str):
                    check_same_file(path, None, read)
                    unused[source] = read
                    continue
                content, worker_signature, youngest = read
                # Where it is being written here, too, the digest of the log finds out.
                if here is not None and here != worker_signature and here == _signature(path):
                    check_same_file(path, content, f"one with the SHA-256 {content[:16]}...")
                hashes[source] = content
                store.saw(path, worker_signature, youngest, content)
            tell(READING, len(hashes) + len(unused), len(fleet.logs))
    return _Logs(hashes, unused)


def _signature(path: str) -> str | None:
    """The signature of a log; None where it is not here: whoever works may see another file system."""
    try:
        return signature(path)[0]
    except OSError:
        return None


def _distinct(fleet: Fleet, logs: _Logs) -> _Logs:
    """``logs`` without those of a type that are copies of others: they would count twice."""
    first, copies = dict[tuple[str, str], str](), dict[str, str]()
    for log in fleet.logs:
        if log.source in logs.hashes:
            original = first.setdefault((log.type, logs.hashes[log.source]), log.source)
            if original != log.source:
                copies[log.source] = f"it is a copy of {original}"
    hashes = {source: content for source, content in logs.hashes.items() if source not in copies}
    return _Logs(hashes, {**logs.unused, **copies})


def _digested(
    fleet: Fleet, logs: _Logs, store: Store, cluster: Callable[[], Cluster], tell: Progress
) -> tuple[Digests, dict[str, str]]:
    """The digests of ``logs``, and why others have none."""
    own = [log for log in fleet.logs if log.source in logs.hashes]
    keys = dict[str, str]()
    for log in own:
        arm = fleet.types[log.type]
        content = logs.hashes[log.source]
        keys[log.source] = key_of("digest", DIGEST_VERSION, content, arm.text, arm.mapping or "")
    new = [log for log in own if not store.has(keys[log.source])]
    refused = dict[str, str]()
    if new:
        tell(DIGESTING, 0, len(new))
        tasks = (
            (log.source, (fleet.types[log.type], absolute_source(log.source), logs.hashes[log.source]))
            for log in new
        )
        for k, (source, outcome) in enumerate(cluster().each(digest_log, tasks)):
            if isinstance(outcome, Done):
                store.keep(keys[source], outcome.value)
            elif isinstance(outcome.error, InputError):
                store.keep(keys[source], Refused(why(outcome.error, absolute_source(source))))
            else:  # not of the log's making: tried again in the next run
                reason = why(outcome.error, absolute_source(source))
                if isinstance(outcome.error, Changed):
                    check_changed([absolute_source(source)], [logs.hashes[source]], reason)
                refused[source] = reason
            tell(DIGESTING, k + 1, len(new))
    for source, key in keys.items():
        value = store.refusal(key)
        if value is not None:
            refused[source] = value
    used = {source: key for source, key in keys.items() if source not in refused}
    return Digests(store, used), refused


def _nothing(fleet: Fleet, unused: Sequence[Unused]) -> InputError:
    """The error of a fleet that has no log that can be used."""
    if not fleet.logs:
        return InputError(f"the fleet {fleet.name} has no logs")
    return InputError(
        f"no log of the fleet {fleet.name} can be used",
        found=f"{len(unused)} that cannot, the first {unused[0].source}: {unused[0].why}",
        remedy="mend the logs, their map, or the description of their type",
    )
