"""Run as a script of its own: expands a xacro file by the package xacro, and prints the XML.

xacro evaluates expressions of the file as Python. Here they are looked at first: no names with underscores
in front, no frames, no generators, none of the functions that lead out of numbers and texts. The process has
bounds of time and memory and cannot write files. Nothing of robodyn is imported: Python runs this isolated.
"""

from __future__ import annotations

import ast
import json
import os
import sys
from pathlib import Path
from typing import Any

#: Attributes that lead from values to the interpreter, and functions that do.
_CLOSED = {"compile", "eval", "exec", "format", "format_map", "getattr", "globals", "locals", "mro", "open"}
_CLOSED |= {"type", "vars"}
_FRAMES = ("gi_", "cr_", "ag_", "tb_", "f_", "co_", "func_", "im_")
_REFUSED = (ast.GeneratorExp, ast.Lambda, ast.Await, ast.Yield, ast.YieldFrom, ast.NamedExpr)


class Refused(Exception):
    """An expression is more than arithmetic."""


def check(expression: str) -> None:
    """Refuse what is more than numbers, texts, lists and calls of plain functions.

    Raises
    ------
    Refused: what it is.
    """
    try:
        tree = ast.parse(expression.strip(), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        raise Refused(f"not an expression: {expression.strip()[:80]!r}") from None
    for node in ast.walk(tree):
        name = node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""
        if isinstance(node, _REFUSED) or name.startswith(("_", *_FRAMES)) or name in _CLOSED:
            raise Refused(f"an expression that is refused: {expression.strip()[:80]!r}")


def package_folder(name: str, file: Path) -> str:
    """The folder of the package ``name``: of ROS where there is one, else beside ``file`` or above it."""
    if name and os.sep not in name and name not in (".", ".."):
        for prefix in filter(None, os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep)):
            if (Path(prefix) / "share" / name).is_dir():
                return str(Path(prefix) / "share" / name)
        for root in filter(None, os.environ.get("ROS_PACKAGE_PATH", "").split(os.pathsep)):
            if (Path(root) / name).is_dir():
                return str(Path(root) / name)
        for folder in file.resolve().parents:
            if folder.name == name:
                return str(folder)
            if (folder / name).is_dir():
                return str(folder / name)
    raise Refused(f"the package {name!r} is neither installed nor a folder beside or above the file")


def bound(seconds: int, memory: int) -> None:
    """Give this process bounds: processor time [s], memory [bytes], no file that grows."""
    try:
        import resource
    except ImportError:
        return
    for limit, value in (
        (resource.RLIMIT_CPU, seconds),
        (resource.RLIMIT_AS, memory),
        (resource.RLIMIT_FSIZE, 0),
        (resource.RLIMIT_CORE, 0),
    ):
        _, most = resource.getrlimit(limit)
        least = value if most == resource.RLIM_INFINITY else min(value, most)
        resource.setrlimit(limit, (least, least))


def expand(file: str, arguments: dict[str, str]) -> str:
    """The XML text of ``file`` with the ``arguments`` of its ``xacro:arg``."""
    import xacro
    from xacro import substitution_args

    evaluate, evaluate_argument = xacro.safe_eval, substitution_args._eval

    def checked(expression: str, *rest: Any) -> Any:
        check(expression)
        return evaluate(expression, *rest)

    def checked_argument(expression: str, context: Any) -> Any:
        check(expression)
        return evaluate_argument(expression, context)

    def find(name: str) -> str:
        return package_folder(name, Path(file))

    xacro.safe_eval, substitution_args._eval, substitution_args._eval_find = checked, checked_argument, find
    substitution_args._eval_dict["find"] = find
    document = xacro.process_file(file, mappings=arguments)
    text: str = document.documentElement.toprettyxml(indent="  ")
    return text


def _words(error: BaseException) -> str:
    """The message, that of a refusal without what xacro wraps around it."""
    inner: Any = error
    while inner is not None:
        if isinstance(inner, Refused | MemoryError):
            return str(inner) or "out of memory"
        inner = getattr(inner, "exc", None)
    return str(error) or type(error).__name__


def main() -> int:
    """``FILE SECONDS MEMORY ARGUMENTS`` (JSON): XML on stdout, or one line on stderr and the code 1."""
    file, seconds, memory, arguments = sys.argv[1:]
    bound(int(seconds), int(memory))
    output = sys.stdout
    sys.stdout = sys.stderr = open(os.devnull, "w")  # noqa: PTH123, SIM115 (xacro prints warnings)
    try:
        text = expand(file, json.loads(arguments))
    except BaseException as error:
        sys.__stderr__.write(" ".join(_words(error).split())[:1000])  # type: ignore[union-attr]
        return 1
    output.buffer.write(text.encode("utf-8", "replace"))
    output.flush()
    return 0


if __name__ == "__main__":
    sys.exit(main())
