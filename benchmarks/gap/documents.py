"""Puts the tables of the results where the documents have marks for them.

python -m benchmarks.gap.documents
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from benchmarks.gap.tables import known_table, table
from benchmarks.marked import with_part

ROOT = Path(__file__).parents[2]
RESULTS = ROOT / "benchmarks" / "results"


def tables() -> list[tuple[str, str, str, Callable[[Mapping[str, Any]], str]]]:
    """Document, mark, results, and the function that makes the table."""
    from benchmarks.gap.blind.published import intervals_table, names_table

    return [
        ("docs/real-arms.md", "gap", "gap.json", table),
        ("docs/real-arms.md", "known", "known.json", known_table),
        ("docs/diagnose.md", "blind", "blind.json", names_table),
        ("docs/diagnose.md", "intervals", "blind.json", intervals_table),
    ]


def main() -> int:
    """Writes all tables whose results are there."""
    for document, mark, results, rendered in tables():
        path = ROOT / document
        text = path.read_text(encoding="utf-8")
        if not (RESULTS / results).is_file():
            print(f"{document}: no {results}", file=sys.stderr)
            continue
        figures = json.loads((RESULTS / results).read_text(encoding="utf-8"))
        path.write_text(with_part(text, mark, rendered(figures)), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
