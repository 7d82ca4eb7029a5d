"""``robodyn completion``, and what real shells make of it."""

from __future__ import annotations

import json
import os
import select
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from time import monotonic

import pytest

from cli.command import Capture, run
from cli.command import environment as processes_see
from robodyn_cli.completion import SHELLS, script
from robodyn_testing.wanted import require_module, require_tool

PLACES = {
    "bash": ".local/share/bash-completion/completions/robodyn",
    "zsh": ".local/share/zsh/site-functions/_robodyn",
    "fish": ".config/fish/completions/robodyn.fish",
}


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name in ("XDG_DATA_HOME", "XDG_CONFIG_HOME", "BASH_COMPLETION_USER_DIR", "SHELL"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("HOME", str(tmp_path))
    return tmp_path


class TestInstalling:
    @pytest.mark.parametrize("shell", SHELLS)
    def test_it_is_written(self, shell: str, home: Path, capsys: Capture) -> None:
        path = home / PLACES[shell]
        for _ in range(2):
            out, _ = run(capsys, f"completion {shell} --install")
            assert out.startswith(f"wrote {path}\n")
            assert path.read_text(encoding="utf-8") == script(shell)
            path.write_text(script(shell) + "# of an older robodyn\n", encoding="utf-8")
        assert list(path.parent.iterdir()) == [path]

    def test_folders_that_the_user_has_chosen(
        self, home: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
    ) -> None:
        monkeypatch.setenv("XDG_DATA_HOME", str(home / "data"))
        monkeypatch.setenv("XDG_CONFIG_HOME", "relative: does not count")
        for shell, place in (
            ("bash", "data/bash-completion/completions/robodyn"),
            ("zsh", "data/zsh/site-functions/_robodyn"),
            ("fish", PLACES["fish"]),
        ):
            report = json.loads(run(capsys, f"completion {shell} --install --json")[0])
            assert report == {"shell": shell, "path": str(home / place)}
        monkeypatch.setenv("BASH_COMPLETION_USER_DIR", f"{home / 'own'}:/elsewhere")
        report = json.loads(run(capsys, "completion bash --install --json")[0])
        assert report["path"] == str(home / "own" / "completions" / "robodyn")

    def test_a_file_of_somebody_else_stays(self, home: Path, capsys: Capture) -> None:
        path = home / PLACES["fish"]
        path.parent.mkdir(parents=True)
        path.write_text("mine", encoding="utf-8")
        _, err = run(capsys, "completion fish --install", code=2)
        assert f"{path} is in the way, which robodyn did not write" in err
        assert path.read_text(encoding="utf-8") == "mine"

    def test_the_shell_is_that_of_the_environment(
        self, home: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
    ) -> None:
        assert "no shell is named" in run(capsys, "completion", code=2)[1]
        monkeypatch.setenv("SHELL", "/usr/bin/zsh")
        assert run(capsys, "completion")[0] == script("zsh")
        assert json.loads(run(capsys, "completion fish --json")[0])["script"] == script("fish")
        monkeypatch.setenv("SHELL", "/bin/tcsh")
        assert "the shell 'tcsh'; expected one of bash, zsh, fish" in run(capsys, "completion", code=2)[1]


class Terminal:
    """An interactive shell; what it says is read until something awaited is there."""

    def __init__(self, command: list[str], environment: dict[str, str], folder: Path) -> None:
        self._master, slave = require_module("pty").openpty()
        self._process = subprocess.Popen(
            command,
            stdin=slave,
            stdout=slave,
            stderr=slave,
            cwd=folder,
            env=environment,
            start_new_session=True,
        )
        os.close(slave)

    def send(self, keys: str) -> None:
        os.write(self._master, keys.encode())

    def until(self, awaited: str) -> str:
        """All that is said until ``awaited`` is."""
        said, end = b"", monotonic() + 60
        while awaited.encode() not in said:
            ready, _, _ = select.select([self._master], [], [], max(0.0, end - monotonic()))
            assert ready, f"no {awaited!r} in {said.decode(errors='replace')!r}"
            said += os.read(self._master, 1 << 16)
        return said.decode(errors="replace")

    def close(self) -> None:
        self._process.kill()
        self._process.wait()
        os.close(self._master)


START = {
    "bash": (["bash", "--norc", "-i"], "PS1=; source {script}"),
    "zsh": (
        ["zsh", "-f", "-i"],
        "unsetopt prompt_cr prompt_sp; PS1=; fpath=({folder} $fpath); autoload -Uz compinit; compinit -u -D; "
        "bindkey -e",
    ),
}


@pytest.fixture
def environment(home: Path, capsys: Capture) -> dict[str, str]:
    """A home with the scripts, and the command ``robodyn``."""
    program = home / "bin" / "robodyn"
    program.parent.mkdir()
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m robodyn "$@"\n', encoding="utf-8")
    program.chmod(0o755)
    (home / "measured.csv").write_text("", encoding="utf-8")
    (home / "results").mkdir()
    for shell in SHELLS:
        run(capsys, f"completion {shell} --install")
    path = f"{program.parent}:{os.environ['PATH']}"
    return processes_see(HOME=str(home), PATH=path, TERM="dumb")


@pytest.fixture
def terminal(shell: str, home: Path, environment: dict[str, str]) -> Iterator[Terminal]:
    command, setup = START[shell]
    require_tool(command[0])
    path = home / PLACES[shell]
    opened = Terminal(command, environment, home)
    try:
        opened.send(setup.format(script=path, folder=path.parent) + "; echo rea''dy\n")
        opened.until("ready")
        yield opened
    finally:
        opened.close()


COMPLETED = [
    ("robodyn tables 2.1", "0"),
    ("robodyn flops puma560 --objective weighted:aa", "rch64"),  # bash takes a colon for the end of a word
    ("robodyn gen puma560 --lang=c,fo", "rtran"),
    ("robodyn verify x --functions bias,momentum_", "observer_term"),
    ("robodyn simulate puma560 --torque=mea", "sured.csv"),
    ("robodyn gen mea", "sured.csv"),  # beside the names of robots
    ("robodyn gen x -o res", "ults"),
]


@pytest.mark.parametrize(
    ("shell", "lines"),
    [
        ("bash", COMPLETED[:3]),
        pytest.param("bash", COMPLETED[3:], marks=pytest.mark.thorough),
        pytest.param("zsh", COMPLETED, marks=pytest.mark.thorough),
    ],
    ids=["bash", "bash, more", "zsh"],
)
def test_a_line_is_completed(shell: str, lines: list[tuple[str, str]], terminal: Terminal) -> None:
    """The keys of a user, and what stands in the line then."""
    for begun, rest in lines:
        terminal.send(f"{begun}\t")
        terminal.until(rest)
        terminal.send("\x01echo '\x05|'\n")  # at the beginning, and at the end
        line = terminal.until("|\r\n").partition("|\r\n")[0].rpartition("\n")[2]
        assert line.rstrip(" /") == begun + rest


@pytest.mark.thorough
def test_fish_offers_the_same(home: Path, environment: dict[str, str]) -> None:
    require_tool("fish")
    for begun, rest in COMPLETED:
        ask = f"source {home / PLACES['fish']}; complete -C '{begun}'"
        done = subprocess.run(
            ["fish", "--no-config", "-c", ask],
            cwd=home, env=environment, capture_output=True, text=True, check=True,
        )  # fmt: skip
        offered = {line.partition("\t")[0] for line in done.stdout.splitlines()}
        assert {text.rstrip("/") for text in offered} == {begun.rpartition(" ")[2] + rest}, done.stderr
