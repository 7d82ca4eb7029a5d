"""Values that a shell completes: names that stand once, in a table of the library, and are looked up late."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

import click

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

    _Word = click.ParamType[str]
else:
    _Word = click.ParamType  # generic from click 8.3 on only


def words(source: str) -> dict[str, str]:
    """The words of a table and what each is, which may be empty; ``source`` is ``module:name`` of a tuple, a
    mapping, or a function that returns the words."""
    module, _, name = source.partition(":")
    table: Any = getattr(importlib.import_module(module), name)
    listed = table() if callable(table) else table
    records = listed.values() if isinstance(listed, Mapping) else listed
    names = (str(_attribute(word, ("id", "name")) or word) for word in listed)
    return dict(zip(names, (_attribute(record, ("purpose", "title")) for record in records), strict=True))


def _attribute(record: Any, names: tuple[str, ...]) -> str:
    """The first of the attributes that ``record`` has as a text."""
    return next((text for name in names if isinstance(text := getattr(record, name, None), str)), "")


class OneOf(_Word):
    """A word out of a table: ``source`` is ``module:name`` of a tuple, a mapping, or a function that returns
    the words, imported when a shell completes.

    ``many``: several, separated by commas. ``files``: the path of a file as well. ``more``: further words.
    ``others``: words that are not in the table are right as well. ``prefix`` stands before each word.
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
        prefix: str = "",
    ) -> None:
        self.source, self.more, self.prefix = source, more, prefix
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
            CompletionItem(before + comma + self.prefix + word, help=text or None)
            for word, text in {**words(self.source), **dict.fromkeys(self.more, "")}.items()
            if (self.prefix + word).startswith(last)
        ]
        if self.files:
            offered.append(CompletionItem(incomplete, type="file"))
        return offered


#: The path of a file or a folder, as a shell completes it. Whoever opens it checks it.
FILE: Final = click.Path(readable=False)
FOLDER: Final = click.Path(readable=False, file_okay=False)
ROBOTS: Final = OneOf("robodyn.robot.bundled:bundled_names", files=True)
FORMULATIONS: Final = OneOf("robodyn.optimize.programs:FORMULATIONS", more=("all",))
LEVELS: Final = OneOf("robodyn.kernels.options:LEVELS")
ENGINES: Final = OneOf("robodyn.kernels.options:ENGINES")
ORDERS: Final = OneOf("robodyn.kernels.options:ORDERS")
TRIGONOMETRY: Final = OneOf("robodyn.kernels.options:TRIGONOMETRY")
SCALARS: Final = OneOf("robodyn.kernels.options:SCALARS")
CONTRACTIONS: Final = OneOf("robodyn.kernels.options:CONTRACTIONS")
FUNCTION_NAMES: Final = OneOf("robodyn.dynamics.functions:FUNCTIONS")
SEVERAL_FUNCTIONS: Final = OneOf("robodyn.dynamics.functions:FUNCTIONS", many=True, others=True)
SEVERAL_LANGUAGES: Final = OneOf("robodyn.emit.languages:LANGUAGES", many=True, others=True)
COMPILED_LANGUAGES: Final = OneOf("robodyn.emit.languages:compiled_names")
EFFECTS: Final = OneOf("robodyn.effects.catalogue:CATALOGUE")
SEVERAL_EFFECTS: Final = OneOf("robodyn.effects.catalogue:CATALOGUE", many=True)
TARGETS: Final = OneOf("robodyn.targets:compiled_targets", many=True, others=True)
PLANNED_TARGETS: Final = OneOf("robodyn.targets:planned_targets", others=True)
OBJECTIVES: Final = OneOf("robodyn.targets:all_targets", prefix="weighted:", others=True)
PROOFS: Final = OneOf("robodyn.certify:PROOFS", many=True)
TABLES: Final = OneOf("robodyn.thesis.tables:TABLE_IDS")
ARMS: Final = OneOf("robodyn.thesis.case_study:ARMS")
PROFILES: Final = OneOf("robodyn.thesis.case_study:REST_TO_REST")
TARGET_FORMATS: Final = OneOf("robodyn.formats.exporting:TARGETS")
COMPARED: Final = OneOf("robodyn.compare.robots:GROUPS", many=True)
SHELL_NAMES: Final = OneOf("robodyn_cli.completion:SHELLS")
TOOLS: Final = OneOf("robodyn.doctor:names", many=True)
PACKAGES: Final = OneOf("robodyn.packages.formats:FORMATS")
