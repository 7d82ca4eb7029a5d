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


_PACKAGES = {
    "ament_xmllint": "python3-ament-xmllint", "clang": "clang", "clang++": "clang",
    "chromedriver": "chromium-driver", "chromium": "chromium", "fish": "fish", "g++": "g++", "make": "make",
    "nm": "binutils", "npm": "npm", "rustc": "rustc", "rustfmt": "rustfmt", "xmllint": "libxml2-utils",
    "zsh": "zsh",
}  # fmt: skip
DEVELOPMENT: Final = tuple(
    Tool((name,), Use.DEVELOPMENT, "tests that are skipped without it", package)
    for name, package in _PACKAGES.items()
)
"""What only robodyn's own tests use."""

PROGRAMS: Final = (
    PYTHON_HEADERS, CMAKE, PKG_CONFIG, FPM, GAPPA, FRAMA_C, CPPCHECK, GCC, VALGRIND, *DEVELOPMENT,
)  # fmt: skip
"""All programs of this file."""
