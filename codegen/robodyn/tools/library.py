"""What a Python package is that robodyn can use."""

from __future__ import annotations

import importlib
import importlib.util
from dataclasses import dataclass
from typing import Any

from robodyn.errors import Place, ToolError
from robodyn.tools.tool import Use


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
        return (
            f"pip install {self.distribution}"
            if self.extra is None
            else f"pip install 'robodyn[{self.extra}]'"
        )

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
