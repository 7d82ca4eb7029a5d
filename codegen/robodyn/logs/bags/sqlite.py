"""rosbag2's database: messages in a table of SQLite. A ``metadata.yaml`` beside it is not needed."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any
from urllib.parse import quote

from robodyn.files import open_regular
from robodyn.logs.bags.storage import LOOKED_AT, LOOKED_SIZE, MESSAGE, BadStorage, Topic, plain

#: Most topics, and the largest definition of a type [bytes].
TOPICS, DEFINITION = 1 << 12, 1 << 18

_DEFINITIONS = "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions LIMIT ?"
_TOPICS = "SELECT id, name, type, serialization_format FROM topics LIMIT ?"
_COUNT = "SELECT count(*) FROM messages WHERE topic_id = ?"
_FIRST = "SELECT data FROM messages WHERE topic_id = ? AND length(data) <= ? LIMIT ?"


class Database:
    """A database at ``path``, which messages call ``file``."""

    cut = ""

    def __init__(self, path: Path, file: str) -> None:
        self.path, self.file = path, file

    def _opened(self) -> closing[sqlite3.Connection]:
        with open_regular(self.path, "a recording, such as log.db3", self.file) as source:
            if (source.read(16) or b"") != b"SQLite format 3\0":
                raise BadStorage("no mark of SQLite at its start")
        beside = self.path.with_name(self.path.name + "-wal")
        # Nothing is written; what a recorder that died has left in its journal is read with the rest.
        mode = "mode=ro" if beside.is_file() and beside.stat().st_size else "mode=ro&immutable=1"
        connection = sqlite3.connect(f"file:{quote(str(self.path.absolute()))}?{mode}", uri=True)
        connection.execute("PRAGMA trusted_schema=OFF")
        if hasattr(connection, "setlimit"):
            connection.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, MESSAGE)
        return closing(connection)

    def topics(self) -> list[Topic]:
        """As :class:`~robodyn.logs.bags.storage.Storage` says."""
        with _errors(), self._opened() as connection:
            tables = {
                str(name): str(kind)
                for kind, name in connection.execute("SELECT type, name FROM sqlite_master LIMIT 1000")
                if kind in ("table", "view")
            }
            for name in ("topics", "messages"):
                if tables.get(name) != "table":
                    raise BadStorage(f"no table {name}: this is no recording of ROS 2")
            definitions: dict[str, tuple[str, str]] = {}
            if tables.get("message_definitions") == "table":
                query = (
                    "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions LIMIT ?"
                )
                for kind, language, text in connection.execute(query, (TOPICS,)):
                    if isinstance(text, str) and len(text) <= DEFINITION:
                        definitions[str(kind)] = (str(language), text)
            rows = connection.execute(
                "SELECT id, name, type, serialization_format FROM topics LIMIT ?", (TOPICS,)
            )
            topics = []
            for key, name, kind, encoding in rows.fetchall():
                if not isinstance(key, int):
                    raise BadStorage("a topic without a number")
                one = (key,)
                (count,) = connection.execute(
                    "SELECT count(*) FROM messages WHERE topic_id = ?", one
                ).fetchone()
                query = "SELECT data FROM messages WHERE topic_id = ? AND length(data) <= ? LIMIT ?"
                first = connection.execute(query, (key, LOOKED_SIZE, LOOKED_AT)).fetchall()
                language, text = definitions.get(str(kind), ("", ""))
                heads = tuple(plain(data) for (data,) in first if isinstance(data, bytes))
                topics.append(Topic(key, str(name), str(kind), str(encoding), language, text, count, heads))
            return topics

    def messages(self, keys: set[int]) -> Iterator[tuple[int, bytes]]:
        """As :class:`~robodyn.logs.bags.storage.Storage` says."""
        with _errors(), self._opened() as connection:
            marks = ",".join("?" * len(keys))
            query = f"SELECT timestamp, data FROM messages WHERE topic_id IN ({marks}) ORDER BY id"
            for time, data in connection.execute(query, sorted(keys)):
                if not isinstance(time, int) or not isinstance(data, bytes):
                    raise BadStorage("a message that is none")
                yield time, plain(data)


class _errors:  # noqa: N801 (a context, like contextlib's)
    """SQLite's errors become ours."""

    def __enter__(self) -> None:
        return None

    def __exit__(self, kind: Any, error: BaseException | None, trace: Any) -> None:
        if isinstance(error, (sqlite3.Error, OverflowError)):
            raise BadStorage(f"SQLite says: {error}") from None
