"""``--lang``: the languages, from the table in :mod:`robodyn.emit.languages`."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

import click

from robodyn_cli.choices import COMPILED_LANGUAGES, SEVERAL_LANGUAGES
from robodyn_cli.options import listed

if TYPE_CHECKING:
    from robodyn.kernels.generate import Generated

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
    return click.option(
        "--lang", "--language", "lang", type=SEVERAL_LANGUAGES, metavar="A,B", cls=_Languages
    )(command)


class _Compiled(click.Option):
    """An option for one language that can be called from Python."""

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        from robodyn.emit.languages import compiled_names

        self.help = f"Language: {' or '.join(compiled_names())}."
        return super().get_help_record(ctx)


def compiled_language_option(command: Command) -> Command:
    """Add ``--lang`` (``--language``), passed to `command` as ``lang: str``."""
    return click.option(
        "--lang",
        "--language",
        "lang",
        type=COMPILED_LANGUAGES,
        metavar="A",
        default="c",
        show_default=True,
        cls=_Compiled,
    )(command)


def chosen_languages(lang: str | None, *, compiled: bool = False) -> tuple[str, ...]:
    """The names of the languages of ``--lang``, aliases resolved; ``compiled``: to be called from Python.

    Raises
    ------
    InputError: no language, a duplicate, an unknown language, or one that cannot be called.
    """
    from robodyn.emit.languages import LANGUAGES, compiled_language, defaults, languages_named
    from robodyn.errors import InputError

    if lang is None:
        return defaults()
    names = listed(lang)
    if not names:
        raise InputError("--lang names no language", expected=f"some of {', '.join(LANGUAGES)}")
    languages = languages_named(names)
    for language in languages if compiled else ():
        compiled_language(language.name)
    return tuple(language.name for language in languages)


def trig_for(languages: tuple[str, ...], trig: str) -> str:
    """``trig``, unless it is the default and one of ``languages`` prefers something else."""
    from click.core import ParameterSource

    from robodyn.emit.languages import LANGUAGES

    if click.get_current_context().get_parameter_source("trig") is not ParameterSource.DEFAULT:
        return trig
    return next((LANGUAGES[name].trig for name in languages if LANGUAGES[name].trig != trig), trig)


def tests_of(generated: Generated, languages: tuple[str, ...]) -> dict[str, str]:
    """The tests that go with ``languages``, where one has any: text by file name."""
    from robodyn.emit.languages import LANGUAGES

    if not any(LANGUAGES[name].tests for name in languages):
        return {}
    from robodyn.firmware.language_tests import language_tests

    return language_tests(generated, languages)
