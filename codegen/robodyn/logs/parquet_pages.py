"""What a Parquet file says of itself, held against itself before anything of it is unpacked.

The numbers of rows stand in the footer three times (for the file, for each group of rows, for each column of
a group), and once more in the head of each page, with the size that the page unpacks to. A small file may
claim any of them. Here they are read, and must agree; a page of numbers has no reason to unpack to more than
its numbers take. Footer and heads are in Thrift's compact protocol (https://github.com/apache/parquet-format,
whose numbers of fields these are).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import IO, Any, Final

_MAGIC: Final = b"PAR1"
#: Largest footer and largest head of a page [bytes].
FOOTER, HEAD = 1 << 24, 1 << 16
#: Columns of a file, levels that they are nested in, and columns of all groups of rows together.
COLUMNS, DEPTH, CHUNKS = 1 << 16, 64, 1 << 17
#: What a page may unpack to [bytes]: so much a value, and so much besides for how it is encoded.
A_VALUE, A_PAGE = 16, 1 << 13

# What is read of a struct: its fields by number, and what is read of each; the rest is passed over.
_Form = Mapping[int, "_Form | bool"]
_COUNT: Final[_Form] = {1: True}
_PAGE: Final[_Form] = {1: True, 2: True, 3: True, 5: _COUNT, 7: _COUNT, 8: _COUNT}
_COLUMN: Final[_Form] = {3: True, 4: True, 5: True}
_CHUNK: Final[_Form] = {3: {3: True, 5: True, 7: True, 9: True, 11: True}}
_FOOTER: Final[_Form] = {2: _COLUMN, 3: True, 4: {1: _CHUNK, 3: True}}

_DATA, _DICTIONARY, _DATA_2 = 0, 2, 3  # types of pages
_HEADS: Final = {_DATA: 5, _DICTIONARY: 7, _DATA_2: 8}  # where the head of each type stands
_REPEATED = 2


class Damaged(ValueError):
    """The file is no Parquet, or contradicts itself; the message says where."""


@dataclass(frozen=True, slots=True)
class Chunk:
    """A column of a group of rows as the footer has it: its ``name`` and its place in the file [bytes], how
    many ``rows`` the group has, and how many ``values`` the column."""

    name: str
    start: int
    size: int
    rows: int
    values: int


@dataclass(frozen=True, slots=True)
class Footer:
    """What the end of a file says: how many ``rows`` it has, ``columns`` (those that are nested in no other
    and have one value a row, by name: their places among all), and its groups of rows."""

    rows: int
    columns: Mapping[str, int]
    groups: Sequence[Mapping[int, Any]]

    def chunks(self, names: Sequence[str]) -> Iterator[Chunk]:
        """The columns called ``names``, group of rows by group of rows.

        Raises
        ------
        Damaged: one of them is not in a group, or not in its place.
        """
        for k, group in enumerate(self.groups, 1):
            listed = group[1]
            for name in names:
                place = self.columns.get(name)
                data = listed[place].get(3) if place is not None and place < len(listed) else None
                if not isinstance(data, Mapping) or data.get(3) != [name.encode()]:
                    raise Damaged(f"no column {name!a} in its place in group {k} of rows")
                values, size, start = (_whole(data.get(key)) for key in (5, 7, 9))
                dictionary = _whole(data.get(11, 0))
                start = dictionary if 0 < dictionary < start else start
                yield Chunk(name, start, size, _whole(group.get(3)), values)


def read_footer(file: IO[bytes], size: int) -> Footer:
    """The footer of a file of ``size`` bytes.

    Raises
    ------
    Damaged: there is none; it is larger, or its columns are nested more deeply, than those of any log; its
        numbers of rows do not agree.
    """
    file.seek(max(0, size - 8))
    tail = file.read(8) or b""
    length = int.from_bytes(tail[:4], "little")
    if len(tail) < 8 or tail[4:] != _MAGIC:
        raise Damaged("it does not end as Parquet does")
    if length > size - 12 or length > FOOTER:
        raise Damaged(f"a footer of {length} bytes in a file of {size}")
    file.seek(size - 8 - length)
    footer = _Thrift(file.read(length) or b"").struct(_FOOTER)
    schema, groups = (footer[key] if isinstance(footer.get(key), list) else [] for key in (2, 4))
    rows, counts = _whole(footer.get(3)), [_whole(group.get(3)) for group in groups]
    if min([rows, *counts]) < 0 or sum(counts) != rows:
        raise Damaged(f"{rows} rows, and {sum(counts)} in its groups of rows")
    if any(not isinstance(group.get(1), list) for group in groups):
        raise Damaged("a group of rows without columns")
    return Footer(rows, dict(_flat(schema)), groups)


def _flat(schema: Sequence[Mapping[int, Any]]) -> Iterator[tuple[str, int]]:
    """Columns that are nested in no other and have one value a row: name, and place among all that have
    values. The first entry of ``schema`` is the table; each stands before those that are in it."""
    waiting: list[int] = []  # columns that each open level still waits for
    place = 0
    for entry in schema:
        while waiting and not waiting[-1]:
            waiting.pop()
        if waiting:
            waiting[-1] -= 1
        children, name = _whole(entry.get(5, 0)), entry.get(4)
        if children > 0:
            waiting.append(children)
        elif waiting:
            if len(waiting) == 1 and entry.get(3) != _REPEATED and isinstance(name, bytes):
                yield name.decode("utf-8", "replace"), place
            place += 1
        if len(waiting) > DEPTH:
            raise Damaged(f"columns nested more than {DEPTH} deep")


def check_pages(file: IO[bytes], size: int, chunk: Chunk) -> None:
    """Hold the footer's numbers of a column against the heads of its pages, in a file of ``size`` bytes.

    Takes time in proportion to the number of pages, and no memory.

    Raises
    ------
    Damaged: they do not agree, or a page would unpack to more than its values take.
    """
    name = ascii(chunk.name)
    if chunk.values != chunk.rows:
        raise Damaged(f"{name} has {chunk.values} values in {chunk.rows} rows")
    end = chunk.start + chunk.size
    if not 0 < chunk.start <= end <= size:
        raise Damaged(f"{name} claims to lie outside of the file")
    place, seen = chunk.start, 0
    while seen < chunk.values:
        if place >= end:
            raise Damaged(f"{name} has {seen} values where {chunk.values} are said to be")
        head, length = _head(file, place, end)
        kind, unpacked, packed = (_whole(head.get(key)) for key in (1, 2, 3))
        place += length + packed
        if packed < 0 or place > end:
            raise Damaged(f"a page of {name} claims to have {packed} bytes")
        if kind not in _HEADS:
            continue  # a page of neither values nor their dictionary is passed over by all readers
        own = head.get(_HEADS[kind])
        count = _whole(own.get(1) if isinstance(own, Mapping) else None)
        least, most = (0, chunk.values) if kind == _DICTIONARY else (1, chunk.values - seen)
        if not least <= count <= most:
            raise Damaged(f"a page of {name} has {count} values, of {chunk.values} in all")
        if not 0 <= unpacked <= A_VALUE * count + A_PAGE:
            raise Damaged(f"a page of {name} unpacks to {unpacked} bytes, for {count} values")
        seen += 0 if kind == _DICTIONARY else count


def _head(file: IO[bytes], place: int, end: int) -> tuple[Mapping[int, Any], int]:
    """The head of the page at ``place``, and its length [bytes]."""
    wanted = 128
    while True:
        file.seek(place)
        data = file.read(min(wanted, end - place)) or b""
        reader = _Thrift(data)
        try:
            return reader.struct(_PAGE), reader.at
        except _Short:
            if wanted >= HEAD or len(data) < wanted:
                raise Damaged("a page without a head") from None
            wanted *= 8


def _whole(value: object) -> int:
    if not isinstance(value, int) or isinstance(value, bool):
        raise Damaged("a number is missing")
    return value


# --- Thrift -----------------------------------------------------------------------------------------------

_TRUE, _FALSE, _BYTE, _NUMBERS, _DOUBLE, _WORD = 1, 2, 3, (4, 5, 6), 7, 8  # kinds of values
_LIST, _SET, _STRUCT = 9, 10, 12
_LEVELS, _FIELDS = 12, 64  # of values in each other, and of a struct; what has more is no Parquet


class _Short(Damaged):
    """The data end before the value does."""


class _Thrift:
    """A reader of Thrift's compact protocol; ``at`` is its place in the data."""

    def __init__(self, data: bytes) -> None:
        self.data, self.at = data, 0
        self.kept = 0

    def struct(self, form: _Form, depth: int = _LEVELS) -> dict[int, Any]:
        """The fields of a struct that ``form`` names, by number; structs in it are the same again."""
        fields: dict[int, Any] = {}
        seen: set[int] = set()
        last = 0
        while True:
            head = self._byte()
            if not head:
                return fields
            last = last + (head >> 4) if head >> 4 else self._signed()
            if last in seen or len(seen) == _FIELDS:
                raise Damaged("a field that stands twice, or too many of them")
            seen.add(last)
            value = self._value(head & 15, form.get(last, False), depth)
            if last in form:
                fields[last] = value

    def _value(self, kind: int, form: _Form | bool, depth: int) -> Any:
        if not depth:
            raise Damaged("values nested too deeply")
        if kind in (_TRUE, _FALSE):
            return kind == _TRUE
        if kind == _BYTE:
            return self._bytes(1)
        if kind in _NUMBERS:
            return self._signed()
        if kind == _DOUBLE:
            return self._bytes(8)
        if kind == _WORD:
            return self._bytes(self._unsigned())
        if kind in (_LIST, _SET):
            return self._list(form, depth - 1)
        if kind == _STRUCT:
            return self.struct(form if isinstance(form, Mapping) else {}, depth - 1)
        raise Damaged(f"a value of a kind {kind} that no Parquet has")

    def _list(self, form: _Form | bool, depth: int) -> list[Any]:
        head = self._byte()
        count, kind = head >> 4, head & 15
        if count == 15:
            count = self._unsigned()
        if count > len(self.data) - self.at:  # each takes a byte at least
            raise _Short("the data end in a list")
        if kind in (_TRUE, _FALSE):
            self._bytes(count)
            return []
        if isinstance(form, Mapping) and kind != _STRUCT:
            raise Damaged("a list of something else")
        self.kept += count if form else 0
        if count > COLUMNS or self.kept > 4 * CHUNKS:
            raise Damaged(f"a list of {count}, more than {COLUMNS}, or too many lists")
        items = []
        for _ in range(count):
            value = self._value(kind, form, depth)
            if form:
                items.append(value)
        return items

    def _signed(self) -> int:
        value = self._unsigned()
        return (value >> 1) ^ -(value & 1)

    def _unsigned(self) -> int:
        value = shift = 0
        while True:
            byte = self._byte()
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value
            if shift > 63:
                raise Damaged("a number without an end")

    def _byte(self) -> int:
        if self.at >= len(self.data):
            raise _Short("the data end in a value")
        self.at += 1
        return self.data[self.at - 1]

    def _bytes(self, count: int) -> bytes:
        if count > len(self.data) - self.at:
            raise _Short("the data end in a word")
        self.at += count
        return self.data[self.at - count : self.at]
