"""A scheduler of Dask's and its workers, as processes of their own: started, killed, started again."""

from __future__ import annotations

import contextlib
import os
import shlex
import signal
import socket
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from types import TracebackType
from typing import Final

from robodyn_testing.wanted import require_tool

__all__ = ["Machines", "certificates", "kill"]

#: [s] Dask waits so long before it believes that something is gone.
_QUICK: Final = {"DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT": "5s"}


class Machines:
    """What runs in a test: the scheduler at ``address`` (HOST:PORT), and workers. Their messages go to files
    in ``folder``; ``environment`` is added to theirs."""

    def __init__(
        self, folder: Path, environment: Mapping[str, str] | None = None, scheme: str = "tcp"
    ) -> None:
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.address = f"127.0.0.1:{free.getsockname()[1]}"
        self._folder, self._scheme = folder, scheme
        self._environment = {**os.environ, **_QUICK, **(environment or {}), "PYTHONPATH": _imports()}
        self._processes: list[subprocess.Popen[bytes]] = []

    def __enter__(self) -> Machines:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        for process in self._processes:
            kill(process)

    def scheduler(self) -> subprocess.Popen[bytes]:
        """Start the scheduler; it is there when somebody connects."""
        host, port = self.address.split(":")
        where = ("--host", f"{self._scheme}://{host}", "--port", port)
        return self._start("scheduler", *where, "--no-dashboard", "--dashboard-address", ":0")

    def worker(self, *options: str) -> subprocess.Popen[bytes]:
        """Start a worker with its nanny, which starts it again when it ends."""
        words = ("--nthreads", "1", "--no-dashboard", "--local-directory", str(self._folder))
        return self._start("worker", f"{self._scheme}://{self.address}", *words, *options)

    def messages(self) -> str:
        """What all of them have said."""
        return "\n".join(path.read_text() for path in sorted(self._folder.glob("*.messages")))

    def _start(self, *words: str) -> subprocess.Popen[bytes]:
        path = self._folder / f"{len(self._processes)}-{words[0]}.messages"
        with path.open("wb") as messages:
            process = subprocess.Popen(
                [sys.executable, "-m", "dask", *words],
                env=self._environment,
                cwd=self._folder,
                stdin=subprocess.DEVNULL,
                stdout=messages,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )
        self._processes.append(process)
        return process


def kill(process: subprocess.Popen[bytes]) -> None:
    """End it and whatever it has started, at once."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


def certificates(folder: Path) -> tuple[Path, Path, Path]:
    """The certificate of an authority, one that it has signed, and the key of that, by the commands of
    docs/fleet-cluster.md."""
    require_tool("openssl")
    text = (Path(__file__).parents[2] / "docs" / "fleet-cluster.md").read_text(encoding="utf-8")
    block = text.partition("<!-- certificates -->")[2].partition("```console\n")[2].partition("```")[0]
    commands = [line.removeprefix("$ ") for line in block.splitlines()]
    assert len(commands) == 3
    for command in commands:
        words = shlex.split(command)
        assert words[0] == "openssl"
        subprocess.run(words, cwd=folder, check=True, capture_output=True)
    return folder / "authority.pem", folder / "fleet.pem", folder / "fleet.key"


def _imports() -> str:
    """The paths that Python imports from here, for processes."""
    return os.pathsep.join(path or str(Path.cwd()) for path in sys.path)
