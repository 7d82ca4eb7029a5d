"""By path or by name, what is said when neither is there, and what reading costs."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from robodyn import resources
from robodyn.errors import InputError, ToolError
from robodyn.robot import bundled_text, load, read_text
from robodyn_testing.clocks import calls_of

ARM = "name: arm\nlinks: [{joint: revolute, mass: 1}]\n"


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_by_path_or_by_name(tmp_path: Path) -> None:
    """An existing file wins over a bundled name, a folder does not hide it."""
    file = tmp_path / "my arm.yaml"
    file.write_text(ARM)
    assert load(file) == load(str(file)) == load("my arm.yaml") == read_text(ARM)
    (tmp_path / "ur5").mkdir()
    assert load("ur5") == load("ur5.yaml") == read_text(bundled_text("ur5"))
    assert bundled_text("ur5") == bundled_text("ur5.yaml")
    (tmp_path / "ur5.yaml").write_text(ARM)
    assert load("ur5.yaml").name == "arm"
    for name in ("nobody", "../robots/ur5", ""):
        with pytest.raises(InputError, match="there is neither"):
            bundled_text(name)


def test_messages_call_a_bundled_robot_by_its_file() -> None:
    wanted = r"\Apuma560\.yaml:\d+:\d+: link 3: inertia is not physical: Ixx \+ Iyy = 0\.0785 < Izz = 0\.086 "
    with pytest.raises(InputError, match=wanted):
        load("puma560", strict=True)


@pytest.mark.parametrize(
    ("spec", "message"),
    [
        ("a\0b", "a\\x00b: there is neither a file"),
        ("a\nb", "a\\nb: there is neither a file"),
        ("\udcff.yaml", "\\udcff.yaml: there is neither a file"),
        ("x" * 5000, "the file cannot be read; found file name too long"),
    ],
)
def test_what_is_no_name_of_a_file(spec: str, message: str) -> None:
    """What is not there: cli/golden/flops.txt."""
    with pytest.raises(InputError) as caught:
        load(spec)
    told = str(caught.value)
    assert message in told
    assert "\n" not in told
    assert caught.value.exit_code == 2
    told.encode("utf-8")


def test_a_file_that_may_not_be_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "arm.yaml").write_text(ARM)

    def refuse(*_: object) -> bytes:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("robodyn.robot.bundled._start_of", refuse)
    with pytest.raises(InputError, match=r"\Aarm\.yaml: the file cannot be read; found permission denied\Z"):
        load("arm.yaml")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="missing: os.mkfifo; only POSIX has it")
def test_pipes_and_devices_are_refused_unopened(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "ff")
    for spec in ("ff", "/dev/zero", "/dev/null"):
        with pytest.raises(InputError, match=f"^{spec}: this is not a regular file; expected a robot"):
            load(spec)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="missing: os.mkfifo; only POSIX has it")
def test_a_file_that_only_calls_itself_regular(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As /proc/kmsg does; without a writer it ends at once, with one it would wait."""
    monkeypatch.setattr("robodyn.files.S_ISREG", lambda _: True)
    os.mkfifo(tmp_path / "kmsg")
    with pytest.raises(InputError, match="kmsg:1:1: the file is empty"):
        load("kmsg")
    held = os.open(tmp_path / "kmsg", os.O_RDWR)
    try:
        with pytest.raises(InputError, match="kmsg: the file cannot be read; found nothing to read yet"):
            load("kmsg")
    finally:
        os.close(held)
    with pytest.raises(InputError, match="/dev/zero: the file is too large"):
        load("/dev/zero")  # an endless file ends


def test_data_of_a_wheel_comes_first_and_none_is_an_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    package = tmp_path / "site" / "packages" / "robodyn"
    package.mkdir(parents=True)
    monkeypatch.setattr(resources, "__file__", str(package / "resources.py"))
    with pytest.raises(ToolError, match="the bundled robots are missing from this installation") as caught:
        resources.data_dir("robots")
    assert caught.value.exit_code == 3
    checkout = tmp_path / "site" / "robots"
    checkout.mkdir()
    assert resources.data_dir("robots") == checkout
    wheel = package / "_data" / "robots"
    wheel.mkdir(parents=True)
    assert resources.data_dir("robots") == wheel
    with pytest.raises(ValueError, match="no data of kind"):
        resources.data_dir("recipes")  # type: ignore[arg-type]


def test_reading_is_quick() -> None:
    load("ur5")  # what is imported and kept for later is done once
    calls_of(lambda: load("ur5"), most=20_000)  # ten milliseconds


def test_reading_loads_neither_numpy_nor_sympy() -> None:
    program = (
        "import sys, robodyn.robot as r\n"
        "assert 'yaml' not in sys.modules\n"
        "r.to_yaml(r.load('ur5')); r.json_schema(); r.starter()\n"
        "print([m for m in ('numpy', 'sympy', 'scipy', 'jinja2') if m in sys.modules])"
    )
    root = str(Path(resources.__file__).parents[1])
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True, env={"PYTHONPATH": root}
    )
    assert done.stdout == "[]\n", done.stderr
