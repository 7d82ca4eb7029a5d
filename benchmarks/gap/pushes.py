"""Pushes that MuJoCo simulates: how many are found in time and with their force, and what is falsely found.

    python -m benchmarks.gap.pushes -o pushes.jsonl [--kinds rest,full] [--arms a,b] [--seeds 1:4] [--cache D]
    python -m benchmarks.gap.pushes --summary pushes.jsonl

Masses, centres and inertias of the model are 30 % off, and it knows no friction. The kinds: ``rest`` (the arm
stands, its friction creeps), ``stuck`` (it stands, and dry friction holds), ``full`` (it moves), ``stops``
(just after a motion), ``calm`` (it moves, nobody pushes), ``effects`` (nobody pushes, and an effect is
hidden, of the catalogue or of none). Pushes are of a random link, place, direction, size, rise and length.
Only the search for contacts is run, unless ``--whole`` asks for the whole diagnosis.
"""

from __future__ import annotations

import argparse
import json
import pickle
import sys
import time
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.blind_arms.arms import ARMS, FURTHER_ARMS, LATER_ARMS, misjudged
from benchmarks.blind_arms.pushed import Push, Pushed, pushed_log
from benchmarks.gap.blind.trials import trials

from peers.numbers import Array
from robodyn.diagnose.run import diagnose
from robodyn.gate.gate import inspect
from robodyn.identify.contact.contact import Contact, contacts
from robodyn.logs.log import Log
from robodyn.robot.model import Joint, Link, Robot

KNOWN_ARMS = (*ARMS, *FURTHER_ARMS)
ALL_ARMS = (*KNOWN_ARMS, *LATER_ARMS)
KINDS = ("rest", "stuck", "full", "stops", "calm")
#: Kinds of blind trials (:mod:`benchmarks.gap.blind.trials`) in which nobody pushes.
UNTOUCHED = ("clear", "outside")
#: A push is found by a window that overlaps it by as much of what both cover.
OVERLAP = 0.5
#: Directions of which the joints feel less than this share of the best one are not asked for.
SHOWN = 0.15
#: A direction is claimed if the cone that holds the true one with 95 % is no wider [degrees].
CONE = 30.0
PUSHES = 3
INERTIA_ERROR = 0.3


def pushed_by(arm: str, kind: str, seed: int, cache: Path | None = None) -> Pushed:
    """The log of an arm, from the cache where it is in it."""
    path = cache / f"{arm}_{kind}_{seed}.pickle" if cache else None
    # What another version wrote may have other fields.
    shape = [[field.name for field in fields(of)] for of in (Pushed, Push, Log, Robot, Link, Joint)]
    if path and path.is_file():
        try:
            classes, saved = pickle.loads(path.read_bytes())
            if classes == shape:
                return saved  # type: ignore[no-any-return]
        except (AttributeError, ImportError, TypeError, ValueError):
            pass
    pushed = pushed_log(
        arm, {"stuck": "rest", "calm": "full"}.get(kind, kind), 1000 + seed,  # type: ignore[arg-type]
        pushes=0 if kind == "calm" else PUSHES, varied=True, sticks=kind == "stuck",
    )  # fmt: skip
    if path:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(pickle.dumps((shape, pushed)))
    return pushed


def overlap(push: Push, contact: Contact) -> float:
    """Of the time that a push and a window cover together, the share that both cover."""
    both = min(push.end, contact.end) - max(push.start, contact.start)
    return max(both, 0.0) / (max(push.end, contact.end) - min(push.start, contact.start))


def untouched(arm: str, seed: int) -> Iterator[tuple[str, Pushed]]:
    """Logs of an arm with each effect in turn but pushes, and what is hidden."""
    for kind in UNTOUCHED:
        for trial in trials(kind, (arm,), range(seed, seed + 1)):
            if trial.effect != "external_contact":
                hidden = trial.make()
                robot = misjudged(hidden.given, INERTIA_ERROR, seed)
                yield (
                    f"{trial.effect}@{trial.joint or 'all'}",
                    Pushed(robot, hidden.train, (), hidden.truth.noise),
                )


def graded(pushed: Pushed, windows: Sequence[Contact]) -> dict[str, Any]:
    """Each push beside the window that overlaps it most; how many windows overlap none."""
    rows = []
    for push in pushed.pushes:
        best = max(windows, key=lambda one: overlap(push, one), default=None)
        row: dict[str, Any] = {"start": push.start, "end": push.end, "link": push.link, "overlap": 0.0}
        if best is not None and overlap(push, best) > 0:
            row |= {
                "overlap": overlap(push, best),
                "early": best.start - push.start,
                "late": best.end - push.end,
            }
            row |= {"of": best.link, **force(push, best)}
        rows.append(row)
    beside = [w for w in windows if not any(overlap(push, w) > 0 for push in pushed.pushes)]
    return {"pushes": rows, "false": [[w.start, w.end, w.link] for w in beside]}


def force(push: Push, contact: Contact) -> dict[str, Any]:
    """Angles [degrees] between the force and the one that was found: in all, and as far as joints show it;
    ratio of their sizes; how many standard errors each component is off."""
    _, size, way = np.linalg.svd(push.columns)
    shown = way[: len(size)][size > SHOWN * size.max()]
    mean = push.force * (1 - push.rise / (push.end - push.start))
    off = (contact.force - mean) / np.maximum(contact.stderr, 1e-300)
    return {
        "angle": angle(push.force, contact.force),
        "shown": angle(shown @ push.force, shown @ contact.force),
        "cone": round(contact.cone, 1),
        "ratio": float(np.linalg.norm(contact.force) / np.linalg.norm(mean)),
        "off": off.round(3).tolist(),
    }


def angle(a: Array, b: Array) -> float:
    """Degrees between two vectors."""
    sizes = float(np.linalg.norm(a) * np.linalg.norm(b))
    return float(np.degrees(np.arccos(np.clip(float(a @ b) / sizes, -1, 1)))) if sizes else 90.0


def run(pushed: Pushed, *, whole: bool) -> dict[str, Any]:
    """What is found in a log."""
    start = time.process_time()
    row = graded(pushed, contacts(pushed.given, inspect(pushed.log, pushed.given)))
    row["cpu"] = round(time.process_time() - start, 3)
    if whole:
        result = diagnose(pushed.given, [pushed.log])
        row["names"] = [[f.effect, f.joint, f.confidence] for f in result.findings]
    return row


def rows_of(arm: str, kind: str, seed: int, options: argparse.Namespace) -> Iterator[dict[str, Any]]:
    """The lines of the results of an arm: one, or one for each effect."""
    head = {"arm": arm, "kind": kind, "seed": seed}
    if kind != "effects":
        yield head | run(pushed_by(arm, kind, seed, options.cache), whole=options.whole)
    elif arm in KNOWN_ARMS:
        for hidden, pushed in untouched(arm, seed):
            yield head | {"hidden": hidden} | run(pushed, whole=options.whole)


def summary(rows: Sequence[Mapping[str, Any]]) -> str:
    """A line for each kind: found, in time, directions, signs, standard errors, false windows."""
    kinds: dict[str, list[Mapping[str, Any]]] = defaultdict(list)
    for row in rows:
        kinds[row["kind"]].append(row)
    lines = []
    for kind, each in kinds.items():
        pushes = [push for row in each for push in row["pushes"]]
        hits = [push for push in pushes if push["overlap"] >= OVERLAP]
        false = sum(len(row["false"]) for row in each)
        line = f"{kind}: {len(each)} logs, {len(hits)} of {len(pushes)} pushes found, {false} false windows"
        if hits:
            near = sum(push["shown"] <= 20 for push in hits)
            wrong = sum(push["shown"] > 90 for push in hits)
            late = np.quantile([max(abs(push["early"]), abs(push["late"])) for push in hits], (0.5, 0.9))
            known = [push for push in hits if push["cone"] <= CONE]
            right = sum(push["angle"] <= 20 for push in known)
            turned = sum(push["angle"] > 90 for push in hits if push["cone"] < 90)
            off = np.abs([x for push in hits for x in push["off"]])
            inside, of = np.mean(off <= 1.96), np.mean([push["of"] == push["link"] for push in hits])
            line += (
                f"; {100 * near / len(hits):.0f} % within 20 degrees as far as joints show, {wrong} with the "
                f"wrong sign; of {len(known)} directions that are claimed {right} within 20 degrees; "
                f"{turned} signs claimed and wrong; ends off by {late[0]:.2f} s (median), {late[1]:.2f} s "
                f"(90 %); {100 * inside:.0f} % of components within 95 %; link {100 * of:.0f} %"
            )
        lines.append(f"{line}; {np.median([row['cpu'] for row in each]):.2f} s")
    return "\n".join(lines)


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line."""
    assert __doc__
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("-o", "--output", type=Path)
    parser.add_argument("--kinds", default=",".join(KINDS))
    parser.add_argument("--arms", default=",".join(ALL_ARMS))
    parser.add_argument("--seeds", default="1:3", help="FIRST:END")
    parser.add_argument("--cache", type=Path)
    parser.add_argument("--whole", action="store_true", help="run the whole diagnosis as well")
    parser.add_argument("--summary", type=Path)
    options = parser.parse_args(arguments)
    if options.summary:
        print(summary([json.loads(line) for line in options.summary.read_text().splitlines()]))
        return 0
    if not options.output:
        parser.error("-o is missing")
    first, end = map(int, options.seeds.split(":"))
    done = set()
    if options.output.is_file():
        rows = [json.loads(line) for line in options.output.read_text().splitlines()]
        done = {(row["arm"], row["kind"], row["seed"]) for row in rows}
    for seed in range(first, end):
        for arm in options.arms.split(","):
            for kind in options.kinds.split(","):
                if (arm, kind, seed) in done:
                    continue
                for row in rows_of(arm, kind, seed, options):
                    with options.output.open("a") as file:
                        file.write(json.dumps(row) + "\n")
    print(summary([json.loads(line) for line in options.output.read_text().splitlines()]))
    return 0


if __name__ == "__main__":
    sys.exit(main())
