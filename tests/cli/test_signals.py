"""Signals and a lack of open files, at whatever moment: a line at most, the right exit code, nothing left."""

from __future__ import annotations

import os
import signal
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from robodyn_testing import covering, require_module, require_tool
from robodyn_testing.waiting import eventually, runs

pytestmark = pytest.mark.skipif(not hasattr(signal, "SIGALRM"), reason="missing: POSIX signals")

#: What a process of a test does when a module is first looked for.
HOOK = """
import os, signal, sys

class Finder:
    def find_spec(self, name, path=None, target=None):
        if name == os.environ["WHEN"]:
            os.environ["WHEN"] = ""
            exec(os.environ["THEN"])

sys.meta_path.insert(0, Finder())
"""


@pytest.fixture
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "site").mkdir()
    (tmp_path / "site" / "sitecustomize.py").write_text(HOOK)
    return tmp_path


def hooked(
    when: str, then: str, *command: str, before: list[str] | None = None, ignored: bool = False
) -> subprocess.CompletedProcess[str]:
    """``python -m robodyn COMMAND`` that does ``then`` when it first looks for the module ``when``; it heeds
    signals, even where the tests run under ``nohup``, unless Ctrl-C is ``ignored``."""

    def heeding() -> None:
        signal.signal(signal.SIGHUP, signal.SIG_DFL)
        signal.signal(signal.SIGINT, signal.SIG_IGN if ignored else signal.SIG_DFL)

    path = os.pathsep.join([str(Path("site").absolute()), *(each for each in sys.path if each)])
    return subprocess.run(
        [sys.executable, *(before or ["-m", "robodyn"]), *command],
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, "PYTHONPATH": path, "WHEN": when, "THEN": then},
        preexec_fn=heeding,
    )


def send(name: str) -> str:
    return f"os.kill(os.getpid(), signal.{name})"


@pytest.mark.usefixtures("elsewhere")
@pytest.mark.parametrize(
    "module",
    ["robodyn.process", "robodyn.__main__", "robodyn_cli", "robodyn_cli.entry", "robodyn_cli.main", "click",
     "click.core", "robodyn.errors", "robodyn_cli.common"],
)  # fmt: skip
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_while_it_begins(module: str, number: signal.Signals) -> None:
    done = hooked(module, send(number.name), "robots")
    assert done.returncode in (-number, 128 + number)
    assert (done.stdout, done.stderr) == ("", "")


@pytest.mark.usefixtures("elsewhere")
@pytest.mark.parametrize("module", ["robodyn.process", "robodyn_cli.entry", "click"])
@pytest.mark.parametrize("way", ["module", "script"])
def test_the_other_ways_to_begin(module: str, way: str) -> None:
    Path("robodyn").write_text("import sys\nfrom robodyn_cli.entry import main\nsys.exit(main())\n")
    done = hooked(
        module, send("SIGINT"), "robots", before=["-m", "robodyn_cli"] if way == "module" else ["robodyn"]
    )
    assert done.returncode in (-signal.SIGINT, 130)
    assert (done.stdout, done.stderr) == ("", "")


@pytest.mark.usefixtures("elsewhere")
@pytest.mark.parametrize(
    ("module", "name", "code", "word"),
    covering(
        ["robodyn_cli.robots", "yaml", "robodyn.robot.values"],
        [("SIGINT", 130, "interrupted"), ("SIGTERM", 143, "terminated"), ("SIGHUP", 129, "hung up")],
    ),
)
def test_a_signal_while_it_works(module: str, name: str, code: int, word: str) -> None:
    done = hooked(module, send(name), "robots")
    assert (done.returncode, done.stdout, done.stderr) == (code, "", f"robodyn: {word}\n")
    twice = hooked(module, f"{send(name)}; {send('SIGINT')}; {send('SIGTERM')}", "robots")
    assert (twice.returncode, twice.stderr) == (code, f"robodyn: {word}\n")


@pytest.mark.usefixtures("elsewhere")
def test_what_is_ignored_stays_ignored() -> None:
    for module in ("click", "robodyn_cli.robots"):
        done = hooked(module, send("SIGINT"), "robots", "--names", ignored=True)
        assert (done.returncode, done.stderr) == (0, "")
        assert "puma560" in done.stdout.split()


def python(code: str, *, path: tuple[str, ...] = ()) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, "PYTHONPATH": os.pathsep.join([*path, *(each for each in sys.path if each)])},
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )


def test_a_library_leaves_signals_alone(elsewhere: Path) -> None:
    names = "robodyn, robodyn.process, robodyn_cli, robodyn_cli.main, robodyn_cli.entry"
    same = "import signal\nassert signal.getsignal(signal.SIGINT) is signal.default_int_handler\n"
    assert python(f"import {names}\n{same}").returncode == 0
    (elsewhere / "other.py").write_text(f"import {names}\n{same}")
    done = hooked("", "", before=["-m", "other"])
    assert (done.returncode, done.stderr) == (0, "")


LISTENING = "import gc, os, signal, sys, time\nfrom robodyn import process\nprocess.listen()\n"


def test_a_signal_in_a_destructor_is_not_lost() -> None:
    done = python(
        LISTENING
        + "class Last:\n"
        + "    def __del__(self):\n        os.kill(os.getpid(), signal.SIGTERM)\n        time.sleep(0)\n"
        + "try:\n    last = Last()\n    del last\n    while True:\n        time.sleep(0.01)\n"
        + "except process.Ended:\n    print(process.received())\n"
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "(143, 'terminated')\n", "")


def test_a_signal_waits_for_what_must_not_be_torn() -> None:
    done = python(
        LISTENING
        + "try:\n    with process.Held():\n        os.kill(os.getpid(), signal.SIGTERM)\n"
        + "        time.sleep(0.2)\n        print('whole', flush=True)\n    time.sleep(60)\n"
        + "except process.Ended:\n    print(process.received())\n"
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "whole\n(143, 'terminated')\n", "")


def test_when_the_work_is_done_no_signal_matters() -> None:
    kill = "os.kill(os.getpid(), signal.SIGINT)\n"
    assert python(f"{LISTENING}process.quiet()\n{kill}").returncode == 0
    impatient = f"{LISTENING}process.PATIENCE = 0\nprocess.quiet()\ntime.sleep(0.01)\n{kill}time.sleep(60)"
    done = python(impatient)
    assert (done.returncode, done.stderr) == (130, "")


@pytest.mark.usefixtures("elsewhere")
@pytest.mark.parametrize(
    ("error", "message"),
    [
        ("MemoryError", "error: the operating system refused: out of memory"),
        ("ImportError('no', name='yaml')", "error: a library cannot be loaded: no; reinstall it"),
        ("KeyError('k')", "internal error: KeyError: 'k'"),
    ],
)
@pytest.mark.parametrize(("name", "code"), [("SIGINT", 130), ("SIGTERM", 143)])
def test_a_signal_that_waits_when_the_command_fails(name: str, code: int, error: str, message: str) -> None:
    """Its timer would run out when the interpreter has taken back its handlers: a death by SIGALRM."""
    slow = "import atexit, time; atexit.register(time.sleep, 0.1)"
    for last in ("", f"; {slow}"):
        done = hooked("yaml", f"{send(name)}{last}; raise {error}", "robots")
        assert (done.returncode, done.stdout) == (code, ""), done.stderr
        assert done.stderr.startswith(f"robodyn: {message.partition(';')[0]}")
        assert done.stderr.count("\n") == 1


@pytest.mark.usefixtures("elsewhere")
@pytest.mark.parametrize(("name", "code"), [("SIGINT", 130), ("SIGTERM", 143)])
def test_a_signal_that_waits_when_robodyn_cannot_be_imported(name: str, code: int) -> None:
    """Once signals are listened for: a module that the command's own table imports."""
    then = f"{send(name)}; raise ImportError('no', name='robodyn_cli.robots')"
    done = hooked("robodyn_cli.robots", then, "robots")
    assert done.returncode == code, done.stderr


def test_a_signal_that_was_lost_when_the_command_fails() -> None:
    """Raised in a destructor while an error is on its way, it is raised once more unless the work is over."""
    done = python(
        LISTENING
        + "class Last:\n"
        + "    def __del__(self):\n        os.kill(os.getpid(), signal.SIGINT)\n        time.sleep(0)\n"
        + "from robodyn_cli.failures import guard\nfrom robodyn.errors import InputError\n"
        + "def work():\n    last = Last()\n    del last\n    raise InputError('wrong')\n"
        + "code = guard(work)\nsys.exit(code)\n"
    )
    assert (done.returncode, done.stderr) == (130, "robodyn: error: wrong\n")


def test_a_library_that_does_not_come_back() -> None:
    require_module("hashlib")
    done = python(
        LISTENING
        + "process.GRACE = 0.1\n"
        + "import hashlib, threading\n"
        + "threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGTERM)).start()\n"
        + "def long():\n    hashlib.pbkdf2_hmac('sha256', b'', b'', (1 << 31) - 1)\n"  # minutes, one call
        + "try:\n    long()\nexcept process.Ended:\n    long()\n"  # it may come before or in it
    )
    assert (done.returncode, done.stdout, done.stderr) == (143, "", "")


@pytest.mark.parametrize(
    ("when", "name", "code"), covering(["--version", "compile"], [("SIGINT", 130), ("SIGTERM", 143)])
)
def test_a_compiler_that_hangs_goes_with_its_command(
    elsewhere: Path, name: str, code: int, when: str
) -> None:
    require_tool("sh")
    notes, tool = elsewhere / "ids", elsewhere / "cc"
    hang = f"sleep 1000 & echo $! $$ > {notes}; sleep 1000"
    known = "echo hanging cc 1.0; exit" if when == "compile" else hang
    tool.write_text(f'#!/bin/sh\ncase "$1" in --version) {known};; -dumpmachine) exit;; *) {hang};; esac\n')
    tool.chmod(tool.stat().st_mode | stat.S_IXUSR)
    (elsewhere / "tmp").mkdir()
    path = os.pathsep.join(each for each in sys.path if each)
    process = subprocess.Popen(
        [sys.executable, "-m", "robodyn", "gen", "stanford_3dof", "-o", "out", "--compile"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": path, "CC": str(tool), "ROBODYN_CACHE": str(elsewhere / "cache"),
             "TMPDIR": str(elsewhere / "tmp")},
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )  # fmt: skip
    try:
        assert eventually(lambda: process.poll() or (notes.exists() and len(notes.read_text().split()) == 2))
        process.send_signal(getattr(signal, name))
        out, err = process.communicate()
    finally:
        process.kill()
        process.wait()
    assert process.returncode == code, err
    assert [line for line in err.splitlines() if "warning" not in line] == [
        "robodyn: interrupted" if code == 130 else "robodyn: terminated"
    ]
    assert "Traceback" not in out + err
    ids = [int(text) for text in notes.read_text().split()]
    assert eventually(lambda: not any(map(runs, ids)))
    assert not list(elsewhere.rglob("unfinished-*"))
    assert not list((elsewhere / "tmp").iterdir())
    assert not list(elsewhere.rglob("*.tmp"))


# --- what cannot be imported ------------------------------------------------------------------------------

FEW = "import resource; resource.setrlimit(resource.RLIMIT_NOFILE, (3, 3))"


@pytest.mark.usefixtures("elsewhere")
@pytest.mark.parametrize(
    "module",
    ["robodyn_cli.entry", "robodyn_cli.main", "click", "click.core", "robodyn_cli.gen",
     "robodyn.kernels.generate",
     "yaml", "jinja2", "robodyn.optimize.records.find"],
)  # fmt: skip
def test_too_few_open_files(module: str) -> None:
    require_module("resource")
    done = hooked(module, FEW, "gen", "stanford_3dof", "-o", "out")
    assert (done.returncode, done.stdout) == (74, ""), done.stderr
    assert done.stderr.startswith("robodyn: error: the limit of open files is too low: ")
    assert done.stderr.endswith("raise it with ulimit -n 256\n")
    assert done.stderr.count("\n") == 1
    assert not Path("out").exists()


@pytest.mark.usefixtures("elsewhere")
@pytest.mark.parametrize(
    ("module", "error"),
    covering(["click", "click.core", "yaml", "jinja2"], ["ModuleNotFoundError", "ImportError"]),
)
def test_a_library_that_is_missing(module: str, error: str) -> None:
    done = hooked(
        module, f"raise {error}('No module named {module}', name='{module}')", "gen", "stanford_3dof"
    )
    assert (done.returncode, done.stdout) == (3, "")
    assert done.stderr.startswith("robodyn: error: ")
    assert module in done.stderr
    assert done.stderr.count("\n") == 1


@pytest.mark.usefixtures("elsewhere")
def test_a_module_of_ours_that_is_broken_is_a_bug() -> None:
    then = "raise ImportError('cannot import name x from robodyn.robot', name='robodyn.robot')"
    done = hooked("robodyn.robot", then, "robots")
    assert done.returncode == 70
    assert "internal error" in done.stderr


@pytest.mark.usefixtures("elsewhere")
def test_a_lack_of_memory_is_no_bug() -> None:
    done = hooked("yaml", "raise MemoryError", "robots")
    assert (done.returncode, done.stderr) == (
        74,
        "robodyn: error: the operating system refused: out of memory\n",
    )
