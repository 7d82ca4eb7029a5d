"""Files that messages are stored in: what topics they have, and the messages one by one."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Final, Protocol

from robodyn.tools.libraries import ROSBAGS

#: Largest message, and largest chunk unpacked [bytes].
MESSAGE, CHUNK = 1 << 26, 1 << 28
#: Messages of a topic that are looked at to learn what it has, and the largest of them [bytes].
LOOKED_AT, LOOKED_SIZE = 24, 1 << 18

_ZSTD: Final = b"\x28\xb5\x2f\xfd"


class BadStorage(ValueError):
    """The file is not what its name says, or contradicts itself."""


@dataclass(frozen=True, slots=True)
class Topic:
    """A topic of a file: its ``key`` there, ``name``, ``type`` of message, ``encoding``, ``definition`` and
    its ``language`` (ros2msg, ros2idl or none), how many messages it has, and the first of them."""

    key: int
    name: str
    type: str
    encoding: str
    language: str
    definition: str
    count: int
    first: tuple[bytes, ...]


class Storage(Protocol):
    """A file with messages; ``cut`` says where it breaks off, if it does."""

    @property
    def cut(self) -> str: ...
    def topics(self) -> list[Topic]:
        """What is in it."""
        ...

    def messages(self, keys: set[int]) -> Iterator[tuple[int, bytes]]:
        """Time of recording [ns] and content of the messages of some topics, as they stand in the file."""
        ...


def needed(module: str) -> Any:
    """A ``module`` that comes with the extra ``ros``.

    Raises
    ------
    ToolError: it is missing.
    """
    try:
        return importlib.import_module(module)
    except ImportError:
        raise ROSBAGS.missing() from None


def unpacked(data: bytes, compression: str, most: int) -> bytes:
    """``data`` unpacked, to ``most`` bytes and no further.

    Raises
    ------
    BadStorage: it is not so compressed, or larger.
    ToolError: the library is missing.
    """
    if compression == "zstd":
        zstd = needed("compression.zstd" if sys.version_info >= (3, 14) else "backports.zstd")
        unpacker = zstd.ZstdDecompressor()
    elif compression == "lz4":
        unpacker = needed("lz4.frame").LZ4FrameDecompressor()
    else:
        raise BadStorage(f"a compression {compression[:20]!a} that is not known")
    try:
        content: bytes = unpacker.decompress(data, most + 1)
    except Exception as error:  # each library has errors of its own
        if isinstance(error, MemoryError):
            raise
        raise BadStorage(f"data that cannot be unpacked: {error}") from None
    if len(content) > most:
        raise BadStorage(f"data that unpack to more than {most} bytes")
    return content


def plain(message: bytes) -> bytes:
    """A message that may be compressed on its own: CDR never begins so."""
    return unpacked(message, "zstd", MESSAGE) if message.startswith(_ZSTD) else message
