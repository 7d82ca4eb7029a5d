"""Programs that do not end, talk without end, or leave others behind: what becomes of them, and of us."""

from __future__ import annotations

import itertools
import os
import signal
import stat
import sys
import threading
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from robodyn.errors import ToolError
from robodyn.kernels.kernel import load
from robodyn.toolchain import running
from robodyn.toolchain.compiler import find_c, find_compiler
from robodyn.toolchain.program import run_program
from robodyn.toolchain.running import end_all, run
from robodyn_testing import require_tool
from robodyn_testing.waiting import eventually, runs

pytestmark = pytest.mark.skipif(not hasattr(os, "killpg"), reason="missing: os.killpg; only POSIX has it")

#: As a compiler with a helper: both note their ids and stay for as long as any test could take.
HANGS = "sleep 1000 & echo $! >> HERE/ids; echo $$ >> HERE/ids; sleep 1000"


@pytest.fixture
def script(tmp_path: Path) -> Callable[[str], str]:
    """A program of a few lines of shell; HERE stands for the folder in which it leaves its notes."""
    require_tool("sh")

    def write(text: str) -> str:
        path = tmp_path / "tool"
        path.write_text(f"#!/bin/sh\n{text.replace('HERE', str(tmp_path))}\n", encoding="utf-8")
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return str(path)

    return write


@pytest.fixture
def over(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Any time is over as soon as the processes of a script have left their ids."""
    later = itertools.count(1)

    def now() -> float:
        notes = tmp_path / "ids"
        there = notes.exists() and len(notes.read_text().split()) == 2
        return 1e6 * next(later) if there else 0.0

    monkeypatch.setattr(running, "monotonic", now)


def alive(folder: Path) -> list[int]:
    """Which of the processes that have left their ids in ``folder`` run still."""
    return [int(line) for line in (folder / "ids").read_text().split() if runs(int(line))]


def all_gone(folder: Path) -> bool:
    """Whether none of them runs, sooner or later."""
    return eventually(lambda: not alive(folder))


def test_what_is_said(script: Callable[[str], str], tmp_path: Path) -> None:
    tool = script("echo out; echo err >&2; pwd; echo $LC_ALL; exit 3")
    done = run([tool], folder=tmp_path)
    assert (done.code, sorted(done.output.split())) == (3, sorted(["out", "err", str(tmp_path), "C"]))
    assert "err" not in run([tool], listen="stdout").output
    assert run([tool], listen="stderr").output == "err\n"
    assert run([script("kill -9 $$")]).code == -9
    assert run([script("cat")]).output == ""  # stdin is empty
    with pytest.raises(OSError, match="no such tool"):
        run([str(tmp_path / "no such tool")])


@pytest.mark.usefixtures("over")
def test_a_program_that_does_not_end(script: Callable[[str], str], tmp_path: Path) -> None:
    done = run([script(f"echo begun; {HANGS}")])
    assert (done.code, done.output) == (None, "begun\n")
    assert all_gone(tmp_path)


@pytest.mark.usefixtures("over")
def test_a_program_that_only_closes_its_mouth(script: Callable[[str], str], tmp_path: Path) -> None:
    done = run([script(f"exec >&- 2>&-; {HANGS}")])
    assert done.code is None
    assert all_gone(tmp_path)


@pytest.mark.usefixtures("over")
def test_a_program_that_talks_without_end(
    script: Callable[[str], str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(running, "MOST_OUTPUT", 1000)
    more = "head -c 200000 /dev/zero | tr '\\0' y"
    done = run([script(f"echo first; {more}; echo $$ $$ >> HERE/ids; exec yes")])
    assert done.code is None
    assert done.output.startswith("first\ny")
    assert len(done.output) == 1000


def test_who_stays_behind_is_not_waited_for(
    script: Callable[[str], str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(running, "_LAST", 0.1)
    done = run([script("sleep 1000 & echo $! > HERE/ids; echo done")])
    assert (done.code, done.output) == (0, "done\n")
    for process in alive(tmp_path):
        os.kill(process, signal.SIGKILL)


def test_an_exception_in_between(
    script: Callable[[str], str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    join = threading.Thread.join

    def interrupted(thread: threading.Thread, timeout: float | None = None) -> None:
        while not (tmp_path / "ids").exists() or len((tmp_path / "ids").read_text().split()) < 2:
            join(thread, 0.01)
        raise KeyboardInterrupt

    tool = script(HANGS)
    with monkeypatch.context() as patch:
        patch.setattr(threading.Thread, "join", interrupted)
        with pytest.raises(KeyboardInterrupt):
            run([tool])
    assert all_gone(tmp_path)


def test_what_other_threads_run_can_be_ended(script: Callable[[str], str], tmp_path: Path) -> None:
    codes: list[int | None] = []
    tool = script(HANGS)
    thread = threading.Thread(target=lambda: codes.append(run([tool]).code))
    thread.start()
    assert eventually(lambda: (tmp_path / "ids").exists() and len(alive(tmp_path)) == 2)
    end_all()
    thread.join()
    assert codes == [-signal.SIGKILL]
    assert all_gone(tmp_path)


# --- compilers --------------------------------------------------------------------------------------------


@pytest.mark.usefixtures("over")
@pytest.mark.parametrize("find", [find_c, partial(find_compiler, "fortran")])
def test_a_compiler_that_does_not_say_who_it_is(
    find: Callable[[str], Any], script: Callable[[str], str], tmp_path: Path
) -> None:
    with pytest.raises(
        ToolError, match=r"tool does not come to an end; found no message; expected 60 s at"
    ) as e:
        find(script(HANGS))
    assert e.value.exit_code == 3
    assert all_gone(tmp_path)


@pytest.mark.usefixtures("over")
def test_a_compiler_that_hangs(
    toy: Callable[..., Any],
    script: Callable[[str], str],
    tmp_path: Path,
    own_cache: Path,
) -> None:
    arm = toy("hanging")
    tool = script(
        f'case "$1" in --version|-dumpmachine) echo hanging cc 1.0;; *) echo reading; {HANGS};; esac'
    )
    with pytest.raises(ToolError, match="does not come to an end; found reading; expected 600 s at most"):
        load(arm.signatures, arm.files, cc=tool)
    assert all_gone(tmp_path)
    assert not list(own_cache.glob("unfinished-*"))


def test_a_program_of_ours_that_hangs() -> None:
    require_tool("cc")
    text = '#include <stdio.h>\nint main(void) { puts("x"); fflush(stdout); for (;;) { } }\n'
    with pytest.raises(
        ToolError, match=r"the compiled program does not come to an end; expected 0\.3 s at most"
    ):
        run_program({"main.c": text}, seconds=0.3)
    code, said = run_program({"main.c": '#include <stdio.h>\nint main(void) { puts("x"); return 3; }\n'})
    assert (code, said) == (3, "x\n")


def test_nothing_else_runs_programs() -> None:
    """Whoever needs a program runs it through here, or takes as good care of it himself."""
    import robodyn

    root = Path(robodyn.__file__).parent
    found = {
        str(path.relative_to(root).as_posix())
        for path in root.rglob("*.py")
        if "subprocess" in path.read_text(encoding="utf-8")
    }
    # formats: a room above toolchain; bounded in time, memory and output, and in a session of its own.
    # logs: bounded in time and memory, ended with the process that asks, and in a session of its own.
    runs = {f"{name}.py" for name in ("toolchain/running", "toolchain/workers", "logs/guard")}
    runs.add("formats/xacro.py")
    assert found == runs | {"formats/xacro_process.py"}  # which names programs to refuse them
    assert sys.modules["robodyn.toolchain.running"] is running
