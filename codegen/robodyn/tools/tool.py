"""What programs beside robodyn are, and Python packages that it can use."""

from __future__ import annotations

import importlib
import importlib.util
import os
import shlex
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import Any

from robodyn.errors import Place, ToolError


class Use(StrEnum):
    """What programs and libraries are used for, in the order in which they are shown."""

    EVERYTHING = "needed by everything"
    KERNELS = "compiled kernels"
    LANGUAGES = "kernels in other languages"
    FIRMWARE = "firmware images"
    PACKAGES = "packages for other builds"
    PROOFS = "proofs"
    ARMS = "arms in other formats"
    LOGS = "logs in other formats"
    SCHEDULES = "schedules"
    CLUSTERS = "work on many processors"
    COMPARISONS = "measurements and comparisons"
    DEVELOPMENT = "robodyn's own tests"


@dataclass(frozen=True, slots=True)
class Tool:
    """A program, or another file of this machine that no Python package brings.

    Attributes
    ----------
    names: what it may be called on the ``PATH``; the first that is there is taken. What messages call it
        is the first of all.
    enables: what robodyn can do with it, in the plural: "proofs that ...".
    debian: its package in Debian and Ubuntu, if it has one.
    others: how to get it elsewhere.
    variable: the variable of the environment that may name it, with arguments.
    version_arguments: what makes it print its version; none: it has none.
    folder: where it is, in place of the ``PATH``.
    """

    names: tuple[str, ...]
    use: Use
    enables: str
    debian: str | None
    others: str = ""
    variable: str | None = None
    version_arguments: tuple[str, ...] = ("--version",)
    folder: Callable[[], str] | None = None

    @property
    def name(self) -> str:
        """What messages call it."""
        return self.names[0]

    @property
    def install(self) -> str:
        """How to get it."""
        ways = [f"Debian, Ubuntu: apt install {self.debian}"] if self.debian else []
        return "; ".join([*ways, *([self.others] if self.others else [])])

    @property
    def remedy(self) -> str:
        """The name, and how to get it."""
        return f"{self.name} ({self.install})"

    def path(self) -> str | None:
        """Where it is; None where it is not."""
        if self.folder is not None:
            file = Path(self.folder()) / self.name
            return str(file) if file.is_file() else None
        return next((path for name in self.names if (path := shutil.which(name)) is not None), None)

    def needed(self) -> str:
        """Where it is.

        Raises
        ------
        ToolError: nowhere.
        """
        path = self.path()
        if path is None:
            raise ToolError(f"there is no program {self.name}", remedy=f"install it: {self.install}")
        return path

    def command(self) -> tuple[str, ...] | None:
        """How it is called: as the environment says, else where it is; None where it is not."""
        named = os.environ.get(self.variable, "") if self.variable else ""
        try:
            words = shlex.split(named)
        except ValueError:
            return None
        path = shutil.which(words[0]) if words else self.path()
        return None if path is None else (path, *words[1:])


@dataclass(frozen=True, slots=True)
class Library:
    """A package of PyPI: its ``module``, and the ``extra`` of robodyn that brings it, if one does.

    ``enables`` is what robodyn can do with it, in the plural: "arms in MJCF". ``title`` is what messages call
    it, ``package`` what PyPI does, where these are not the module's name.
    """

    module: str
    use: Use
    enables: str
    package: str = ""
    extra: str | None = None
    title: str = ""

    @property
    def name(self) -> str:
        """What messages call it."""
        return self.title or self.distribution

    @property
    def distribution(self) -> str:
        """What PyPI calls it."""
        return self.package or self.module

    @property
    def install(self) -> str:
        """How to get it."""
        return f"pip install 'robodyn[{self.extra}]'" if self.extra else f"pip install {self.distribution}"

    def present(self) -> bool:
        """Whether it is installed; it is not imported."""
        return importlib.util.find_spec(self.module) is not None

    def load(self, submodule: str = "", *, where: Place | None = None, otherwise: str = "") -> Any:
        """Its module, or a ``submodule`` of that; ``where`` and ``otherwise`` as of :meth:`missing`.

        Raises
        ------
        ToolError: it is not installed.
        """
        try:
            return importlib.import_module(f"{self.module}.{submodule}" if submodule else self.module)
        except ImportError:
            raise self.missing(where=where, otherwise=otherwise) from None

    def missing(self, *, where: Place | None = None, otherwise: str = "") -> ToolError:
        """The error where it is not installed; ``otherwise`` is what helps as well."""
        return ToolError(
            f"{self.enables} need {self.name}, which is not installed",
            where=where,
            remedy=f"{self.install}{f', or {otherwise}' if otherwise else ''}",
        )
