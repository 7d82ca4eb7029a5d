"""``robodyn build``: what is written, that nothing is done twice, and what is refused."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

import robodyn_cli.building
from cli.built import FILES, PROJECT, build, outputs
from cli.generated import Capture, tree
from records.made import ELBOW
from robodyn_cli.main import main


@pytest.fixture
def generated(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The names of the robots whose kernels are generated in this process."""
    names: list[str] = []
    carry_out = robodyn_cli.building.carry_out

    def noted(job: Any, root: Path) -> Any:
        names.append(job.name)
        return carry_out(job, root)

    monkeypatch.setattr(robodyn_cli.building, "carry_out", noted)
    return names


def test_it_writes_what_gen_writes(project: Path, capsys: Capture) -> None:
    build()
    out = capsys.readouterr().out
    assert "wrote firmware/two/other.c\n" in out
    assert set(tree(project)) == FILES | {"elbow.yaml", "other.yaml", "robodyn.toml"}
    options = ["--functions", "inverse_dynamics,gravity", "--lang", "c"]
    assert main(["gen", "elbow.yaml", *options, "-o", "gen/one"]) == 0
    assert main(["gen", "other.yaml", *options, "--scalar", "float", "-o", "gen/two"]) == 0
    assert tree(project / "generated" / "one") == tree(project / "gen" / "one")
    assert tree(project / "firmware" / "two") == tree(project / "gen" / "two")


def test_nothing_is_done_twice(project: Path, generated: list[str], capsys: Capture) -> None:
    build()
    assert generated == ["one", "two"]
    times = {name: (project / name).stat().st_mtime_ns for name in FILES}
    capsys.readouterr()
    build()
    build("--check")
    assert generated == ["one", "two"]
    assert times == {name: (project / name).stat().st_mtime_ns for name in FILES}
    out, err = capsys.readouterr()
    assert re.fullmatch(r"(2 robots, 4 functions, \d+ operations; no count changed\n){2}", out)
    assert err == ""


@pytest.mark.parametrize(
    ("file", "before", "after"),
    [
        ("other.yaml", "mass: 1.5", "mass: 1.6"),
        ("robodyn.toml", 'scalar = "float"', 'trig = "builtin"'),
        ("records/other.inverse_dynamics.total.record", "", "no record, but it might be one"),
    ],
)
def test_what_changed_is_done_alone(
    file: str, before: str, after: str, project: Path, generated: list[str]
) -> None:
    (project / "two").mkdir()
    (project / "other.yaml").rename(project / "two" / "other.yaml")
    text = PROJECT.replace("other.yaml", "two/other.yaml")
    (project / "robodyn.toml").write_text(text)
    build()
    path = project / file if file == "robodyn.toml" else project / "two" / file
    path.parent.mkdir(exist_ok=True)
    path.write_text((path.read_text() if path.exists() else "").replace(before, after) if before else after)
    generated.clear()
    build()
    assert generated == ["two"]
    path.write_text(text if file == "robodyn.toml" else ELBOW.replace("elbow", "other"))
    if before:  # what was generated once is still known
        generated.clear()
        build()
        assert generated == []


def test_another_robodyn_generates_anew(
    project: Path, generated: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from robodyn.project import fingerprint

    build()
    monkeypatch.setattr(fingerprint, "own_key", lambda: "other sources")
    build()
    assert generated == ["one", "two"] * 2


def test_a_file_that_somebody_changed_is_written_again_without_generating(
    project: Path, generated: list[str], capsys: Capture
) -> None:
    build()
    wanted = outputs(project)
    with (project / "generated/one/elbow.c").open("a") as file:  # its head says what becomes of that
        file.write("/* edited */\n")
    (project / "firmware/two/other.h").unlink()
    generated.clear()
    capsys.readouterr()
    build("--json")
    assert json.loads(capsys.readouterr().out)["written"] == ["generated/one/elbow.c", "firmware/two/other.h"]
    assert outputs(project) == wanted
    assert generated == []


def test_a_damaged_store_is_mended(project: Path, tmp_path: Path, generated: list[str]) -> None:
    build()
    wanted = outputs(project)
    for path in (tmp_path / "cache").glob("*/texts/*.c"):
        path.write_text("damaged")
    for name in FILES:
        (project / name).unlink()
    build()
    assert outputs(project) == wanted
    assert generated == ["one", "two"] * 2


def test_the_same_bytes_with_many_processes(
    project: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    build()
    wanted = outputs(project)
    monkeypatch.setenv("ROBODYN_CACHE", str(tmp_path / "other"))
    for name in FILES:
        (project / name).unlink()
    assert main(["build", "--workers", "3"]) == 0
    assert outputs(project) == wanted


def test_from_another_folder(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    build()
    wanted = outputs(project)
    (project / "elsewhere").mkdir()
    for name in FILES:
        (project / name).unlink()
    monkeypatch.chdir(project / "elsewhere")
    build("--file", "../robodyn.toml")
    assert outputs(project) == wanted


def test_notes_are_told_whether_kernels_are_generated_or_in_the_store(project: Path, capsys: Capture) -> None:
    (project / "elbow.yaml").write_text(ELBOW.replace("xx: 0.2", "xx: 2"))
    build()
    notes = capsys.readouterr().err
    assert "robodyn: warning: elbow.yaml:6:" in notes
    build()
    assert capsys.readouterr().err == notes


def test_packages_are_written_with_the_kernels(project: Path, generated: list[str], capsys: Capture) -> None:
    """What robodyn package writes, with the robot's options; locked, checked and left alone like kernels."""
    text = (project / "robodyn.toml").read_text()
    (project / "robodyn.toml").write_text(
        f'{text}packages.cmake = {{ version = "1.2.0", functions = ["gravity"] }}\n'
        '[robots.one.packages.crate]\noutput = "crate"\n'
    )
    build()
    assert generated == ["one", "one/crate", "two", "two/cmake"]
    out = capsys.readouterr().out
    assert "two/cmake  gravity " in out
    assert out.endswith("operations; 7 changed\n")
    assert "2 robots, 2 packages, 7 functions, " in out
    options = ["--functions", "gravity", "--scalar", "float", "--version", "1.2.0"]
    assert main(["package", "other.yaml", "--as", "cmake", *options, "-o", "packaged"]) == 0
    assert tree(project / "packages" / "two" / "cmake") == tree(project / "packaged")
    assert '[robots."two/cmake".counts]' in (project / "robodyn.lock").read_text()
    generated.clear()
    build("--check")
    assert not generated
    capsys.readouterr()
    (project / "crate" / "src" / "lib.rs").write_text("// mine\n")
    build("--check", code=1)
    assert "crate/src/lib.rs differs from line 1 on: found '// mine'" in capsys.readouterr().err


@pytest.mark.thorough
def test_firmware_is_written_as_gen_writes_it(project: Path) -> None:
    """But for the README, which has what one machine measured."""
    text = PROJECT.replace('scalar = "float"', 'firmware = true\ntarget = "cortex-m4f"')
    (project / "robodyn.toml").write_text(text)
    build()
    options = ["--functions", "inverse_dynamics,gravity", "--lang", "c", "--target", "cortex-m4f"]
    assert main(["gen", "other.yaml", "--firmware", *options, "-o", "gen"]) == 0
    own = tree(project / "firmware" / "two")
    assert {**own, "firmware/README.md": ""} == {**tree(project / "gen"), "firmware/README.md": ""}
    assert "firmware/link.ld" in own
    build("--check")
