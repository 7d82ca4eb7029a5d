"""Compile runners, once: what has not changed is not compiled again."""

from __future__ import annotations

import functools
import hashlib
import importlib.metadata
import shutil
import subprocess
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

NATIVE_FOLDER = Path(__file__).with_name("native")

#: What everything is timed with, ours and theirs.
NATIVE = ("-O3", "-march=native")
#: What instructions are counted with where it is not C that a tool has generated: valgrind knows no AVX-512.
AVX2 = ("-O3", "-march=x86-64-v3")
#: What instructions of generated C are counted with.
STRICT = ("-std=c99", "-O2", "-march=x86-64-v3")
_SHARED = ("-fPIC", "-shared", "-w", "-fno-gnu-unique", "-Wl,-Bsymbolic")


class Lacking(Exception):
    """A peer cannot be had here: what is missing, and how to get it."""


@dataclass(frozen=True, slots=True)
class Source:
    """A runner to compile: files of the folder ``native`` or absolute ones, and what they need."""

    files: tuple[str | Path, ...]
    flags: tuple[str, ...] = ()
    libraries: tuple[str, ...] = ()
    defines: tuple[tuple[str, str], ...] = ()
    #: Versions of packages whose headers are compiled in.
    packages: tuple[str, ...] = ()


def version(package: str) -> str:
    """The version of a Python package.

    Raises
    ------
    Lacking: it is not installed.
    """
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        raise Lacking(f"the Python package {package} is not installed: pip install {package}") from None


def package_folder(package: str, inside: str) -> Path:
    """The folder ``inside`` the place where ``package`` is installed."""
    version(package)
    place = Path(str(importlib.metadata.distribution(package).locate_file(inside)))
    if not place.exists():
        raise Lacking(f"the installed {package} has no {inside}")
    return place


@functools.cache
def compiler(language: str) -> tuple[str, str]:
    """Path and version of gcc or g++."""
    program = {"c": "gcc", "c++": "g++"}[language]
    path = shutil.which(program)
    if path is None:
        raise Lacking(f"there is no {program}: apt-get install {program}")
    output = subprocess.run([path, "--version"], capture_output=True, text=True, check=True).stdout
    return path, output.splitlines()[0]


def library(target: Path, source: Source, optimise: Sequence[str]) -> Path:
    """The shared library ``target`` of ``source``, compiled with ``optimise``.

    Raises
    ------
    Lacking: no compiler, or it refuses the sources.
    """
    return _compiled(target, source, [*optimise, *_SHARED], optimise)


def program(target: Path, source: Source, optimise: Sequence[str] = ("-O2",)) -> Path:
    """The program ``target`` of ``source``."""
    return _compiled(target, source, [*optimise, "-w"], optimise)


def _compiled(target: Path, source: Source, flags: Sequence[str], optimise: Sequence[str]) -> Path:
    paths = [NATIVE_FOLDER / file for file in source.files]
    plus = any(path.suffix == ".cpp" for path in paths)
    path, compiler_version = compiler("c++" if plus else "c")
    defines = [f"-D{name}={value}" for name, value in source.defines]
    if plus:
        flags = [flag for flag in flags if not flag.startswith("-std=c99")]
    rest = [*source.flags, f"-I{NATIVE_FOLDER}", *defines]
    command = [path, *flags, *rest, *map(str, paths), *source.libraries, "-lm", "-o", str(target)]
    key = _key(
        [*command, compiler_version, *(f"{p} {version(p)}" for p in source.packages)], _texts(paths, source)
    )
    note = target.with_suffix(".key")
    if target.is_file() and note.is_file() and note.read_text(encoding="utf-8") == key:
        return target
    target.parent.mkdir(parents=True, exist_ok=True)
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        lines = [line for line in done.stderr.splitlines() if "error" in line] or done.stderr.splitlines()
        raise Lacking(f"does not compile: {' | '.join(lines[:2])[:300]}")
    note.write_text(key, encoding="utf-8")
    return target


def _texts(paths: Iterable[Path], source: Source) -> Mapping[str, str]:
    """What is compiled: the sources, the headers beside them and those of this folder."""
    files = {path for path in paths if path.is_file()}
    for folder in {path.parent for path in files} | {NATIVE_FOLDER}:
        files |= {*folder.glob("*.h"), *folder.glob("*.hpp")}
    return {path.name: path.read_text(encoding="utf-8", errors="replace") for path in sorted(files)}


def _key(command: Sequence[str], texts: Mapping[str, str]) -> str:
    digest = hashlib.sha256("\0".join(command).encode())
    for name, text in texts.items():
        digest.update(f"\0{name}\0{text}".encode())
    return digest.hexdigest()
