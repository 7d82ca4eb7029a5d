"""The arm's numbers from logs: links, friction and rotors, physically consistent, with intervals.

The package can be called: ``robodyn.identify(...)`` is :func:`robodyn.identify.run.identify`.
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
        from robodyn.identify.run import identify

        return identify(*arguments, **options)


sys.modules[__name__].__class__ = _Package
