"""``--lang``: the languages, from the table in :mod:`robodyn.emit.languages`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

from robodyn_cli.options import listed

Command = TypeVar("Command", bound=Callable[..., Any])


class _Languages(click.Option):
    """An option whose help names the languages; they are looked up when the help is printed."""

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        from robodyn.emit.languages import LANGUAGES, defaults

        names = [
            name if not language.aliases else f"{name} ({', '.join(language.aliases)})"
            for name, language in LANGUAGES.items()
        ]
        self.help = f"Languages, separated by commas: {', '.join(names)}.  [default: {','.join(defaults())}]"
        return super().get_help_record(ctx)


def language_option(command: Command) -> Command:
    """Add ``--lang`` (``--language``), passed to `command` as ``lang: str | None``."""
    return click.option("--lang", "--language", "lang", metavar="A,B", cls=_Languages)(command)


def chosen_languages(lang: str | None) -> tuple[str, ...]:
    """The names of the languages of ``--lang``, without duplicates, aliases resolved.

    Raises
    ------
    InputError: no language, a duplicate, or an unknown language.
    """
    from robodyn.emit.languages import LANGUAGES, defaults, languages_named
    from robodyn.errors import InputError

    if lang is None:
        return defaults()
    names = listed(lang)
    if not names:
        raise InputError("--lang names no language", expected=f"some of {', '.join(LANGUAGES)}")
    return tuple(language.name for language in languages_named(names))


def trig_for(languages: tuple[str, ...], trig: str) -> str:
    """``trig``, unless it is the default and one of ``languages`` prefers something else."""
    from click.core import ParameterSource

    from robodyn.emit.languages import LANGUAGES

    if click.get_current_context().get_parameter_source("trig") is not ParameterSource.DEFAULT:
        return trig
    return next((LANGUAGES[name].trig for name in languages if LANGUAGES[name].trig != trig), trig)
