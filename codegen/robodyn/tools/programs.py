"""The programs that belong to no language and no processor."""

from __future__ import annotations

import sysconfig
from typing import Final

from robodyn.tools.tool import Tool, Use

PYTHON_HEADERS: Final = Tool(
    ("Python.h",),
    Use.KERNELS,
    "shorter calls from Python",
    "python3-dev",
    "Fedora: dnf install python3-devel",
    version_arguments=(),
    folder=lambda: sysconfig.get_path("include"),
)

GAPPA: Final = Tool(
    ("gappa",), Use.PROOFS, "bounds on rounding errors", "gappa", "https://gappa.gitlabpages.inria.fr"
)
FRAMA_C: Final = Tool(
    ("frama-c",),
    Use.PROOFS,
    "proofs that no input leads to undefined behaviour",
    "frama-c-base",
    "opam install frama-c, https://frama-c.com",
    version_arguments=("-version",),
)
CPPCHECK: Final = Tool(
    ("cppcheck",), Use.PROOFS, "deviations from MISRA C:2012", "cppcheck", "https://cppcheck.sourceforge.io"
)
GCC: Final = Tool(("gcc",), Use.PROOFS, "worst-case stacks", "gcc", "a real gcc: clang writes no stack usage")

VALGRIND: Final = Tool(("valgrind",), Use.COMPARISONS, "instructions per call in robodyn bench", "valgrind")

CMAKE: Final = Tool(("cmake",), Use.PACKAGES, "builds of robodyn package --as cmake", "cmake")
PKG_CONFIG: Final = Tool(("pkg-config",), Use.PACKAGES, "builds that ask pkg-config", "pkg-config")
FPM: Final = Tool(("fpm",), Use.PACKAGES, "builds of robodyn package --as fpm", None, "pip install fpm")


def _development(name: str, package: str) -> Tool:
    return Tool((name,), Use.DEVELOPMENT, "tests that are skipped without it", package)


DEVELOPMENT: Final = (
    _development("ament_xmllint", "python3-ament-xmllint"),
    _development("clang", "clang"),
    _development("clang++", "clang"),
    _development("chromedriver", "chromium-driver"),
    _development("chromium", "chromium"),
    _development("fish", "fish"),
    _development("g++", "g++"),
    _development("make", "make"),
    _development("nm", "binutils"),
    _development("npm", "npm"),
    _development("rustc", "rustc"),
    _development("rustfmt", "rustfmt"),
    _development("xmllint", "libxml2-utils"),
    _development("zsh", "zsh"),
)
"""What only robodyn's own tests use."""

PROGRAMS: Final = (
    PYTHON_HEADERS, CMAKE, PKG_CONFIG, FPM, GAPPA, FRAMA_C, CPPCHECK, GCC, VALGRIND, *DEVELOPMENT,
)  # fmt: skip
"""All programs of this file."""
