"""The text of an XML file: decoded as the file declares, and XML by the letter where others read it without.

What is mended keeps its length, so that lines and columns stay those of the file. Each mend is a warning.
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

#: Python's names of the encodings that are read. Others are not looked up: Python also has codecs that
#: decompress, or that read escapes.
ENCODINGS: Final = frozenset(
    (
        *("ascii", "utf_8", "utf_16", "utf_16_le", "utf_16_be", "latin_1", "koi8_r", "koi8_u", "mac_roman"),
        *(f"iso8859_{part}" for part in (2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 14, 15, 16)),
        *(f"cp{page}" for page in (437, 850, 852, 866, 932, 949, *range(1250, 1259))),
        *("gb2312", "gbk", "gb18030", "big5", "shift_jis", "euc_jp", "euc_kr"),
    )
)
_SAVE: Final = "save the file as UTF-8"
_HEAD: Final = 1024
"""[characters] So far from the beginning the declaration is looked for, as in HTML (WHATWG, section 13.2.3.2:
the prescan of 1024 bytes)."""
_DECLARATION: Final = re.compile(r"([ \t\n\ufeff]*)(<\?xml\s[^<>]*?\?>)?")
_ENCODING: Final = re.compile(r"""encoding\s*=\s*["']([^"']*)["']""")
_MARKS: Final = {
    codecs.BOM_UTF8: "utf_8",
    codecs.BOM_UTF16_LE: "utf_16_le",
    codecs.BOM_UTF16_BE: "utf_16_be",
}
#: How a file without byte order mark begins whose characters have two bytes.
_WIDE: Final = re.compile(rb"(?P<utf_16_le>[<\s]\0)|(?P<utf_16_be>\0[<\s])")
_OPENING: Final = re.compile(r"<!--|<!\[CDATA\[|<\?")
_CLOSING: Final = {"<!--": "-->", "<![CDATA[": "]]>", "<?": "?>"}


@dataclass(frozen=True, slots=True)
class XmlText:
    """A text that expat reads as UTF-8, whatever its declaration says; and what was not XML by the letter."""

    text: str
    warnings: tuple[tuple[Place, str], ...] = ()


def xml_text(data: bytes, file: str) -> XmlText:
    """The text in ``data``, the content of the file that messages call ``file``; lines end in ``\\n``.

    Read though XML forbids it: blanks and byte order marks before the declaration, ``--`` in comments, an
    encoding that a byte order mark contradicts.

    Raises
    ------
    InputError: the declared encoding is not one that is read, or the bytes are none of its text; with the
        place.
    """
    warnings: list[tuple[Place, str]] = []
    text = _with_declaration_first(_with_plain_ends(_decoded(data, file, warnings)), file, warnings)
    text = _with_plain_comments(text, file, warnings)
    return XmlText(text, tuple(warnings))


def load_encodings() -> None:
    """Have Python load all :data:`ENCODINGS`, for a process that later may load nothing."""
    for name in ENCODINGS:
        codecs.lookup(name)


def _decoded(data: bytes, file: str, warnings: list[tuple[Place, str]]) -> str:
    mark = next((mark for mark in _MARKS if data.startswith(mark)), b"")
    wide = _WIDE.match(data)
    by_bytes = _MARKS.get(mark) or (wide.lastgroup if wide else None) or ""
    data = data.removeprefix(mark)
    head = data[: 2 * _HEAD].decode(by_bytes if by_bytes.startswith("utf_16") else "latin-1", "replace")
    head = _with_plain_ends(head)[:_HEAD]
    declaration = _DECLARATION.match(head)
    stated = declaration and declaration[2] and _ENCODING.search(declaration[2])
    if not stated:
        return _decode(data, by_bytes or "utf_8", "", file)
    assert declaration is not None
    name, where = stated[1], _place(head, declaration.start(2) + stated.start(1), file)
    codec = normalize_encoding(name).lower()
    codec = codec if codec in ENCODINGS else aliases.get(codec, "")
    if codec not in ENCODINGS:
        raise InputError(
            "the encoding that the file declares is not read",
            where=where,
            found=shown(name),
            expected="UTF-8, UTF-16, ISO-8859-1, windows-1252 or another usual one",
            remedy=_SAVE,
        )
    if by_bytes == "utf_8" and codec != "utf_8":
        words = f"the file declares {shown(name)} and begins with the byte order mark of UTF-8: read as UTF-8"
        warnings.append((where, words))
        return _decode(data, by_bytes, "", file)
    if by_bytes.startswith("utf_16") != codec.startswith("utf_16") or (
        by_bytes and codec not in (by_bytes, "utf_16", "utf_8")
    ):
        raise InputError(
            "the file is not in the encoding that it declares",
            where=where,
            found=f"{shown(name)}, and text in {'UTF-16' if by_bytes else 'characters of one byte'}",
            remedy="correct the declaration, or save the file as UTF-8",
        )
    if codec == "utf_16" and not mark:
        warnings.append((where, "a file in UTF-16 has no byte order mark, which is not XML by the letter"))
    return _decode(data, by_bytes or codec, name, file)


def _decode(data: bytes, codec: str, declared: str, file: str) -> str:
    """The text of ``data``, which the file declares to be ``declared``."""
    try:
        return data.decode(codec)
    except UnicodeDecodeError as error:
        before = _with_plain_ends(data[: error.start].decode(codec, "replace"))
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


def _with_plain_ends(text: str) -> str:
    """``text`` with lines that end in ``\\n``."""
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _place(text: str, offset: int, file: str) -> Place:
    return Place(file, text.count("\n", 0, offset) + 1, offset - text.rfind("\n", 0, offset))


def _with_declaration_first(text: str, file: str, warnings: list[tuple[Place, str]]) -> str:
    """``text`` with blanks in place of a declaration that is not at its beginning."""
    match = _DECLARATION.match(text)
    if match is None or not match[1] or not (match[2] or "\ufeff" in match[1]):
        return text
    start = match.start(2) if match[2] else text.index("\ufeff")
    words = "a byte order mark that is not at the beginning is not XML by the letter"
    if match[2]:
        words = "something stands before <?xml, which is not XML by the letter: other readers refuse the file"
    warnings.append((_place(text, start, file), words))
    return re.sub(r"[^\n]", " ", match[0]) + text[match.end() :]


def _with_plain_comments(text: str, file: str, warnings: list[tuple[Place, str]]) -> str:
    """``text`` with ``=`` in place of the hyphens in comments that have two in a row, or one at the end."""
    parts, wrong, end, position = [], [], 0, 0
    while opening := _OPENING.search(text, position):
        begin = opening.end()
        close = text.find(_CLOSING[opening[0]], begin)
        if close < 0:
            break  # expat says where
        position = close + 3 if opening[0] != "<?" else close + 2
        comment = text[begin:close]
        if opening[0] == "<!--" and ("--" in comment or comment.endswith("-")):
            hyphens = comment.find("--")
            wrong.append(begin + (hyphens if hyphens >= 0 else len(comment) - 1))
            parts += [text[end:begin], comment.replace("-", "=")]
            end = close
    if not wrong:
        return text
    others = f", here and in {len(wrong) - 1} more" if len(wrong) > 1 else ""
    words = f"hyphens in a row in a comment{others} are not XML by the letter: other readers refuse the file"
    warnings.append((_place(text, wrong[0], file), words))
    return "".join((*parts, text[end:]))
