"""Emission: a program spelled in a language. Returns texts by name, writes nothing."""

from robodyn.emit.render import render
from robodyn.emit.unit import Unit

__all__ = ["Unit", "render"]
