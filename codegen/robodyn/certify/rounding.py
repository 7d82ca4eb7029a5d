"""Rounding errors: Gappa's bound of every torque, ours, and the worst error that a search finds."""

from __future__ import annotations

import math
import re
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from robodyn.certify.tools import Done, end_all, last_lines, run
from robodyn.errors import ToolError

#: Gappa's enclosure: ``[low, high]``, each a dyadic number, and decimals in braces for people.
_ENCLOSURE = r"\[(\S+)(?: \{[^}]*\})?, (\S+?)(?: \{[^}]*\})?\]"
_DYADIC = re.compile(r"(-?[0-9]+)(?:b(-?[0-9]+))?\Z")


@dataclass(frozen=True, slots=True)
class Proven:
    """What Gappa says of one script: where the computed value lies, and how far from the exact one at most.

    ``error`` None: no bound, and ``reason`` says why.
    """

    low: float | None
    high: float | None
    error: float | None
    seconds: float
    reason: str = ""


def prove(
    gappa: str,
    folder: Path,
    scripts: Sequence[str],
    *,
    seconds: float,
    workers: int,
    progress: Callable[[int], None],
) -> list[Proven]:
    """Run Gappa on ``scripts`` (files in ``folder``), ``workers`` at a time, ``seconds`` each at most;
    ``progress`` is told how many are done."""
    proven: dict[str, Proven] = {}
    with ThreadPoolExecutor(workers) as pool:
        jobs = {pool.submit(run, [gappa, name], folder, seconds): name for name in scripts}
        try:
            for job in as_completed(jobs):
                proven[jobs[job]] = read(job.result(), seconds)
                progress(len(proven))
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            while not all(job.done() for job in jobs):  # one may just be starting
                end_all()
                time.sleep(0.02)
            raise
    return [proven[name] for name in scripts]


def read(done: Done, seconds: float) -> Proven:
    """Gappa's answer, read."""
    if done.code is None:
        return Proven(None, None, None, done.seconds, f"not finished after {seconds:g} s")
    value = re.search(rf"^\s*result in {_ENCLOSURE}", done.output, re.M)
    error = re.search(rf"^\s*result - E_result in {_ENCLOSURE}", done.output, re.M)
    # What is exact is told as a single number.
    none = re.search(r"^\s*result - E_result in \[0, 0\]", done.output, re.M)
    if done.code != 0 or value is None or (error is None and none is None):
        return Proven(None, None, None, done.seconds, f"no bound found: {last_lines(done.output)}")
    low, high = (_number(text) for text in value.groups())
    sizes = [abs(_number(text)) for text in error.groups()] if error else [Fraction(0)]
    return Proven(_outward(low, -1), _outward(high, 1), _outward(max(sizes), 1), done.seconds)


def _number(text: str) -> Fraction:
    match = _DYADIC.match(text)
    if match is None:
        raise ToolError("Gappa's answer cannot be read", found=text, expected="a number such as 12b-3")
    return Fraction(match[1]) * Fraction(2) ** int(match[2] or 0)


def _outward(value: Fraction, side: int) -> float:
    near = float(value)
    if (Fraction(near) < value) if side > 0 else (Fraction(near) > value):
        return math.nextafter(near, side * math.inf)
    return near
