"""The race of every function: ours, Pinocchio in C++, and the C that CasADi makes of Pinocchio."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.peers.building import NATIVE, STRICT, Lacking, Source, library, version
from benchmarks.peers.candidates import Candidate, Missing, both, pinocchio_headers, pinocchio_traced
from benchmarks.peers.numbers_in_c import text_of
from benchmarks.peers.ours import BUILDS, values_of, written
from benchmarks.peers.race import Race, States, paired, random_states

from robodyn.bench.peers.numbers import Disagreement, hold_against, numbers_of
from robodyn.kernels.generate import Options, generate, program
from robodyn.robot import Robot, load

#: How many times faster than Pinocchio each function is to be.
WANTED = {
    "inverse_dynamics": 18.0,
    "mass_matrix": 15.0,
    "forward_dynamics": 9.0,
    "inverse_dynamics_derivatives": 8.0,
    "forward_dynamics_derivatives": 8.0,
    "jacobian_and_forward_kinematics": 8.0,
}
#: And than the C that CasADi makes of Pinocchio.
WANTED_CASADI = 2.5
#: What Pinocchio calls them, where its own name says more; those that it has in two conventions race in both.
ALGORITHMS = {
    "inverse_dynamics": ("rnea",),
    "mass_matrix": ("crba", "crba, Convention::WORLD"),
    "forward_dynamics": ("aba", "aba, Convention::WORLD"),
    "inverse_dynamics_derivatives": ("computeRNEADerivatives",),
    "forward_dynamics_derivatives": ("computeABADerivatives",),
    "jacobian_and_forward_kinematics": ("computeJointJacobians, getJointJacobian",),
}
_ENDINGS = ("", "_world")
REFERENCE = "robodyn"


def measured(name: str, work: Path, harness: Path, rounds: int) -> Iterator[dict[str, Any]]:
    """The race of each function of the robot ``name``."""
    robot = load(name, warn=lambda _: None)
    states = random_states(robot.n)
    for function in WANTED:
        folder = work / robot.name / function
        folder.mkdir(parents=True, exist_ok=True)
        states.write(folder / "states.bin")
        (folder / "arm.txt").write_text(text_of(numbers_of(robot)), encoding="utf-8")
        print(f"racing {function} of {robot.name}", file=sys.stderr, flush=True)
        yield _race(robot, function, Race(folder, harness), states, rounds)


def _race(robot: Robot, function: str, race: Race, states: States, rounds: int) -> dict[str, Any]:
    plain = program(robot, function, Options((function,), optimize="none"))
    expected = values_of(plain, np.array([states.q, states.qd, states.qdd]))
    racing, worst, missing = [], [], []
    for one in [*_ours(robot, function, race.folder), *_peers(function, race.folder, expected.shape[1])]:
        if isinstance(one, Missing):
            missing.append(one)
            continue
        try:
            worst.append(hold_against(one.title, expected, race.results(one.timed, expected.shape)))
            racing.append(one)
        except Disagreement as error:
            if one.ours:
                raise
            missing.append(Missing(one.key, one.title, f"refused: {error}"))
    times = race.times([one.timed for one in racing], rounds)
    first = [one.key for one in racing].index(REFERENCE)
    rows = [
        {
            "key": one.key,
            "title": one.title,
            "flags": one.flags,
            "ours": one.ours,
            "worst": worst[k],
            "ns": float(np.median(times[:, k])),
            "ratio": paired(times[:, k], times[:, first]).to_list(),
            "instructions": race.instructions(one.counted, len(states.q)) if one.counted else None,
        }
        for k, one in enumerate(racing)
    ]
    return {
        "robot": robot.name,
        "function": function,
        "rounds": rounds,
        "rows": rows,
        "missing": [{"title": one.title, "why": one.why} for one in missing],
        "demands": list(_demands(function, racing, times)),
    }


def _demands(function: str, racing: list[Candidate], times: Any) -> Iterator[dict[str, Any]]:
    """What is asked for, against the fastest of a peer's ways."""
    median = np.median(times, axis=0)
    for peer, wanted in (("pinocchio", WANTED[function]), ("casadi", WANTED_CASADI)):
        theirs = [k for k, one in enumerate(racing) if one.key.startswith(peer)]
        if not theirs:
            continue
        fastest = min(theirs, key=lambda k: float(median[k]))
        for k, one in enumerate(racing):
            if one.ours:
                ratio = paired(times[:, fastest], times[:, k]).to_list()
                yield {"peer": racing[fastest].key, "ours": one.key, "wanted": wanted, "ratio": ratio}


def _ours(robot: Robot, function: str, folder: Path) -> Iterator[Candidate]:
    generated = generate(robot, Options((function,), trig="builtin"))
    files = written(folder / "ours", generated.files(("c",)))
    (interface,) = generated.signatures
    n, results, taken = robot.n, [], 0
    for _, size in interface.outputs:
        results.append(f"results + (k) * SIZE + {taken}")
        taken += size
    place = {"q": "angle", "qd": "qd", "qdd": "qdd", "tau": "qdd"}
    arguments = [f"{place[name]} + (k) * n" for name, _ in interface.inputs]
    assert [size for _, size in interface.inputs] == [n] * len(arguments)
    defines = (
        ("HEADER", f'"{robot.name}.h"'),
        ("REAL", f"{robot.name}_real"),
        ("KERNEL", interface.symbol),
        ("SIZE", str(taken)),
        ("ARGUMENTS(k)", ", ".join(arguments)),
        ("RESULTS(k)", ", ".join(results)),
    )
    source = Source(("robodyn.c", *files), (f"-I{folder / 'ours'}",), defines=defines)
    counted = library(folder / "robodyn-counted.so", source, STRICT)
    for build in ("native", "scheduled"):
        timed = library(folder / f"robodyn-{build}.so", source, BUILDS[build])
        key = REFERENCE + ("" if build == "native" else f"-{build}")
        yield Candidate(key, "robodyn", " ".join(BUILDS[build]), timed, counted, ours=True)


def _peers(function: str, folder: Path, size: int) -> Iterator[Candidate | Missing]:
    for algorithm, ending in zip(ALGORITHMS[function], _ENDINGS, strict=False):
        title = f"Pinocchio, {algorithm}, C++"
        try:
            yield _pinocchio(function + ending, title, folder)
        except Lacking as lacking:
            yield Missing("pinocchio", title, str(lacking))
        title = f"Pinocchio, {algorithm} -> CasADi C, after cse"
        try:
            pinocchio_traced(folder, (function + ending,), folder.parents[1])
            called = f"pinocchio_{function}{ending}_cse"
            defines = (("FUNCTION", called), ("SIZE", str(size)))
            source = Source(("casadi.c", folder / f"{called}.c"), defines=defines)
            yield both(f"casadi{ending}", f"{title} {version('casadi')}", source, folder, STRICT)
        except Lacking as lacking:
            yield Missing("casadi", title, str(lacking))


def _pinocchio(name: str, title: str, folder: Path) -> Candidate:
    """Compiled from its headers, once for all arms."""
    flags = ("-std=c++17", "-DNDEBUG", *pinocchio_headers())
    source = Source(
        ("pinocchio_function.cpp",), flags, defines=(("FUNCTION", name),), packages=("pin", "cmeel-eigen")
    )
    timed = library(folder.parents[1] / f"pinocchio-{name}.so", source, NATIVE)
    return Candidate(f"pinocchio-{name}", title, " ".join(NATIVE), timed, None)
