"""From a log to what the model lacks: the gate, signals, candidates, names, estimates, proof.

The package can be called: ``robodyn.diagnose(...)`` is :func:`robodyn.diagnose.run.diagnose`.
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
        from robodyn.diagnose.run import diagnose

        return diagnose(*arguments, **options)


sys.modules[__name__].__class__ = _Package
