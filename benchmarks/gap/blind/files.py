"""Blind trials as files, for any program: what it is given, the answer beside it, and what it said."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.blind_arms.logs import Hidden
from benchmarks.gap.blind.grade import graded, truths
from benchmarks.gap.blind.trials import Trial

from robodyn.robot.writer import to_yaml

GIVEN = ("robot.yaml", "train.csv", "validate.csv")
ANSWER = "answer.json"


def answer(hidden: Hidden) -> dict[str, Any]:
    """What is hidden, ready for JSON: ``effects`` with their numbers; RMS [n] of the torques' ``noise`` and
    of the ``gap`` that the given model leaves."""
    truth = hidden.truth
    return {
        "effects": [{"effect": e.effect, "joint": e.joint, "parameters": truths(e)} for e in truth.effects],
        "noise": truth.noise.tolist(),
        "gap": truth.gap.tolist(),
    }


def write(trial: Trial, root: Path) -> None:
    """The trial's files in a folder of its own, the name of which does not say what is hidden, unless they
    are there; the answer last, so that what has one is whole."""
    place = hashlib.sha256(trial.key.encode()).hexdigest()[:8]
    folder = root / f"{trial.kind}_{trial.seed}_{place}"
    if (folder / ANSWER).is_file():
        return
    hidden = trial.make()
    if not all(np.isfinite(log.tau).all() for log in (hidden.train, hidden.validate)):
        raise ValueError(f"{trial.key}: the simulation diverged")
    folder.mkdir(parents=True, exist_ok=True)
    texts = (to_yaml(hidden.given), hidden.train.csv(), hidden.validate.csv())
    for name, text in zip(GIVEN, texts, strict=True):
        (folder / name).write_text(text, encoding="utf-8")
    content = {"key": trial.key, "kind": trial.kind, "arm": trial.arm, "seed": trial.seed, **answer(hidden)}
    (folder / ANSWER).write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")


def graded_rows(folder: Path, program: str) -> Iterator[dict[str, Any]]:
    """A line of the results for each trial of ``folder`` of which ``TRIAL/program/diagnosis.json`` is there;
    ``cpu`` beside it holds the seconds that it took."""
    for path in sorted(folder.glob(f"*/{ANSWER}")):
        said = path.parent / program
        if not (said / "diagnosis.json").is_file():
            continue
        wanted: Mapping[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        diagnosis = json.loads((said / "diagnosis.json").read_text(encoding="utf-8"))
        cpu = float((said / "cpu").read_text()) if (said / "cpu").is_file() else float("nan")
        row = {key: wanted[key] for key in ("key", "kind", "arm", "seed")}
        yield {**row, **graded(wanted, diagnosis), "cpu": cpu, "warnings": []}
