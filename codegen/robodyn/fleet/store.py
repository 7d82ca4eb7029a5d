"""What was worked out of logs, by their content: a second run does only what is new.

An SQLite file with a write-ahead log, held by one run at a time. Each result is a transaction of its own, so
that a run that is killed, or whose disk is full, leaves every result that it had; and because nobody else
holds it, no shared memory is needed, which network file systems do not have.
"""

from __future__ import annotations

import sqlite3
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any, Final

from robodyn.errors import InputError, OutputError, Place, RobodynError
from robodyn.files import label
from robodyn.outputs import check_outputs
from robodyn.version import VERSION

#: The layout of the file; files of another are not read. The mark by which SQLite's own files are told apart.
_LAYOUT: Final = 2
_MARK: Final = 0x726F626F
#: [ns] A file that is younger than this when it is looked at may be written again without a new time.
_YOUNG: Final = 2_000_000_000
_TABLE: Final = (
    "create table results (key text primary key, robodyn text, refused integer, value blob, seal text)"
)


@dataclass(frozen=True, slots=True)
class Refused:
    """A log that cannot be used: ``why``."""

    why: str


def key_of(*parts: str | bytes) -> str:
    """The key of what is worked out of ``parts``: hashes, texts, the version of what works it out."""
    joined = b"".join(len(data).to_bytes(8, "big") + data for data in map(_encoded, parts))
    return sha256(joined).hexdigest()


class Store:
    """Results by key, and what files were when they were last looked at: see :func:`open_store`."""

    def __init__(self, connection: sqlite3.Connection, name: str) -> None:
        self._connection, self._name = connection, name

    def result(self, key: str) -> bytes | Refused | None:
        """What was worked out; None: it was not yet.

        Raises
        ------
        InputError: it is not what was kept under this key. SQLite notices where its pages are damaged, and
            neither what is in them nor that the value of one key stands at another.
        """
        row = self._row("select robodyn, refused, value, seal from results where key = ?", key)
        if row is None:
            return None
        *stated, seal = row
        if seal != _seal(key, *stated):
            what, remedy = _DAMAGED
            found = "a row that differs from its checksum"
            raise InputError(what, where=Place(self._name), found=found, remedy=remedy)
        _, refused, value = stated
        return Refused(value.decode()) if refused else bytes(value)

    def value(self, key: str) -> bytes:
        """What was worked out of a log that can be used.

        Raises
        ------
        InputError: as of :meth:`result`.
        KeyError: there is no such result.
        """
        data = self.result(key)
        if not isinstance(data, bytes):
            raise KeyError(key)
        return data

    def refusal(self, key: str) -> str | None:
        """Why a log cannot be used; None: it can, or it is not known.

        Raises
        ------
        InputError: as of :meth:`result`.
        """
        is_refused = self._row("select 1 from results where key = ? and refused", key) is not None
        value = self.result(key) if is_refused else None
        return value.why if isinstance(value, Refused) else None

    def has(self, key: str) -> bool:
        """Whether there is a result, of whichever kind."""
        return self._row("select 1 from results where key = ?", key) is not None

    def keep(self, key: str, value: bytes | Refused) -> None:
        """Keep a result, for good.

        Raises
        ------
        OutputError: there is no room for it; all others stay.
        """
        data = value.why.encode() if isinstance(value, Refused) else value
        row = (key, VERSION, int(isinstance(value, Refused)), data)
        self._row("insert or replace into results values (?, ?, ?, ?, ?)", *row, _seal(*row))

    def content(self, source: str, signature: str) -> str | None:
        """The hash of a log whose files have that ``signature``; None: they were not read yet, or written
        since.

        Raises
        ------
        InputError: it is not what was kept of this log.
        """
        content = self.result(key_of("content", source, signature))
        return content.decode() if isinstance(content, bytes) else None

    def saw(self, source: str, signature: str, youngest: int, content: str) -> None:
        """Remember the hash of a log whose files had that ``signature``, the ``youngest`` written then [ns].

        Raises
        ------
        OutputError: there is no room for it.
        """
        if time.time_ns() - youngest >= _YOUNG:
            self.keep(key_of("content", source, signature), content.encode())

    def _row(self, statement: str, *values: Any) -> Any:
        """The first row that a ``statement`` comes to; None without one."""
        try:
            return self._connection.execute(statement, values).fetchone()
        except sqlite3.DatabaseError as error:
            raise _cannot(self._name, error) from None


@contextmanager
def open_store(path: Path) -> Iterator[Store]:
    """The store in the file ``path``, which is there afterwards; what other versions of robodyn left there is
    dropped.

    Raises
    ------
    InputError: another run holds it, it is something else or damaged, or it cannot be written there.
    OutputError: there is no room.
    """
    name = label(path)
    check_outputs(path.parent, [path.name], named=True)  # SQLite would follow a link
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        connection = sqlite3.connect(path, timeout=0.0, isolation_level=None)
    except (OSError, sqlite3.DatabaseError) as error:
        raise InputError(_NO_PLACE, where=Place(name), found=str(error)) from None
    with closing(connection):
        try:
            connection.execute("pragma locking_mode = exclusive")
            is_new = _is_new(connection, name)  # before anything of it is changed
            connection.execute("pragma journal_mode = wal")
            connection.execute("pragma synchronous = normal")
            connection.execute("begin immediate")
            if is_new:
                connection.execute(_TABLE)
                connection.execute(f"pragma application_id = {_MARK}")
                connection.execute(f"pragma user_version = {_LAYOUT}")
            connection.execute("delete from results where robodyn != ?", [VERSION])
            connection.execute("commit")
        except sqlite3.DatabaseError as error:
            raise _cannot(name, error) from None
        yield Store(connection, name)


def _is_new(connection: sqlite3.Connection, name: str) -> bool:
    """Whether the file is empty; else it is a store.

    Raises
    ------
    InputError: it is something else.
    """
    if connection.execute("select count(*) from sqlite_master").fetchone()[0] == 0:
        return True
    mark = connection.execute("pragma application_id").fetchone()[0]
    layout = connection.execute("pragma user_version").fetchone()[0]
    if (mark, layout) == (_MARK, _LAYOUT):
        return False
    raise InputError(
        "this is no store of results",
        where=Place(name),
        found="the layout of another robodyn" if mark == _MARK else "another program's data",
        expected=f"a store of layout {_LAYOUT}",
        remedy="choose another folder with -o, or delete the file",
    )


_NO_PLACE: Final = "results cannot be kept"
_DAMAGED: Final = ("the store of results is damaged", "delete it: all logs are read again then")
#: What is wrong where SQLite fails with one of these codes, and what to do.
_FAILURES: Final = {
    (sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED): (
        "another run holds the results",
        "wait for its end, or choose another folder",
    ),
    (sqlite3.SQLITE_NOTADB, sqlite3.SQLITE_CORRUPT, sqlite3.SQLITE_ERROR): _DAMAGED,  # the last: no table
    (sqlite3.SQLITE_READONLY, sqlite3.SQLITE_CANTOPEN, sqlite3.SQLITE_PERM): (
        _NO_PLACE,
        "choose another folder with -o, or allow this one to be written",
    ),
}


def _cannot(name: str, error: sqlite3.DatabaseError) -> RobodynError:
    """What to say where SQLite fails."""
    code, where = (getattr(error, "sqlite_errorcode", 0) or 0) & 0xFF, Place(name)
    for codes, (what, remedy) in _FAILURES.items():
        if code in codes:
            return InputError(what, where=where, found=str(error), remedy=remedy)
    remedy = "free some space and run it again: what is done is kept"
    return OutputError(_NO_PLACE, where=where, found=str(error), remedy=remedy)


def _seal(*row: Any) -> str:
    """The checksum of a ``row``, its key first: of what each column holds, and of which kind."""
    fields = [(type(value).__name__, value if isinstance(value, bytes) else str(value)) for value in row]
    return key_of(f"layout {_LAYOUT}", *(part for field in fields for part in field))


def _encoded(text: str | bytes) -> bytes:
    return text if isinstance(text, bytes) else text.encode(errors="surrogatepass")
