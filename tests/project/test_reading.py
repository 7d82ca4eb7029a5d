"""``robodyn.toml``, what it says, and ``robodyn.lock``. What is refused stands in ``tests/refusals``."""

from __future__ import annotations

import itertools
import tomllib
from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn.project.lock import Locked, lock_text, read_lock
from robodyn.project.reading import Project, read_project
from robodyn.project.tables import Places, parsed
from robodyn.resources import bundled_robot
from robodyn_cli.project_keys import project_keys
from robodyn_testing.clocks import calls_of

ALL = """\
# comment
[options]
functions = ["gravity", "bias"]
no-regroup = true
fuse = ["gravity,bias", "bias,mass_matrix"]

[robots.arm]
robot = "arms/arm.yaml"
scalar = "float"
prune = 0.01

[robots.ur5]
output = "firmware"
functions = "mass_matrix"
no-regroup = false
budgets.mass_matrix = { total = 100, mul = 60 }
"""


def read(folder: Path, text: str) -> Project:
    (folder / "arms").mkdir(exist_ok=True)
    (folder / "arms" / "arm.yaml").touch()
    (folder / "robodyn.toml").write_text(text, encoding="utf-8")
    return read_project(folder / "robodyn.toml", project_keys())


@pytest.mark.parametrize("text", ["{}=1", "[{}]", "a={{b='',{}=1}}"])
def test_a_key_of_very_many_parts_is_refused_before_it_takes_long(text: str, tmp_path: Path) -> None:
    many = text.format(".".join(['"a"', "b"] * 20_000))
    with pytest.raises(InputError, match=r"robodyn\.toml:2: this file has lines with too many dots"):
        calls_of(lambda: parsed(f"\n{many}", "robodyn.toml"), most=1_000)
    assert read(tmp_path, f"# {'.' * 9_000}\n{ALL}").entries


def test_robots_have_the_options_of_all_and_their_own(tmp_path: Path) -> None:
    project = read(tmp_path, ALL)
    arm, ur5 = project.entries
    assert (arm.name, arm.robot) == ("arm", str(tmp_path / "arms" / "arm.yaml"))
    assert project.output(arm) == tmp_path / "generated" / "arm"
    assert project.output(ur5) == tmp_path / "firmware"
    assert arm.arguments == (  # in the order of their names, whatever that of the file is
        "--functions=gravity", "--functions=bias", "--fuse=gravity,bias", "--fuse=bias,mass_matrix",
        "--no-regroup", "--prune=0.01", "--scalar=float",
    )  # fmt: skip
    assert ur5.robot == str(bundled_robot("ur5"))
    assert "--functions=mass_matrix" in ur5.arguments
    assert "--no-regroup" not in ur5.arguments
    assert ur5.budgets == {"mass_matrix": {"total": 100, "mul": 60}}
    assert project.lock == tmp_path / "robodyn.lock"


def test_packages_have_the_options_of_their_robot_and_their_own(tmp_path: Path) -> None:
    project = read(
        tmp_path,
        "[options]\nlang = 'c'\nmisra = true\n[robots.a]\nrobot = 'ur5'\nscalar = 'float'\n"
        "packages = ['cmake', 'fpm']\n[robots.b]\nrobot = 'ur10'\nscalar = 'float'\n"
        "[robots.b.packages.cmake]\noutput = 'there'\nscalar = 'double'\nversion = '1.2.0'\n",
    )
    a, a_cmake, a_fpm, b, b_cmake = project.entries
    assert [entry.command for entry in (a, a_cmake, a_fpm, b, b_cmake)] == [
        "gen",
        *["package"] * 2,
        "gen",
        "package",
    ]
    assert (a_cmake.name, a_cmake.output, a_cmake.robot) == ("a/cmake", "packages/a/cmake", a.robot)
    assert a_cmake.arguments == ("--as=cmake", "--misra", "--scalar=float")
    assert a_fpm.arguments == ("--as=fpm", "--misra", "--scalar=float")
    assert b_cmake.arguments == ("--as=cmake", "--misra", "--scalar=double", "--version=1.2.0")
    assert b_cmake.output == "there"
    lines = [
        entry.place(key).line for entry, key in ((a_cmake, "scalar"), (b_cmake, "scalar"), (b_cmake, "misra"))
    ]
    assert lines == [6, 13, 3]
    assert [entry.place().line for entry in (a_cmake, b_cmake)] == [7, 11]


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"no\.toml: there is no project file of this name; name one with"):
        read_project(tmp_path / "no.toml", project_keys())
    with pytest.raises(InputError, match="this is the name of a lock file"):
        read_project(tmp_path / "robodyn.lock", project_keys())


PLACES = '''\
top = 1  # \u2028 is no end of a line

[a]
  x = """
b = 3
[c]
"""
list = [
  1,
  # comment
  2,
]

[a.b]
# comment
"quoted key" = { inner = 1 }
c.d.e = 5
[[tables]]
'''


def test_the_place_of_every_key() -> None:
    places = Places("file", PLACES)

    def at(*path: str) -> tuple[int | None, int | None]:
        place = places.of(*path)
        return place.line, place.column

    assert at("top") == (1, 1)
    assert at("a") == (3, 1)
    assert at("a", "x") == (4, 3)
    assert at("b") == at("c") == at() == at("a", "x", "y") == (None, None)
    assert at("a", "list") == (8, 1)
    assert at("a", "b") == (14, 1)
    assert at("a", "b", "quoted key") == at("a", "b", "quoted key", "inner") == (16, 1)
    assert at("a", "b", "c", "d") == (17, 1)
    assert at("tables") == (18, 1)
    lines = PLACES.split("\n")
    for path in itertools.permutations(tomllib.loads(PLACES), 1):
        line, _ = at(*path)
        assert path[0] in lines[(line or 0) - 1]


LOCK = {
    "b": Locked("out/b", {"gravity": {"mul": 2, "total": 3}}, {"b.h": "00", 'src/"é\x7f".rs': "11"}),
    "a.1": Locked("generated/a", {"bias": {"mul": 1, "total": 1}, "gravity": {"mul": 2, "total": 2}}, {}),
}


def test_what_is_written_is_read(tmp_path: Path) -> None:
    path = tmp_path / "robodyn.lock"
    assert read_lock(path) is None
    text = lock_text(LOCK)
    path.write_text(text, encoding="utf-8")
    assert read_lock(path) == LOCK
    assert text == lock_text(dict(reversed(LOCK.items())))
    assert "\ngravity = { mul = 2, total = 3 }\n" in text
