"""Joints that are flipped or exchanged: how many logs are refused with the remedy, and how many sound ones.

    python -m benchmarks.gap.flips [--arms a,b] [--seeds 1:3] [--cache D]

Logs by MuJoCo (``calm`` of :mod:`benchmarks.gap.pushes`): masses, centres and inertias of the model are 30 %
off, and it knows no friction. Of each log every joint's position and torque are flipped, and neighbours
exchanged.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from benchmarks.gap.pushes import ALL_ARMS, pushed_by

from robodyn.errors import InputError
from robodyn.gate.gate import inspect
from robodyn.logs.log import Log
from robodyn.robot.model import Robot


def wrong(log: Log) -> Iterator[tuple[str, str, Log]]:
    """What is wrong, the remedy's words, and the log: each joint flipped, each with the next exchanged."""
    for j in range(log.n):
        sign = np.where(np.arange(log.n) == j, -1.0, 1.0)
        yield "q flipped", f"change the sign of q{j + 1}", replace(log, q=log.q * sign)
        yield "tau flipped", f"change the sign of tau{j + 1}", replace(log, tau=log.tau * sign)
    for j in range(log.n - 1):
        order = list(range(log.n))
        order[j], order[j + 1] = j + 1, j
        both = [f"swap the columns {group}{j + 1}, {group}{j + 2}" for group in ("q", "tau")]
        yield "q exchanged", both[0], replace(log, q=log.q[:, order])
        yield "tau exchanged", both[1], replace(log, tau=log.tau[:, order])


def answer(log: Log, robot: Robot, remedy: str) -> str:
    """``right``: refused with the ``remedy`` first; ``beside``: among others; ``flag``: only told; ``wrong``:
    refused with another; ``missed``."""
    try:
        flags = inspect(log, robot).flags
    except InputError as error:
        text = str(error.remedy)
        return "right" if text.startswith(remedy) else "beside" if remedy in text else "wrong"
    return "flag" if any(flag.kind.startswith("perhaps_") for flag in flags) else "missed"


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line."""
    assert __doc__
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--arms", default=",".join(ALL_ARMS))
    parser.add_argument("--seeds", default="1:2", help="FIRST:END")
    parser.add_argument("--cache", type=Path)
    options = parser.parse_args(arguments)
    first, end = map(int, options.seeds.split(":"))
    counts: dict[str, Counter[str]] = {}
    for seed in range(first, end):
        for arm in options.arms.split(","):
            pushed = pushed_by(arm, "calm", seed, options.cache)
            log = pushed.log
            sound = answer(log, pushed.given, "nothing is wrong")
            counts.setdefault("sound", Counter())[
                "passed" if sound == "missed" else "refused or flagged"
            ] += 1
            for what, remedy, other in wrong(log):
                result = answer(other, pushed.given, remedy)
                counts.setdefault(what, Counter())[result] += 1
                if result != "right":
                    print(f"{arm} {seed}: {what}: {remedy}: {result}", file=sys.stderr, flush=True)
    for what, each in counts.items():
        print(f"{what}: " + ", ".join(f"{name} {count}" for name, count in each.most_common()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
