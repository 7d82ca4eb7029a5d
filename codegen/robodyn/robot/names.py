"""Which words may become names in C, C++, Fortran and Python, and which texts may become comments."""

from __future__ import annotations

import functools
import keyword
import re
import unicodedata
from collections.abc import Iterable
from typing import Any

from robodyn.errors import InputError
from robodyn.resources import data_dir

#: Longest name of a robot. Fortran allows 63 characters, and no function of the default set takes over 17.
ROBOT_NAME_LENGTH = 40
#: Longest name of a run-time parameter: what C99 promises to tell apart.
PARAMETER_NAME_LENGTH = 31
#: Longest free text: a title, a source, the name of a link.
TEXT_LENGTH = 200
_SPELLING = "a letter, then letters, digits or underscores, at most {} characters, no keyword"
ROBOT_NAME_EXPECTED = _SPELLING.format(ROBOT_NAME_LENGTH)
PARAMETER_NAME_EXPECTED = _SPELLING.format(PARAMETER_NAME_LENGTH) + ", no macro of C"

# Words that stand for a number, or for none, in somebody's mind: never the name of one.
_VALUE_WORDS = frozenset("pi nan inf infinity null nil true false yes no on off".split())  # noqa: SIM905
_DEVICES = {"con", "prn", "aux", "nul", *(f"{port}{i}" for port in ("com", "lpt") for i in range(1, 10))}
_IDENTIFIER = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")
# Joiners, which some scripts and emoji need, and the hyphen that shows only where a line ends.
_HARMLESS = frozenset("\u00ad\u200c\u200d")


@functools.cache
def _reserved() -> dict[str, Any]:
    """The lists of ``templates/reserved_names.yaml``: sets of words, and patterns."""
    import yaml  # not at the top: whoever reads no names does not pay for it

    text = (data_dir("templates") / "reserved_names.yaml").read_text(encoding="utf-8")
    lists = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    languages = {"Python": " ".join(keyword.kwlist).lower(), **lists["keywords"]}
    macros = lists["macros"]
    return {
        "keywords": {word: language for language, words in languages.items() for word in words.split()},
        "headers": frozenset(lists["headers"].split()),
        "endings": frozenset(lists["endings"].split()),
        "macros": {  # whose they are: words, and a pattern
            "the C library": (macros["library"].split(), "|".join(macros["families"])),
            "C compilers": (macros["compilers"].split(), ""),
            "the emitted files": ((), macros["emitted"]),
        },
    }


def is_unprintable(c: str) -> bool:
    """Whether the character ``c`` is a control character, ends a line, is half of one, or cannot be seen:
    such as the marks that turn the direction of writing, with which text is not what it looks like."""
    return unicodedata.category(c) in ("Cc", "Cf", "Cs", "Zl", "Zp") and c not in _HARMLESS


def _unprintable(text: str) -> str | None:
    """The first unprintable character of ``text``."""
    return None if text.isascii() and text.isprintable() else next(filter(is_unprintable, text), None)


def shown(text: str, length: int = 40) -> str:
    """``text`` quoted for an error message: shortened, control characters escaped, one line."""
    short = text if len(text) <= length else text[: length - 3] + "..."
    return ascii(short) if _unprintable(short) else f"'{short}'"


def _identifier_fault(name: str, length: int) -> str | None:
    if not _IDENTIFIER.match(name):
        if name.startswith("_"):
            return "begins with an underscore, which Fortran forbids"
        return "is not a name in C and Fortran"
    if len(name) > length:
        return f"has {len(name)} characters, {length} are allowed"
    language = _reserved()["keywords"].get(name.lower())
    return f"is a keyword of {language}" if language else None


def macro_of(name: str) -> str | None:
    """Whose macro ``name`` is, in words for a message; None: it is no macro that is known here."""
    for owner, (words, pattern) in _reserved()["macros"].items():
        if name in words or re.fullmatch(pattern, name):
            return str(owner)
    return None


def robot_name_fault(name: str) -> str | None:
    """What keeps ``name`` from being a robot's name, or None.

    It prefixes every emitted symbol and is the stem of every emitted file.
    """
    fault = _identifier_fault(name, ROBOT_NAME_LENGTH)
    if fault is None and name.lower() in _reserved()["headers"]:
        fault = f"would make a file that hides the C header <{name.lower()}.h>"
    if fault is None and name.lower() in _DEVICES:
        fault = "is the name of a device on Windows"
    return fault


def parameter_name_fault(name: str) -> str | None:
    """What keeps ``name`` from being a run-time parameter's name, or None.

    A parameter is a member of the struct ``NAME_params`` (``p->m_tool``, in Fortran ``p%m_tool``), so
    only keywords and macros can clash, and what :func:`parameter_clash` tells.
    """
    if name.lower() in _VALUE_WORDS:
        return "is not a number, nor free to be a name"
    fault = _identifier_fault(name, PARAMETER_NAME_LENGTH)
    owner = macro_of(name)
    return f"is a macro of {owner}" if fault is None and owner else fault


@functools.lru_cache(maxsize=1 << 16)  # every function of an arm has a t1
def is_reserved(name: str) -> bool:
    """Whether ``name`` may not be that of a variable: it is a keyword, a type or a macro somewhere."""
    return name.lower() in _reserved()["keywords"] or name.endswith("_t") or macro_of(name) is not None


def parameter_clash(name: str, robot: str) -> str | None:
    """What keeps the parameter ``name`` out of a robot of the name ``robot``, or None.

    The emitted files' types, macros and include guards have these names: as a member, ``arm_real arm_real``
    is no C++, and ``ARM_H`` is nothing at all.
    """
    prefix, ending = f"{robot}_".lower(), name.lower()[len(robot) + 1 :]
    clash = name.lower().startswith(prefix) and ending in _reserved()["endings"]
    return "is a name of the emitted files" if clash else None


def text_fault(text: str) -> str | None:
    """What keeps ``text`` from being a title, a source or a link's name, or None.

    Such text is written into comments of the emitted files. ``*/`` and the like may be in it: the
    emitter escapes them.
    """
    if len(text) > TEXT_LENGTH:
        return f"has {len(text)} characters, {TEXT_LENGTH} are allowed"
    return unprintable_fault(text)


def unprintable_fault(text: str) -> str | None:
    """What keeps ``text`` from being a line that may be as long as it will, or None."""
    bad = _unprintable(text)
    return f"contains the control character U+{ord(bad):04X}" if bad else None


def check_robot_name(name: str) -> str:
    """``name`` itself if it may name a robot.

    Raises
    ------
    InputError: it may not.
    """
    fault = robot_name_fault(name)
    if fault:
        raise InputError(
            f"the robot's name {fault}",
            found=shown(name),
            expected=ROBOT_NAME_EXPECTED,
            remedy="choose another name",
        )
    return name


def check_names(robot: str, parameters: Iterable[str]) -> None:
    """Make sure that a robot of the name ``robot`` with these run-time ``parameters`` can be emitted, whoever
    made it: a description was checked when it was read.

    Raises
    ------
    InputError: a name cannot stand in the emitted files.
    """
    check_robot_name(robot)
    for name in parameters:
        fault = parameter_name_fault(name) or parameter_clash(name, robot)
        if fault:
            raise InputError(
                f"the run-time parameter {fault}",
                found=shown(name),
                expected=PARAMETER_NAME_EXPECTED,
                remedy="choose another name",
            )
