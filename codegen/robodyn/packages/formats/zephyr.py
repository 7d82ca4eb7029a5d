"""Zephyr: a module with a Kconfig option, and a sample that tests it on the board."""

from __future__ import annotations

from typing import Final

from robodyn.emit.languages.c import LANGUAGE as C
from robodyn.packages.format import Files, Format, Package
from robodyn.packages.writing import arithmetic_flags, readme, rendered, sources

#: Stack [bytes] of a sample's thread beside the largest result: frames of the kernel and of printf.
MAIN_STACK: Final = 4096
#: Of a number, by its type [bytes].
BYTES: Final = {"double": 8, "float": 4}
_SAMPLE = "samples/selftest"
_TEMPLATES = {
    "zephyr/module.yml": "module.yml.j2",
    "zephyr/Kconfig": "Kconfig.j2",
    "zephyr/CMakeLists.txt": "CMakeLists.txt.j2",
    f"{_SAMPLE}/CMakeLists.txt": "sample.cmake.j2",
    f"{_SAMPLE}/prj.conf": "prj.conf.j2",
    f"{_SAMPLE}/sample.yaml": "sample.yaml.j2",
}


def _files(package: Package) -> Files:
    # Which processor it is, the board says and not the module.
    flags = [flag for flag in arithmetic_flags(package) if not flag.startswith("-m")]
    largest = max(array.size for array in package.arrays)
    more = {"flags": flags, "stack": MAIN_STACK + BYTES[package.scalar] * largest}
    return {
        **readme(package),
        **rendered(package, _TEMPLATES, **more),
        **sources(package, headers="include", tests=f"{_SAMPLE}/src"),
    }


FORMAT = Format(
    name="zephyr",
    title="a Zephyr module",
    tool="Zephyr 3.2 or newer",
    language=C,
    files=_files,
    take="west build -b BOARD {folder}/samples/selftest",
    options={"scalar": "float", "trig": "builtin"},
)
