"""The keys of robodyn.toml: those options of ``gen`` and ``package`` that say what is written, as they are
defined there."""

from __future__ import annotations

from typing import Final

import click

from robodyn.errors import InputError
from robodyn.project.keys import PACKAGE, Key, Keys
from robodyn.project.reading import OF, Entry
from robodyn_cli.choices import OneOf
from robodyn_cli.file_options import with_common_options
from robodyn_cli.gen import command as gen
from robodyn_cli.package import command as package

#: Options that say what a run does, and not what is written; those of a search, which may come to another
#: program on another machine; the output, which each entry of a project has, and what its table says; what
#: opens folders, which whoever proposes a project file may not.
_OF_A_RUN: Final = frozenset(
    [
        "output",
        "arg",
        "compile_",
        "check",
        "as_json",
        "force",
        "keep",
        "budget_seconds",
        "seed",
        "on",
        "seeds",
        "format_",
    ]
)
_SEARCHES: Final = ("search", "full")


def project_keys() -> Keys:
    """All keys."""
    return Keys(kernels=_keys(with_common_options(gen)), packages=_keys(with_common_options(package)))


def _keys(command: click.Command) -> dict[str, Key]:
    options = (parameter for parameter in command.params if isinstance(parameter, click.Option))
    return {
        key.name: key for key in (_key(option, command) for option in options if option.name not in _OF_A_RUN)
    }


def _key(option: click.Option, command: click.Command) -> Key:
    words = option.type if isinstance(option.type, OneOf) and not option.type.others else None
    return Key(
        name=option.opts[0].removeprefix("--"),
        help=lambda: (option.get_help_record(click.Context(command)) or ("", ""))[1],
        flag=option.is_flag,
        several=option.multiple,
        listed="," in (option.metavar or ""),
        words=None if words is None else words.words,
    )


def check_settings(entry: Entry, keys: Keys) -> None:
    """Hold the values of an entry to the words that its options take, and its format to those there are.

    Raises
    ------
    InputError: one of them is none of those, or asks for a search.
    """
    from robodyn.packages import format_named

    if entry.command == PACKAGE:
        try:
            format_named(entry.name.partition(OF)[2])
        except InputError as error:
            raise error.at(entry.place()) from None
    for name, value in entry.settings.items():
        try:
            keys.of(entry.command)[name].check(value)
        except InputError as error:
            raise error.at(entry.place(name)) from None
        if name == "optimize" and value in _SEARCHES:
            raise InputError(
                "a search is no part of a build: it may end with another program each time",
                where=entry.place(name),
                found=f"optimize = {value!r}",
                expected="record, which takes what a search has found, fast or none",
                remedy=f"run once: robodyn gen {entry.robot} --optimize {value} --keep",
            )
