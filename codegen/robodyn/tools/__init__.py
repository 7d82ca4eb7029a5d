"""Programs and libraries beside robodyn: what each enables, where it is, how to get it.

A record stands here, or with what it belongs to: a compiler with its language, an emulator with its
architecture. Error messages, ``robodyn doctor`` and the tests take names and packages from the records.
"""

from robodyn.tools.tool import Library, Tool, Use

__all__ = ["Library", "Tool", "Use"]
