"""Emission: a program spelled in a language. Returns texts by name, writes nothing."""

from robodyn.emit.render import Unit, render

__all__ = ["Unit", "render"]
