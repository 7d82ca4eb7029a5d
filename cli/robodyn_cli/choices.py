"""Values that a shell completes: names that stand once, in a table of the library, and are looked up late."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, Literal

import click

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

    _Word = click.ParamType[str]
else:
    _Word = click.ParamType  # generic from click 8.3 on only


class OneOf(_Word):
    """A word out of a table: ``source`` is ``module:name`` of a tuple, a mapping, or a function that returns
    the words, imported when a shell completes.

    ``many``: several, separated by commas. ``files``: the path of a file as well. ``more``: further words.
    ``others``: words that are not in the table are right as well. ``late``: the words may change without a
    change of robodyn.
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
        late: bool = False,
    ) -> None:
        self.source, self.more = source, more
        self.many, self.files, self.others, self.late = many, files, others, late

    def words(self) -> tuple[str, ...]:
        """All of them, in the order of the table."""
        from robodyn_cli.words import words

        return (*words(self.source), *self.more)

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        """The words that begin like ``incomplete``, the last one of several that commas separate."""
        from click.shell_completion import CompletionItem

        from robodyn_cli.words import remembered, words

        before, comma, last = incomplete.rpartition(",") if self.many else ("", "", incomplete)
        known = words(self.source) if self.late else remembered(self.source)
        offered = [
            CompletionItem(before + comma + word, help=text or None)
            for word, text in {**known, **dict.fromkeys(self.more, "")}.items()
            if word.startswith(last)
        ]
        if self.files:
            offered.append(CompletionItem(incomplete, type="file"))
        return offered


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
ROBOTS: Final = OneOf("robodyn.robot.bundled:bundled_names", files=True, late=True)
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
