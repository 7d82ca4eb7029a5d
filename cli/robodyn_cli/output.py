"""What a command prints: results on stdout, as text or as one JSON document, and messages on stderr."""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, TYPE_CHECKING, Final

import click

if TYPE_CHECKING:
    from robodyn.robot import Robot


@dataclass(slots=True)
class Document:
    """The one JSON document that stdout gets from a command: whether the command line asks for one, and
    whether its printing has begun; ``robots``: those that it is about. It is the object of
    click's context."""

    as_json: bool = False
    begun: bool = False
    robots: list[Robot] = field(default_factory=list)


def _document() -> Document | None:
    context = click.get_current_context(silent=True)
    return None if context is None else context.find_object(Document)


def note_robot(robot: Robot) -> None:
    """Let the document say what is known of `robot`, too."""
    if (document := _document()) is not None:
        document.robots.append(robot)


def as_json() -> bool:
    """Whether the command that runs has ``--json``."""
    document = _document()
    return document is not None and document.as_json


def echo_document(text: str) -> None:
    """Print `text`, a JSON document, on stdout: the only one there, even if the command fails afterwards."""
    if (document := _document()) is not None:
        document.begun = True
    click.echo(text.rstrip("\n"))


def echo_json(obj: object) -> None:
    """Print `obj` on stdout as indented JSON; keys keep their order, and NaN is refused (ValueError). What is
    known of the robots that were loaded stands at its end under ``account``."""
    import json

    echo_document(json.dumps(with_account(obj), indent=2, ensure_ascii=False, allow_nan=False))


def show(data: Callable[[], object], lines: Callable[[], Iterable[str]]) -> None:
    """Print the results: their ``data`` as JSON with --json, else as ``lines``."""
    if as_json():
        echo_json(data())
        return
    for line in lines():
        click.echo(line)


def with_account(obj: object) -> object:
    """`obj`, each of its mappings if it is a list, with what is known of the robots that were loaded."""
    document = _document()
    if document is None or not document.robots:
        return obj
    from robodyn.robot.account import account_to_dict

    account = [account_to_dict(robot) for robot in document.robots]
    if isinstance(obj, list):
        return [{**record, "account": account} for record in obj]
    assert isinstance(obj, dict)
    return {**obj, "account": account}


#: Columns of what is printed on stdout.
WIDTH: Final = 100


def wrapped(text: str) -> list[str]:
    """``text`` as lines of at most :data:`WIDTH` columns, all but the first indented; words stay whole."""
    import textwrap

    return textwrap.wrap(text, WIDTH, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False)


def talk(text: str) -> None:
    """Print the message `text` on stderr; a stderr that cannot be written is ignored."""
    try:
        click.echo(text, err=True)
    except OSError:
        drop(sys.stderr)


def drop(stream: IO[str] | None) -> None:
    """Discard what `stream` still buffers, so that the interpreter does not complain at exit."""
    if stream is None:
        return
    with contextlib.suppress(OSError, ValueError):  # a replacement without a descriptor, as in tests
        descriptor = stream.fileno()
        null = os.open(os.devnull, os.O_WRONLY)
        os.dup2(null, descriptor)
        os.close(null)


def printable(path: Path | str) -> str:
    """`path` for a message: as it is, or quoted and escaped if it contains a control character."""
    from robodyn.robot.names import shown

    text = str(path)
    quoted = shown(text, len(text))
    return text if quoted == f"'{text}'" else quoted
