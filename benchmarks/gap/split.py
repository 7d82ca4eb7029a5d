"""The fitted and the held-out samples of a log as two logs, each with gaps.

    python -m benchmarks.gap.split LOG.csv... -o DIR [--raster S]

writes DIR/LOG_fitted.csv and DIR/LOG_held_out.csv, all columns as they were.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from benchmarks.gap.recordings import blocks


def split(path: Path, folder: Path, raster: float | None = None) -> tuple[Path, Path]:
    """Writes both logs of the one at ``path``; with a ``raster`` [s] samples belong where it puts them."""
    head, *rows = path.read_text(encoding="utf-8").splitlines(keepends=True)
    count = len(rows)
    place = np.arange(count)
    if raster is not None:
        times = head.strip().split(",").index("t")
        t = np.array([float(row.split(",")[times]) for row in rows])
        count = len(np.arange(t[0], t[-1], raster))
        place = np.minimum(((t - t[0]) / raster).astype(int), count - 1)
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for mask, what in zip(blocks(count), ("fitted", "held_out"), strict=True):
        target = folder / f"{path.stem}_{what}{path.suffix}"
        chosen = (row for row, at in zip(rows, place, strict=True) if mask[at])
        target.write_text("".join([head, *chosen]), encoding="utf-8")
        paths.append(target)
    return paths[0], paths[1]


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line."""
    assert __doc__
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("logs", nargs="+", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--raster", type=float, help="even step for logs with jitter [s]")
    options = parser.parse_args(arguments)
    for path in options.logs:
        for written in split(path, options.output, options.raster):
            print(written)
    return 0


if __name__ == "__main__":
    sys.exit(main())
