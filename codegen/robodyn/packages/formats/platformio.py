"""PlatformIO and the Arduino IDE: a library in C, with a sketch that tests it on the board."""

from __future__ import annotations

import json

from robodyn.emit.languages.c import LANGUAGE as C
from robodyn.packages.format import Files, Format, Package
from robodyn.packages.writing import MARK, arithmetic_flags, readme, rendered

_SKETCH = "examples/selftest"
_TEMPLATES = {"library.properties": "library.properties.j2", f"{_SKETCH}/selftest.ino": "selftest.ino.j2"}


def _files(package: Package) -> Files:
    tests = package.tests(entry=f"{package.robot.name}_vectors")
    return {
        **readme(package),
        "library.json": json.dumps(_manifest(package), indent=2) + "\n",
        **rendered(package, _TEMPLATES),
        **{f"src/{path}": text for path, text in package.kernel().items()},
        **{f"{_SKETCH}/{path}": text for path, text in tests.items()},
    }


def _manifest(package: Package) -> dict[str, object]:
    """What PlatformIO reads. Which processor it is, the board says and not the library."""
    flags = [flag for flag in arithmetic_flags(package) if not flag.startswith("-m")]
    contact = package.maintainer
    authors = [] if contact is None else [{"name": contact.name, "email": contact.email, "maintainer": True}]
    return {
        "name": package.name,
        "version": package.version,
        "description": f"Dynamics of the arm {package.robot.name}. {MARK}; do not edit, generate again.",
        "keywords": ["robotics", "dynamics"],
        **({"license": package.license} if package.license else {}),
        **({"authors": authors} if authors else {}),
        "headers": f"{package.robot.name}.h",
        "frameworks": "*",
        "platforms": "*",
        "build": {"flags": flags},
    }


FORMAT = Format(
    name="platformio",
    title="a PlatformIO and Arduino library",
    tool="PlatformIO 6 or newer, and the Arduino IDE 1.5 or newer",
    language=C,
    files=_files,
    take="pio ci {folder}/examples/selftest --lib {folder} --board BOARD",
    options={"scalar": "float", "trig": "builtin"},
)
