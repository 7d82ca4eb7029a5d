"""Whether ``robodyn diagnose`` says of real logs what is known of them from elsewhere.

    python -m benchmarks.gap.known [RUN...] [--out DIR] [--render]

Each run is one command on whole logs as a user would type it; what it must say, and must not, is in
``examples/real/README.md``. Written to results/known.json and known.md. How large friction is, is read off
the amended model's kernel, whatever laws it has got.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.gap.tables import known_table
from benchmarks.gap.tools import CLAIM, measured

import robodyn
from robodyn.robot import load

RESULTS = Path(__file__).parents[1] / "results"
REAL = Path(__file__).parents[2] / "examples" / "real"
TX40 = REAL.parent / "tx40"
#: Kinds of names that an arm may get.
MOST_KINDS = 8
#: A claimed number's standard error, as a share of it, may not be larger.
MOST_ERROR = 0.5
#: Speed [rad/s] at which friction is read off, and at its double.
_SPEED = 0.05


@dataclass(frozen=True, slots=True)
class Answer:
    """What a run said: ``diagnosis.json`` and the folder where the amended model is."""

    diagnosis: Mapping[str, Any]
    folder: Path

    @property
    def claims(self) -> list[Mapping[str, Any]]:
        """Findings that are claims."""
        return [f for f in self.diagnosis["findings"] if f["confidence"] >= CLAIM]

    def of(self, *effects: str) -> list[Mapping[str, Any]]:
        """Claims of one of the effects."""
        return [f for f in self.claims if f["effect"] in effects]


@dataclass(frozen=True, slots=True)
class Fact:
    """Something known, in words; ``judge`` says what was said, and whether it agrees."""

    words: str
    judge: Callable[[Answer], tuple[str, bool]]


@dataclass(frozen=True, slots=True)
class Run:
    """A command: the description, its logs (``A+B``: B has the links' encoders), the facts."""

    robot: Path
    logs: tuple[str, ...]
    facts: tuple[Fact, ...]


def kinds(answer: Answer) -> tuple[str, bool]:
    """How many kinds of names there are."""
    names = {f["effect"] for f in answer.claims}
    return ", ".join(sorted(names)) or "none", len(names) <= MOST_KINDS


def certain(answer: Answer) -> tuple[str, bool]:
    """Claims with a number that is hardly known."""
    vague = [
        f"{f['effect']}@{f['joint'] or 'all'} {name}"
        for f in answer.claims
        for name, p in f["parameters"].items()
        if isinstance(p["value"], (int, float)) and p["stderr"] and p["stderr"] > MOST_ERROR * abs(p["value"])
    ]
    return ", ".join(vague) or "none", not vague


def claimed(joint: int | None, *effects: str) -> Callable[[Answer], tuple[str, bool]]:
    """One of the effects is claimed, at that joint where one is stated."""

    def judge(answer: Answer) -> tuple[str, bool]:
        there = [f for f in answer.of(*effects) if joint is None or f["joint"] == joint]
        return ", ".join(f"{f['effect']}@{f['joint'] or 'all'}" for f in there) or "not claimed", bool(there)

    return judge


def silent(*effects: str) -> Callable[[Answer], tuple[str, bool]]:
    """None of the effects is claimed."""

    def judge(answer: Answer) -> tuple[str, bool]:
        there = answer.of(*effects)
        return ", ".join(f"{f['effect']}@{f['joint'] or 'all'}" for f in there) or "not claimed", not there

    return judge


def flagged(*words: str) -> Callable[[Answer], tuple[str, bool]]:
    """A flag of the data check has one of the words."""

    def judge(answer: Answer) -> tuple[str, bool]:
        there = [flag for flag in answer.diagnosis["flags"] if any(word in flag for word in words)]
        return (there[0] if there else "no flag"), bool(there)

    return judge


def mass(wanted: float) -> Callable[[Answer], tuple[str, bool]]:
    """A payload of that mass [kg], to 10 %."""

    def judge(answer: Answer) -> tuple[str, bool]:
        masses = [f["parameters"]["mass"]["value"] for f in answer.of("payload")]
        text = ", ".join(f"{x:.4g} kg" for x in masses) or "no payload"
        return text, len(masses) == 1 and abs(masses[0] / wanted - 1) <= 0.1

    return judge


def stiffness(wanted: Mapping[int, float], *, needed: bool) -> Callable[[Answer], tuple[str, bool]]:
    """Stiffness [N m/rad] of joints, to 25 %; where it is not ``needed``, at least no other."""

    def judge(answer: Answer) -> tuple[str, bool]:
        springs = {f["joint"]: f["parameters"]["stiffness"]["value"] for f in answer.of("joint_elasticity")}
        near = [j for j, k in wanted.items() if j in springs and abs(springs[j] / k - 1) <= 0.25]
        text = ", ".join(f"{j}: {k / 1e6:.3g} MN m/rad" for j, k in sorted(springs.items())) or "not claimed"
        return text, len(near) == (len(wanted) if needed else len(set(springs) & set(wanted)))

    return judge


def jumps(wanted: Mapping[int, float], share: float | None) -> Callable[[Answer], tuple[str, bool]]:
    """Half the jump of torque [N m] at zero velocity, to a share of what is published; None: it is there at
    all, with a fifth of it at least."""

    def judge(answer: Answer) -> tuple[str, bool]:
        levels = half_jumps(answer.folder / "model.yaml")
        text = ", ".join(f"{j}: {levels[j - 1]:.3g}" for j in wanted)
        if share is None:
            return text, all(levels[j - 1] >= 0.2 * level for j, level in wanted.items())
        return text, all(abs(levels[j - 1] / level - 1) <= share for j, level in wanted.items())

    return judge


def half_jumps(model: Path) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Half the jump of each joint's torque [n] at zero velocity, from slow motion of that joint alone."""
    robot = load(str(model), warn=lambda _: None)
    kernel = robodyn.compile(robot, functions=["inverse_dynamics"], optimize="fast", mode="abi")
    more: dict[str, Any] = {"dt": 1e-3} if kernel.signatures["inverse_dynamics"].states else {}
    n, levels = robot.n, []
    for j in range(n):
        odd = []
        for speed in (_SPEED, 2 * _SPEED):
            pair = []
            for way in (1, -1):
                # Far enough for bristles to slide.
                qd = np.zeros((2000, n))
                qd[:, j] = way * speed
                q = np.cumsum(qd, axis=0) * 1e-3
                pair.append(kernel.inverse_dynamics(q, qd, np.zeros_like(q), **more)[-1, j])
            odd.append((pair[0] - pair[1]) / 2)
        levels.append(2 * odd[0] - odd[1])
    return np.array(levels)


_KR300 = {1: 3.9e6, 2: 5.3e6, 3: 4.4e6}
_ABC = tuple(f"kr300_{x}.csv" for x in "ABC")
_COMMON = (
    Fact(f"at most {MOST_KINDS} kinds of names", kinds),
    Fact("no claimed number with a standard error above half of it", certain),
)
RUNS: dict[str, Run] = {
    "kr300": Run(
        REAL / "kr300" / "kr300.yaml", _ABC,
        (
            Fact("gas spring at joint 2", claimed(2, "gas_spring", "spring")),
            Fact("no motor drives a second joint", silent("motor_coupling")),
            Fact("no stiffness that the link encoders contradict", stiffness(_KR300, needed=False)),
            *_COMMON,
        ),
    ),
    "kr300, link encoders": Run(
        REAL / "kr300" / "kr300.yaml", tuple(f"kr300_{x}.csv+kr300_{x}_secondary.csv" for x in "ABC"),
        (Fact("stiffness 3.9, 5.3, 4.4 MN m/rad at joints 1 to 3", stiffness(_KR300, needed=True)),),
    ),
    "kr300, no payload in the model": Run(
        REAL / "kr300" / "kr300_bare.yaml", _ABC, (Fact("payload of 150 kg", mass(150.0)),)
    ),
    "ur10_bag": Run(
        REAL / "ur10_bag" / "ur10_bag.yaml", ("ur10_bag.csv",),
        (
            Fact(
                "half jumps 13.9, 17.2, 9.4, 2.6, 2.8, 3.5 N m, to 30 %",
                jumps(dict(enumerate((13.9, 17.2, 9.4, 2.6, 2.8, 3.5), 1)), 0.3),
            ),
            Fact("signals were smoothed", flagged("smooth")),
            *_COMMON,
        ),
    ),
    "panda_bag": Run(
        REAL / "panda_bag" / "panda_bag.yaml", ("panda_bag.csv",),
        (
            Fact(
                "friction at joints 1, 5, 6, 7 though torque is the link's",
                jumps({1: 0.27, 5: 0.42, 6: 0.15, 7: 0.28}, None),
            ),
            Fact("no payload", silent("payload")),
            *_COMMON,
        ),
    ),
    "panda_bag, as recorded": Run(
        REAL / "panda_bag" / "panda_bag.yaml", ("panda_bag_as_recorded.csv",),
        (Fact("14 rows repeat the row before", flagged("same as the row before", "repeat")),),
    ),
    "servo": Run(
        REAL / "servo" / "xl330.yaml",
        tuple(sorted(path.name for path in (REAL / "servo").glob("xl330_kp*[!d].csv"))),
        (Fact("a loss by load", claimed(1, "load_dependent_friction", "transmission_loss")), *_COMMON),
    ),
    "servo, its own speed": Run(
        REAL / "servo" / "xl330.yaml", ("xl330_kp400_sin_sin_late_speed.csv",),
        (Fact("the speed reading is late by 20 ms", flagged("late", "lag")),),
    ),
    "tx40": Run(
        TX40 / "tx40.yaml", ("tx40.csv",),
        (Fact("the wrist motor drives joints 5 and 6", claimed(None, "motor_coupling")), *_COMMON),
    ),
}  # fmt: skip


def carried_out(run: Run) -> dict[str, Any]:
    """What is known beside what a run says, its CPU time [s] and memory [MB]."""
    at = run.robot.parent
    logs = ["+".join(str(at / name) for name in log.split("+")) for log in run.logs]
    with tempfile.TemporaryDirectory() as folder:
        words = [
            sys.executable,
            "-m",
            "robodyn",
            "diagnose",
            str(run.robot),
            *logs,
            "-o",
            folder,
            "--no-kernels",
        ]
        try:
            cpu, memory = measured(words)
        except RuntimeError as error:
            return {
                "error": str(error),
                "facts": [[fact.words, "the run failed", False] for fact in run.facts],
            }
        answer = Answer(
            json.loads((Path(folder) / "diagnosis.json").read_text(encoding="utf-8")), Path(folder)
        )
        facts = [[fact.words, *fact.judge(answer)] for fact in run.facts]
    claims = [[f["effect"], f["joint"]] for f in answer.claims]
    return {
        "facts": facts,
        "verdict": answer.diagnosis["verdict"],
        "claims": claims,
        "cpu": round(cpu, 1),
        "memory": round(memory),
    }


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line."""
    assert __doc__
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("runs", nargs="*", choices=[[], *RUNS], metavar="RUN", help="; ".join(RUNS))
    parser.add_argument("--out", type=Path, default=RESULTS)
    parser.add_argument("--render", action="store_true")
    options = parser.parse_args(arguments)
    file = options.out / "known.json"
    results = json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
    if not options.render:
        for name in options.runs or RUNS:
            results[name] = carried_out(RUNS[name])
            print(name, json.dumps(results[name]), file=sys.stderr, flush=True)
    results = {name: results[name] for name in RUNS if name in results}
    options.out.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(results, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    (options.out / "known.md").write_text(
        f"# What is known of real logs\n\n{known_table(results)}\n", encoding="utf-8"
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
