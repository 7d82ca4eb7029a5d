"""Texts that are refused, in files with the whole message of each: whoever changes a message reads it there.

A file is a list of ``text`` and ``says``. After a change that is meant::

    PYTHONPATH=tests python -m refusals.test_refusals --update

writes the messages anew, and the difference is read before it is committed.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

from robodyn.errors import InputError

#: What parsers of YAML, TOML and CSV say in words of their own, which other versions of them do not have.
_PARSERS_WORDS = re.compile(r"(not valid YAML: |not TOML; found |not CSV; found )[^;]*")
#: Long lists of words, which grow with what robodyn knows: their first three are shown.
_LONG_LIST = re.compile(r"((?:[\w-]+, ){3})(?:[\w-]+, ){3,}(?:or )?[\w-]+")
#: What reads a text in a folder of its own.
Reader = Callable[[str, Path], object]


def message_of(reader: Reader, text: str, folder: Path) -> str:
    """What the ``reader`` says of ``text``, in one line; the folder is left out of paths."""
    with pytest.raises(InputError) as caught:
        reader(text, folder)
    error, position = caught.value, getattr(caught.value, "position", None)
    message = str(error).replace(f"{folder}/", "").replace(str(folder), "FOLDER")
    assert (error.exit_code, error.__cause__) == (2, None), message
    assert message.isprintable(), message
    assert len(message) < 700, message
    message = _LONG_LIST.sub(r"\1...", _PARSERS_WORDS.sub(r"\1...", message))
    return message if position is None else f"{position}: {message}"  # of text that stands in no file


def refusals(path: Path) -> list[dict[str, str]]:
    """The texts of a file with their messages."""
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    cases: list[dict[str, str]] = yaml.load(path.read_text(encoding="utf-8"), Loader=loader)
    return cases


def differences(path: Path, reader: Reader, folder: Path) -> Iterator[str]:
    """Where the messages of the ``reader`` are others than those of the file."""
    for k, case in enumerate(refusals(path)):
        here = folder / str(k)
        here.mkdir()
        message = message_of(reader, case["text"], here)
        if message != case["says"]:
            yield f"{case['text']!r}\n  says    {message}\n  instead {case['says']}"


class _Dumper(yaml.SafeDumper):
    """Texts of several lines stand as they are."""


def _string(dumper: _Dumper, text: str) -> Any:
    return dumper.represent_scalar("tag:yaml.org,2002:str", text, style="|" if "\n" in text else None)


_Dumper.add_representer(str, _string)


def write(path: Path, texts: list[str], reader: Reader, folder: Path) -> None:
    """The file of ``texts`` with what the ``reader`` says of them."""
    cases = []
    for k, text in enumerate(texts):
        here = folder / str(k)
        here.mkdir(parents=True)
        cases.append({"text": text, "says": message_of(reader, text, here)})
    dumped = yaml.dump(cases, Dumper=_Dumper, allow_unicode=True, width=1000, sort_keys=False)
    path.write_text(dumped, encoding="utf-8")
