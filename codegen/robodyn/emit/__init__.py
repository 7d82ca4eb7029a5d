"""Emission: a program spelled in C or Fortran. Returns texts by name, writes nothing."""

from robodyn.emit.render import Unit, render

__all__ = ["Unit", "render"]
