"""``robodyn.toml``: the robots of a project, their options, outputs and budgets."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any, Final

from robodyn.errors import InputError, Place
from robodyn.files import label, read_text
from robodyn.project.keys import KERNELS, LARGEST_BUDGET, PACKAGE, Key, Keys
from robodyn.project.tables import LARGEST_FILE, Places, Tables, shown

#: What the file is called where nothing else is said.
FILE: Final = "robodyn.toml"
_LOCK: Final = ".lock"
#: Keys of a robot's table that are no options.
OWN: Final = ("robot", "output", "budgets", "packages")
#: Those of a package's table.
OWN_OF_PACKAGE: Final = ("output",)
#: Between a robot's name and the format in the name of a package; no robot's name has it.
OF: Final = "/"
_TABLES: Final = ("options", "robots")
_NAME: Final = re.compile(r"\w[\w.+-]*")

Budgets = Mapping[str, Mapping[str, int]]


@dataclass(frozen=True, slots=True)
class Entry:
    """A robot of a project, or a package of one, whose name is ``ROBOT/FORMAT``.

    ``robot`` is the path of its description, ``output`` the folder of its files as the project has it,
    relative to the project's folder; ``settings`` are its options, ``arguments`` the same as the ``command``
    takes them that writes it; ``budgets`` the most operations by function and kind. What it says stands in
    ``tables``, and where the first of them says nothing, in the next.
    """

    name: str
    robot: str
    output: str
    settings: Mapping[str, Any]
    arguments: tuple[str, ...]
    budgets: Budgets
    places: Places
    tables: tuple[tuple[str, ...], ...]
    command: str = KERNELS

    def place(self, *keys: str) -> Place:
        """Where ``keys`` of its tables are stated; without keys where the first of them is."""
        places = (self.places.of(*table, *keys) for table in self.tables)
        return next((place for place in places if place.line is not None), Place(self.places.file))


@dataclass(frozen=True, slots=True)
class Project:
    """What the file at ``path`` says; relative paths in it start in its folder. A robot's packages come after
    it."""

    path: Path
    entries: tuple[Entry, ...]

    @property
    def folder(self) -> Path:
        """The folder of the file."""
        return self.path.parent

    @property
    def lock(self) -> Path:
        """The lock file, beside it."""
        return self.path.with_suffix(_LOCK)

    def output(self, entry: Entry) -> Path:
        """The folder of the kernels of ``entry``."""
        return self.folder / entry.output


def read_project(path: Path, keys: Keys) -> Project:
    """The project in the file at ``path``, whose options are ``keys``.

    Raises
    ------
    InputError: there is no such file, it is no TOML, or it says what no project says.
    """
    name = label(path)
    if path.suffix == _LOCK:
        raise InputError("this is the name of a lock file", where=Place(name), expected=f"a name as {FILE}")
    if not path.exists():
        raise InputError(
            "there is no project file of this name",
            where=Place(name),
            remedy="name one with --file, or write one: a line [robots.puma560], and robodyn build",
        )
    text = read_text(path, LARGEST_FILE, "a project file, such as robodyn.toml", name)
    return Project(path, _Reader(Tables(text, name), path.parent, keys).entries())


class _Reader:
    """Reads the tables of one file, each with the place of what is wrong in it."""

    def __init__(self, tables: Tables, folder: Path, keys: Keys) -> None:
        self.tables, self.places, self.folder, self.keys = tables, tables.places, folder, keys

    def entries(self) -> tuple[Entry, ...]:
        self.tables.check_keys((), _TABLES)
        self._options(("options",), (), self.keys.kernels)  # also where every robot overrides it
        robots = self.tables.table("robots")
        if not robots:
            raise InputError(
                "there is no robot in this project",
                where=self.places.of("robots"),
                expected="a table for each robot",
                remedy="write [robots.puma560], for one, on a line of its own",
            )
        entries = map(self._entry, robots)
        return tuple(each for entry in entries for each in (entry, *self._packages(entry)))

    def _entry(self, name: str) -> Entry:
        at = ("robots", name)
        if not _NAME.fullmatch(name):
            raise InputError(
                "this cannot be the name of a robot's table",
                where=self.places.of(*at),
                found=shown(name),
                expected="letters, digits, and . + - _ after the first of them",
            )
        table = self.tables.table(*at)
        keys = self.keys.kernels
        settings = {**self._options(("options",), (), keys), **self._options(at, OWN, keys)}
        return Entry(
            name,
            self.tables.description(
                (*at, "robot") if "robot" in table else at, table.get("robot", name), self.folder
            ),
            self._output((*at, "output"), table.get("output", f"generated/{name}")),
            settings,
            _arguments(settings, keys),
            self._budgets(*at, "budgets"),
            self.places,
            (at, ("options",)),
        )

    def _packages(self, entry: Entry) -> Iterator[Entry]:
        """The packages of the robot ``entry``: formats in a list, or a table for each. They have the options
        of the robot that packages have."""
        at = ("robots", entry.name, "packages")
        formats = self.tables.table("robots", entry.name).get("packages", {})
        is_list = isinstance(formats, list) and all(isinstance(form, str) for form in formats)
        if not isinstance(formats, dict) and not (is_list and len(set(formats)) == len(formats)):
            raise InputError(
                "these are no formats of packages",
                where=self.places.of(*at),
                found=shown(formats),
                expected="a list of formats, each once, or a table for each",
            )
        keys = self.keys.packages
        inherited = {name: value for name, value in entry.settings.items() if name in keys}
        for form in formats:
            table = self.tables.table(*at, form) if isinstance(formats, dict) else {}
            own = self._options((*at, form), OWN_OF_PACKAGE, keys) if isinstance(formats, dict) else {}
            settings = {**inherited, **own}
            output = table.get("output", f"packages/{entry.name}/{form}")
            yield Entry(
                f"{entry.name}{OF}{form}",
                entry.robot,
                self._output((*at, form, "output"), output),
                settings,
                (f"--as={form}", *_arguments(settings, keys)),
                {},
                self.places,
                ((*at, form), at, *entry.tables),
                PACKAGE,
            )

    def _output(self, at: tuple[str, ...], value: Any) -> str:
        """The folder of an output: below that of the project file, whoever wrote that, for CI builds what a
        pull request asks for. Links on the way are refused where files are written.

        Raises
        ------
        InputError: it lies elsewhere, as Windows or others spell it.
        """
        text = self.tables.text(at, value)
        for path in (PurePosixPath(text), PureWindowsPath(text)):
            if path.anchor or ".." in path.parts:
                raise InputError(
                    "this output leaves the folder of the project file",
                    where=self.places.of(*at),
                    found=shown(text),
                    expected="a folder below it, without ..",
                    remedy="choose another output, or put the project file further up",
                )
        return text

    def _options(self, at: tuple[str, ...], own: tuple[str, ...], keys: Mapping[str, Key]) -> dict[str, Any]:
        """The options in the table ``at``, each of the right type; the table has keys of its ``own``, too."""
        settings = {}
        for name, value in self.tables.table(*at).items():
            if name in own:
                continue
            if name not in keys:
                raise self.tables.unknown(at, name, (*own, *keys))
            try:
                keys[name].arguments(value)
            except InputError as error:
                raise error.at(self.places.of(*at, name)) from None
            settings[name] = value
        return settings

    def _budgets(self, *at: str) -> Budgets:
        budgets: dict[str, Any] = self.tables.table(*at)
        for function in budgets:
            from robodyn.counts.count import KINDS

            for kind, most in self.tables.table(*at, function).items():
                if kind not in KINDS:
                    raise self.tables.unknown((*at, function), kind, KINDS)
                if not isinstance(most, int) or isinstance(most, bool) or not 0 <= most < LARGEST_BUDGET:
                    raise InputError(
                        f"the budget of {kind} is not a count",
                        where=self.places.of(*at, function, kind),
                        found=shown(most),
                        expected="how many operations there may be",
                    )
        return budgets


def _arguments(settings: Mapping[str, Any], keys: Mapping[str, Key]) -> tuple[str, ...]:
    """``settings`` as a command line has them, in the order of their names."""
    return tuple(word for name, value in sorted(settings.items()) for word in keys[name].arguments(value))
