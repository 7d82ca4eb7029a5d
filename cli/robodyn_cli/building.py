"""The kernels of a project's robots: those in the store, and the others from processes that work in parallel.

What is generated goes to the store at once, so that it is there whatever becomes of the build.
"""

from __future__ import annotations

import contextlib
import importlib
import io
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import click

from robodyn.errors import CheckError, InputError, OutputError, RobodynError, ToolError
from robodyn.project.fingerprint import fingerprints
from robodyn.project.keys import PACKAGE, Keys
from robodyn.project.product import Product, Store
from robodyn_cli.file_options import files_read_by, with_common_options
from robodyn_cli.output import Document, talk
from robodyn_cli.project_keys import check_settings

if TYPE_CHECKING:
    from robodyn.kernels.generate import Generated
    from robodyn.project.reading import Entry, Project

#: Options of the commands for what becomes of what is written.
_OF_A_RUN = ("output", "compile_", "check", "force")
_BY_EXIT_CODE = {kind.exit_code: kind for kind in (CheckError, InputError, ToolError, OutputError)}


class Products:
    """What there is to write for the robots of a project, ``by_name``; generated if it is not in the store.

    At most ``workers`` processes work at a time; None: as many as there are cores.

    Raises
    ------
    RobodynError: of a description or of an option; all of them are told on stderr, but the last.
    """

    def __init__(self, project: Project, keys: Keys, workers: int | None) -> None:
        self._store = Store()
        self._workers = workers
        self._fingerprints = fingerprints(project.entries)
        self.by_name: dict[str, Product] = {}
        missing = [entry for entry in project.entries if not self._take(entry)]
        for entry in missing:
            check_settings(entry, keys)
        self._generate(missing)
        for entry in project.entries:
            for note in self.by_name[entry.name].notes:
                talk(note)

    def texts(self, entry: Entry) -> dict[str, bytes]:
        """The contents of the files of ``entry``, by path within its output."""
        texts = self._store.texts(self._fingerprints[entry.name])
        if texts is None:  # damaged in the store, and gone from there
            self._generate([entry])
            texts = self._store.texts(self._fingerprints[entry.name])
        assert texts is not None
        return texts

    def _take(self, entry: Entry) -> bool:
        """Whether the product of ``entry`` is in the store; from now on it is at hand."""
        product = self._store.find(self._fingerprints[entry.name])
        if product is not None:
            self.by_name[entry.name] = product
        return product is not None

    def _generate(self, entries: Sequence[Entry]) -> None:
        """Generate the kernels of ``entries``, and say what is to be said of them."""
        if not entries:
            return
        from robodyn.toolchain.program import cores
        from robodyn_cli.progress import line

        jobs = {
            (key := self._fingerprints[entry.name]): Job(
                entry.name, key, entry.robot, entry.command, entry.arguments
            )
            for entry in entries
        }
        with line() as shown:
            errors = generate_all(
                list(jobs.values()),
                self._store,
                self._workers or cores(),
                lambda name, done: shown.tell(f"robodyn: {done} of {len(jobs)} robots generated; {name} ..."),
            )
        failed = []
        for entry in entries:
            error = errors.get(self._fingerprints[entry.name])
            if error is not None:
                failed.append(error.at(error.where or entry.place()))
            else:
                self._take(entry)
        for error in failed[:-1]:
            talk(f"robodyn: error: {error}")
        if failed:
            raise failed[-1]


@dataclass(frozen=True, slots=True)
class Job:
    """Generate what the ``command`` writes of the description ``robot`` with ``arguments``, and keep it as
    the product ``key``; ``name`` is what messages call it."""

    name: str
    key: str
    robot: str
    command: str
    arguments: tuple[str, ...]


def generate_all(
    jobs: Sequence[Job], store: Store, workers: int, begun: Callable[[str, int], None]
) -> dict[str, RobodynError]:
    """Carry out the jobs, at most ``workers`` at a time; the errors of those that failed, by key.

    ``begun`` is told the name of each job that begins, and how many are done.

    Raises
    ------
    ToolError: one of the processes has ended before its work was done.
    """
    from robodyn.toolchain.workers import Workers

    errors: dict[str, RobodynError] = {}
    done: list[int] = []
    with Workers(min(workers, len(jobs))) as helpers:
        tasks = [(job, store.root) for job in jobs]
        for k, error in helpers.each(carry_out, tasks, lambda k: begun(jobs[k].name, len(done))):
            done.append(k)
            if error is not None:
                errors[jobs[k].key] = error
    return errors


#: What the files of an entry are, and the counts of their functions.
_Contents = tuple[Mapping[str, str | bytes], dict[str, dict[str, int]]]


def carry_out(job: Job, root: Path) -> RobodynError | None:
    """Generate what ``job`` says and keep it in the store at ``root``, with what was said meanwhile; the
    error, if there is one."""
    module, contents = _PACKAGED if job.command == PACKAGE else _GENERATED
    command = with_common_options(importlib.import_module(module).command)
    messages, document = io.StringIO(), Document()
    try:
        with (
            contextlib.redirect_stderr(messages),
            command.make_context(job.command, [*job.arguments, "--", job.robot], obj=document) as c,
        ):
            options = {name: value for name, value in c.params.items() if name not in _OF_A_RUN}
            with files_read_by(options):
                texts, counts = contents(options)
    except click.UsageError as error:
        return InputError(error.format_message())
    except RobodynError as error:
        return _plain(error)
    from robodyn.robot.account import account_to_dict  # a build that generates nothing does without

    (robot,) = document.robots
    notes = tuple(messages.getvalue().splitlines())
    Store(root).save(job.key, texts, counts, notes, account_to_dict(robot))
    return None


def _generated(options: dict[str, Any]) -> _Contents:
    """What ``gen`` would write; of firmware all but the README, which has what this machine measures."""
    from robodyn_cli.firmware import FOLDER, firmware_of
    from robodyn_cli.generating import kernels

    product = kernels(**options)
    if options["firmware"]:
        folder = firmware_of(product.generated, product.languages, options["target"])
        files = {f"{FOLDER}/{name}": text for name, text in folder.files.items()}
        return files, _counts(product.generated)
    return product.files(batch=options["batch"], latex=options["latex"]), _counts(product.generated)


def _packaged(options: dict[str, Any]) -> _Contents:
    """What ``package`` would write.

    Raises
    ------
    InputError: that has a binary, which another machine's build would not give.
    """
    from robodyn_cli.package import packed

    package, _ = packed(**options)
    if package.format.binary:
        raise InputError(
            f"{package.format.title} has a binary, and another machine's compiler gives another one",
            expected="a package of sources",
            remedy="write it with robodyn package, and do not commit it",
        )
    return package.files(), _counts(package.generated)


_GENERATED: Final = ("robodyn_cli.gen", _generated)
_PACKAGED: Final = ("robodyn_cli.package", _packaged)


def _counts(generated: Generated) -> dict[str, dict[str, int]]:
    return {function: count.to_dict() for function, count in generated.counts.items()}


def _plain(error: RobodynError) -> RobodynError:
    """The same error as one of the family's own kinds, which go from process to process."""
    return _BY_EXIT_CODE[error.exit_code](
        error.what, where=error.where, found=error.found, expected=error.expected, remedy=error.remedy
    )
