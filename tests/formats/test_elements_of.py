"""The tables of elements have the names that the formats' authors list: all, and none besides."""

from __future__ import annotations

import copy
import ctypes
import re
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

from robodyn.formats.elements import parse
from robodyn.formats.elements_of import FORMATS, Table, Unread, table_of
from robodyn.formats.tree import PHYSICS, Leftovers
from robodyn_testing import require_module

NAMES = Path(__file__).parent / "names"
Names = dict[tuple[str, ...], set[str]]
#: The MuJoCo whose schema the table is; what only older ones have says so in it.
NEWEST = "4.0.0"


def recorded(title: str, root: str) -> Names:
    """The names of each path of tags of a format, from the record of its authors' descriptions."""
    lines = (NAMES / f"{title.lower()}.txt").read_text(encoding="utf-8").splitlines()
    split = (line.split(": ", 1) for line in lines if not line.startswith("#"))
    described = {tuple(path.split("/")): names.split() for path, names in split}
    names_of: Names = defaultdict(set)

    def walk(key: tuple[str, ...], tags: tuple[str, ...], passed: tuple[str, ...]) -> None:
        for word in described.get(key, ()):
            name, _, elsewhere = word.rstrip("^").partition("=")
            names_of[tags].add(name)
            tag = name.strip("<>")
            if elsewhere and elsewhere not in passed:
                walk((elsewhere,), (*tags, tag), (*passed, elsewhere))
            elif name.startswith("<") and not elsewhere and not word.endswith("^"):
                walk((*key, tag), (*tags, tag), passed)

    walk(("root",), (root,), ("root",))
    return names_of


def printed(schema: str) -> Names:
    """The names of each path of tags in a schema as MuJoCo prints it: a tag, how often, attributes."""
    names_of: Names = {}
    tags: tuple[str, ...] = ()
    for line in schema.splitlines():
        if head := re.match(r"( *)(\S+) \(.\)", line):
            tag = head[2].replace("(world)", "")
            above = tags[: len(head[1]) // 3]
            if above:
                names_of[above].add("<worldbody>" if head[2] == "(world)body" else f"<{tag}>")
            tags = (*above, tag)
            names_of[tags] = set()
        names_of[tags].update(line[head.end() :].split() if head else line.split())
    return names_of


def by_row(table: Table, names_of: Names) -> Names:
    """The names that each row of the table should have: an element without a row is described around it."""
    rows: Names = defaultdict(set)
    for tags, names in names_of.items():
        paths = (table.path_of(tags[:end]) for end in range(len(tags), 0, -1))
        rows[next(filter(None, paths), tags)] |= names
    return rows


def differences(table: Table, names_of: Names) -> Iterator[str]:
    """What is in one of the two only; names that only others have may be in the table alone."""
    expected = by_row(table, names_of)
    for path in {**expected, **table.rows}:
        row, names = table.rows.get(path, {}), expected.get(path, set())
        yield from (f"{'/'.join(path)}: {name} is not in the table" for name in sorted(names - row.keys()))
        formats_own = {name for name, entry in row.items() if not entry.source}
        yield from (f"{'/'.join(path)}: there is no {name}" for name in sorted(formats_own - names))


@pytest.mark.parametrize(("title", "root"), [("URDF", "robot"), ("SDF", "sdf")])
def test_the_table_is_what_the_authors_list(title: str, root: str) -> None:
    names_of = recorded(title, root)
    assert len(names_of) > 20
    assert not [*differences(table_of(title), names_of)]


def test_the_table_of_mjcf_is_the_schema_that_mujoco_prints() -> None:
    mujoco = require_module("mujoco")
    library = ctypes.CDLL(str(next(Path(str(mujoco.__file__)).parent.glob("libmujoco*"))))
    text = ctypes.create_string_buffer(1 << 20)
    assert library.mj_printSchema(None, text, len(text), 0, 0) > 0
    names_of = printed(text.value.decode())
    assert ("mujoco", "actuator", "general") in names_of
    table = copy.deepcopy(table_of("MJCF"))
    assert table.rows.pop(("worldbody", "geom"))
    alike = [path for path in table.rows if len(path) == 2 and path[0] in ("worldbody", "frame", "replicate")]
    assert all(table.rows.pop(path) == table.rows["body", path[1]] for path in alike)
    wrong = [*differences(table, names_of)]
    is_newest = mujoco.__version__ == NEWEST
    assert not [words for words in wrong if is_newest or "is not in the table" in words]


@pytest.mark.parametrize("title", FORMATS)
def test_names_of_what_is_refused_are_those_of_the_command_line(title: str) -> None:
    entries = [entry for row in table_of(title).rows.values() for entry in row.values()]
    assert {entry.physics for entry in entries} <= {"", *PHYSICS}
    assert len(entries) > 200


def test_every_name_of_what_is_refused_is_of_some_format() -> None:
    listed = {
        entry.physics for title in FORMATS for row in table_of(title).rows.values() for entry in row.values()
    }
    assert {*PHYSICS} == listed - {""}


@pytest.mark.parametrize(
    ("title", "text", "unknown"),
    [
        (
            "URDF",
            '<robot name="a"><link name="l"><inertial mass="3"><weight/></inertial><visual><shape/></visual>'
            '</link><joint><dynamics viscosity="1"/></joint><gazebo><spring>1</spring></gazebo><drake:thing/>'
            "</robot>",
            [
                "'mass' of <inertial>", "<weight> in <inertial>", "<shape> in <visual>",
                "'viscosity' of <dynamics>", "<spring> in <gazebo>", "<drake:thing> in <robot>",
            ],
        ),
        (
            "SDF",
            '<sdf version="1.9"><model name="m"><link name="l"><inertial><weight/></inertial>'
            '<sensor><camera><lens><dust/></lens></camera></sensor></link><joint><axis><dynamics><drag/></dynamics>'
            '</axis></joint><plugin name="p"><anything/></plugin></model></sdf>',
            ["<weight> in <inertial>", "<dust> in <lens>", "<drag> in <dynamics>"],
        ),
        (
            "MJCF",
            '<mujoco><option thrust="1"/><worldbody><body name="b"><inertial weight="1"/><joint drag="1"/>'
            '</body></worldbody><sensor><gyro colour="red"/></sensor></mujoco>',
            ["'thrust' of <option>", "'weight' of <inertial>", "'drag' of <joint>", "'colour' of <gyro>"],
        ),
    ],
)  # fmt: skip
def test_what_the_table_does_not_have_is_told_as_unknown(title: str, text: str, unknown: list[str]) -> None:
    """In what has no effect, too; what a plugin holds is its."""
    document = parse(text.encode(), "arm.xml")
    leftovers = Leftovers("arm.xml")
    Unread(table_of(title), leftovers, document.place).note(document.root)
    said = [part.what for part in leftovers.unused() if part.what.startswith("unknown")]
    assert sorted(said) == sorted(f"unknown to {title}: {what}" for what in unknown)
