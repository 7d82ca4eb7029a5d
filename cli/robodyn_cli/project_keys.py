"""The keys of robodyn.toml: those options of ``gen`` that say what is written, as they are defined there."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import click

from robodyn.errors import InputError
from robodyn.project.keys import Key
from robodyn.project.reading import Entry
from robodyn_cli.choices import OneOf
from robodyn_cli.gen import command as gen

#: Options of ``gen`` that say what a run does, and not what the kernels are; those of a search, which may
#: come to another program on another machine; and the output, which a project has for each robot.
_OF_A_RUN: Final = frozenset(
    {"output", "compile_", "check", "as_json", "keep", "budget_seconds", "seed", "firmware"}
)
_SEARCHES: Final = ("search", "full")


def project_keys() -> dict[str, Key]:
    """All keys, by name."""
    options = (parameter for parameter in gen.params if isinstance(parameter, click.Option))
    return {key.name: key for key in (_key(option) for option in options if option.name not in _OF_A_RUN)}


def _key(option: click.Option) -> Key:
    words = option.type if isinstance(option.type, OneOf) and not option.type.others else None
    return Key(
        name=option.opts[0].removeprefix("--"),
        help=lambda: (option.get_help_record(click.Context(gen)) or ("", ""))[1],
        flag=option.is_flag,
        several=option.multiple,
        listed="," in (option.metavar or ""),
        words=None if words is None else words.words,
    )


def check_settings(entry: Entry, keys: Mapping[str, Key]) -> None:
    """Hold the values of an entry to the words that its options take.

    Raises
    ------
    InputError: one of them is none of those, or asks for a search.
    """
    for name, value in entry.settings.items():
        try:
            keys[name].check(value)
        except InputError as error:
            raise error.at(entry.place(name)) from None
        if name == "optimize" and value in _SEARCHES:
            raise InputError(
                "a search is no part of a build: it may end with another program each time",
                where=entry.place(name),
                found=f"optimize = {value!r}",
                expected="record, which takes what a search has found, fast or none",
                remedy=f"run once: robodyn gen {entry.name} --optimize {value} --keep",
            )
