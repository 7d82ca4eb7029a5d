"""Values that a shell completes: names that stand once, in a table of the library, and are looked up late."""

from __future__ import annotations

import importlib
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, Final

import click

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem


class OneOf(click.ParamType[str]):
    """A word out of a table: ``source`` is ``module:name`` of a tuple, a mapping, or a function that returns
    the words, imported when a shell completes.

    ``many``: several, separated by commas. ``files``: the path of a file as well. ``more``: further words.
    The library checks what was typed: its message says what there is, and Python gets the same one.
    """

    name = "text"

    def __init__(
        self, source: str, *, many: bool = False, files: bool = False, more: tuple[str, ...] = ()
    ) -> None:
        self.source, self.many, self.files, self.more = source, many, files, more

    def words(self) -> tuple[str, ...]:
        """All of them, in the order of the table."""
        module, _, name = self.source.partition(":")
        table: Any = getattr(importlib.import_module(module), name)
        listed: Iterable[Any] = table() if callable(table) else table
        return (*(str(getattr(word, "id", word)) for word in listed), *self.more)

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        """The words that begin like ``incomplete``, the last one of several that commas separate."""
        from click.shell_completion import CompletionItem

        before, comma, last = incomplete.rpartition(",") if self.many else ("", "", incomplete)
        offered = [CompletionItem(before + comma + word) for word in self.words() if word.startswith(last)]
        if self.files:
            offered.append(CompletionItem(incomplete, type="file"))
        return offered


ROBOTS: Final = OneOf("robodyn.robot:bundled_names", files=True)
FORMULATIONS: Final = OneOf("robodyn.optimize.programs:FORMULATIONS", more=("all",))
LEVELS: Final = OneOf("robodyn.kernels.options:LEVELS")
ENGINES: Final = OneOf("robodyn.kernels.options:ENGINES")
ORDERS: Final = OneOf("robodyn.kernels.options:ORDERS")
TRIGONOMETRY: Final = OneOf("robodyn.kernels.options:TRIGONOMETRY")
SCALARS: Final = OneOf("robodyn.kernels.options:SCALARS")
CONTRACTIONS: Final = OneOf("robodyn.kernels.options:CONTRACTIONS")
EFFECTS: Final = OneOf("robodyn.effects.catalogue:CATALOGUE")
SEVERAL_EFFECTS: Final = OneOf("robodyn.effects.catalogue:CATALOGUE", many=True)
PROOFS: Final = OneOf("robodyn.certify:PROOFS", many=True)
TABLES: Final = OneOf("robodyn.thesis.tables:TABLE_IDS")
ARMS: Final = OneOf("robodyn.thesis.case_study:ARMS")
PROFILES: Final = OneOf("robodyn.thesis.case_study:REST_TO_REST")
TARGET_FORMATS: Final = OneOf("robodyn.formats.exporting:TARGETS")
COMPARED: Final = OneOf("robodyn.compare.robots:GROUPS", many=True)
REPORTS: Final = OneOf("robodyn.project.reports:FORMATS")
PACKAGES: Final = OneOf("robodyn.packages.formats:FORMATS")
