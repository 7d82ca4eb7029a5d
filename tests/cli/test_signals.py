"""Signals and a lack of open files, at whatever moment: a line at most, the right exit code, nothing left."""

from __future__ import annotations

import os
import signal
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from cli.command import environment, heed, python
from robodyn_testing import require_module, require_tool
from robodyn_testing.waiting import eventually, runs

pytestmark = [
    pytest.mark.skipif(not hasattr(signal, "SIGALRM"), reason="missing: POSIX signals"),
    pytest.mark.usefixtures("site"),
]

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
def site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "site").mkdir()
    (tmp_path / "site" / "sitecustomize.py").write_text(HOOK)
    return tmp_path


def hooked(when: str, then: str, line: str = "-m robodyn robots") -> subprocess.CompletedProcess[str]:
    """``python LINE`` that does ``then`` when it first looks for the module ``when``."""
    path = os.pathsep.join([str(Path("site").absolute()), *(each for each in sys.path if each)])
    return python(*line.split(), PYTHONPATH=path, WHEN=when, THEN=then)


def send(name: str) -> str:
    return f"os.kill(os.getpid(), signal.{name})"


@pytest.mark.parametrize(
    ("module", "line"),
    [
        ("robodyn.process", "-m robodyn"),
        pytest.param("click", "-m robodyn_cli", marks=pytest.mark.thorough),
        ("robodyn_cli.entry", "robodyn"),
    ],
)
def test_a_signal_while_it_begins(module: str, line: str) -> None:
    Path("robodyn").write_text("import sys\nfrom robodyn_cli.entry import main\nsys.exit(main())\n")
    for number in (signal.SIGINT, signal.SIGTERM):
        done = hooked(module, send(number.name), f"{line} robots")
        assert done.returncode in (-number, 128 + number)
        assert (done.stdout, done.stderr) == ("", "")


@pytest.mark.parametrize(
    ("module", "name", "code", "word"),
    [
        ("yaml", "SIGINT", 130, "interrupted"),
        ("robodyn.robot.values", "SIGTERM", 143, "terminated"),
        ("robodyn_cli.robots", "SIGHUP", 129, "hung up"),
    ],
)
def test_a_signal_while_it_works(module: str, name: str, code: int, word: str) -> None:
    """The first one counts."""
    done = hooked(module, f"{send(name)}; {send('SIGINT')}; {send('SIGTERM')}")
    assert (done.returncode, done.stdout, done.stderr) == (code, "", f"robodyn: {word}\n")


def test_what_is_ignored_stays_ignored() -> None:
    ignoring = "import os, signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\n"
    for module in ("click", "robodyn_cli.robots"):
        Path("start.py").write_text(
            f"{ignoring}import sys\nos.execv(sys.executable, [sys.executable, '-m', 'robodyn', 'robots'])\n"
        )
        done = hooked(module, send("SIGINT"), "start.py")
        assert (done.returncode, done.stderr) == (0, "")
        assert "puma560" in done.stdout.split()


def test_a_library_leaves_signals_alone() -> None:
    names = "robodyn, robodyn.process, robodyn_cli, robodyn_cli.main, robodyn_cli.entry"
    Path("other.py").write_text(
        f"import {names}\nimport signal\n"
        "assert signal.getsignal(signal.SIGINT) is signal.default_int_handler\n"
    )
    for line in ("other.py", "-m other"):
        done = hooked("", "", line)
        assert (done.returncode, done.stderr) == (0, "")


LISTENING = "import gc, os, signal, sys, time\nfrom robodyn import process\nprocess.listen()\n"
KILL = "os.kill(os.getpid(), signal.SIGTERM)\n"
LAST = f"class Last:\n    def __del__(self):\n        {KILL}        time.sleep(0)\n"
TELL = "except process.Ended:\n    print(process.received())\n"


@pytest.mark.parametrize(
    ("program", "code", "out", "err"),
    [
        pytest.param(
            f"{LAST}try:\n    last = Last()\n    del last\n    while True:\n        time.sleep(0.01)\n{TELL}",
            0, "(143, 'terminated')\n", "", id="in a destructor, it is not lost",
        ),
        pytest.param(
            f"try:\n    with process.Held():\n        {KILL}        time.sleep(0.2)\n"
            f"        print('whole', flush=True)\n    time.sleep(60)\n{TELL}",
            0, "whole\n(143, 'terminated')\n", "", id="it waits for what must not be torn",
        ),
        pytest.param(f"process.quiet()\n{KILL}", 0, "", "", id="when the work is done, none matters"),
        pytest.param(
            f"process.PATIENCE = 0\nprocess.quiet()\ntime.sleep(0.01)\n{KILL}time.sleep(60)",
            143, "", "", id="unless the end takes long",
        ),
        pytest.param(
            f"{LAST}from robodyn_cli.failures import guard\nfrom robodyn.errors import InputError\n"
            "def work():\n    last = Last()\n    del last\n    raise InputError('wrong')\n"
            "sys.exit(guard(work))\n",
            143, "", "robodyn: error: wrong\n", id="lost in an error, it is raised once more",
        ),
        pytest.param(  # minutes, in one call; the signal may come before it or in it
            "process.GRACE = 0.1\nimport hashlib, threading\n"
            "threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGTERM)).start()\n"
            "def long():\n    hashlib.pbkdf2_hmac('sha256', b'', b'', (1 << 31) - 1)\n"
            "try:\n    long()\nexcept process.Ended:\n    long()\n",
            143, "", "", id="a library that does not come back",
        ),
    ],
)  # fmt: skip
def test_a_signal_in_a_program(program: str, code: int, out: str, err: str) -> None:
    done = python("-c", LISTENING + program)
    assert (done.returncode, done.stdout, done.stderr) == (code, out, err)


def test_an_interrupt_of_a_program_of_somebody_else_waits_too() -> None:
    done = python(
        "-c",
        "import os, signal\nfrom robodyn.process import Held\n"
        "try:\n    with Held() as held:\n        os.kill(os.getpid(), signal.SIGINT)\n"
        "        print('whole', held.has_signal)\n    print('never')\n"
        "except KeyboardInterrupt:\n"
        "    print(signal.getsignal(signal.SIGINT) is signal.default_int_handler)\n",
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "whole True\nTrue\n", "")


def test_a_signal_that_waits_when_the_command_fails() -> None:
    """Its timer would run out when the interpreter has taken back its handlers: a death by SIGALRM."""
    late = "import atexit, time; atexit.register(time.sleep, 0.1)"
    done = hooked("yaml", f"{send('SIGTERM')}; {late}; raise MemoryError")
    assert (done.returncode, done.stdout) == (143, ""), done.stderr
    assert done.stderr == "robodyn: error: the operating system refused: out of memory\n"
    # Once signals are listened for: a module that the command's own table imports.
    then = f"{send('SIGINT')}; raise ImportError('no', name='robodyn_cli.robots')"
    assert hooked("robodyn_cli.robots", then).returncode == 130


@pytest.mark.parametrize("when", ["--version", pytest.param("compile", marks=pytest.mark.thorough)])
def test_a_compiler_that_hangs_goes_with_its_command(when: str, site: Path) -> None:
    require_tool("sh")
    notes, tool = site / "ids", site / "cc"
    hang = f"sleep 1000 & echo $! $$ > {notes}; sleep 1000"
    known = "echo hanging cc 1.0; exit" if when == "compile" else hang
    tool.write_text(f'#!/bin/sh\ncase "$1" in --version) {known};; -dumpmachine) exit;; *) {hang};; esac\n')
    tool.chmod(tool.stat().st_mode | stat.S_IXUSR)
    (site / "tmp").mkdir()
    process = subprocess.Popen(
        [sys.executable, "-m", "robodyn", "gen", "stanford_3dof", "-o", "out", "--compile"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environment(CC=str(tool), ROBODYN_CACHE=str(site / "cache"), TMPDIR=str(site / "tmp")),
        preexec_fn=heed,
    )
    try:
        assert eventually(lambda: process.poll() or (notes.exists() and len(notes.read_text().split()) == 2))
        process.send_signal(signal.SIGINT)
        out, err = process.communicate()
    finally:
        process.kill()
        process.wait()
    assert process.returncode == 130, err
    assert [line for line in err.splitlines() if "warning" not in line] == ["robodyn: interrupted"]
    assert "Traceback" not in out + err
    ids = [int(text) for text in notes.read_text().split()]
    assert eventually(lambda: not any(map(runs, ids)))
    assert not [*site.rglob("unfinished-*"), *(site / "tmp").iterdir(), *site.rglob("*.tmp")]


# --- what cannot be imported ------------------------------------------------------------------------------

FEW = "import resource; resource.setrlimit(resource.RLIMIT_NOFILE, (3, 3))"
GEN = "-m robodyn gen stanford_3dof -o out"


@pytest.mark.parametrize(
    "module", ["robodyn_cli.entry", pytest.param("click", marks=pytest.mark.thorough), "yaml"]
)
def test_too_few_open_files(module: str) -> None:
    require_module("resource")
    done = hooked(module, FEW, GEN)
    assert (done.returncode, done.stdout) == (74, ""), done.stderr
    assert done.stderr.startswith("robodyn: error: the limit of open files is too low: ")
    assert done.stderr.endswith("raise it with ulimit -n 256\n")
    assert done.stderr.count("\n") == 1
    assert not Path("out").exists()


@pytest.mark.parametrize(("module", "error"), [("click", "ModuleNotFoundError"), ("yaml", "ImportError")])
def test_a_library_that_is_missing(module: str, error: str) -> None:
    done = hooked(module, f"raise {error}('No module named {module}', name='{module}')", GEN)
    assert (done.returncode, done.stdout) == (3, "")
    assert done.stderr.startswith("robodyn: error: ")
    assert module in done.stderr
    assert done.stderr.count("\n") == 1


def test_a_module_of_ours_that_is_broken_is_a_bug() -> None:
    then = "raise ImportError('cannot import name x from robodyn.robot', name='robodyn.robot')"
    done = hooked("robodyn.robot", then)
    assert done.returncode == 70
    assert "internal error" in done.stderr
