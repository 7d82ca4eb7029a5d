"""The languages that kernels are written in, one file each: every module here that has a ``LANGUAGE``."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterator, Mapping, Sequence
from functools import cache

from robodyn.emit.language import Compiled, Feature, Language
from robodyn.errors import InputError

__all__ = [
    "LANGUAGES",
    "compiled_language",
    "compiled_names",
    "defaults",
    "language_named",
    "language_of_browsers",
    "languages_named",
    "require",
]


@cache
def _all() -> dict[str, Language]:
    names = sorted(module.name for module in pkgutil.iter_modules(__path__))
    modules = [importlib.import_module(f"{__name__}.{name}") for name in names]
    return {module.LANGUAGE.name: module.LANGUAGE for module in modules}


class _Languages(Mapping[str, Language]):
    """All languages by name, found at the first look."""

    def __getitem__(self, name: str) -> Language:
        return _all()[name]

    def __iter__(self) -> Iterator[str]:
        return iter(_all())

    def __len__(self) -> int:
        return len(_all())


LANGUAGES: Mapping[str, Language] = _Languages()


def defaults() -> tuple[str, ...]:
    """The names of the languages that are written unless others are asked for."""
    return tuple(name for name, language in LANGUAGES.items() if language.default)


def compiled_names() -> tuple[str, ...]:
    """The names of the languages that can be called from Python."""
    return tuple(name for name, language in LANGUAGES.items() if language.compiled is not None)


def language_named(name: str) -> Language:
    """The language called ``name``, which may be an alias.

    Raises
    ------
    InputError: there is none.
    """
    for language in LANGUAGES.values():
        if name == language.name or name in language.aliases:
            return language
    import difflib

    close = difflib.get_close_matches(name, list(LANGUAGES), n=1)
    raise InputError(
        f"unknown language {name!r}",
        expected=f"one of {', '.join(LANGUAGES)}",
        remedy=f"did you mean {close[0]!r}?" if close else None,
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


def languages_named(names: Sequence[str]) -> tuple[Language, ...]:
    """The languages called ``names``, in that order.

    Raises
    ------
    InputError: there is no such language, or one stands there twice.
    """
    languages = tuple(map(language_named, names))
    if len({language.name for language in languages}) != len(languages):
        raise InputError("a language is asked for twice", found=",".join(names))
    return languages


def language_of_browsers() -> Language:
    """The language that browsers run."""
    return next(language for language in LANGUAGES.values() if language.of_browsers)


def require(feature: Feature, languages: Sequence[Language]) -> None:
    """:class:`InputError` where none of ``languages`` has ``feature``."""
    if any(feature in language.features for language in languages):
        return
    able = [language for language in LANGUAGES.values() if feature in language.features]
    raise InputError(
        f"{_TITLES[feature]} in {' and '.join(language.title for language in able)} only",
        found=", ".join(language.name for language in languages),
        expected=f"{' or '.join(language.name for language in able)} among them",
    )


_TITLES: dict[Feature, str] = {
    "batch": "batches are",
    "parallel": "parallel code is",
    "misra": "MISRA C:2012 is",
    "firmware": "a firmware folder is",
}
