"""Options whose help lists targets: read from the table when the help is shown, or a shell completes."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

    from robodyn.targets import Target


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
