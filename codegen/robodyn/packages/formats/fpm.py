"""The Fortran package manager: a library with one module."""

from __future__ import annotations

from robodyn.emit.languages.fortran import LANGUAGE as FORTRAN
from robodyn.packages.format import Files, Format, Package
from robodyn.packages.writing import readme, rendered, sources


def _files(package: Package) -> Files:
    return {**readme(package), **rendered(package, {"fpm.toml": "fpm.toml.j2"}), **sources(package)}


FORMAT = Format(
    name="fpm",
    title="an fpm package",
    tool="fpm 0.8 or newer, with gfortran",
    language=FORTRAN,
    files=_files,
    take="add to the dependencies in fpm.toml: {name}, with path {folder}",
)
