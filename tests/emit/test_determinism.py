"""The same bytes from the same input: in every process, on every Python, and as committed."""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
import tomllib
from functools import cache
from pathlib import Path

import pytest

from emit.kernels import made, robots
from robodyn.robot import bundled_names, to_yaml
from robodyn_testing import sampled

ROOT = Path(__file__).parents[2]
NAMES = ("stanford_3dof", "tool", "smooth")
SCRIPT = """
import hashlib, json, sys
from robodyn.kernels.generate import Options, generate
from robodyn.robot import read_text
robots = json.load(sys.stdin)
found = {}
for name, text in robots.items():
    robot = read_text(text, warn=lambda _: None)
    for trig in ("libm", "given"):
        for file, content in generate(robot, Options(trig=trig)).files().items():
            found[f"{trig} {file}"] = hashlib.sha256(content.encode()).hexdigest()
json.dump(found, sys.stdout)
"""


@cache
def texts() -> str:
    return json.dumps({name: to_yaml(robots()[name]) for name in NAMES})


@cache
def expected() -> dict[str, str]:
    """Hashes of the files that this process makes."""
    found = {}
    for name in NAMES:
        for trig in ("libm", "given"):
            for file, content in made(name, trig).files().items():
                found[f"{trig} {file}"] = hashlib.sha256(content.encode()).hexdigest()
    return found


def hashes(python: str, **environment: str) -> dict[str, str]:
    """Hashes of the files that another process makes."""
    done = subprocess.run(
        [python, "-c", SCRIPT],
        input=texts(),
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=True,
    )
    found: dict[str, str] = json.loads(done.stdout)
    return found


@pytest.mark.parametrize("seed", ["0", "4242"])
def test_hash_seeds_make_no_difference(seed: str, tmp_path: Path) -> None:
    """Nor does the locale, the time zone, or the folder."""
    other = {"LC_ALL": "C", "TZ": "Pacific/Auckland", "HOME": str(tmp_path)} if seed == "0" else {}
    assert hashes(sys.executable, PYTHONHASHSEED=seed, **other) == expected()


GENERATED = ROOT / "generated"
COMMITTED = sorted(path.name for path in GENERATED.glob("*/")) if GENERATED.is_dir() else []


def test_every_bundled_robot_is_committed() -> None:
    project = tomllib.loads((ROOT / "robodyn.toml").read_text(encoding="utf-8"))
    assert set(COMMITTED) == set(project["robots"]) == set(bundled_names())


@pytest.mark.parametrize("name", sampled(COMMITTED, every=8, rest="slow"))  # make generated-check has all
def test_the_committed_kernels_are_what_is_generated(name: str) -> None:
    folder = GENERATED / name
    files = made(name).files()
    assert {path.name for path in folder.iterdir()} == set(files)
    for file, text in files.items():
        assert (folder / file).read_bytes() == text.encode(), f"{name}/{file}: run `make generated`"
