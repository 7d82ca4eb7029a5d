"""From kernels and a format to a package: what does not fit is refused before anything is written."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Final

from robodyn.errors import InputError
from robodyn.kernels.generate import Generated
from robodyn.packages.format import Format, Package, Trait, read_maintainer
from robodyn.packages.formats import format_named

#: The version of a package whose user states none.
FIRST_VERSION: Final = "0.1.0"
#: What CMake, cargo, fpm, pip, ROS, PlatformIO and FMI all take.
_VERSION: Final = re.compile(r"(0|[1-9][0-9]{0,5})(\.(0|[1-9][0-9]{0,5})){2}")
#: An SPDX expression, as far as the characters go.
_LICENSE: Final = re.compile(r"[A-Za-z0-9][A-Za-z0-9.+() -]{0,98}")
_PHRASES: Final[Mapping[Trait, str]] = {
    "parameters": "run-time parameters",
    "memory": "memory from call to call",
    "given sines": "sines and cosines that are given (--trig given)",
}


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
    _check_metadata(version, license)
    contact = None if maintainer is None else read_maintainer(maintainer)
    missing = [function for function in form.needs if function not in generated.counts]
    if missing:
        reasons = (f"{name}: {generated.left_out.get(name, 'not generated')}" for name in missing)
        raise InputError(
            f"{form.title} needs functions that {generated.unit.robot.name} lacks",
            found="; ".join(reasons),
            expected=", ".join(form.needs),
        )
    unfit = [_PHRASES[trait] for trait in _traits(generated) if trait in form.lacks]
    if unfit:
        raise InputError(
            f"{form.title} has no place for {' and '.join(unfit)}",
            remedy="choose another format, or a description and options without them",
        )
    return Package(generated, form, version, license, contact)


def _check_metadata(version: str, license: str | None) -> None:
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


def _traits(generated: Generated) -> Iterable[Trait]:
    """Those that the kernels have."""
    if generated.unit.robot.parameters:
        yield "parameters"
    if generated.unit.states:
        yield "memory"
    if generated.unit.sc or generated.options.trig == "given":
        yield "given sines"
