"""Folders and archives that somebody else's build takes as they are, with a robot's kernels in them.

>>> from robodyn.packages import package
>>> package(generate(load("puma560")), "cmake").files()                  # doctest: +SKIP
{"CMakeLists.txt": ..., "src/puma560.c": ..., ...}

One file of :mod:`.formats` for each format; :mod:`.format` is what a format is and what it is given,
:mod:`.writing` what they share.
"""

from robodyn.packages.format import Argument, Format, Package, Routine
from robodyn.packages.formats import FORMATS, format_named
from robodyn.packages.packing import package

__all__ = ["FORMATS", "Argument", "Format", "Package", "Routine", "format_named", "package"]
