"""Numbers that bound what is read of a fleet's files."""

from __future__ import annotations

from typing import Final

LARGEST_FILE: Final = 4 << 20
"""[bytes] A fleet.toml with more is refused: thousands of types need less."""

LARGEST_MANIFEST: Final = 256 << 20
"""[bytes] A manifest with more is refused: a million logs need less."""

MOST_LOGS: Final = 1_000_000
"""[logs] A fleet with more is refused."""

MOST_ENTRIES: Final = 5_000_000
"""[files and folders] A pattern that goes through more is refused: it was meant for another folder."""

DEEPEST: Final = 40
"""[folders in each other] ``**`` goes no deeper: links that lead round in circles end as well."""

MOST_FIELDS: Final = 4
"""[fields of any text, and stars, in a part of a path] With more, a name fits a pattern in too many ways."""

LONGEST_NAME: Final = 200
"""[characters] A type, a unit or a condition with a longer name is refused: a slip of a pattern."""

LONGEST_FORMAT: Final = 100
"""[characters] The longest format of dates."""

MOST_CONDITIONS: Final = 64
"""[conditions] A log with more is refused: its columns are no conditions."""

LISTED: Final = 3
"""[names] Of many files with the same fault so many are named."""
