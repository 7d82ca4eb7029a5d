"""How many robot files of public packages are read right, and how many are refused, by which word.

    pip download --no-deps --only-binary=:all: -d WHEELS -r benchmarks/public_files.txt
    python -m benchmarks.public_files WHEELS            writes results/public_files.json and .md
    python -m benchmarks.public_files WHEELS --only ur5 --out /somewhere

Every URDF, xacro and MJCF file of the packages that has or includes joints is read as ``robodyn import``
reads it, each chain from the root to a link at an end of the tree is made a description, and that is
compared with what Pinocchio (URDF) or MuJoCo (MJCF) reads in the same file: torques, mass matrix, motion of
the links, tool frame and gear ratios at random states (:mod:`robodyn.verify.against`). A file is *right* if
all chains that are read are, *wrong* if one is not or if anything but an error with a reason comes out,
*refused* if none is read, *no arm* if nothing moves in it (things, macros), and *not compared* if the
library refuses what robodyn reads.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import re
import tempfile
import traceback
import zipfile
from collections import Counter
from collections.abc import Iterator, Sequence
from importlib.metadata import version
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, Final

import numpy as np

from robodyn.errors import InputError, RobodynError
from robodyn.formats.arm import how_files_are_read, read_tree
from robodyn.formats.frames import description_of
from robodyn.formats.serial import serial_chain
from robodyn.formats.topology import Topology
from robodyn.robot import Robot, read_text, to_yaml
from robodyn.robot.masses import require_masses
from robodyn.verify import Comparison, Reference
from robodyn.verify.against import comparable, compare, frame_comparisons, read_original
from robodyn.verify.against.arm import PeerArm
from robodyn.verify.sample import draw

RESULTS: Final = Path(__file__).parent / "results" / "public_files.json"
#: [states] At which a chain is compared; a wrong reading shows at almost any.
STATES: Final = 4
#: [s] A file that takes longer counts as wrong; none of those in the results did.
LIMIT: Final = 300
_ROOT: Final = re.compile(rb"<\s*(robot|mujoco)[\s>]")
_JOINTS: Final = re.compile(rb"<(xacro:)?(joint|include)[\s>/]")
#: What is said of files and chains in which nothing moves, and of files with macros alone.
_NO_ARM: Final = ("the robot has no joints", "the robot has no links", "between NAME and NAME nothing moves")


def robots_in(folder: Path) -> list[tuple[Path, str]]:
    """The files below ``folder`` with joints, and which they are by their root elements."""
    roots = {b"robot": "URDF", b"mujoco": "MJCF"}
    files = [path for path in folder.rglob("*") if path.suffix in (".urdf", ".xacro", ".xml", ".mjcf")]
    texts = [(path, path.read_bytes()) for path in sorted(files)]
    hits = [(path, _ROOT.search(text)) for path, text in texts if _JOINTS.search(text)]
    return [(path, roots[hit.group(1)]) for path, hit in hits if hit]


def reason(error: RobodynError) -> str:
    """What is wrong, without the names and numbers of the file."""
    if error.what.endswith("would rest on numbers that nobody states"):
        return "torques would rest on masses that nobody states"
    words = re.sub(r"'[^']*'|(?<=the constraint )\S+", "NAME", error.what)
    return re.sub(r"(is not modelled: \w+).*", r"\1", words)


def judged(path: Path) -> dict[str, Any]:
    """The verdict on one file."""
    try:
        topology = Topology(read_tree(path))
    except RobodynError as error:
        return {"verdict": "refused", "reason": reason(error), "both": _is_refused_by_the_library(path)}
    refused: Counter[str] = Counter()
    right, wrong, largest = set[str](), [], 0.0
    original = None
    for robot, tip in _chains(topology, refused):
        try:
            original = original or read_original(path)
            arm = original.arm(robot, {})
        except InputError as error:
            return {"verdict": "not compared", "reason": f"{reason(error)}: {error.found}"}
        rows = _compared(robot, arm, refused)
        largest = max(largest, *(row.error for row in rows))
        off = [f"{row.function} {row.error:.1e} at joint {row.joint}" for row in rows if not row.passed]
        wrong += [f"{tip}: {', '.join(off)}"] if off else []
        right |= {tip} if not off and any(row.function == "inverse_dynamics" for row in rows) else set()
    chains = {"right": len(right), "refused": dict(+refused), "wrong": wrong, "error": largest}
    if wrong or right:
        return {"verdict": "wrong" if wrong else "right", **chains}
    why = max(refused, key=lambda each: refused[each], default=_NO_ARM[0])
    return {"verdict": "refused", "reason": why, "both": False, **chains}


def _folders(path: Path, folder: Path) -> dict[str, str]:
    """What ``--arg`` says of what lies where: an MJCF's package in ``folder``, those that a xacro names."""
    if path.suffix != ".xacro":
        return {"find package": str(folder)}
    named = set(re.findall(r"\$\(find ([\w.-]+)\)", path.read_text(errors="replace")))
    return {f"find {d.name}": str(d) for d in sorted(folder.rglob("*")) if d.name in named and d.is_dir()}


def _chains(topology: Topology, refused: Counter[str]) -> Iterator[tuple[Robot, str]]:
    """The chains to the ends of the tree, read back from their descriptions, and their tips; where one is
    ``refused``, that to the link before it."""
    tips = dict.fromkeys(link for link in topology.links if not topology.below[link])
    for tip in list(tips):
        while True:
            try:
                serial = serial_chain(topology.tree, "arm", tip=tip)
                robot = read_text(to_yaml(description_of(serial.chain)), warn=lambda _: None)
            except RobodynError as error:
                refused[reason(error)] += reason(error) not in _NO_ARM
                if tip not in topology.above or (tip := topology.above[tip].parent) in tips:
                    break
            else:
                tips[tip] = None
                yield robot, tip
                break


def _compared(robot: Robot, arm: PeerArm, refused: Counter[str]) -> list[Comparison]:
    """The rows of ``robot``; of one whose torques are ``refused`` those of its frames."""
    alike, _ = comparable(robot, arm)
    try:
        require_masses(robot)
    except InputError as error:
        refused[reason(error)] += 1
        sample = draw(robot, STATES, 0, np.dtype(np.float64))
        return frame_comparisons(Reference(alike), arm, sample)
    return compare(alike, arm, states=STATES)


def _is_refused_by_the_library(path: Path) -> bool:
    try:
        read_original(path)
    except RobodynError:
        return True
    return False


def _send(pipe: Connection, path: Path, folder: Path) -> None:
    try:
        with how_files_are_read(_folders(path, folder)):
            verdict = judged(path)
        if verdict["verdict"] == "refused" and verdict["reason"] in _NO_ARM:
            verdict["verdict"] = "no arm"
        pipe.send(verdict)
    except BaseException as error:  # whatever it is, it is no error with a reason
        last = traceback.extract_tb(error.__traceback__)[-1]
        where = f"{Path(last.filename).name}:{last.lineno}"
        pipe.send({"verdict": "wrong", "reason": f"{type(error).__name__} in {where}: {error}"[:300]})


def verdict_on(path: Path, folder: Path) -> dict[str, Any]:
    """The verdict on one file, by a process of its own: a library may take it down."""
    context = multiprocessing.get_context("fork")
    here, there = context.Pipe(duplex=False)
    process = context.Process(target=_send, args=(there, path, folder))
    process.start()
    there.close()
    try:
        if not here.poll(LIMIT):
            return {"verdict": "wrong", "reason": f"more than {LIMIT} s"}
        verdict: dict[str, Any] = here.recv()
    except EOFError:
        process.join()
        verdict = {"verdict": "wrong", "reason": f"the process ended with {process.exitcode}"}
    finally:
        process.kill()
        process.join()
    return verdict


def measured(wheels: Sequence[Path], only: str) -> Iterator[dict[str, Any]]:
    """A record for every file of the ``wheels`` whose path has ``only`` in it."""
    for wheel in sorted(wheels):
        package, release = wheel.name.split("-")[:2]
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(temporary)
            with zipfile.ZipFile(wheel) as archive:
                archive.extractall(folder)
            for path, form in robots_in(folder):
                file = path.relative_to(folder).as_posix()
                if only in file:
                    of = {"package": package, "version": release, "file": file, "format": form}
                    yield {**of, **verdict_on(path, folder)}


def table(results: dict[str, Any]) -> str:
    """The results in Markdown: counts by package, refusals by reason, and what is wrong."""
    records = results["files"]
    lines = [f"# Robot files of public packages\n\n{_summary(results)}\n"]
    lines += [
        "| package | format | files | right | chains | refused | by both | no arm | not compared | wrong |"
    ]
    lines += ["|---|---|" + "---:|" * 8]
    groups = sorted({(r["package"], r["version"], r["format"]) for r in records})
    for package, release, form in groups:
        of = [r for r in records if (r["package"], r["format"]) == (package, form)]
        lines.append(f"| {package} {release} | {form} | {len(of)} | {_counts(of)} |")
    for form in ("MJCF", "URDF"):
        of = [r for r in records if r["format"] == form]
        lines.append(f"| all | {form} | {len(of)} | {_counts(of)} |")
    lines += ["\n## Refused\n", "| reason | files | chains of other files |", "|---|---:|---:|"]
    files = Counter(r["reason"] for r in records if r["verdict"] == "refused" and not r["both"])
    chains: Counter[str] = Counter()
    for record in records:
        if record["verdict"] == "right":
            chains.update(record["refused"])
    lines += [f"| {why} | {files[why]} | {chains[why]} |" for why in sorted({*files, *chains})]
    wrong = [r for r in records if r["verdict"] == "wrong"]
    lines += ["\n## Wrong\n"] + [
        f"- {r['package']}: {r['file']}: {r.get('reason') or r['wrong']}" for r in wrong
    ]
    return "\n".join(lines) + ("" if wrong else "\nNone.") + "\n"


def _counts(records: Sequence[dict[str, Any]]) -> str:
    kinds = Counter(r["verdict"] for r in records)
    both = sum(r["verdict"] == "refused" and r["both"] for r in records)
    chains = sum(r.get("right", 0) for r in records)
    figures = (kinds["right"], chains, kinds["refused"] - both, both)
    return " | ".join(map(str, (*figures, kinds["no arm"], kinds["not compared"], kinds["wrong"])))


def _summary(results: dict[str, Any]) -> str:
    records, libraries = results["files"], " and ".join(results["libraries"])
    kinds = Counter(r["verdict"] for r in records)
    largest = max((r["error"] for r in records if r["verdict"] == "right"), default=0.0)
    words = ", ".join(
        f"{kinds[kind]} {kind}" for kind in ("right", "refused", "no arm", "not compared", "wrong")
    )
    return (
        f"{len(records)} files: {words}. Largest relative error of those that are right: {largest:.1e}. "
        f"Read by {libraries} as well. Made by `python -m benchmarks.public_files`, whose head says "
        "what the words mean."
    )


def main() -> int:
    """Measure, write, and return the exit code: 1 if a file is wrong."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path, help="folder with wheels of packages")
    parser.add_argument("--only", default="", help="only files whose path has this in it")
    parser.add_argument("--out", type=Path, default=RESULTS.parent, help="folder of the results")
    arguments = parser.parse_args()
    records = []
    for record in measured(list(arguments.folder.glob("*.whl")), arguments.only):
        records.append(record)
        print(json.dumps(record), flush=True)
    write(records, arguments.out)
    return int(any(record["verdict"] == "wrong" for record in records))


def write(records: Sequence[dict[str, Any]], folder: Path) -> None:
    """Write the results, a record a line, and their table."""
    libraries = [f"Pinocchio {version('pin')}", f"MuJoCo {version('mujoco')}"]
    lines = ",\n".join(json.dumps(record) for record in records)
    text = f'{{"libraries": {json.dumps(libraries)}, "files": [\n{lines}\n]}}\n'
    (folder / RESULTS.name).write_text(text, encoding="utf-8")
    (folder / "public_files.md").write_text(table(json.loads(text)), encoding="utf-8")


if __name__ == "__main__":
    raise SystemExit(main())
