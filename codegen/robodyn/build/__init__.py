"""Compile emitted kernels with the system's compiler, keep them, call them on numpy arrays."""

from robodyn.build.cache import Cache, default_root
from robodyn.build.compiler import C_FLAGS, FORTRAN_FLAGS, Compiler, Language, find_c, find_fortran
from robodyn.build.function import Function
from robodyn.build.kernel import Kernel, load
from robodyn.build.library import Mode
from robodyn.build.workspace import Workspace

__all__ = [
    "C_FLAGS",
    "FORTRAN_FLAGS",
    "Cache",
    "Compiler",
    "Function",
    "Kernel",
    "Language",
    "Mode",
    "Workspace",
    "default_root",
    "find_c",
    "find_fortran",
    "load",
]
