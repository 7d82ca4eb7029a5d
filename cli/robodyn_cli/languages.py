"""``--lang``: the languages, from the table in :mod:`robodyn.emit.languages`."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from robodyn.errors import InputError
from robodyn_cli.choices import COMPILED_LANGUAGES, SEVERAL_LANGUAGES
from robodyn_cli.decorators import option
from robodyn_cli.options import listed

if TYPE_CHECKING:
    from robodyn.kernels.generate import Generated


def _languages() -> str:
    from robodyn.emit.languages import DEFAULTS, LANGUAGES

    names = [
        name if not language.aliases else f"{name} ({', '.join(language.aliases)})"
        for name, language in LANGUAGES.items()
    ]
    return f"Languages, separated by commas: {', '.join(names)}.  [default: {','.join(DEFAULTS)}]"


def _compiled_languages() -> str:
    from robodyn.emit.languages import compiled_names

    return f"Language: {' or '.join(compiled_names())}."


#: Adds ``--lang`` (``--language``), passed to a command as ``lang: str | None``.
language_option = option("--lang --language=A,B lang", _languages, SEVERAL_LANGUAGES)
#: The same for one language that can be called from Python, passed as ``lang: str``.
compiled_language_option = option(
    "--lang --language=A lang", _compiled_languages, COMPILED_LANGUAGES, default="c"
)


def chosen_languages(lang: str | None, *, compiled: bool = False) -> tuple[str, ...]:
    """The names of the languages of ``--lang``, aliases resolved; ``compiled``: to be called from Python.

    Raises
    ------
    InputError: no language, a duplicate, an unknown language, or one that cannot be called.
    """
    from robodyn.emit.languages import DEFAULTS, LANGUAGES, compiled_language, languages_named

    if lang is None:
        return DEFAULTS
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
