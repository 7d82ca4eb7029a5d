"""``robodyn.toml``: what it says, and where what is wrong in it stands."""

from __future__ import annotations

import itertools
import tomllib
from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn.project.places import Places
from robodyn.project.reading import Project, read_project
from robodyn.resources import bundled_robot
from robodyn_cli.project_keys import project_keys

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


def test_robots_have_the_options_of_all_and_their_own(tmp_path: Path) -> None:
    project = read(tmp_path, ALL)
    arm, ur5 = project.entries
    assert (arm.name, arm.robot) == ("arm", str(tmp_path / "arms" / "arm.yaml"))
    assert project.output(arm) == tmp_path / "generated" / "arm"
    assert project.output(ur5) == tmp_path / "firmware"
    assert set(arm.arguments) == {
        "--functions=gravity",
        "--functions=bias",
        "--no-regroup",
        "--fuse=gravity,bias",
        "--fuse=bias,mass_matrix",
        "--scalar=float",
        "--prune=0.01",
    }
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


def test_the_order_of_keys_does_not_matter(tmp_path: Path) -> None:
    one, other = (
        read(tmp_path, text).entries[0].arguments
        for text in (
            "[options]\nmisra = true\n[robots.ur5]\nscalar = 'float'\ntrig = 'builtin'\n",
            "[robots.ur5]\ntrig = 'builtin'\nmisra = true\nscalar = 'float'\n",
        )
    )
    assert one == other


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("robots = [", ":1: this is not TOML"),
        ("[robots.ur5]\nscalar = 'float'\nscalar = 'double'\n", ":3:18: this is not TOML"),
        ("[robot.ur5]\n", ":1:1: unknown key 'robot'; expected one of options, robots; did you mean 'ro"),
        ("packages = ['cmake']\n[robots.ur5]\n", ":1:1: unknown key 'packages'; expected one of opt"),
        ("[robots.ur5]\npackages = 'cmake'\n", ":2:1: these are no formats of packages; found 'cmake'"),
        ("[robots.ur5]\npackages = ['fpm', 'fpm']\n", "found ['fpm', 'fpm']; expected a list of formats"),
        ("[robots.ur5.packages]\nfpm = 1\n", ":2:1: fpm is not a table; found 1"),
        ("[robots.ur5.packages.fpm]\nlang = 'c'\n", ":2:1: unknown key 'lang' in [robots.ur5.packages.fpm]"),
        ("[robots.ur5.packages.fpm]\nversion = 1\nmisra = 1\n", ":3:1: misra has the wrong type"),
        ("\n[robots.ur5]\n  scaler = 'float'\n", ":3:3: unknown key 'scaler' in [robots.ur5]"),
        ("[robots.ur5]\nscaler = 'float'\n", "did you mean 'scalar'?"),
        ("[robots.ur5]\nno_regroup = true\n", "did you mean 'no-regroup'?"),
        ("[options]\ncompile = true\n[robots.ur5]\n", ":2:1: unknown key 'compile' in [options]"),
        ("[options]\noutput = 'x'\n[robots.ur5]\n", ":2:1: unknown key 'output' in [options]"),
        ("[options]\n", "there is no robot in this project; expected a table for each robot"),
        ("options = 1\n[robots.ur5]\n", ":1:1: options is not a table; found 1"),
        ("[robots]\nur5 = 'ur5'\n", ":2:1: ur5 is not a table; found 'ur5'; expected [robots.ur5]"),
        ("[robots.ur5]\nmisra = 'yes'\n", ":2:1: misra has the wrong type; found 'yes'; expected true or"),
        ("[robots.ur5]\nscalar = true\n", ":2:1: scalar has the wrong type; found true; expected a text"),
        ("[robots.ur5]\nscalar = ['float']\n", "found ['float']; expected a text"),
        ("[robots.ur5]\nfunctions = [\n  'gravity',\n  7,\n]\n", ":2:1: functions has the wrong type"),
        ("[robots.ur5]\nfunctions = []\n", "expected a list of texts"),
        ("[robots.ur5]\noutput = ''\n", ":2:1: output is not a path"),
        ("[robots.ur5]\nrobot = 5\n", ":2:1: robot is not a path; found 5"),
        ("[robots.ur6]\n", ":1:1: there is neither a description nor a bundled robot of this"),
        ("[robots.ur6]\n", "did you mean 'ur5'?"),
        ("[robots.a]\nrobot = 'arms'\n", ":2:1: there is neither a description nor a bundled robot"),
        ("[robots.'../a']\nrobot = 'ur5'\n", ":1:1: this cannot be the name of a robot's table"),
        ("[robots.ur5.budgets]\ngravity = 5\n", ":2:1: gravity is not a table"),
        ("[robots.ur5.budgets.gravity]\ntotl = 5\n", ":2:1: unknown key 'totl' in [robots.ur5.budgets.gra"),
        ("[robots.ur5.budgets]\ngravity.total = -1\n", ":2:1: the budget of total is not a count; found -1"),
        ("[robots.ur5.budgets]\ngravity.total = true\n", "found true; expected how many operations"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told_with_its_place(text: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as error:
        read(tmp_path, text)
    assert f"{tmp_path / 'robodyn.toml'}:" in str(error.value)
    assert message in str(error.value)


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
