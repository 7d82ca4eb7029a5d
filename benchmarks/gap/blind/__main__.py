"""Runs blind trials one after the other and adds a line of JSON for each to a file; what is there is kept.

    python -m benchmarks.gap.blind KIND... -o results.jsonl [--arms a,b] [--effects a,b] [--seeds 1:3]
                                   [--most N] [--cache D] [--named]
    python -m benchmarks.gap.blind KIND... --write FOLDER [--arms a,b] [--seeds 1:3] ...
    python -m benchmarks.gap.blind --read FOLDER PROGRAM -o results.jsonl
    python -m benchmarks.gap.blind --summary results.jsonl
    python -m benchmarks.gap.blind --diagram results.jsonl -o reliability.svg
    python -m benchmarks.gap.blind --publish results.jsonl

Each seed has an arm of its own, unless ``--arms`` names some. ``--write`` leaves the trials as files for
another program (FOLDER/TRIAL/{robot.yaml,train.csv,validate.csv}, and answer.json); ``--read`` grades what it
wrote into FOLDER/TRIAL/PROGRAM/diagnosis.json. ``--diagram`` draws how right names are that are said to be so
sure.

A run can be stopped at any time and begun again. With a cache, logs are made once and used for every version
of the tool. The kinds are those of :mod:`benchmarks.gap.blind.trials`. ``--named`` asks for the numbers of
what is hidden and not for its name, at a fraction of the time: for the coverage of intervals, of which
``--summary`` has a table for each kind. In ``exact`` and ``uncertain`` the description is as right as it
says.
"""

from __future__ import annotations

import argparse
import json
import pickle
import random
import sys
import time
import warnings
from collections.abc import Sequence
from dataclasses import fields
from pathlib import Path
from typing import Any

from benchmarks.blind_arms.logs import Hidden
from benchmarks.gap.blind.diagram import diagram
from benchmarks.gap.blind.files import answer, graded_rows, write
from benchmarks.gap.blind.grade import graded
from benchmarks.gap.blind.identification import RUNS
from benchmarks.gap.blind.published import published, renewed
from benchmarks.gap.blind.summary import reliability, summary
from benchmarks.gap.blind.trials import ALL_ARMS, KINDS, Trial, trials

from robodyn.diagnose.run import diagnose
from robodyn.logs.log import Log
from robodyn.robot.model import EffectEntry, Joint, Link, Robot

RESULTS = Path(__file__).parents[2] / "results" / "blind.json"


def logs_of(trial: Trial, cache: Path | None) -> Hidden:
    """The trial's logs, from the cache where they are in it."""
    if cache is None:
        return trial.make()
    path = cache / f"{trial.key.replace(':', '_')}.pickle"
    shape = [[field.name for field in fields(of)] for of in (Log, Robot, Link, Joint, EffectEntry)]
    if path.is_file():
        try:
            classes, hidden = pickle.loads(path.read_bytes())
            if classes == shape:
                return hidden  # type: ignore[no-any-return]
        except (AttributeError, ImportError, TypeError, ValueError):
            pass  # written by a version with other classes
    hidden = trial.make()
    cache.mkdir(parents=True, exist_ok=True)
    path.write_bytes(pickle.dumps((shape, hidden)))
    return hidden


def _key(trial: Trial, is_named: bool) -> str:
    return f"{trial.key}:named" if is_named else trial.key


def run(trial: Trial, cache: Path | None, *, is_named: bool = False) -> dict[str, Any]:
    """One line of the results; ``is_named``: nothing but what is hidden is looked for."""
    names = {"journal": "load_dependent_friction"}
    only = tuple(names.get(id, id) for id in (trial.effect, trial.beside) if id and is_named)
    kind = f"{trial.kind}, named" if is_named else trial.kind  # no trial of names
    row: dict[str, Any] = {"key": _key(trial, is_named), "kind": kind, "arm": trial.arm, "seed": trial.seed}
    hidden = logs_of(trial, cache)
    start = time.process_time()

    def make(other: Trial) -> Hidden:
        nonlocal start
        before = time.process_time()
        logs = hidden if other == trial else logs_of(other, cache)
        start += time.process_time() - before
        return logs

    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            if trial.kind in RUNS:
                row |= RUNS[trial.kind](trial, make, only)
            else:
                diagnosis = diagnose(hidden.given, [hidden.train], hidden.validate, only=only)
                row |= graded(answer(hidden), diagnosis.to_dict())
        except Exception as error:
            row |= {"status": "error", "error": f"{type(error).__name__}: {error}"}
    row["cpu"] = round(time.process_time() - start, 2)
    row["warnings"] = sorted({f"{w.category.__name__}: {w.message}" for w in caught})
    return row


def lines_of(file: Path) -> list[dict[str, Any]]:
    """The rows of a file of results."""
    return [json.loads(line) for line in file.read_text(encoding="utf-8").splitlines()]


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line."""
    assert __doc__
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("kinds", nargs="*", choices=[[], *KINDS], metavar="KIND", help=", ".join(KINDS))
    parser.add_argument("-o", "--output", type=Path)
    parser.add_argument("--arms", default=",".join(ALL_ARMS))
    parser.add_argument("--effects", help="ids of what is hidden; all that the kinds have if left out")
    parser.add_argument("--seeds", default="1:2", help="FIRST:END")
    parser.add_argument("--most", type=int, help="at most so many trials, drawn from all asked for")
    parser.add_argument("--cache", type=Path)
    parser.add_argument("--named", action="store_true", help="look for nothing but what is hidden")
    parser.add_argument("--write", type=Path, metavar="FOLDER", help="write the trials as files")
    parser.add_argument("--read", nargs=2, metavar=("FOLDER", "PROGRAM"), help="grade a program's answers")
    parser.add_argument("--summary", type=Path)
    parser.add_argument("--diagram", type=Path)
    parser.add_argument(
        "--publish", type=Path, help="write these rows' figures to results/blind.json and reliability.svg"
    )
    options = parser.parse_args(arguments)
    if options.summary:
        print(summary(lines_of(options.summary)))
        return 0
    if options.publish:
        rows = lines_of(options.publish)
        before = json.loads(RESULTS.read_text(encoding="utf-8")) if RESULTS.is_file() else {}
        figures = renewed(before, published(rows))
        RESULTS.write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")
        if figures["reliability"]:
            picture = RESULTS.with_name("reliability.svg")
            picture.write_text(diagram(figures["reliability"]), encoding="utf-8")
        return 0
    if not (options.output or options.write):
        parser.error("-o is missing")
    if options.diagram:
        options.output.write_text(diagram(reliability(lines_of(options.diagram))), encoding="utf-8")
        return 0
    if options.read:
        read = graded_rows(Path(options.read[0]), options.read[1])
        options.output.write_text("".join(json.dumps(row) + "\n" for row in read), encoding="utf-8")
        return 0
    first, end = map(int, options.seeds.split(":"))
    selected = [
        t for kind in options.kinds for t in trials(kind, tuple(options.arms.split(",")), range(first, end))
    ]
    if options.effects:
        selected = [t for t in selected if t.effect in options.effects.split(",")]
    random.Random(1).shuffle(selected)  # any first part is of all kinds and arms, and part of any longer one
    if options.write:
        for trial in selected[: options.most]:
            write(trial, options.write)
            print(trial.key, file=sys.stderr, flush=True)
        return 0
    done = set()
    if options.output.is_file():
        done = {row["key"] for row in lines_of(options.output)}
    for k, trial in enumerate(selected[: options.most]):
        if _key(trial, options.named) in done:
            continue
        row = run(trial, options.cache, is_named=options.named)
        with options.output.open("a") as file:
            file.write(json.dumps(row) + "\n")
        print(
            f"{k + 1}/{len(selected[: options.most])} {trial.key}: {row['status']}",
            file=sys.stderr,
            flush=True,
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())
