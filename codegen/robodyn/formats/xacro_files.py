"""What a xacro file may read: its own folder, and packages, which their ``package.xml`` names.

Everything else is refused before it is looked at, so that a refusal does not even say whether it exists.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any, Final

from robodyn.files import MIB, label, read_bytes
from robodyn.formats.limits import FILE_MIB, FILES_INCLUDED
from robodyn.formats.xacro_values import Refused, size_of

LEVELS: Final = 5
"""[levels] Packages are looked for in so many folders, upwards from the file's: from urdf/inc/ to src/."""
FOLDERS: Final = 2000
"""[folders] So many are looked at for a package.xml."""
UNITS: Final = {
    "radians": 1.0,
    "degrees": math.pi / 180.0,
    "meters": 1.0,
    "millimeters": 0.001,
    "foot": 0.3048,
    "inches": 0.0254,
}
"""xacro's units of numbers in YAML, in rad and m."""
KEYS: Final = 10_000
"""[keys] Most keys of a mapping in YAML, with those that it merges."""
_NAME: Final = re.compile(r"[A-Za-z0-9][\w.-]*")
_NAMED: Final = re.compile(rb"<name>\s*([\w.-]+)\s*</name>")
_COMMENT: Final = re.compile(rb"<!--.*?-->", re.DOTALL)


class Files:
    """The files that the xacro file ``top`` may read; ``packages`` are folders by name that the command line
    states, ``ros`` the search paths of ROS: ``AMENT_PREFIX_PATH`` and ``ROS_PACKAGE_PATH``."""

    def __init__(self, top: str, packages: Mapping[str, str], ros: tuple[str, str]) -> None:
        self.top = os.path.abspath(top)  # noqa: PTH100 (links are not followed)
        self.packages = {name: os.path.abspath(folder) for name, folder in packages.items()}  # noqa: PTH100
        self.prefixes, self.roots = (list(filter(None, paths.split(os.pathsep))) for paths in ros)
        folder = Path(self.top).parent.resolve()
        self.above = [each for each in (folder, *folder.parents[: LEVELS - 1]) if each != each.parent]
        self.near: dict[str, Path] | None = None
        self.count = 0
        #: Folders in which a file must lie when links are followed: what wrote the links is not trusted.
        self.trees = [str(folder)]
        self.trees += [str(each) for each in self.above if (each / "package.xml").is_file()][:1]
        #: Folders in which a path must lie as it is written: ROS links files of a workspace into them.
        self.trusted = list(self.packages.values())

    def package(self, name: str) -> str:
        """The folder of the package ``name``, which may be read from now on.

        Raises
        ------
        Refused: there is none.
        """
        if not _NAME.fullmatch(name):
            raise Refused(f"{label(name)[:80]!r} is no name of a package")
        if name in self.packages:
            return self.packages[name]
        if self.near is None:
            self.near = {}
            for folder in self._folders():
                self.near.setdefault(_package_name(folder), folder)
        if name in self.near:
            self.trees.append(str(self.near[name]))
            return str(self.near[name])
        for folder in self._of_ros(name):
            if folder.is_dir():
                self.trusted.append(os.path.abspath(folder))  # noqa: PTH100
                return self.trusted[-1]
        for folder in self.above:  # a path for meshes: what may be read is not more by it
            if folder.name == name:
                return str(folder)
        raise Refused(
            f"no package.xml beside or above the file, and none of ROS, names the package {name!r}; "
            f"if it is elsewhere: --arg 'find {name}=FOLDER'"
        )

    def _folders(self) -> Iterator[Path]:
        """Folders that may be packages, the nearest first: above the file, and two levels below those."""
        passed: set[Path] = set()
        for above in self.above:
            level = [above]
            for depth in range(3):
                level = [folder for folder in level if folder not in passed][: FOLDERS - len(passed)]
                passed.update(level)
                yield from level
                level = [below for folder in level for below in _subfolders(folder) if depth < 2]

    def _of_ros(self, name: str) -> Iterator[Path]:
        yield from (Path(prefix) / "share" / name for prefix in self.prefixes)
        for root in self.roots:
            level = [Path(root), *_subfolders(Path(root))]
            yield from (folder for folder in level if _package_name(folder) == name)
            yield Path(root) / name

    def path(self, spec: str, folder: str) -> str:
        """The path that ``spec`` states in a file of ``folder``: also ``package://NAME/...``, ``file://...``.

        Raises
        ------
        Refused: it leads out of what may be read, or its package is nowhere.
        """
        kind, separator, rest = spec.partition("://")
        if separator and kind == "package":
            name, _, rest = rest.partition("/")
            spec = os.path.join(self.package(name), rest)  # noqa: PTH118
        elif separator and kind == "file":
            spec = rest
        path = os.path.abspath(os.path.join(folder, spec))  # noqa: PTH100, PTH118
        if path == self.top or any(_is_in(path, tree) for tree in self.trusted):
            return path
        real = os.path.realpath(path) if "\0" not in path else ""
        if not any(_is_in(real, tree) for tree in self.trees):
            raise Refused(
                f"{label(spec)[:150]} is outside the file's folder and its packages, and is not read; "
                "if that is meant: --arg 'find NAME=FOLDER' lets it read FOLDER"
            )
        return path

    def read(self, path: str, expected: str) -> bytes:
        """The bytes of the regular file at ``path``, which :meth:`path` gave.

        Raises
        ------
        FileNotFoundError: there is none.
        InputError: it is no regular file, or too large.
        Refused: it is one too many.
        """
        self.count += 1
        if self.count > 10 * FILES_INCLUDED:
            raise Refused(f"more than {10 * FILES_INCLUDED} files are read")
        if not os.path.lexists(path):
            raise FileNotFoundError(f"there is no file {label(path)}")
        return read_bytes(path, FILE_MIB * MIB, expected)


def _subfolders(folder: Path) -> list[Path]:
    """The folders in ``folder``, in the order of their names; hidden ones and links are left out."""
    try:
        return sorted(
            each
            for each in folder.iterdir()
            if each.is_dir() and not each.is_symlink() and not each.name.startswith(".")
        )
    except OSError:
        return []


def _package_name(folder: Path) -> str:
    """What the package.xml in ``folder`` calls the package; empty without one."""
    path = folder / "package.xml"
    try:
        data = read_bytes(path, MIB, "package.xml") if path.is_file() else b""
    except Exception:
        return ""
    name = _NAMED.search(_COMMENT.sub(b"", data))
    return name.group(1).decode("ascii", "replace") if name else ""


def _is_in(path: str, tree: str) -> bool:
    """Whether ``path`` is a file below ``tree``, and in no hidden folder of it."""
    return path.startswith(tree + os.sep) and f"{os.sep}." not in path[len(tree) :]


def load_yaml(data: bytes, name: str, read_number: Callable[[str], float]) -> Any:
    """What the YAML text ``data`` says, as plain data; ``read_number`` reads a number that has a unit.

    Raises
    ------
    Refused: it is no YAML, has tags of Python, or says more than values may hold.
    """
    import yaml

    class Loader(yaml.SafeLoader):
        """Its own class: constructors of the real one are for everybody."""

        def flatten_mapping(self, node: Any) -> None:
            super().flatten_mapping(node)
            if len(node.value) > KEYS:  # merges of merges double it each time
                raise Refused(f"a mapping of more than {KEYS} keys")

    for unit, factor in UNITS.items():

        def with_unit(loader: Any, node: Any, factor: float = factor) -> float:
            return read_number(loader.construct_scalar(node)) * factor

        Loader.add_constructor(f"!{unit}", with_unit)
    if len(data) > MIB:
        raise Refused(f"{name}: more than 1 MiB of YAML")
    try:
        value = Loader(data).get_single_data()
        size_of(value)
        return _plain(value)
    except yaml.MarkedYAMLError as error:  # without its words: they quote the file
        line = error.problem_mark.line + 1 if error.problem_mark else 1
        raise Refused(f"{name}:{line}: not plain YAML") from None
    except RecursionError:
        raise Refused(f"{name}: nested too deeply") from None
    except (Refused, yaml.YAMLError, ValueError, TypeError) as error:
        words = str(error) if isinstance(error, Refused) else "not plain YAML"
        raise Refused(f"{name}: {words}") from None


def _plain(value: Any) -> Any:
    """``value`` of plain types; a date is the text that it prints as."""
    import datetime

    if type(value) is dict:
        return {_plain(key): _plain(entry) for key, entry in value.items()}
    if type(value) in (list, tuple, set):
        return type(value)(map(_plain, value))
    if isinstance(value, datetime.date):
        return str(value)
    if value is None or type(value) in (bool, int, float, str):
        return value
    raise Refused(f"a value of the type {type(value).__name__}")
