"""``robodyn build`` and signals, other builds, terminals: nothing is half-written, whatever ends it."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from cli.built import FILES, PROJECT, build, outputs
from cli.generated import Capture, tree
from robodyn_testing import require_module

posix = pytest.mark.skipif(not hasattr(os, "killpg"), reason="missing: signals; only POSIX has them")

#: A build that a signal meets when it does something for the NTH time: "replace" is the renaming of a file
#: that it writes, "tell" the beginning of a robot.
HIT = """
import os, signal, sys
from pathlib import Path
from robodyn_cli.entry import main
from robodyn_cli.progress import Line
name, left, number = sys.argv[1], [int(sys.argv[2])], getattr(signal, sys.argv[3])
kind = {"replace": Path, "tell": Line}[name]
method = getattr(kind, name)
def hit(self, *arguments):
    if not left[0]:
        os.kill(os.getpid(), number)
    left[0] -= 1
    return method(self, *arguments)
setattr(kind, name, hit)
sys.argv = ["robodyn", "build", "--workers", sys.argv[4]]
sys.exit(main())
"""


def hit(what: str, nth: int, number: str, workers: int = 1) -> subprocess.CompletedProcess[str]:
    """A build that gets the signal ``number`` there."""
    return subprocess.run(
        [sys.executable, "-c", HIT, what, str(nth), number, str(workers)],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)},
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        capture_output=True,
        text=True,
        check=False,
    )


@posix
@pytest.mark.parametrize("renamed", [*(pytest.param(k, marks=pytest.mark.thorough) for k in (0, 4)), 2])
def test_a_killed_build_leaves_whole_files_old_or_new(renamed: int, project: Path) -> None:
    build()
    old = outputs(project)
    (project / "robodyn.toml").write_text(PROJECT.replace('"gravity"', '"bias"'))
    assert hit("replace", renamed, "SIGKILL").returncode == -9
    between = outputs(project)
    build()
    new = outputs(project)
    assert set(new) == set(old) == set(between) == FILES
    assert all(text in (old[name], new[name]) for name, text in between.items())
    assert sum(between[name] == new[name] != old[name] for name in FILES) == renamed
    assert between["robodyn.lock"] == old["robodyn.lock"]
    assert not list(project.rglob(".robodyn.*"))


@posix
@pytest.mark.parametrize(
    ("workers", "number", "code", "err"),
    [
        pytest.param(1, "SIGINT", 130, "robodyn: interrupted\n", marks=pytest.mark.thorough),
        (2, "SIGINT", 130, "robodyn: interrupted\n"),
        pytest.param(2, "SIGTERM", 143, "robodyn: terminated\n", marks=pytest.mark.thorough),
        pytest.param(2, "SIGKILL", -9, "", marks=pytest.mark.thorough),
    ],
)
def test_a_build_that_ends_while_it_generates_has_written_nothing(
    workers: int, number: str, code: int, err: str, project: Path
) -> None:
    before = tree(project)
    done = hit("tell", 1, number, workers)
    assert (done.returncode, done.stdout, done.stderr) == (code, "", err)
    assert tree(project) == before
    build()
    assert set(tree(project)) >= FILES


@posix
def test_progress_is_a_line_on_a_terminal(project: Path) -> None:
    pty = require_module("pty")
    master, terminal = pty.openpty()
    command = [sys.executable, "-m", "robodyn", "build", "--workers", "1"]
    imports = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    with subprocess.Popen(command, env=imports, stdout=subprocess.DEVNULL, stderr=terminal) as process:
        os.close(terminal)
        text = b""
        with contextlib.suppress(OSError):  # the other end is closed
            while part := os.read(master, 4096):
                text += part
    os.close(master)
    assert process.returncode == 0
    assert b"\rrobodyn: 0 of 2 robots generated; one ..." in text
    assert text.endswith(b"\r")


@pytest.mark.thorough
def test_two_builds_at_once_wait_for_each_other(project: Path, capsys: Capture) -> None:
    fcntl = require_module("fcntl")
    with (project / "robodyn.toml").open("rb") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        build("--check", code=1)  # writes nothing, and waits for nobody
        command = [sys.executable, "-m", "robodyn", "build", "--workers", "1"]
        imports = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
        with subprocess.Popen(command, env=imports, stderr=subprocess.PIPE, text=True) as other:
            assert other.stderr is not None
            assert "another build of robodyn.toml is running" in other.stderr.readline()
            assert not set(tree(project)) & FILES
            fcntl.flock(file, fcntl.LOCK_UN)
            other.communicate()
    assert other.returncode == 0
    assert set(tree(project)) >= FILES
