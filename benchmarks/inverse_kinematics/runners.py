"""Who solves and races: our kernel, EAIK's C++ and ssik's native backend, each as a library of the harness.

The states that the harness hands over are poses and positions (``native/inverse.hpp``); :func:`answers` reads
what a runner gives back.
"""

from __future__ import annotations

import subprocess
import sys
import tarfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.inverse_kinematics.chain import Chain, Floats
from benchmarks.inverse_kinematics.sets import Answers
from benchmarks.peers.building import AVX2, NATIVE, STRICT, Lacking, Source, library, package_folder, version
from benchmarks.peers.candidates import Candidate, Missing
from benchmarks.peers.ours import written
from benchmarks.peers.race import Race, States

from robodyn.dynamics.arm import build_arm
from robodyn.dynamics.inverse import inverse_of
from robodyn.kernels.generate import Options, generate
from robodyn.robot import Robot

FUNCTION = "inverse_kinematics"
#: Numbers of a state: a pose's.
TWELVE = 12
#: Most solutions of a pose that a runner hands out: of six joints there are 16 at most. ssik's sweep gives
#: those at many positions of a redundant joint.
SLOTS, SLOTS_REDUNDANT = 16, 1024
EAIK = "1.2.2"
#: By ssik's families: the header, the call for the pose of index k, and what else is defined.
FAMILIES: dict[str, tuple[str, str, tuple[tuple[str, str], ...]]] = {
    "ikgeo.three_parallel": ("three_parallel", "ssik::three_parallel_solve(joints, poses[k])", ()),
    "ikgeo.spherical_two_parallel": (
        "spherical_two_parallel",
        "ssik::spherical_two_parallel_solve(joints, poses[k])",
        (),
    ),
    "seven_r.srs": ("srs", "swept(poses[k])", (("SRS", "1"),)),
    "seven_r.spherical_shoulder": ("spherical_shoulder", "swept(poses[k])", (("SHOULDER", "1"),)),
    "seven_r.spherical_shoulder, one position": (
        "spherical_shoulder",
        "at_one(poses[k], near[k])",
        (("SHOULDER", "1"),),
    ),
}
_NATIVE_FOLDER = Path(__file__).with_name("native")
_RELEASE = ("-std=c++17", "-DNDEBUG", f"-I{_NATIVE_FOLDER}")


@dataclass(frozen=True, slots=True)
class Ours:
    """Our kernel as a runner, what holds of the arm, and processor time of its generation [s].

    Its results are ``branches`` solutions and their flags; ``redundant``: the joint (from 0) that takes its
    position from the reference.
    """

    candidate: Candidate
    branches: int
    redundant: int | None
    conditions: tuple[str, ...]
    seconds: float


@dataclass(frozen=True, slots=True)
class Flagged:
    """What our kernel says of N poses: solutions, and which of them are within limits and singular [N, b]."""

    answers: Answers
    within: Floats
    singular: Floats
    count: Floats


def states(poses: Floats, near: Floats) -> States:
    """What the harness hands over: ``poses`` [N, 4, 4] and the positions ``near`` [N, n]."""
    padded = np.zeros((len(poses), TWELVE))
    padded[:, : near.shape[1]] = near
    return States(poses[:, :3].reshape(-1, TWELVE), padded, np.zeros_like(padded))


def computed(
    race: Race, runner: Path, poses: Floats, near: Floats, size: int, together: int
) -> Iterator[Floats]:
    """What ``runner`` gives, ``together`` poses at a time [<= together, size]."""
    for start in range(0, len(poses), together):
        some = slice(start, start + together)
        states(poses[some], near[some]).write(race.folder / "states.bin")
        yield race.results(runner, (len(poses[some]), size))


def answers(results: Floats, n: int) -> Answers:
    """The solutions that a peer hands out.

    Raises
    ------
    ValueError: it has more than its places.
    """
    count, q = results[:, 0], results[:, 1:].reshape(len(results), -1, n)
    if count.max(initial=0) > q.shape[1]:
        raise ValueError(f"a pose has {count.max():.0f} solutions; there is room for {q.shape[1]}")
    most = max(1, int(count.max(initial=0)))
    return Answers(q[:, :most], np.arange(most) < count[:, None])


def flagged(results: Floats, branches: int, n: int) -> Flagged:
    """What our kernel's results say."""
    ends = np.cumsum([branches * n, branches, branches, branches])
    q, exists, within, singular, count = np.split(results, ends, axis=1)
    return Flagged(Answers(q.reshape(-1, branches, n), exists > 0), within, singular, count[:, 0])


def ours(robot: Robot, folder: Path) -> Ours:
    """Our kernel for ``robot``.

    Raises
    ------
    NoSuchFunction: the arm is of no class that has a closed form.
    """
    limits = [link.joint.limits.position for link in robot.links]
    inverse = inverse_of(build_arm(robot, lambda x: x, lambda name: name), limits)
    begin = time.process_time()
    generated = generate(robot, Options((FUNCTION,), trig="builtin"))
    seconds = time.process_time() - begin
    place = folder / "ours"
    files = written(place, generated.files(("c",)))
    (interface,) = generated.signatures
    starts = np.cumsum([0, *(size for _, size in interface.outputs)]).tolist()
    defines = (
        ("HEADER", f'"{robot.name}.h"'),
        ("REAL", f"{robot.name}_real"),
        ("KERNEL", interface.symbol),
        ("SIZE", str(starts[-1])),
        ("ARGUMENTS(k)", "angle + (k) * n, qd + (k) * n"),
        ("RESULTS(k)", ", ".join(f"results + (k) * SIZE + {start}" for start in starts[:-1])),
    )
    source = Source(("robodyn.c", *files), (f"-I{place}",), defines=defines)
    timed = library(folder / "robodyn.so", source, NATIVE)
    counted = library(folder / "robodyn-counted.so", source, STRICT)
    candidate = Candidate("robodyn", "robodyn", " ".join(NATIVE), timed, counted, ours=True)
    return Ours(candidate, inverse.branches, inverse.redundant, inverse.conditions, seconds)


def eaik(chain: Chain, folder: Path, work: Path, locked: int | None) -> Candidate:
    """EAIK's C++, from its source distribution, with the joint ``locked`` where the arm has seven.

    Raises
    ------
    Lacking: it cannot be had here, or does not solve this arm.
    """
    if not chain.revolute.all():
        raise Lacking("EAIK knows no prismatic joints")
    rows = [[chain.n, -1 if locked is None else locked], chain.axes, chain.offsets(), chain.home[:3, :3]]
    _write_numbers(folder / "axes.txt", rows)
    sources = _eaik_sources(work)
    inside = (
        "CPP/src",
        "CPP/src/IK",
        "CPP/src/IK/utils",
        "CPP/src/utils",
        "CPP/external/ik-geo/cpp/subproblems",
    )
    files = sorted(file for place in inside for file in (sources / place).glob("*.cpp"))
    flags = (*_RELEASE, f"-I{_eigen()}", *(f"-I{sources / place}" for place in inside), f"-DSLOTS={SLOTS}")
    source = Source((_NATIVE_FOLDER / "eaik.cpp", *files), flags, ("-lpthread",), packages=("cmeel-eigen",))
    return _both("eaik", f"EAIK {EAIK}", source, work)


def _eaik_sources(work: Path) -> Path:
    place = work / f"eaik-{EAIK}"
    if not place.is_dir():
        command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--no-binary", "eaik"]
        done = subprocess.run([*command, f"eaik=={EAIK}", "-d", str(work)], capture_output=True, text=True)
        archive = place.with_suffix(f"{place.suffix}.tar.gz")
        if done.returncode or not archive.is_file():
            raise Lacking(f"the sources of EAIK {EAIK} cannot be downloaded: {done.stderr.strip()[-200:]}")
        with tarfile.open(archive) as packed:
            packed.extractall(work, filter="data")
    return place


def ssik(chain: Chain, folder: Path, work: Path, one: bool = False) -> Candidate:
    """ssik's native backend: the function of the arm's family, with ``one`` that for a given redundant joint.

    Raises
    ------
    Lacking: it cannot be had here, or does not solve this arm in C++.
    """
    release = version("ssik")
    manipulator, cpp = import_module("ssik").Manipulator, import_module("ssik.cpp")

    if not chain.revolute.all():
        raise Lacking("ssik takes the axes of an arm without prismatic joints")
    steps = np.tile(np.eye(4), (chain.n + 1, 1, 1))
    steps[:, :3, 3] = chain.offsets()
    steps[-1, :3, :3] = chain.home[:3, :3]
    try:
        data = cpp.solver_data(manipulator.from_transforms(steps, chain.axes))
    except (cpp.UnsupportedFamilyError, ValueError) as refused:
        raise Lacking(f"ssik: {refused}") from None
    key = data.family + (", one position" if one else "")
    if key not in FAMILIES:
        raise Lacking(f"ssik's {data.family} has no such function")
    _write_arrays(folder / "solver.txt", data.arrays)
    header, call, defines = FAMILIES[key]
    slots = SLOTS_REDUNDANT if chain.n > 6 and not one else SLOTS
    defines += (("FAMILY", f'"ssik_cpp/solvers/{header}.hpp"'), ("SOLVE(k)", call))
    defines += (("JOINTS", str(chain.n)), ("SLOTS", str(slots)))
    flags = (*_RELEASE, f"-I{cpp.get_include()}", f"-I{_eigen()}")
    source = Source((_NATIVE_FOLDER / "ssik.cpp",), flags, ("-lpthread",), defines, ("ssik", "cmeel-eigen"))
    return _both(f"ssik-{key.replace(', ', '-').replace(' ', '-')}", f"ssik {release}, {key}", source, work)


def peers(chain: Chain, folder: Path, work: Path, redundant: int | None) -> Iterator[Candidate | Missing]:
    """Each peer for the arm, or the reason why it does not solve it."""
    makers: dict[str, Callable[[], Candidate]] = {
        f"EAIK {EAIK}": lambda: eaik(chain, folder, work, redundant),
        "ssik": lambda: ssik(chain, folder, work),
    }
    for title, make in makers.items():
        try:
            yield make()
        except Lacking as lacking:
            yield Missing(title, title, str(lacking))


def _eigen() -> Path:
    return package_folder("cmeel-eigen", "cmeel.prefix/include/eigen3")


def _both(key: str, title: str, source: Source, work: Path) -> Candidate:
    """A runner for all arms of its kind: the arm is in the folder that it is given."""
    timed = library(work / f"{key}.so", source, NATIVE)
    return Candidate(key, title, " ".join(NATIVE), timed, library(work / f"{key}-counted.so", source, AVX2))


def _write_numbers(path: Path, rows: list[Any]) -> None:
    lines = (" ".join(repr(x) for x in np.ravel(row).tolist()) for row in rows)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _write_arrays(path: Path, arrays: Any) -> None:
    lines = (
        " ".join([name, str(array.size), *map(repr, array.ravel().tolist())])
        for name, array in arrays.items()
    )
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
