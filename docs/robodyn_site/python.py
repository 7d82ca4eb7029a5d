"""The Python library: a page for each group of the public names, from signatures and docstrings."""

from __future__ import annotations

import importlib
import inspect
from typing import Any, Final

import robodyn
from robodyn_site.docstrings import markdown
from robodyn_site.markdown import code, fenced, page, plain, table

FOLDER: Final = "python"

#: File -> title, what it is for, and the names: those of the package, and classes that its functions return.
GROUPS: Final = {
    "robots": ("Robots", "Read the description of an arm.", ("load", "Robot")),
    "kernels": (
        "Kernels",
        "Compile an arm's functions and call them, for one state or for many.",
        ("compile", "robodyn.kernels.kernel.Kernel", "robodyn.kernels.function.Function"),
    ),
    "code": (
        "Code and counts",
        "Generate the text of kernels, count their operations, or look at their programs.",
        ("generate", "Generated", "Options", "count", "robodyn.counts.count.Count", "program"),
    ),
    "models": (
        "Models to read",
        "An arm's equations as sympy expressions, and the parameters that its torques depend on.",
        ("symbolic", "robodyn.kernels.through_sympy.Symbolic", "base_parameters"),
    ),
    "simulate": (
        "Simulation and motions",
        "Move an arm with its effects, or design a motion.",
        ("simulate", "robodyn.simulate.simulation.Simulation", "excite", "robodyn.diagnose.excite.Design"),
    ),
    "logs": (
        "Identification and diagnosis",
        "Fit an arm to logs, and find what its model lacks.",
        ("identify", "robodyn.identify.run.Identification", "diagnose", "robodyn.diagnose.result.Diagnosis"),
    ),
    "errors": (
        "Errors",
        "What the library raises on purpose: each says what, where, found, expected and what to do.",
        ("RobodynError", "InputError", "ToolError", "CheckError"),
    ),
}
#: Packages that can be called: the function that a call runs.
_CALLED: Final = {
    "diagnose": "robodyn.diagnose.run.diagnose",
    "identify": "robodyn.identify.run.identify",
    "simulate": "robodyn.simulate.simulation.simulate",
}


def pages() -> dict[str, str]:
    """The pages of the library, and their index."""
    return {f"{FOLDER}/index.md": _index()} | {
        f"{FOLDER}/{name}.md": _group(*group) for name, group in GROUPS.items()
    }


def _index() -> str:
    rows = (
        (f"[{title}]({name}.md)", purpose, ", ".join(code(each.rpartition(".")[2]) for each in names))
        for name, (title, purpose, names) in GROUPS.items()
    )
    return page(
        "# Python library",
        "The library `robodyn` generates, compiles, counts, simulates, identifies and diagnoses.",
        table(("page", "what for", "names"), rows),
        markdown(inspect.getdoc(robodyn) or ""),
    )


def _group(title: str, purpose: str, names: tuple[str, ...]) -> str:
    return page(f"# {title}", purpose, *(_entry(name) for name in names))


def _entry(name: str) -> str:
    value = _value(name)
    shown = name.rpartition(".")[2] if "." in name else f"robodyn.{name}"
    members = _members(value) if inspect.isclass(value) else []
    return page(
        f"## {shown}",
        "" if "." in name else fenced(_signature(shown, value), "python"),
        markdown(inspect.getdoc(value) or ""),
        *(f"### {plain(f'{value.__name__}.{member}')}\n\n{text}" for member, text in members),
    )


def _value(name: str) -> Any:
    path = _CALLED.get(name, name if "." in name else f"robodyn.{name}")
    module, _, attribute = path.rpartition(".")
    return getattr(importlib.import_module(module), attribute)


def _signature(name: str, value: Any) -> str:
    """How it is called, an argument a line where there are many."""
    signature = inspect.signature(value)
    if inspect.isclass(value):
        signature = signature.replace(return_annotation=inspect.Signature.empty)
    arguments = [_argument(parameter) for parameter in signature.parameters.values()]
    keyword = next((k for k, p in enumerate(signature.parameters.values()) if p.kind is p.KEYWORD_ONLY), None)
    if keyword is not None:
        arguments.insert(keyword, "*")
    result = signature.return_annotation
    tail = ")" if result is inspect.Signature.empty else f") -> {result}"
    line = f"{name}({', '.join(arguments)}{tail}"
    return line if len(line) <= 80 else f"{name}(\n" + "".join(f"    {each},\n" for each in arguments) + tail


def _argument(parameter: inspect.Parameter) -> str:
    text = parameter.name
    if parameter.kind in (parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD):
        text = ("*" if parameter.kind is parameter.VAR_POSITIONAL else "**") + text
    if parameter.annotation is not parameter.empty:
        text += f": {parameter.annotation}"
    if parameter.default is not parameter.empty:
        default = repr(parameter.default)
        text += f" = {default if len(default) <= 30 and '<' not in default else '...'}"
    return text


def _members(value: type) -> list[tuple[str, str]]:
    """Methods and properties of a class that have a docstring."""
    members = []
    for name, member in vars(value).items():
        function = member.fget if isinstance(member, property) else getattr(member, "__func__", member)
        doc = inspect.getdoc(function)
        if (name.startswith("_") and name != "__call__") or not inspect.isfunction(function) or not doc:
            continue
        head = [] if isinstance(member, property) else [fenced(_signature(name, function), "python")]
        members.append((name, page(*head, markdown(doc))))
    return members
