"""The tables of the benchmarks, made from what the last measurements wrote."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from typing import Any, Final

from benchmarks.batch.__main__ import markdown as batch
from benchmarks.cuda.__main__ import markdown as cuda
from benchmarks.fleet import table as fleet
from benchmarks.functions import tables as functions
from benchmarks.gap import tables as gap
from benchmarks.peers import limits
from benchmarks.peers import tables as peers
from benchmarks.public_files import table as public_files

from robodyn_site.outside import RESULTS, ROOT

_WRITERS: Final[Mapping[str, Callable[[Any], str]]] = {
    "benchmarks/batch.md": batch,
    "benchmarks/cuda.md": cuda,
    "benchmarks/fleet.md": fleet.page,
    "benchmarks/peers.md": peers.markdown,
    "benchmarks/functions.md": functions.markdown,
    "benchmarks/limits.md": limits.markdown,
    "benchmarks/gap.md": gap.markdown,
    "benchmarks/public_files.md": public_files,
}


def pages() -> dict[str, str]:
    """A page for each file of results."""
    return {page: _WRITERS[page](_results(source)) for page, source in RESULTS.items()}


def _results(document: str) -> Any:
    """The figures that a document is made from."""
    return json.loads((ROOT / document).with_suffix(".json").read_text(encoding="utf-8"))
