"""A search on a terminal, and one that is interrupted."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest

from cli.searched import NAME, Capture, files, run
from robodyn.optimize.records import FOLDER, parse_record
from robodyn_cli import progress
from robodyn_cli.main import main
from robodyn_testing.clocks import ticking
from robodyn_testing.waiting import eventually

pytestmark = pytest.mark.usefixtures("here")

# --- a terminal, and somebody who has had enough ----------------------------------------------------------


class Terminal:
    """Stands in for stderr on a terminal."""

    def __init__(self) -> None:
        self.text = ""

    def isatty(self) -> bool:
        return True

    def write(self, text: str) -> int:
        self.text += text
        return len(text)

    def flush(self) -> None:
        pass


def shown(text: str) -> str:
    """What a terminal shows in the end of what was written on one line."""
    cells: list[str] = []
    at = 0
    for letter in text:
        if letter == "\r":
            at = 0
            continue
        cells[at : at + 1] = [letter]
        at += 1
    return "".join(cells).rstrip()


def test_a_line_is_written_over_and_gone_in_the_end(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    clock = iter(range(100))
    monkeypatch.setattr("robodyn_cli.progress.time.monotonic", lambda: float(next(clock)))
    with progress.line() as line:
        line.tell("a long line of text")
        assert shown(terminal.text) == "a long line of text"
        line.tell("short")
        assert shown(terminal.text) == "short"
        line.tell("longer again")
        assert shown(terminal.text) == "longer again"
    assert shown(terminal.text) == ""
    assert "\n" not in terminal.text


def test_a_line_is_gone_after_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    with pytest.raises(KeyboardInterrupt), progress.line() as line:  # noqa: PT012  # noqa: PT012 (the context is what is tested)
        line.tell("text")
        raise KeyboardInterrupt
    assert shown(terminal.text) == ""


def test_a_line_is_not_told_too_often(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    ticking(monkeypatch, {progress: 1e-3})
    with progress.line() as line:
        for k in range(1000):
            line.tell(str(k))
    assert terminal.text.count("\r") == 5 + 2  # one in 0.2 s, and two to clear it


def test_a_terminal_that_goes_away_stops_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    class Gone(Terminal):
        attempts = 0

        def write(self, text: str) -> int:
            self.attempts += 1
            raise OSError(5, "Input/output error")

    monkeypatch.setattr(sys, "stderr", gone := Gone())
    work = 0
    with progress.line() as line:
        line.tell("text")
        work += 1
    assert gone.attempts  # it was written to
    assert work


@pytest.mark.thorough
def test_a_search_tells_how_far_it_is_on_a_terminal(monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> None:
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    assert main(["flops", "elbow.yaml", "--optimize", "full", "--budget-seconds", "1.5"]) == 0
    assert "\rrobodyn: elbow inverse_dynamics: algebra, " in terminal.text
    assert shown(terminal.text) == ""


SEARCHING = """
import pathlib, sys
from robodyn.search import improve, structured
from robodyn_cli.entry import main

def begins(work):
    def working(*arguments, **options):
        pathlib.Path({begun!r}).touch()
        return work(*arguments, **options)
    return working

improve.climb = begins(improve.climb)
structured.Workers.run = begins(structured.Workers.run)
sys.argv[1:] = {options!r}
sys.exit(main())
"""


def group_runs(group: int) -> bool:
    try:
        os.killpg(group, 0)
    except ProcessLookupError:
        return False
    return True


@pytest.mark.parametrize("level", ["search", "full"])
def test_an_interrupt_leaves_nothing_half_done(level: str, here: Path, tmp_path: Path) -> None:
    begun = tmp_path / "begun"
    options = ["gen", "elbow.yaml", "-o", "out", "--keep", "--optimize", level, "--budget-seconds", "1000"]
    process = subprocess.Popen(
        [sys.executable, "-c", SEARCHING.format(begun=str(begun), options=options)],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        # A shell that started the tests in the background has them ignore interrupts.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
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
    assert eventually(lambda: not group_runs(process.pid)), "processes are left"


@pytest.mark.thorough
def test_a_record_that_is_kept_has_exact_numbers(here: Path, capsys: Capture) -> None:
    run(capsys, "flops", "elbow.yaml", "--optimize", "search", "--budget-seconds", "0.1", "--keep")
    record = parse_record((here / FOLDER / NAME).read_text(), "")
    numbers = [arg for op in record.program.operations for arg in op.args if isinstance(arg, Fraction)]
    assert numbers
    assert all(number.denominator < 10**40 for number in numbers)
