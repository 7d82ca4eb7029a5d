"""Commands and what stands where they write: a file that somebody wrote, a link, a folder elsewhere."""

from __future__ import annotations

from pathlib import Path

import pytest

from robodyn_cli.main import main

MINE = "/* by hand */\n"
PROJECT = "[robots.stanford_3dof]\nfunctions = 'gravity'\nlang = 'c'\n"
COMMANDS = {
    "gen stanford_3dof --functions gravity --lang c -o out": "out/stanford_3dof.c",
    "gen stanford_3dof --functions gravity --lang c": "generated/stanford_3dof/stanford_3dof.c",
    "package stanford_3dof --as fpm -o out": "out/fpm.toml",
    "package stanford_3dof --as fpm": "packages/stanford_3dof/fpm/fpm.toml",
    "build": "generated/stanford_3dof/stanford_3dof.c",
}
Capture = pytest.CaptureFixture[str]


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    work = tmp_path / "work"
    work.mkdir()
    monkeypatch.chdir(work)
    (work / "robodyn.toml").write_text(PROJECT)
    return work


def files(folder: Path) -> dict[str, str]:
    return {str(path): path.read_text() for path in folder.rglob("*") if path.is_file()}


def refused(command: str, capsys: Capture, folder: Path) -> str:
    """What stderr says of a ``command`` that ends with 2 and leaves all in ``folder`` as it is."""
    before = files(folder)
    assert main(command.split()) == 2
    assert files(folder) == before
    return capsys.readouterr().err


@pytest.mark.parametrize(("command", "output"), COMMANDS.items())
def test_a_file_that_somebody_wrote(command: str, output: str, here: Path, capsys: Capture) -> None:
    (here / output).parent.mkdir(parents=True)
    (here / output).write_text(MINE)
    err = refused(command, capsys, here)
    assert f"{output} is in the way, which robodyn did not write" in err
    assert "--force" in err
    assert main([*command.split(), "--force"]) == 0
    assert "Written by robodyn" in (here / output).read_text()
    assert main(command.split()) == 0


@pytest.mark.parametrize(("command", "output"), COMMANDS.items())
def test_a_link(command: str, output: str, here: Path, capsys: Capture) -> None:
    (here.parent / "precious").write_text(MINE)
    (here / output).parent.mkdir(parents=True)
    (here / output).symlink_to(here.parent / "precious")
    assert f"{output} is a symbolic link" in refused(command, capsys, here.parent)
    assert main([*command.split(), "--force"]) == 0
    assert (here.parent / "precious").read_text() == MINE
    assert not (here / output).is_symlink()


@pytest.mark.parametrize("command", [command for command in COMMANDS if "-o" not in command])
def test_a_folder_that_leads_elsewhere(command: str, here: Path, capsys: Capture) -> None:
    """Nobody has named it, other than that of ``-o``."""
    (here.parent / "elsewhere").mkdir()
    name = COMMANDS[command].partition("/")[0]
    (here / name).symlink_to(here.parent / "elsewhere")
    for force in ("", " --force"):
        assert f"{name} is a symbolic link" in refused(command + force, capsys, here.parent)


@pytest.mark.parametrize(
    "output", ["../out", "a/../../out", "a/..", "/tmp/out", "..\\\\out", "C:/out", "//host/out"]
)
@pytest.mark.parametrize("key", ["output", "packages.fpm.output"])
def test_an_output_of_a_project_that_leaves_it(key: str, output: str, here: Path, capsys: Capture) -> None:
    (here / "robodyn.toml").write_text(f'{PROJECT}{key} = "{output}"\n')
    for command in ("build", "build --check", "build --force"):
        err = refused(command, capsys, here.parent)
        assert "robodyn.toml:4:1: this output leaves the folder of the project file" in err


def test_a_description_may_lie_elsewhere(here: Path, capsys: Capture) -> None:
    assert main(["new", "arm", "--joints", "2", "-o", str(here.parent / "arm.yaml")]) == 0
    text = PROJECT.replace("stanford_3dof]", "arm]\nrobot = '../arm.yaml'")
    (here / "robodyn.toml").write_text(text)
    assert main(["build"]) == 0
    assert (here / "generated/arm/arm.c").is_file()


@pytest.mark.parametrize("what", ["file", "link"])
def test_nothing_of_a_build_is_written_where_one_file_is_in_the_way(
    what: str, here: Path, capsys: Capture
) -> None:
    (here / "robodyn.toml").write_text(f"{PROJECT}[robots.puma560_3dof]\nfunctions = 'gravity'\n")
    (here.parent / "precious").write_text(MINE)
    if what == "file":
        (here / "robodyn.lock").write_text("mine\n")
    else:
        (here / "robodyn.lock").symlink_to("../precious")
    assert "robodyn.lock" in refused("build", capsys, here.parent)
    assert main(["build", "--force"]) == 0
    assert (here.parent / "precious").read_text() == MINE


def test_a_project_says_nothing_of_force(here: Path, capsys: Capture) -> None:
    (here / "robodyn.toml").write_text(f"{PROJECT}force = true\n")
    assert "unknown key 'force'" in refused("build", capsys, here)


@pytest.mark.parametrize(
    "command",
    [
        "report stanford_3dof -o out.html", "tables 2.9 --picture out.svg", "build -o out.txt",
        "new arm -o out.yaml --force", "schedule stanford_3dof -p 2 --picture out.svg",
        "simulate stanford_3dof --duration 0.01 -o out.csv",
    ],
)  # fmt: skip
def test_a_file_of_the_command_line_that_is_a_link(command: str, here: Path) -> None:
    """It is refused, or replaced by ``new --force``, and what it leads to stays."""
    name = next(word for word in command.split() if word.startswith("out."))
    (here.parent / "precious").write_text(MINE)
    (here / name).symlink_to("../precious")
    assert main(command.split()) == (0 if "--force" in command else 2)
    assert (here.parent / "precious").read_text() == MINE
    if "build" in command:
        assert not (here / "generated").exists()


def test_a_default_name_is_nobodys_choice(here: Path, capsys: Capture) -> None:
    """A log that was recorded is not replaced by a simulated one; a simulated one is."""
    simulate = "simulate stanford_3dof --duration 0.0"
    (here / "stanford_3dof.csv").write_text("t,q1\n")
    assert "stanford_3dof.csv is in the way" in refused(f"{simulate}1", capsys, here)
    (here / "stanford_3dof.csv").unlink()
    assert main(f"{simulate}1".split()) == 0
    assert main(f"{simulate}2".split()) == 0
