"""Motions, controllers, integration and sensors: what stands in for the arm and its log.

The package can be called: ``robodyn.simulate(...)`` is :func:`robodyn.simulate.simulation.simulate`.
A name cannot be both a function and a package, whichever was imported first.
"""

from __future__ import annotations

import sys
from types import ModuleType

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class _Package(ModuleType):
    def __call__(self, *arguments: Any, **options: Any) -> Any:
        from robodyn.simulate.simulation import simulate

        return simulate(*arguments, **options)


sys.modules[__name__].__class__ = _Package
