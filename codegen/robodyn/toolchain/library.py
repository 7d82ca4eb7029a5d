"""From emitted files to a loaded library: compile, link, load with cffi.

There are two ways to load. ``api`` compiles a Python extension around the kernels, for the cheapest calls;
it needs Python's headers. ``abi`` opens a plain shared library; it needs nothing but the compiler, and a call
costs more. Both run the same machine code on the numbers. An ``api`` library may hold a second module, calls
that take numpy's arrays without cffi; where that cannot be compiled or loaded, the library does without.
"""

from __future__ import annotations

import importlib.machinery
import importlib.util
import platform
import sys
import sysconfig
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any, Literal

import numpy as np

from robodyn.emit.languages import compiled_language, language_named
from robodyn.errors import InputError, ToolError
from robodyn.toolchain.cache import Cache, content_key
from robodyn.toolchain.compiler import (
    C_FLAGS,
    Compiler,
    find_c,
    find_compiler,
    split_flags,
)
from robodyn.tools.programs import PYTHON_HEADERS

Mode = Literal["auto", "api", "abi"]

#: With a hyphen, which no emitted file has in its name: a robot may be called what it likes.
_WRAPPER, _DIRECT = "robodyn-calls.c", "robodyn-direct.c"
#: The second module of an ``api`` library, by which Python finds it there.
DIRECT = "robodyn_direct"
_STRICT = ("-Werror=incompatible-pointer-types", "-Werror=implicit-function-declaration")
_loaded: dict[str, Library] = {}
_lock = threading.Lock()


@dataclass(frozen=True, slots=True)
class Calls:
    """The C between Python and the kernels: its source, its prototypes as cffi reads them; ``direct``: the
    source of the module :data:`DIRECT`, "" for none."""

    prototypes: str
    source: str
    direct: str = ""


@dataclass(frozen=True, slots=True)
class Library:
    """A loaded library: cffi's two halves, and how it was made; ``direct`` is its second module, if any."""

    ffi: Any
    lib: Any
    mode: Literal["api", "abi"]
    path: Path
    compiler: str
    flags: tuple[str, ...]
    direct: Any = None


def open_library(
    calls: Calls,
    files: Mapping[str, str],
    *,
    language: str,
    mode: Mode,
    cc: str | None,
    fc: str | None,
    flags: str | Sequence[str] | None,
    cache: Path | None,
) -> Library:
    """Compile (or find in the cache) and load; see :func:`robodyn.kernels.kernel.load`."""
    sources = _sources(files, language)
    c = find_c(cc)
    main = c if language == "c" else find_compiler(language, fc)
    chosen = compiled_language(language)[1].flags if flags is None else split_flags(flags)
    around = chosen if language == "c" else C_FLAGS
    content = {
        "files": dict(files),
        "wrapper": [calls.source, calls.direct],
        "language": language,
        "flags": [chosen, around],
        "compilers": [[k.command, k.identity] for k in (c, main)],
        "platform": _platform(chosen),
    }

    def attempt(way: Literal["api", "abi"]) -> Library:
        key = content_key({**content, "way": [way, _python() if way == "api" else ""]})
        with _lock:
            if key in _loaded:
                return _loaded[key]
        name = f"_robodyn_{key}"

        def build(folder: Path) -> str:
            for path, source in {**files, _WRAPPER: calls.source}.items():
                target = folder / path
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_text(source, encoding="utf-8", newline="\n")
            objects = [main.compile(source, flags=chosen, folder=folder) for source in sources]
            objects.append(c.compile(_WRAPPER, flags=(*around, *_STRICT), folder=folder))
            if way == "api":
                objects.append(_binding(name, calls.prototypes, c, folder))
                objects += _direct(calls.direct, c, folder)
            suffix = str(sysconfig.get_config_var("EXT_SUFFIX")) if way == "api" else ".so"
            main.link(objects, name + suffix, flags=chosen, folder=folder, extension=way == "api")
            return name + suffix

        path = _fetch(Cache(cache), key, build)
        ffi, lib = _load_api(name, path) if way == "api" else _load_abi(calls.prototypes, path)
        direct = _load_direct(path) if way == "api" and calls.direct else None
        library = Library(ffi, lib, way, path, main.version, chosen, direct)
        with _lock:
            return _loaded.setdefault(key, library)

    if mode == "api" and not _headers():
        raise ToolError(
            "Python's headers are missing",
            found=f"no Python.h in {sysconfig.get_path('include')}",
            remedy=f"install them ({PYTHON_HEADERS.install}), or take mode 'abi'",
        )
    if mode == "abi" or not _headers():
        return attempt("abi")
    if mode == "api":
        return attempt("api")
    try:
        return attempt("api")
    except _BindingError:
        return attempt("abi")


class _BindingError(ToolError):
    """The glue to Python does not compile or load; the kernels may well do."""


def _sources(files: Mapping[str, str], language: str) -> list[str]:
    """The files to compile, in the order given."""
    spoken = language_named(language)
    endings = spoken.suffixes
    for path in files:
        pure = PurePosixPath(path)
        if pure.is_absolute() or ".." in pure.parts or path in (_WRAPPER, _DIRECT):
            raise InputError(
                "an emitted file has an impossible path",
                found=repr(path),
                expected="a path inside the folder",
            )
    sources = [path for path in files if path.endswith(endings)]
    if not sources:
        raise InputError(
            f"there is no {spoken.title} among the emitted files",
            found=", ".join(files) or "no file at all",
            expected=f"a file that ends in {endings[0]}",
        )
    return sources


def _headers() -> bool:
    """Whether a Python extension can be compiled here."""
    return PYTHON_HEADERS.path() is not None


def _binding(name: str, declared: str, c: Compiler, folder: Path) -> str:
    """Write and compile cffi's glue; the object's name. No arithmetic is in it, so any flags will do."""
    import cffi

    ffi = cffi.FFI()
    ffi.cdef(declared)
    ffi.set_source(name, "#include <stddef.h>\n" + declared, compiler_verbose=0)
    ffi.emit_c_code(str(folder / f"{name}.c"))
    try:
        return c.compile(f"{name}.c", flags=("-O1", "-w", *_include()), folder=folder)
    except ToolError as error:
        raise _BindingError(
            error.what, found=error.found, remedy=f"{error.remedy}; mode 'abi' does without Python's headers"
        ) from None


def _include() -> list[str]:
    headers = {sysconfig.get_path("include"), sysconfig.get_path("platinclude")}
    return [f"-I{path}" for path in sorted(headers)]


def _direct(source: str, c: Compiler, folder: Path) -> list[str]:
    """Compile the module :data:`DIRECT`; its object, none where this Python or numpy cannot have it."""
    if not source or sys.implementation.name != "cpython":
        return []
    (folder / _DIRECT).write_text(source, encoding="utf-8", newline="\n")
    try:
        return [c.compile(_DIRECT, flags=("-O2", "-w", *_include(), f"-I{np.get_include()}"), folder=folder)]
    except ToolError:
        return []


def _fetch(cache: Cache, key: str, build: Callable[[Path], str]) -> Path:
    try:
        return cache.fetch(key, build)
    except OSError as error:
        raise ToolError(
            "the compiled kernel cannot be stored",
            found=f"{error.filename or cache.root}: {error.strerror or error}",
            remedy="set ROBODYN_CACHE to a folder that can be written",
        ) from None


def _load_api(name: str, path: Path) -> tuple[Any, Any]:
    try:
        module = _module(name, path)
    except ImportError as error:
        raise _BindingError(
            "the compiled kernel does not load", found=str(error), remedy=_EXECUTABLE
        ) from None
    return module.ffi, module.lib


def _load_direct(path: Path) -> Any:
    try:
        return _module(DIRECT, path)
    except ImportError:  # it is not in there, or is not for this numpy
        return None


def _module(name: str, path: Path) -> Any:
    """The module ``name`` of the library ``path``, which may hold several."""
    loader = importlib.machinery.ExtensionFileLoader(name, str(path))
    spec = importlib.util.spec_from_file_location(name, path, loader=loader)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


def _load_abi(declared: str, path: Path) -> tuple[Any, Any]:
    import cffi

    ffi = cffi.FFI()
    ffi.cdef(declared)
    try:
        return ffi, ffi.dlopen(str(path))
    except OSError as error:
        raise ToolError("the compiled kernel does not load", found=str(error), remedy=_EXECUTABLE) from None


_EXECUTABLE = "set ROBODYN_CACHE to a folder from which libraries may be loaded"


def _python() -> list[str]:
    """What an extension depends on: this Python's binary interface, cffi's and numpy's, and whether numpy's
    headers are there (distributions have them in a package of their own), for they may be installed later."""
    import cffi

    return [
        sys.implementation.name,
        str(sysconfig.get_config_var("EXT_SUFFIX")),
        sysconfig.get_path("include"),
        cffi.__version__,
        np.__version__,
        str(Path(np.get_include(), "numpy", "arrayobject.h").is_file()),
    ]


def _platform(flags: Sequence[str]) -> list[str]:
    """The machine that the code is for; its very processor where a flag says ``native``."""
    machine = [sys.platform, platform.machine(), *platform.libc_ver()]
    if any("native" in flag for flag in flags):
        try:
            lines = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace").splitlines()
            kept = {
                line for line in lines if line.startswith(("model name", "flags", "Features", "CPU part"))
            }
            machine += sorted(kept)
        except OSError:
            machine += [platform.processor(), platform.node()]
    return machine
