"""Clean virtual environments, as of somebody who installs robodyn for the first time."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

_HIDDEN = frozenset({"PYTHONPATH", "PYTHONHOME", "VIRTUAL_ENV"})


def clean_environment(folder: Path) -> Path:
    """``folder`` as a virtual environment with nothing in it, without even pip."""
    run(sys.executable, "-m", "venv", "--without-pip", folder, cwd=folder.parent)
    return folder


def pip_install(environment: Path, *arguments: str | Path) -> None:
    """Install into ``environment`` with the pip of this interpreter."""
    pip: list[str | Path] = [sys.executable, "-m", "pip", "--python", environment / "bin" / "python"]
    run(*pip, "install", "--quiet", "--disable-pip-version-check", *arguments, cwd=environment)


def run(*command: str | Path, cwd: Path, variables: Mapping[str, str] | None = None) -> str:
    """The stdout of ``command`` in ``cwd``, away from the checkout's own environment; it must end in 0.

    ``variables`` take the place of all of the environment's.
    """
    environment = {name: value for name, value in os.environ.items() if name not in _HIDDEN}
    done = subprocess.run(
        [*command],
        cwd=cwd,
        env=environment if variables is None else dict(variables),
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout
