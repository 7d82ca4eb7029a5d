"""What differs: files from what would be written, counts from their budgets and from the lock file."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Final

from robodyn.errors import InputError, did_you_mean
from robodyn.files import label, read_start
from robodyn.project.lock import Lock, Locked
from robodyn.project.product import Product
from robodyn.project.reading import OF, Entry, Project
from robodyn.toolchain.sources import digest

Kinds = Mapping[str, int]
#: What is shown, as JSON has it.
Report = dict[str, Any]
#: Of a committed file no more is compared [bytes]; kernels of a hundred joints have a tenth of it.
LARGEST_OUTPUT: Final = 64 << 20
#: Before the place where two lines differ so much is shown, and twice as much behind it [characters].
_AROUND: Final = 20


def _fault(kind: str, robot: str | None, subject: str, text: str) -> Report:
    """Something that a check does not let pass, a file, budget, count or lock: of which ``robot``, at which
    ``subject`` (a function or a file), and the line that says why."""
    return {"kind": kind, "robot": robot, "subject": subject, "text": text}


def locked(project: Project, products: Mapping[str, Product]) -> Lock:
    """The lock file that goes with ``products``, by robot."""
    return {
        entry.name: Locked(entry.output, products[entry.name].counts, products[entry.name].files)
        for entry in project.entries
    }


def check_products(project: Project, products: Mapping[str, Product]) -> None:
    """Hold what was generated to what the project says of it.

    Raises
    ------
    InputError: two outputs write the same file, or a budget is one of a function that is not written.
    """
    owners: dict[str, Entry] = {}
    for entry in project.entries:
        product = products[entry.name]
        for name in product.files:
            other = owners.setdefault(os.path.realpath(project.output(entry) / name), entry)
            if other is not entry:
                raise InputError(
                    "two outputs write the same file",
                    where=entry.place(),
                    found=f"{entry.output}/{name} of {entry.name} and of {other.name}",
                    remedy="give one of them another output",
                )
        for function in entry.budgets:
            if function not in product.counts:
                raise InputError(
                    f"{entry.name} has a budget of a function that is not written",
                    where=entry.place("budgets", function),
                    found=function,
                    expected=f"one of {', '.join(product.counts)}",
                    remedy=did_you_mean(function, product.counts) or "ask for it with the key functions",
                )


def outdated(folder: Path, product: Product) -> list[str]:
    """The files of ``product`` that are not in ``folder`` as they should be."""
    contents = {name: _contents(folder / name) for name in product.files}
    return [name for name, data in contents.items() if data is None or digest(data) != product.files[name]]


def _contents(path: Path) -> bytes | None:
    """What is in the file at ``path``; None where there is none that could be read."""
    try:
        return read_start(path, LARGEST_OUTPUT, "a file of kernels")
    except (OSError, InputError):
        return None


def compare(
    project: Project,
    products: Mapping[str, Product],
    lock: Lock | None,
    base: Lock | None,
    texts: Callable[[Entry], Mapping[str, bytes]],
) -> Report:
    """The project's files and ``lock`` beside ``products``, and their counts beside those of ``base``, which
    is the lock as well or that of another branch. ``texts`` has what should stand in the files of a robot."""
    before = {name: each.counts for name, each in sorted((base or {}).items())}
    robots = [
        _robot(project, entry, products[entry.name], before.get(entry.name, {}), texts)
        for entry in project.entries
    ]
    faults = [fault for robot in robots for fault in _faults(robot)]
    grown = {(f["robot"], f["subject"]) for f in faults if f["kind"] == "count"} if base is lock else set()
    faults += _lock_faults(project, lock, locked(project, products), grown)
    for name, counts in before.items():
        if name not in products:  # in the lock file alone
            functions = [_function(f, None, kinds, {}) for f, kinds in counts.items()]
            robots.append(_record(name, True, [], functions, []))
    head = {"project": label(project.path), "passed": not faults}
    return {**head, "robots": robots, "written": [], "faults": faults}


def _record(
    name: str, gone: bool, files: list[Report], functions: list[Report], account: list[Any]
) -> Report:
    """A robot of the project, or a package of one."""
    return {
        "robot": name,
        "package": name.partition(OF)[2] or None,
        "gone": gone,
        "files": files,
        "functions": functions,
        "account": account,
    }


def _robot(
    project: Project,
    entry: Entry,
    product: Product,
    before: Mapping[str, Kinds],
    texts: Callable[[Entry], Mapping[str, bytes]],
) -> Report:
    folder = project.output(entry)
    different = outdated(folder, product)
    wanted = texts(entry) if different else {}
    files = [
        {
            "path": label(folder / name),
            "fault": _difference(_contents(folder / name), wanted[name]) if name in different else None,
        }
        for name in product.files
    ]
    functions = [
        _function(f, product.counts.get(f), before.get(f), entry.budgets.get(f, {}))
        for f in dict.fromkeys((*product.counts, *before))
    ]
    return _record(entry.name, False, files, functions, [product.account])


def _function(function: str, now: Kinds | None, before: Kinds | None, budget: Kinds) -> Report:
    """The operations of a function, ``now`` and ``before`` (None: it is new, or gone); its budget."""
    changed = "worse" if _grown(now, before) else "better"
    changed = "new" if before is None else "gone" if now is None else changed
    return {
        "function": function,
        "count": now,
        "locked": before,
        "status": "same" if now == before else changed,
        "budget": dict(budget) or None,
    }


def _grown(now: Kinds | None, before: Kinds | None) -> list[str]:
    """The kinds of which there are more than before, in words."""
    if now is None or before is None:
        return []
    pairs = {kind: (before.get(kind, count), count) for kind, count in now.items()}
    return [f"{kind} {new}, locked {old} ({new - old:+})" for kind, (old, new) in pairs.items() if new > old]


def _difference(there: bytes | None, wanted: bytes) -> str:
    """Where a file first differs from what is ``wanted``, in words."""
    if there is None:
        return "is missing"
    ours, theirs = wanted.split(b"\n"), there.split(b"\n")
    for line, (a, b) in enumerate(zip(ours, theirs, strict=False), 1):
        if a != b:
            same = next(
                (k for k, (x, y) in enumerate(zip(a, b, strict=False)) if x != y), min(len(a), len(b))
            )
            return f"differs from line {line} on: found {_quoted(b, same)}, expected {_quoted(a, same)}"
    return f"has {len(theirs) - 1} lines, expected {len(ours) - 1}"


def _quoted(line: bytes, at: int) -> str:
    """What stands in ``line`` around the byte ``at``."""
    begin, end = max(0, at - _AROUND), at + 2 * _AROUND
    text = line[begin:end].decode("utf-8", "replace")
    return f"{'...' * (begin > 0)}{text!r}{'...' * (end < len(line))}"


def _faults(robot: Report) -> Iterator[Report]:
    name = robot["robot"]
    for file in robot["files"]:
        if file["fault"]:
            yield _fault("file", name, file["path"], f"{file['path']} {file['fault']}")
    for each in robot["functions"]:
        for text in _exceeded(each):
            yield _fault("budget", name, each["function"], f"{name}: {each['function']}: {text}")
    for each in robot["functions"]:
        grown = _grown(each["count"], each["locked"])
        if grown:
            text = f"{name}: {each['function']} got worse: {', '.join(grown)}"
            yield _fault("count", name, each["function"], text)


def _exceeded(each: Report) -> Sequence[str]:
    """By how much a function is over its budget."""
    if not each["budget"] or each["count"] is None:
        return ()
    from robodyn.counts.count import Budget, Count

    count = Count(**{kind: amount for kind, amount in each["count"].items() if kind != "total"})
    return Budget(tuple(each["budget"].items())).exceeded(count)


def _lock_faults(
    project: Project, lock: Lock | None, now: Lock, grown: set[tuple[str, str]]
) -> Iterator[Report]:
    """What is not up to date in the lock file, besides counts that have ``grown``."""
    path = label(project.lock)
    if lock is None:
        yield _fault("lock", None, path, f"{path} is missing")
        return
    for name in sorted({*lock, *now}):
        if name not in lock or name not in now:
            why = "is not in it" if name in now else "is not in the project any more"
        elif parts := _stale(name, lock[name], now[name], grown):
            why = f"has other {' and '.join(parts)} now"
        else:
            continue
        yield _fault("lock", name, path, f"{path} is not up to date: {name} {why}")


def _stale(name: str, old: Locked, new: Locked, grown: set[tuple[str, str]]) -> list[str]:
    """What of a robot differs from its part of the lock file."""
    functions = dict.fromkeys((*old.counts, *new.counts))
    changed = [f for f in functions if old.counts.get(f) != new.counts.get(f) and (name, f) not in grown]
    parts = [f"counts of {', '.join(changed)}"] if changed else []
    parts += ["files"] if old.files != new.files else []
    return parts + (["output"] if old.output != new.output else [])
