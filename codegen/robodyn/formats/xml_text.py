"""Decodes XML files, and repairs the violations of the XML standard that other readers of robot files accept.

A repair replaces characters one for one, so line and column numbers stay those of the file. Every repair is
reported as a warning.
"""

from __future__ import annotations

import codecs
import re
from dataclasses import dataclass
from encodings import normalize_encoding
from encodings.aliases import aliases
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.robot.names import shown

#: Supported encodings, by their Python names. No other name reaches Python's codec registry, which also has
#: codecs that decompress data or interpret escape sequences.
ENCODINGS: Final = frozenset(
    (
        *("ascii", "utf_8", "utf_16", "utf_16_le", "utf_16_be", "latin_1", "koi8_r", "koi8_u", "mac_roman"),
        *(f"iso8859_{part}" for part in (2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 14, 15, 16)),
        *(f"cp{page}" for page in (437, 850, 852, 866, 932, 949, *range(1250, 1259))),
        *("gb2312", "gbk", "gb18030", "big5", "shift_jis", "euc_jp", "euc_kr"),
    )
)
_SAVE: Final = "save the file as UTF-8"
_PRESCAN: Final = 1024
"""[characters] The declaration must be within this distance from the beginning, as in HTML (WHATWG, section
13.2.3.2: the prescan of 1024 bytes)."""
_DECLARATION: Final = re.compile(r"([ \t\n\ufeff]*)(<\?xml\s[^<>]*?\?>)?")
_ENCODING: Final = re.compile(r"""encoding\s*=\s*["']([^"']*)["']""")
_MARKS: Final = {
    codecs.BOM_UTF8: "utf_8",
    codecs.BOM_UTF16_LE: "utf_16_le",
    codecs.BOM_UTF16_BE: "utf_16_be",
}
#: The first two bytes of a UTF-16 file without a byte order mark.
_UTF16_START: Final = re.compile(rb"(?P<utf_16_le>[<\s]\0)|(?P<utf_16_be>\0[<\s])")
_OPENING: Final = re.compile(r"<!--|<!\[CDATA\[|<\?")
_CLOSING: Final = {"<!--": "-->", "<![CDATA[": "]]>", "<?": "?>"}


@dataclass(frozen=True, slots=True)
class XmlText:
    """The repaired text of a file, with a warning for each repair. Expat must be told to read it as UTF-8,
    whatever encoding it declares."""

    text: str
    warnings: tuple[tuple[Place, str], ...] = ()


def xml_text(data: bytes, file: str) -> XmlText:
    """Decode and repair ``data``, the content of ``file`` (its name in messages); lines end in ``\\n``.

    Three violations of the XML standard are accepted: blanks and byte order marks before the declaration,
    ``--`` in comments, and a byte order mark that contradicts the declared encoding.

    Raises
    ------
    InputError: the declared encoding is not supported, or the bytes are not valid in it. The error has the
        position in the file.
    """
    warnings: list[tuple[Place, str]] = []
    text = _blank_misplaced_declaration(
        _normalize_newlines(_decode_as_declared(data, file, warnings)), file, warnings
    )
    text = _repair_comments(text, file, warnings)
    return XmlText(text, tuple(warnings))


def load_encodings() -> None:
    """Load the codecs of all :data:`ENCODINGS` now, for a process that may not open files later."""
    for name in ENCODINGS:
        codecs.lookup(name)


def _decode_as_declared(data: bytes, file: str, warnings: list[tuple[Place, str]]) -> str:
    mark = next((mark for mark in _MARKS if data.startswith(mark)), b"")
    utf16_start = _UTF16_START.match(data)
    by_bytes = _MARKS.get(mark) or (utf16_start.lastgroup if utf16_start else None) or ""
    data = data.removeprefix(mark)
    head = data[: 2 * _PRESCAN].decode(by_bytes if by_bytes.startswith("utf_16") else "latin-1", "replace")
    head = _normalize_newlines(head)[:_PRESCAN]
    declaration = _DECLARATION.match(head)
    encoding = declaration and declaration[2] and _ENCODING.search(declaration[2])
    if not encoding:
        return _decode(data, by_bytes or "utf_8", "", file)
    assert declaration is not None
    name, where = encoding[1], _place(head, declaration.start(2) + encoding.start(1), file)
    codec = normalize_encoding(name).lower()
    codec = codec if codec in ENCODINGS else aliases.get(codec, "")
    if codec not in ENCODINGS:
        raise InputError(
            "the encoding that the file declares is not supported",
            where=where,
            found=shown(name),
            expected="UTF-8, UTF-16, ISO-8859-1, windows-1252 or another usual one",
            remedy=_SAVE,
        )
    if by_bytes == "utf_8" and codec != "utf_8":
        message = (
            f"the file declares {shown(name)} and begins with the byte order mark of UTF-8: read as UTF-8"
        )
        warnings.append((where, message))
        return _decode(data, by_bytes, "", file)
    if by_bytes.startswith("utf_16") != codec.startswith("utf_16") or (
        by_bytes and codec not in (by_bytes, "utf_16", "utf_8")
    ):
        raise InputError(
            "the file is not in the encoding that it declares",
            where=where,
            found=f"{shown(name)}, but the text is {'UTF-16' if by_bytes else 'in a one-byte encoding'}",
            remedy="correct the declaration, or save the file as UTF-8",
        )
    if codec == "utf_16" and not mark:
        warnings.append((where, "a file in UTF-16 has no byte order mark; the XML standard requires one"))
    return _decode(data, by_bytes or codec, name, file)


def _decode(data: bytes, codec: str, declared: str, file: str) -> str:
    """Decode ``data`` with ``codec``. Messages name the encoding ``declared`` by the file, if any."""
    try:
        return data.decode(codec)
    except UnicodeDecodeError as error:
        before = _normalize_newlines(data[: error.start].decode(codec, "replace"))
        remedy = _SAVE
        if not declared and codec == "utf_8":
            remedy += ', or declare what it is: <?xml version="1.0" encoding="ISO-8859-1"?>'
        name = declared or codec.upper().replace("_", "-", 1).partition("_")[0]
        raise InputError(
            f"the file is not {shown(name)[1:-1]} text",
            where=_place(before, len(before), file),
            found=f"byte 0x{data[error.start]:02x}",
            remedy=remedy,
        ) from None


def _normalize_newlines(text: str) -> str:
    """``text`` with lines that end in ``\\n``."""
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _place(text: str, offset: int, file: str) -> Place:
    return Place(file, text.count("\n", 0, offset) + 1, offset - text.rfind("\n", 0, offset))


def _blank_misplaced_declaration(text: str, file: str, warnings: list[tuple[Place, str]]) -> str:
    """Overwrite with blanks an XML declaration or byte order mark that is not at the beginning."""
    match = _DECLARATION.match(text)
    if match is None or not match[1] or not (match[2] or "\ufeff" in match[1]):
        return text
    start = match.start(2) if match[2] else text.index("\ufeff")
    message = "a byte order mark that is not at the beginning is not well-formed XML"
    if match[2]:
        message = (
            "something stands before <?xml; this is not well-formed XML, and other readers refuse the file"
        )
    warnings.append((_place(text, start, file), message))
    return re.sub(r"[^\n]", " ", match[0]) + text[match.end() :]


def _repair_comments(text: str, file: str, warnings: list[tuple[Place, str]]) -> str:
    """Replace every hyphen by ``=`` in comments that contain ``--`` or end in a hyphen."""
    parts, offsets, end, position = [], [], 0, 0
    while opening := _OPENING.search(text, position):
        begin = opening.end()
        close = text.find(_CLOSING[opening[0]], begin)
        if close < 0:
            break  # expat reports the unclosed comment or section
        position = close + 3 if opening[0] != "<?" else close + 2
        comment = text[begin:close]
        if opening[0] == "<!--" and ("--" in comment or comment.endswith("-")):
            hyphens = comment.find("--")
            offsets.append(begin + (hyphens if hyphens >= 0 else len(comment) - 1))
            parts += [text[end:begin], comment.replace("-", "=")]
            end = close
    if not offsets:
        return text
    others = f", here and in {len(offsets) - 1} more" if len(offsets) > 1 else ""
    message = f"hyphens in a row in a comment{others} are not well-formed XML: other readers refuse the file"
    warnings.append((_place(text, offsets[0], file), message))
    return "".join((*parts, text[end:]))
