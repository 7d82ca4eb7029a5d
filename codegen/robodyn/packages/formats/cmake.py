"""CMake: a library that is installed and found with ``find_package``, and with pkg-config."""

from __future__ import annotations

from typing import Any

from robodyn.emit.languages.c import LANGUAGE as C
from robodyn.packages.format import Files, Format, Package
from robodyn.packages.writing import arithmetic_flags, readme, rendered, sources

_TEMPLATES = {
    "CMakeLists.txt": "CMakeLists.txt.j2",
    "cmake/NAME_dynamicsConfig.cmake.in": "Config.cmake.in.j2",
    "cmake/NAME_dynamics.pc.in": "package.pc.in.j2",
}


def _files(package: Package) -> Files:
    return {
        **readme(package),
        **rendered(package, _TEMPLATES, flags=arithmetic_flags(package), **_compatibility(package.version)),
        **sources(package, headers=f"include/{package.name}"),
    }


def _compatibility(version: str) -> dict[str, Any]:
    """Which versions stand in for each other: those of one major version; before 1.0 of one minor version."""
    major, minor, _ = version.split(".")
    if major == "0":
        return {"abi": f"0.{minor}", "compatibility": "SameMinorVersion"}
    return {"abi": major, "compatibility": "SameMajorVersion"}


FORMAT = Format(
    name="cmake",
    title="a CMake package",
    tool="CMake 3.16 or newer, and pkg-config",
    language=C,
    files=_files,
    take="cmake -S {folder} -B build && cmake --build build && cmake --install build --prefix PREFIX",
)
