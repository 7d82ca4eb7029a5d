"""What differs: files from what would be written, counts from their budgets and from the lock file."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final, Literal

from robodyn.errors import InputError, did_you_mean
from robodyn.files import label, read_start
from robodyn.project.lock import Lock, Locked
from robodyn.project.product import Product
from robodyn.project.reading import OF, Entry, Project
from robodyn.toolchain.sources import digest

Kinds = Mapping[str, int]
#: Of a committed file no more is compared [bytes]; kernels of a hundred joints have a tenth of it.
LARGEST_OUTPUT: Final = 64 << 20
#: Before the place where two lines differ so much is shown, and twice as much behind it [characters].
_AROUND: Final = 20


@dataclass(frozen=True, slots=True)
class Fault:
    """Something that a check does not let pass: of which ``robot``, at which ``subject`` (a function or a
    file), and the line that says why."""

    kind: Literal["file", "budget", "count", "lock"]
    robot: str | None
    subject: str
    text: str


@dataclass(frozen=True, slots=True)
class Counted:
    """The operations of a function, ``now`` and ``before`` (None: it is new, or gone); its budget."""

    function: str
    now: Kinds | None
    before: Kinds | None
    budget: Kinds

    @property
    def grown(self) -> dict[str, tuple[int, int]]:
        """The kinds of which there are more than before: how many before, and now."""
        if self.now is None or self.before is None:
            return {}
        before = {kind: self.before.get(kind, count) for kind, count in self.now.items()}
        return {kind: (before[kind], count) for kind, count in self.now.items() if count > before[kind]}


@dataclass(frozen=True, slots=True)
class RobotState:
    """A robot of the project, or a package of one: the paths of its files with what is wrong with them (None:
    nothing), and the counts of its functions; what is known of it, None if it is ``gone``: in the lock file
    alone."""

    name: str
    files: Mapping[str, str | None]
    functions: tuple[Counted, ...]
    account: Mapping[str, Any] | None
    gone: bool = False

    @property
    def package(self) -> str | None:
        """The format of a package, if it is one."""
        return self.name.partition(OF)[2] or None


@dataclass(frozen=True, slots=True)
class Comparison:
    """A project beside what is committed of it: its file, the robots, and all faults in their order."""

    project: str
    robots: tuple[RobotState, ...]
    faults: tuple[Fault, ...]


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
) -> Comparison:
    """The project's files and ``lock`` beside ``products``, and their counts beside those of ``base``, which
    is the lock as well or that of another branch. ``texts`` has what should stand in the files of a robot."""
    before = {name: each.counts for name, each in sorted((base or {}).items())}
    robots = tuple(
        _state(project, entry, products[entry.name], before.get(entry.name, {}), texts)
        for entry in project.entries
    )
    gone = tuple(
        RobotState(name, {}, tuple(Counted(f, None, x, {}) for f, x in counts.items()), None, gone=True)
        for name, counts in before.items()
        if name not in products
    )
    faults = [fault for robot in robots for fault in _faults(robot)]
    faults += _of_lock(project, lock, locked(project, products), robots if base is lock else ())
    return Comparison(label(project.path), robots + gone, tuple(faults))


def exceeded(functions: tuple[Counted, ...]) -> list[tuple[str, str]]:
    """Functions over their budgets, and by how much."""
    over = []
    for counted in functions:
        if counted.budget and counted.now is not None:
            from robodyn.counts.budget import Budget
            from robodyn.counts.count import Count

            count = Count(**{kind: amount for kind, amount in counted.now.items() if kind != "total"})
            texts = Budget(tuple(counted.budget.items())).exceeded(count)
            over += [(counted.function, text) for text in texts]
    return over


def _state(
    project: Project,
    entry: Entry,
    product: Product,
    before: Mapping[str, Kinds],
    texts: Callable[[Entry], Mapping[str, bytes]],
) -> RobotState:
    folder = project.output(entry)
    different = outdated(folder, product)
    wanted = texts(entry) if different else {}
    files: dict[str, str | None] = {label(folder / name): None for name in product.files}
    for name in different:
        files[label(folder / name)] = _difference(_contents(folder / name), wanted[name])
    functions = tuple(
        Counted(f, product.counts.get(f), before.get(f), entry.budgets.get(f, {}))
        for f in dict.fromkeys((*product.counts, *before))
    )
    return RobotState(entry.name, files, functions, product.account)


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


def _faults(robot: RobotState) -> list[Fault]:
    faults = [Fault("file", robot.name, path, f"{path} {why}") for path, why in robot.files.items() if why]
    for function, text in exceeded(robot.functions):
        faults.append(Fault("budget", robot.name, function, f"{robot.name}: {function}: {text}"))
    for counted in robot.functions:
        grown = [
            f"{kind} {now}, locked {before} ({now - before:+})"
            for kind, (before, now) in counted.grown.items()
        ]
        if grown:
            text = f"{robot.name}: {counted.function} got worse: {', '.join(grown)}"
            faults.append(Fault("count", robot.name, counted.function, text))
    return faults


def _of_lock(project: Project, lock: Lock | None, now: Lock, compared: tuple[RobotState, ...]) -> list[Fault]:
    """What is not up to date in the lock file, besides counts that grew, which are ``compared`` apart."""
    path = label(project.lock)
    if lock is None:
        return [Fault("lock", None, path, f"{path} is missing")]
    grown = {(robot.name, c.function) for robot in compared for c in robot.functions if c.grown}
    faults = []
    for name in sorted({*lock, *now}):
        if name not in lock or name not in now:
            why = "is not in it" if name in now else "is not in the project any more"
        elif parts := _stale(name, lock[name], now[name], grown):
            why = f"has other {' and '.join(parts)} now"
        else:
            continue
        faults.append(Fault("lock", name, path, f"{path} is not up to date: {name} {why}"))
    return faults


def _stale(name: str, old: Locked, new: Locked, grown: set[tuple[str, str]]) -> list[str]:
    """What of a robot differs from its part of the lock file."""
    functions = dict.fromkeys((*old.counts, *new.counts))
    changed = [f for f in functions if old.counts.get(f) != new.counts.get(f) and (name, f) not in grown]
    parts = [f"counts of {', '.join(changed)}"] if changed else []
    parts += ["files"] if old.files != new.files else []
    return parts + (["output"] if old.output != new.output else [])
