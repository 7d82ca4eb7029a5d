"""``gen`` and ``flops`` with records and searches: what is used, written, refused, told and left behind."""

from __future__ import annotations

import errno
import os
import shutil
import signal
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest

from cli.command import Capture, environment, heed, run, run_json
from records.made import ELBOW, arm, better, fast
from robodyn.counts import count
from robodyn.dynamics.equality import equals_recursion
from robodyn.optimize.records import FOLDER, bundled_records, parse_record
from robodyn.search.improve import write_record
from robodyn.search.walk import library
from robodyn_cli import progress
from robodyn_testing.clocks import ticking
from robodyn_testing.waiting import eventually
from search.arms import search_for_a_moment

pytestmark = pytest.mark.usefixtures("here")

ROBOT = arm(ELBOW)
FAST = count(fast(ROBOT)).total
BEST = count(better(ROBOT).program).total
NAME = "elbow.inverse_dynamics.total.record"


@pytest.fixture(scope="session")
def walk_entries() -> list[Path]:
    """Where the compiled walk lies; it is compiled but once."""
    library()
    found = [path.parent for path in Path(os.environ["ROBODYN_CACHE"]).glob("*/walk.so")]
    return sorted(found, key=lambda path: path.stat().st_mtime)


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, walk_entries: list[Path]) -> Path:
    """A folder with the elbow's file, and a cache with nothing but the compiled walk."""
    folder, cache = tmp_path / "here", tmp_path / "cache"
    folder.mkdir()
    cache.mkdir(mode=0o700)
    for entry in walk_entries[-1:]:
        shutil.copytree(entry, cache / entry.name)
    (folder / "elbow.yaml").write_text(ELBOW)
    monkeypatch.chdir(folder)
    monkeypatch.setenv("ROBODYN_CACHE", str(cache))
    return folder


@pytest.fixture
def moment(monkeypatch: pytest.MonkeyPatch) -> None:
    search_for_a_moment(monkeypatch)


@pytest.fixture
def with_record(here: Path) -> Path:
    """The record of a better program beside the elbow's file."""
    return write_record(better(ROBOT), here / FOLDER)


def files(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if not path.is_dir()}


def total(capsys: Capture, options: str = "", file: str = "elbow.yaml") -> int:
    return int(run_json(capsys, f"flops {file} {options}")["total"])


# --- records beside the file ------------------------------------------------------------------------------


def test_a_record_beside_the_file_is_used(with_record: Path, here: Path, capsys: Capture) -> None:
    assert total(capsys) == total(capsys, "--optimize record") == total(capsys, "--objective total:") == BEST
    assert total(capsys, "--optimize fast") == FAST > BEST
    run(capsys, "gen elbow.yaml -o out")
    text = (here / "out" / "elbow.c").read_text()
    assert "the best program known for these parameters" in text
    assert "a test" in text
    run(capsys, "gen elbow.yaml -o out --functions bias,inverse_dynamics")
    run(capsys, "gen elbow.yaml -o out")
    run(capsys, "gen elbow.yaml -o out --check")
    run(capsys, "gen elbow.yaml -o out --check --optimize fast", code=1)


def test_where_records_are_looked_for(
    with_record: Path, here: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    """Beside the file, whatever its name and the working folder; for other numbers there is none."""
    (here / "copy.yaml").write_text(ELBOW.replace("name: elbow", "name: copy"))
    (here / "far").mkdir()
    monkeypatch.chdir(here / "far")
    assert total(capsys, file="../elbow.yaml") == total(capsys, file=str(here / "copy.yaml")) == BEST
    shutil.copy(here / "elbow.yaml", here / "far" / "elbow.yaml")
    # The bytes of a kernel must not depend on what was searched for on this machine.
    write_record(better(ROBOT), Path(os.environ["ROBODYN_CACHE"]) / FOLDER)
    assert total(capsys) == FAST
    (here / "elbow.yaml").write_text(ELBOW.replace("mass: 1.5", "mass: 1.6"))
    other = total(capsys, file="../elbow.yaml")
    assert other == total(capsys, "--optimize fast", file="../elbow.yaml")


# --- searching --------------------------------------------------------------------------------------------


@pytest.mark.usefixtures("moment")
@pytest.mark.thorough
@pytest.mark.parametrize("level", ["search", "full"])
def test_a_short_search(level: str, here: Path, capsys: Capture) -> None:
    options = f"--optimize {level} --budget-seconds 0.5"
    _, err = run(capsys, f"gen elbow.yaml -o out {options}")
    assert err == "", "no progress where nobody watches"
    head = (here / "out" / "elbow.h").read_text()
    assert f"robodyn --optimize {level}, seed 0" in " ".join(head.replace(" *", " ").split())
    assert files(here) == {"elbow.yaml", "out/elbow.c", "out/elbow.h", "out/elbow.f90"}, "no record unasked"
    found = run_json(capsys, f"flops elbow.yaml --functions inverse_dynamics,gravity {options}")
    counts = {each["function"]: each["total"] for each in found}
    assert counts["inverse_dynamics"] < FAST
    assert counts["gravity"] <= count(fast(ROBOT, "gravity")).total


@pytest.mark.usefixtures("moment")
def test_keep_writes_beside_the_file(here: Path, capsys: Capture) -> None:
    options = "--optimize full --budget-seconds 0.5"
    _, err = run(capsys, f"flops elbow.yaml {options} --keep")
    assert err == f"robodyn: wrote {FOLDER}/{NAME}\n"
    made = parse_record((here / FOLDER / NAME).read_text(), "").program
    assert equals_recursion(ROBOT, "inverse_dynamics", made)
    numbers = [arg for op in made.operations for arg in op.args if isinstance(arg, Fraction)]
    assert numbers
    assert all(number.denominator < 10**40 for number in numbers)
    assert files(here) == {"elbow.yaml", f"{FOLDER}/{NAME}"}
    assert total(capsys) == count(made).total < FAST
    assert total(capsys, "--objective mul") >= count(made).total
    # The next search goes on from there.
    assert total(capsys, "--optimize search --budget-seconds 0.01 --seed 7") <= count(made).total


@pytest.mark.thorough
def test_keep_where_it_cannot(here: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    command = "gen elbow.yaml -o out --optimize search --budget-seconds 0.1 --keep"
    (here / FOLDER).write_text("in the way")
    assert "cannot write to records" in run(capsys, command, code=2)[1]
    assert files(here) == {"elbow.yaml", FOLDER}
    (here / FOLDER).unlink()

    def full(record: object, folder: Path) -> Path:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr("robodyn.search.improve.write_record", full)
    _, err = run(capsys, command, code=74)
    assert "cannot write to records: No space left on device; remove --keep" in err
    assert files(here) == {"elbow.yaml"}


@pytest.mark.thorough
def test_objectives(here: Path, capsys: Capture) -> None:
    objective = "depth"
    total(capsys, f"--optimize search --budget-seconds 0.1 --objective {objective} --keep")
    (path,) = (here / FOLDER).iterdir()
    assert f"\nobjective {objective}\n" in path.read_text()
    assert (
        total(capsys, f"--objective {objective}") == count(parse_record(path.read_text(), "").program).total
    )
    assert total(capsys) == FAST


def test_a_function_that_has_no_writings(capsys: Capture) -> None:
    found = total(capsys, "--functions gravity --optimize search --budget-seconds 0.3")
    assert found <= total(capsys, "--functions gravity --optimize fast")


@pytest.mark.thorough
def test_bundled_records_stay_as_they_are(capsys: Capture) -> None:
    before = {path: path.read_bytes() for path in bundled_records().rglob("*.record")}
    run(capsys, "flops stanford_3dof_d3 --optimize search --budget-seconds 0.1")
    assert before == {path: path.read_bytes() for path in bundled_records().rglob("*.record")}


# --- a terminal, and somebody who has had enough ----------------------------------------------------------


class Terminal:
    """Stands in for stderr on a terminal."""

    def __init__(self, patch: pytest.MonkeyPatch, *, gone: bool = False) -> None:
        self.text, self.gone = "", gone
        patch.setattr(sys, "stderr", self)

    def isatty(self) -> bool:
        return True

    def write(self, text: str) -> int:
        self.text += text
        if self.gone:
            raise OSError(errno.EIO, "Input/output error")
        return len(text)

    def flush(self) -> None:
        pass

    def shown(self) -> str:
        """What stands in the end on the one line that was written to."""
        cells: list[str] = []
        at = 0
        for letter in self.text:
            if letter == "\r":
                at = 0
                continue
            cells[at : at + 1] = [letter]
            at += 1
        return "".join(cells).rstrip()


def test_a_line_is_written_over_and_gone_in_the_end(monkeypatch: pytest.MonkeyPatch) -> None:
    """After an error, too."""
    terminal = Terminal(monkeypatch)
    ticking(monkeypatch, {progress: 1.0})
    with pytest.raises(KeyboardInterrupt), progress.line() as line:  # noqa: PT012 (the context is what is tested)
        for text in ("a long line of text", "short", "longer again"):
            line.tell(text)
            assert terminal.shown() == text
        raise KeyboardInterrupt
    assert terminal.shown() == ""
    assert "\n" not in terminal.text


def test_a_line_is_not_told_too_often(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = Terminal(monkeypatch)
    ticking(monkeypatch, {progress: 1e-3})
    with progress.line() as line:
        for k in range(1000):
            line.tell(str(k))
    assert terminal.text.count("\r") == 5 + 2  # one in 0.2 s, and two to clear it


def test_a_terminal_that_goes_away_stops_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = Terminal(monkeypatch, gone=True)
    with progress.line() as line:
        line.tell("text")
    assert terminal.text  # it was written to


@pytest.mark.thorough
def test_a_search_tells_how_far_it_is_on_a_terminal(monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> None:
    terminal = Terminal(monkeypatch)
    run(capsys, "flops elbow.yaml --optimize full --budget-seconds 1.5")
    assert "\rrobodyn: elbow inverse_dynamics: algebra, " in terminal.text
    assert terminal.shown() == ""


SEARCHING = """
import pathlib, sys
from robodyn.search import improve, structured
from robodyn_cli.entry import main

def begins(work):
    def working(*arguments, **options):
        pathlib.Path(begun).touch()
        return work(*arguments, **options)
    return working

improve.climb = begins(improve.climb)
structured.Workers.run = begins(structured.Workers.run)
begun, sys.argv[1:] = sys.argv[1], "gen elbow.yaml -o out --keep --budget-seconds 1000".split() + sys.argv[2:]
sys.exit(main())
"""


@pytest.mark.parametrize("level", ["full", pytest.param("search", marks=pytest.mark.thorough)])
def test_an_interrupt_leaves_nothing_half_done(level: str, here: Path, tmp_path: Path) -> None:
    begun = tmp_path / "begun"
    process = subprocess.Popen(
        [sys.executable, "-c", SEARCHING, str(begun), "--optimize", level],
        env=environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        preexec_fn=heed,
    )
    try:
        assert eventually(lambda: process.poll() is not None or begun.exists())
        assert process.poll() is None
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to the processes that help, too
        out, err = process.communicate(timeout=300)
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
    assert (process.returncode, out, err) == (130, "", "robodyn: interrupted\n")
    assert files(here) == {"elbow.yaml"}
    assert not [name for name in files(tmp_path) if name.endswith(".tmp")]
    assert not list((tmp_path / "cache").glob("unfinished-*"))

    def group_is_gone() -> bool:
        try:
            os.killpg(process.pid, 0)
        except ProcessLookupError:
            return True
        return False

    assert eventually(group_is_gone), "processes are left"
