"""Folders and archives that somebody else's build takes as they are, with a robot's kernels in them.

>>> from robodyn.packages import package
>>> package(generate(load("puma560")), "cmake").files()                  # doctest: +SKIP
{"CMakeLists.txt": ..., "src/puma560.c": ..., ...}

One file of :mod:`.formats` for each format; :mod:`.format` is what a format is and what it is given,
:mod:`.writing` what they share.
"""

from __future__ import annotations

import re
from typing import Final

from robodyn.errors import InputError
from robodyn.kernels.generate import Generated
from robodyn.packages.format import Argument, Format, Package, Routine, read_maintainer
from robodyn.packages.formats import FORMATS, format_named

__all__ = ["FORMATS", "Argument", "Format", "Package", "Routine", "format_named", "package"]

#: The version of a package whose user states none.
FIRST_VERSION: Final = "0.1.0"
#: What CMake, cargo, fpm, pip, ROS, PlatformIO and FMI all take.
_VERSION: Final = re.compile(r"(0|[1-9][0-9]{0,5})(\.(0|[1-9][0-9]{0,5})){2}")
#: An SPDX expression, as far as the characters go.
_LICENSE: Final = re.compile(r"[A-Za-z0-9][A-Za-z0-9.+() -]{0,98}")


def package(
    generated: Generated,
    form: str | Format,
    *,
    version: str = FIRST_VERSION,
    license: str | None = None,
    maintainer: str | None = None,
) -> Package:
    """The package of ``generated`` in the format ``form``; ``maintainer`` as ``NAME <EMAIL>``.

    Raises
    ------
    InputError: there is no such format, it has no place for what the kernels are, the robot lacks a function
        that it needs, or version, licence or maintainer are none.
    """
    form = format_named(form) if isinstance(form, str) else form
    if not _VERSION.fullmatch(version):
        raise InputError(
            "this is no version of a package",
            found=repr(version),
            expected="three numbers, as 1.2.0, which every format takes",
        )
    if license is not None and not _LICENSE.fullmatch(license):
        raise InputError(
            "this is no licence", found=repr(license), expected="an SPDX expression, such as Apache-2.0"
        )
    contact = None if maintainer is None else read_maintainer(maintainer)
    missing = [function for function in form.needs if function not in generated.counts]
    if missing:
        reasons = (f"{name}: {generated.left_out.get(name, 'not generated')}" for name in missing)
        raise InputError(
            f"{form.title} needs functions that {generated.unit.robot.name} lacks",
            found="; ".join(reasons),
            expected=", ".join(form.needs),
        )
    packed = Package(generated, form, version, license, contact)
    unfit = [phrase for trait, phrase in packed.traits.items() if trait in form.lacks]
    if unfit:
        raise InputError(
            f"{form.title} has no place for {' and '.join(unfit)}",
            remedy="choose another format, or a description and options without them",
        )
    return packed
