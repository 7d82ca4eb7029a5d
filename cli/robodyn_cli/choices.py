"""Values that a shell completes: names that stand once, in a table of the library, and are looked up late."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, Final, Literal

import click

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

    from robodyn.targets import Target

    _Word = click.ParamType[str]
else:
    _Word = click.ParamType  # generic from click 8.3 on only


#: Attributes of a record that say in a few words what it is.
_HELP: Final = ("purpose", "title")


def words(source: str) -> dict[str, str]:
    """The words of a table and what each is, which may be empty; ``source`` is ``module:name`` of a tuple, a
    mapping, or a function that returns the words."""
    module, _, name = source.partition(":")
    table: Any = getattr(importlib.import_module(module), name)
    listed = table() if callable(table) else table
    records = listed.values() if isinstance(listed, Mapping) else listed
    return dict(zip((str(getattr(word, "id", word)) for word in listed), map(_help, records), strict=True))


def _help(record: Any) -> str:
    return next((text for name in _HELP if isinstance(text := getattr(record, name, None), str)), "")


class OneOf(_Word):
    """A word out of a table: ``source`` is ``module:name`` of a tuple, a mapping, or a function that returns
    the words, imported when a shell completes.

    ``many``: several, separated by commas. ``files``: the path of a file as well. ``more``: further words.
    ``others``: words that are not in the table are right as well.
    The library checks what was typed: its message says what there is, and Python gets the same one.
    """

    name = "text"

    def __init__(
        self,
        source: str,
        *,
        many: bool = False,
        files: bool = False,
        more: tuple[str, ...] = (),
        others: bool = False,
    ) -> None:
        self.source, self.more = source, more
        self.many, self.files, self.others = many, files, others

    def words(self) -> tuple[str, ...]:
        """All of them, in the order of the table."""
        return (*words(self.source), *self.more)

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        """The words that begin like ``incomplete``, the last one of several that commas separate."""
        from click.shell_completion import CompletionItem

        before, comma, last = incomplete.rpartition(",") if self.many else ("", "", incomplete)
        offered = [
            CompletionItem(before + comma + word, help=text or None)
            for word, text in {**words(self.source), **dict.fromkeys(self.more, "")}.items()
            if word.startswith(last)
        ]
        if self.files:
            offered.append(CompletionItem(incomplete, type="file"))
        return offered


class TargetOption(click.Option):
    """An option that takes names of targets. ``{name}`` in its help stands for those that ``lists[name]``,
    a function of :mod:`robodyn.targets`, returns; a shell completes those of the first.

    ``prefix`` stands before a target's name in a value: ``weighted:`` of an objective.
    """

    def __init__(self, *names: Any, lists: dict[str, str], prefix: str = "", **others: Any) -> None:
        self._lists = lists
        self._prefix = prefix
        super().__init__(*names, **others)

    @property
    def help(self) -> str | None:
        """The help, with names in place of ``{name}``."""
        lists = {name: _names(what) for name, what in self._lists.items()}
        return None if self._template is None else self._template.format(**lists)

    @help.setter
    def help(self, template: str | None) -> None:
        self._template = template

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """The names that begin like ``incomplete``, the last one of several that commas part."""
        from click.shell_completion import CompletionItem

        before, comma, last = incomplete.rpartition(",")
        first = next(iter(self._lists.values()))
        words = (self._prefix + target.name for target in _targets(first))
        return [CompletionItem(f"{before}{comma}{word}") for word in words if word.startswith(last)]


def _targets(what: str) -> Iterable[Target]:
    import robodyn.targets

    listed: Callable[[], tuple[Target, ...]] = getattr(robodyn.targets, what)
    return listed()


def _names(what: str) -> str:
    return ", ".join(target.name for target in _targets(what))


class Place(_Word):
    """The path of a file, or of a folder: a shell completes it. Whoever opens it checks it."""

    name = "text"

    def __init__(self, kind: Literal["file", "dir"]) -> None:
        self.kind = kind

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        """What the shell finds."""
        from click.shell_completion import CompletionItem

        return [CompletionItem(incomplete, type=self.kind)]


FILE: Final = Place("file")
FOLDER: Final = Place("dir")
ROBOTS: Final = OneOf("robodyn.robot.bundled:bundled_names", files=True)
FORMULATIONS: Final = OneOf("robodyn.optimize.programs:FORMULATIONS", more=("all",))
LEVELS: Final = OneOf("robodyn.kernels.options:LEVELS")
ENGINES: Final = OneOf("robodyn.kernels.options:ENGINES")
ORDERS: Final = OneOf("robodyn.kernels.options:ORDERS")
TRIGONOMETRY: Final = OneOf("robodyn.kernels.options:TRIGONOMETRY")
SCALARS: Final = OneOf("robodyn.kernels.options:SCALARS")
CONTRACTIONS: Final = OneOf("robodyn.kernels.options:CONTRACTIONS")
SEVERAL_FUNCTIONS: Final = OneOf("robodyn.dynamics.functions:FUNCTIONS", many=True, others=True)
SEVERAL_LANGUAGES: Final = OneOf("robodyn.emit.languages:LANGUAGES", many=True, others=True)
COMPILED_LANGUAGES: Final = OneOf("robodyn.emit.languages:compiled_names")
EFFECTS: Final = OneOf("robodyn.effects.catalogue:CATALOGUE")
SEVERAL_EFFECTS: Final = OneOf("robodyn.effects.catalogue:CATALOGUE", many=True)
PROOFS: Final = OneOf("robodyn.certify:PROOFS", many=True)
TABLES: Final = OneOf("robodyn.thesis.tables:TABLE_IDS")
ARMS: Final = OneOf("robodyn.thesis.case_study:ARMS")
PROFILES: Final = OneOf("robodyn.thesis.case_study:REST_TO_REST")
TARGET_FORMATS: Final = OneOf("robodyn.formats.exporting:TARGETS")
COMPARED: Final = OneOf("robodyn.compare.robots:GROUPS", many=True)
SHELLS: Final = OneOf("robodyn_cli.shells:SHELLS")
TOOLS: Final = OneOf("robodyn.doctor:names", many=True)
REPORTS: Final = OneOf("robodyn.project.reports:FORMATS")
PACKAGES: Final = OneOf("robodyn.packages.formats:FORMATS")
