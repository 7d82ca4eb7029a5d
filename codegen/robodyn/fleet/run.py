"""A fleet from its logs to what is said of it: what is new is digested, all is judged, some is diagnosed."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import replace
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
        return digested(self._store.value(self._keys[source]))[1]

    def __contains__(self, source: object) -> bool:
        return source in self._keys

    def __iter__(self) -> Iterator[str]:
        return iter(self._keys)

    def __len__(self) -> int:
        return len(self._keys)


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

        hashes, reasons = _contents(fleet, store, cluster, tell)
        reasons |= _copies(fleet, hashes)
        new = {source: content for source, content in hashes.items() if source not in reasons}
        keys, refused = _digested(fleet, new, store, cluster, tell)
        undated = [log.source for log in fleet.logs if math.isnan(log.date) and log.source in keys]
        fleet = fleet.dated({source: digested(store.value(keys[source]))[0] for source in undated})
        reasons = {log.source: _DATELESS for log in fleet.logs if math.isnan(log.date)} | reasons | refused
        unused = [*fleet.missing]
        for log in fleet.logs:
            if log.source in reasons:
                unused.append(Unused(log.source, log.type, log.unit, reasons[log.source]))
        digests = Digests(store, {source: key for source, key in keys.items() if source not in reasons})
        if not digests:
            raise _nothing(fleet, unused)
        result = judge(
            fleet, digests, unused=unused, false_names=false_names, progress=lambda stage: tell(stage, 0, 0)
        )
        if files_of is None or diagnose == "none":
            return result
        named = [unit for unit in result.units if unit.claims or diagnose == "all"]
        pages = diagnosed(
            fleet, named, {source: hashes[source] for source in digests}, store, cluster, folder,
            files_of, lambda done, of: tell(DIAGNOSING, done, of),
        )  # fmt: skip
        units = tuple(completed(unit, pages.get((unit.type, unit.unit))) for unit in result.units)
        return replace(result, units=units)


def _contents(
    fleet: Fleet, store: Store, cluster: Callable[[], Cluster], tell: Progress
) -> tuple[dict[str, str], dict[str, str]]:
    """The hashes of the content of logs, and why others have none, by their sources; what was read before and
    is unchanged is not read again."""
    hashes, unread, new = dict[str, str](), dict[str, str](), list[str]()
    paths = {log.source: absolute_source(log.source) for log in fleet.logs}
    named = {log.source: f"; {log.named} names it" for log in fleet.logs if log.named}
    signatures = {source: _signature(path) for source, path in paths.items()}
    for source, here in signatures.items():
        content = here and store.content(paths[source], here)
        if content:
            hashes[source] = content
        else:
            new.append(source)
    if not new:
        return hashes, unread
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
                unread[source] = read + named.get(source, "")
                continue
            content, worker_signature, youngest = read
            # Where it is being written here, too, the digest of the log finds out.
            if here is not None and here != worker_signature and here == _signature(path):
                check_same_file(path, content, f"one with the SHA-256 {content[:16]}...")
            hashes[source] = content
            store.saw(path, worker_signature, youngest, content)
        tell(READING, len(hashes) + len(unread), len(fleet.logs))
    return hashes, unread


def _signature(path: str) -> str | None:
    """The signature of a log; None where it is not here: whoever works may see another file system."""
    try:
        return signature(path)[0]
    except OSError:
        return None


def _copies(fleet: Fleet, hashes: Mapping[str, str]) -> dict[str, str]:
    """Why logs of a type that are copies of others do not count: they would twice."""
    first, copies = dict[tuple[str, str], str](), dict[str, str]()
    for log in fleet.logs:
        if log.source in hashes:
            original = first.setdefault((log.type, hashes[log.source]), log.source)
            if original != log.source:
                copies[log.source] = f"it is a copy of {original}"
    return copies


def _digested(
    fleet: Fleet, hashes: Mapping[str, str], store: Store, cluster: Callable[[], Cluster], tell: Progress
) -> tuple[dict[str, str], dict[str, str]]:
    """The keys of the digests of logs with these ``hashes``, and why others have none."""
    arms = {log.source: fleet.types[log.type] for log in fleet.logs if log.source in hashes}
    keys = {
        source: key_of("digest", DIGEST_VERSION, hashes[source], arm.text, arm.mapping or "")
        for source, arm in arms.items()
    }
    new = [source for source in arms if not store.has(keys[source])]
    refused = dict[str, str]()
    if new:
        tell(DIGESTING, 0, len(new))
        tasks = ((one, (arms[one], absolute_source(one), hashes[one])) for one in new)
        for k, (source, outcome) in enumerate(cluster().each(digest_log, tasks)):
            path = absolute_source(source)
            if isinstance(outcome, Done):
                store.keep(keys[source], outcome.value)
            elif isinstance(outcome.error, InputError):
                store.keep(keys[source], Refused(why(outcome.error, path)))
            else:  # not of the log's making: tried again in the next run
                refused[source] = why(outcome.error, path)
                if isinstance(outcome.error, Changed):
                    check_changed([path], [hashes[source]], refused[source])
            tell(DIGESTING, k + 1, len(new))
    for source, key in keys.items():
        reason = store.refusal(key)
        if reason is not None:
            refused[source] = reason
    return {source: key for source, key in keys.items() if source not in refused}, refused


def _nothing(fleet: Fleet, unused: Sequence[Unused]) -> InputError:
    """The error of a fleet that has no log that can be used."""
    if not fleet.logs:
        return InputError(f"the fleet {fleet.name} has no logs")
    return InputError(
        f"no log of the fleet {fleet.name} can be used",
        found=f"{len(unused)} that cannot, the first {unused[0].source}: {unused[0].why}",
        remedy="mend the logs, their map, or the description of their type",
    )
