"""What readers of descriptions, files in other formats, projects, fleets, maps, logs, motions and numbers
refuse, text by text."""

from __future__ import annotations

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from robodyn.errors import InputError
from robodyn.fleet.sources.reading import read_fleet
from robodyn.formats.arm import import_arm
from robodyn.logs.log import read_log
from robodyn.logs.mapping import map_of_columns, map_of_text
from robodyn.project.lock import read_lock
from robodyn.project.reading import read_project
from robodyn.robot import numbers, read_text
from robodyn.simulate.trajectories import from_file
from robodyn_cli.project_keys import project_keys
from robodyn_testing import require_module
from robodyn_testing.clocks import calls_of
from robodyn_testing.refusals import Reader, differences, refusals, write

HERE = Path(__file__).parent


def _description(text: str, folder: Path) -> None:
    calls_of(lambda: read_text(text, "arm.yaml", strict=True), most=200_000)


def _number(text: str, folder: Path) -> None:
    calls_of(lambda: numbers.parse(text), most=5_000)


def _project(text: str, folder: Path) -> None:
    (folder / "arms").mkdir()
    (folder / "arms" / "arm.yaml").touch()
    (folder / "robodyn.toml").write_text(text, encoding="utf-8")
    read_project(folder / "robodyn.toml", project_keys())


def _lock(text: str, folder: Path) -> None:
    (folder / "robodyn.lock").write_text(text, encoding="utf-8")
    read_lock(folder / "robodyn.lock")


def _fleet(text: str, folder: Path) -> None:
    (folder / "logs" / "7").mkdir(parents=True)
    (folder / "logs" / "7" / "2026-05-03.csv").touch()
    (folder / "fleet.toml").write_text(text, encoding="utf-8")
    read_fleet(folder)


def _manifest(text: str, folder: Path) -> None:
    (folder / "a.csv").touch()
    (folder / "m.csv").write_text(text, encoding="utf-8")
    (folder / "fleet.toml").write_text("[types.ur5]\n[[logs]]\nmanifest = 'm.csv'\n", encoding="utf-8")
    read_fleet(folder)


def _log(text: str, folder: Path) -> None:
    (folder / "log.csv").write_text(text, encoding="utf-8", newline="")
    read_log(folder / "log.csv")


def _mapped(text: str, folder: Path) -> None:
    (folder / "log.csv").write_text("t,q1,x,y\n0,0,1,2\n1,0.1,1,2\n", encoding="utf-8")
    read_log(folder / "log.csv", mapping=map_of_columns(text))


def _second(text: str, folder: Path) -> None:
    (folder / "a.csv").write_text("t,q1,tau1\n0,1,2\n1,2,3\n", encoding="utf-8")
    (folder / "b.csv").write_text(text, encoding="utf-8")
    read_log(f"{folder / 'a.csv'}+{folder / 'b.csv'}")


def _motion(text: str, folder: Path) -> None:
    (folder / "m.csv").write_text(text, encoding="utf-8")
    from_file(folder / "m.csv")


def _urdf(text: str, folder: Path) -> None:
    (folder / "arm.urdf").write_text(text, encoding="utf-8")
    import_arm(folder / "arm.urdf")


def _sdf(text: str, folder: Path) -> None:
    (folder / "arm.sdf").write_text(text, encoding="utf-8")
    import_arm(folder / "arm.sdf")


def _mjcf(text: str, folder: Path) -> None:
    require_module("mujoco")
    (folder / "arm.xml").write_text(text, encoding="utf-8")
    import_arm(folder / "arm.xml")


READERS: dict[str, Reader] = {
    "columns": lambda text, _: map_of_columns(text),
    "description": _description,
    "effects": _description,
    "fleet": _fleet,
    "lock": _lock,
    "log": _log,
    "manifest": _manifest,
    "map": lambda text, _: map_of_text(text, "map.yaml"),
    "mapped": _mapped,
    "mjcf": _mjcf,
    "motion": _motion,
    "name": lambda text, _: numbers.parse(text, names=True),
    "number": _number,
    "project": _project,
    "sdf": _sdf,
    "second": _second,
    "urdf": _urdf,
}


@pytest.mark.parametrize("kind", READERS)
def test_every_text_is_refused_with_its_message(kind: str, tmp_path: Path) -> None:
    wrong = list(differences(HERE / f"{kind}.yaml", READERS[kind], tmp_path))
    assert not wrong, "\n".join(wrong)


def test_every_file_has_its_reader() -> None:
    assert {path.stem for path in HERE.glob("*.yaml")} == set(READERS)


def test_the_python_parser_of_yaml_refuses_too(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where PyYAML was built without libyaml."""
    import yaml

    cases = refusals(HERE / "description.yaml")
    monkeypatch.delattr(yaml, "CSafeLoader", raising=False)
    for case in cases:
        with pytest.raises(InputError, match=r"\Aarm\.yaml:\d+:\d+: "):
            read_text(case["text"], "arm.yaml", strict=True)


if __name__ == "__main__" and "--update" in sys.argv:
    for kind, reader in READERS.items():
        with TemporaryDirectory() as folder:
            path = HERE / f"{kind}.yaml"
            write(path, [case["text"] for case in refusals(path)], reader, Path(folder))
