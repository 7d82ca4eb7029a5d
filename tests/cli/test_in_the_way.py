"""Commands and what stands where they write: a file that somebody wrote, a link, a folder elsewhere."""

from __future__ import annotations

from pathlib import Path

import pytest

from cli.command import Capture, run, tree
from robodyn_testing import representative

MINE = "/* by hand */\n"
PROJECT = "[robots.stanford_3dof]\nfunctions = 'gravity'\nlang = 'c'\n"
COMMANDS = {
    "gen stanford_3dof --functions gravity --lang c -o out": "out/stanford_3dof.c",
    "gen stanford_3dof --functions gravity --lang c": "generated/stanford_3dof/stanford_3dof.c",
    "package stanford_3dof --as fpm -o out": "out/fpm.toml",
    "package stanford_3dof --as fpm": "packages/stanford_3dof/fpm/fpm.toml",
    "build": "generated/stanford_3dof/stanford_3dof.c",
}
ROWS = representative(COMMANDS.items(), "build", "package stanford_3dof --as fpm -o out", rest="slow")


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    work = tmp_path / "work"
    work.mkdir()
    monkeypatch.chdir(work)
    (work / "robodyn.toml").write_text(PROJECT)
    (tmp_path / "precious").write_text(MINE)
    return work


def refused(capsys: Capture, command: str) -> str:
    """What stderr says of a ``command`` that ends with 2 and leaves all as it is, here and beside."""
    before = tree(Path(".."))
    _, err = run(capsys, command, code=2)
    assert tree(Path("..")) == before
    return err


@pytest.mark.parametrize(("command", "output"), ROWS)
def test_a_file_that_somebody_wrote(command: str, output: str, capsys: Capture) -> None:
    Path(output).parent.mkdir(parents=True)
    Path(output).write_text(MINE)
    err = refused(capsys, command)
    assert f"{output} is in the way, which robodyn did not write" in err
    assert "--force" in err
    run(capsys, f"{command} --force")
    assert "Written by robodyn" in Path(output).read_text()
    run(capsys, command)


@pytest.mark.parametrize(("command", "output"), ROWS)
def test_a_link(command: str, output: str, here: Path, capsys: Capture) -> None:
    Path(output).parent.mkdir(parents=True)
    Path(output).symlink_to(here.parent / "precious")
    assert f"{output} is a symbolic link" in refused(capsys, command)
    run(capsys, f"{command} --force")
    assert (here.parent / "precious").read_text() == MINE
    assert not Path(output).is_symlink()


@pytest.mark.parametrize("command", [command for command in COMMANDS if "-o" not in command])
def test_a_folder_that_leads_elsewhere(command: str, here: Path, capsys: Capture) -> None:
    """Nobody has named it, other than that of ``-o``."""
    (here.parent / "elsewhere").mkdir()
    name = COMMANDS[command].partition("/")[0]
    Path(name).symlink_to(here.parent / "elsewhere")
    for force in ("", " --force"):
        assert f"{name} is a symbolic link" in refused(capsys, command + force)


@pytest.mark.parametrize("key", ["output", "packages.fpm.output"])
def test_an_output_of_a_project_that_leaves_it(key: str, capsys: Capture) -> None:
    for output in ("../out", "a/../../out", "a/..", "/tmp/out", "..\\\\out", "C:/out", "//host/out"):
        Path("robodyn.toml").write_text(f'{PROJECT}{key} = "{output}"\n')
        for command in ("build", "build --check", "build --force"):
            err = refused(capsys, command)
            assert "robodyn.toml:4:1: this output leaves the folder of the project file" in err


def test_a_description_may_lie_elsewhere(capsys: Capture) -> None:
    run(capsys, "new arm --joints 2 -o ../arm.yaml")
    Path("robodyn.toml").write_text(PROJECT.replace("stanford_3dof]", "arm]\nrobot = '../arm.yaml'"))
    run(capsys, "build")
    assert Path("generated/arm/arm.c").is_file()


@pytest.mark.parametrize("kind", ["file", "link"])
def test_nothing_of_a_build_is_written_where_one_file_is_in_the_way(kind: str, capsys: Capture) -> None:
    Path("robodyn.toml").write_text(f"{PROJECT}[robots.puma560_3dof]\nfunctions = 'gravity'\n")
    if kind == "file":
        Path("robodyn.lock").write_text("mine\n")
    else:
        Path("robodyn.lock").symlink_to("../precious")
    assert "robodyn.lock" in refused(capsys, "build")
    run(capsys, "build --force")
    assert Path("../precious").read_text() == MINE


@pytest.mark.parametrize(
    "command",
    representative(
        ["report stanford_3dof -o out.html", "tables 2.9 --picture out.svg", "build -o out.txt",
         "new arm -o out.yaml --force", "schedule stanford_3dof -p 2 --picture out.svg",
         "simulate stanford_3dof --duration 0.01 -o out.csv"],
        "build -o out.txt", "new arm -o out.yaml --force",
    ),
)  # fmt: skip
def test_a_file_of_the_command_line_that_is_a_link(command: str, capsys: Capture) -> None:
    """It is refused, or replaced by ``new --force``, and what it leads to stays."""
    name = next(word for word in command.split() if word.startswith("out."))
    Path(name).symlink_to("../precious")
    run(capsys, command, code=0 if "--force" in command else 2)
    assert Path("../precious").read_text() == MINE
    assert not Path("generated").exists()


def test_a_default_name_is_nobodys_choice(capsys: Capture) -> None:
    """A log that was recorded is not replaced by a simulated one; a simulated one is."""
    simulate = "simulate stanford_3dof --duration 0.0"
    Path("stanford_3dof.csv").write_text("t,q1\n")
    assert "stanford_3dof.csv is in the way" in refused(capsys, f"{simulate}1")
    Path("stanford_3dof.csv").unlink()
    run(capsys, f"{simulate}1")
    run(capsys, f"{simulate}2")
