"""The languages that kernels are written in, one file each: every module here has a ``LANGUAGE``, and is
imported when that is asked for."""

from __future__ import annotations

from collections.abc import Sequence

from robodyn.emit.language import Compiled, Feature, Language
from robodyn.errors import InputError, did_you_mean
from robodyn.registry import Registry

LANGUAGES = Registry("robodyn.emit.languages", "LANGUAGE", Language)
#: Those that are written unless others are asked for.
DEFAULTS = ("c", "fortran")


def compiled_names() -> tuple[str, ...]:
    """The names of the languages that can be called from Python."""
    return tuple(name for name, language in LANGUAGES.items() if language.compiled is not None)


def language_named(name: str) -> Language:
    """The language called ``name``, which may be an alias.

    Raises
    ------
    InputError: there is none.
    """
    if name in LANGUAGES:
        return LANGUAGES[name]
    for language in LANGUAGES.values():
        if name in language.aliases:
            return language
    raise InputError(
        f"unknown language {name!r}",
        expected=f"one of {', '.join(LANGUAGES)}",
        remedy=did_you_mean(name, LANGUAGES),
    )


def compiled_language(name: str) -> tuple[Language, Compiled]:
    """The language called ``name``, and how it is compiled and called from Python.

    Raises
    ------
    InputError: there is no such language, or it is written and cannot be called.
    """
    language = language_named(name)
    if language.compiled is None:
        raise InputError(
            f"{language.title} is written, and cannot be called from Python",
            expected=" or ".join(compiled_names()),
        )
    return language, language.compiled


def languages_named(names: Sequence[str] | None) -> tuple[Language, ...]:
    """The languages called ``names``, in that order; None: those that are written by default.

    Raises
    ------
    InputError: there is no such language, or one stands there twice.
    """
    languages = tuple(map(language_named, DEFAULTS if names is None else names))
    if len({language.name for language in languages}) != len(languages):
        raise InputError("a language is asked for twice", found=",".join(names or ()))
    return languages


def require(feature: Feature, what: str, languages: Sequence[Language]) -> None:
    """:class:`InputError` where none of ``languages`` has ``feature``; ``what`` is how its message begins."""
    if any(feature in language.features for language in languages):
        return
    able = [language for language in LANGUAGES.values() if feature in language.features]
    raise InputError(
        f"{what} in {' and '.join(language.title for language in able)} only",
        found=", ".join(language.name for language in languages),
        expected=f"{' or '.join(language.name for language in able)} among them",
    )
