"""Who looks after a package: a name and an address that every format's manifest takes as they are."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass
from typing import Final

from robodyn.errors import InputError

#: Beside letters, digits and their marks. Quotes, backslashes, commas, ``@`` and ``$`` end a text, list a
#: second person or name a variable in one manifest or another (TOML, METADATA, Arduino's, pkg-config's).
_IN_NAMES: Final = " .'\u2019&+-_"
#: What ROS takes (catkin_pkg, whose schema is the strictest), and the other formats as well.
_EMAIL: Final = re.compile(r"[\w%+-]+(\.[\w%+-]+)*@[A-Za-z0-9-]+(\.[A-Za-z0-9-]+)*\.[A-Za-z]{2,}", re.ASCII)
#: The longest address that mail has (RFC 5321), and as much for a name [characters].
_LONGEST: Final = 254
_EXAMPLE: Final = "Ada Lovelace <ada@example.org>"


@dataclass(frozen=True, slots=True)
class Maintainer:
    """A person, a team or a company, and their address."""

    name: str
    email: str

    def __str__(self) -> str:
        return f"{self.name} <{self.email}>"


#: For formats that require one, where none is stated. No mail ever goes to ``.invalid`` (RFC 2606).
NOT_STATED: Final = Maintainer("not stated", "not-stated@example.invalid")


def read_maintainer(text: str) -> Maintainer:
    """The maintainer that ``text`` states as ``NAME <EMAIL>``.

    Raises
    ------
    InputError: it has another form, or a name or an address that not every format takes.
    """
    match = re.fullmatch(r"\s*([^<>]*?)\s*<([^<>]*)>\s*", text)
    if match is None:
        raise InputError(
            "this is no maintainer of a package",
            found=repr(text[:_LONGEST]),
            expected=f"a name and an address, such as {_EXAMPLE!r}",
        )
    name, email = " ".join(match[1].split()), match[2]
    other = sorted({c for c in name if c not in _IN_NAMES and unicodedata.category(c)[0] not in "LMN"})
    if other or not re.search(r"[^\W\d_]", name) or len(name) > _LONGEST:
        raise InputError(
            "not every manifest takes this name of a maintainer",
            found=" ".join(map(ascii, other)) or repr(name[:_LONGEST]),
            expected=f"letters, digits, spaces and any of {_IN_NAMES.strip()}, such as {_EXAMPLE!r}",
        )
    if not _EMAIL.fullmatch(email) or len(email) > _LONGEST:
        raise InputError(
            "this is no address of a maintainer",
            found=repr(email[:_LONGEST]),
            expected=f"one such as in {_EXAMPLE!r}",
        )
    return Maintainer(name, email)
