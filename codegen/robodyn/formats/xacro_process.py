"""Run as a process of its own: expands a xacro file by the package xacro, and prints the XML.

The package walks the XML; whatever it would evaluate, read or look up is done here in its place
(:data:`REPLACED`): expressions over a whitelist of syntax, files within the file's packages, no environment.
Two walls stand behind that: the process has bounds of time and memory, cannot write files and is given no
environment, and an audit hook ends what would run code, open another file or start a program, so that a
version of the package that evaluates by another way than it did is refused.
"""

from __future__ import annotations

import glob
import json
import os
import re
import sys
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final
from xml.dom import expatbuilder
from xml.parsers import expat

from robodyn import files
from robodyn.errors import Place, RobodynError
from robodyn.files import MIB, label
from robodyn.formats.limits import FILE_MIB
from robodyn.formats.xacro_expressions import evaluate
from robodyn.formats.xacro_files import Files, load_yaml
from robodyn.formats.xacro_values import (
    DATA,
    MATH,
    PYTHON,
    Function,
    Names,
    Refused,
    check_count,
    shown,
    tokenize,
)
from robodyn.formats.xml_text import load_encodings, xml_text
from robodyn.process import bound

#: What is taken out of the package and replaced; a version without one of them is refused.
REPLACED: Final = (
    "_global_symbols", "eval_extension", "eval_text", "get_include_files", "load_yaml", "parse", "safe_eval",
)  # fmt: skip
#: Names of xacro that need no ``python.`` or ``math.`` in front.
_GLOBAL: Final = (
    "list", "dict", "map", "len", "str", "float", "int", "bool", "min", "max", "round", "sorted", "range",
)  # fmt: skip
#: Beginnings of audited events that have no part in an expansion.
_AUDITED: Final = (
    "exec",
    "import",
    "open",
    "os.",
    "subprocess.",
    "socket.",
    "ctypes.",
    "shutil.",
    "marshal.",
)
_UNAUDITED: Final = ("os.scandir", "os.listdir")
_OF_EVAL: Final = {"true": True, "false": False}
_FIND: Final = re.compile(r"\$\(find +([^()\s]+) *\)")


class _Builder(expatbuilder.ExpatBuilderNS):
    """A document without a document type: there are no entities, and nothing else is read."""

    def start_doctype_decl_handler(self, *_: Any) -> None:
        raise Refused("the file has a document type: delete it, entities are not expanded")


class Expansion:
    """The expansion of one file: what xacro does through :data:`REPLACED`.

    ``arguments`` are those of the command line: of ``xacro:arg`` by name, and behind ``find`` and ``env`` the
    folder of a package and the value of an environment variable.
    """

    def __init__(self, file: str, arguments: Mapping[str, str], ros: tuple[str, str]) -> None:
        import unicodedata  # noqa: F401 (for names that are not ASCII; later nothing is imported)

        import xacro
        import yaml  # noqa: F401

        missing = [name for name in REPLACED if not hasattr(xacro, name)]
        if missing:
            raise Refused(f"this version of the package xacro has no {missing[0]}: install 'xacro>=2.1,<3'")
        self.xacro, self.eval_text = xacro, xacro.eval_text
        stated: dict[str, dict[str, str]] = {"find": {}, "env": {}, "": {}}
        for name, value in arguments.items():
            words = name.split(None, 1)
            of_command = len(words) == 2 and words[0] in stated
            stated[words[0] if of_command else ""][words[1] if of_command else name] = value
        self.arguments, self.environment = stated[""], stated["env"]
        self.file, self.files = file, Files(file, stated["find"], ros)
        self.warnings: dict[Place, str] = {}
        self.symbols = self._symbols(xacro._global_symbols)

    def text(self) -> str:
        """The XML of the document."""
        xacro = self.xacro
        xacro.safe_eval, xacro.eval_extension = self.value, self.substituted
        xacro.get_include_files, xacro.load_yaml, xacro.parse = self.included, self.yaml, self.document
        xacro.eval_text = self.evaluated
        xacro._global_symbols = self.symbols
        document = xacro.process_file(self.file, mappings=self.arguments)
        text: str = document.documentElement.toprettyxml(indent="  ")
        return text

    def _symbols(self, names: Mapping[str, Any]) -> dict[str, Any]:
        """What is in place of xacro's global names: all of them, so that each counts as defined."""
        functions = {
            "abs_filename": self.xacro.abs_filename_spec,
            "arg": self._argument,
            "dotify": lambda value: value,
            "fatal": _fail,
            "load_yaml": self.yaml,
            "tokenize": tokenize,
            **dict.fromkeys(("error", "message", "print_location", "warning"), lambda *_, **__: ""),
        }
        of_xacro = {name: Function(name, function) for name, function in functions.items()}
        spaces = {"python": PYTHON, "math": MATH, "xacro": of_xacro}
        known = {
            **MATH,
            **{name: PYTHON[name] for name in _GLOBAL},
            **{name: of_xacro[name] for name in ("load_yaml", "abs_filename", "dotify")},
            **{name: Names(space.__getitem__) for name, space in spaces.items()},
        }
        return {name: known.get(name, Function(name, _unavailable)) for name in names} | known

    def evaluated(self, text: str, symbols: Any) -> Any:
        """Around ``eval_text``: texts that double from property to property have an end."""
        check_count(len(text or ""))
        value = self.eval_text(text, symbols)
        check_count(len(value) if type(value) is str else 0)
        return value

    def value(self, expression: str, symbols: Any, _: Any = None) -> Any:
        """In place of ``safe_eval``."""
        return evaluate(expression, Names(lambda name: self._bound(symbols, name)))

    def _bound(self, symbols: Any, name: str) -> Any:
        value = symbols[name]
        if isinstance(value, self.xacro.NameSpace):
            return Names(lambda inner: self._bound(value, inner))
        if type(value) not in DATA and not isinstance(value, Function | Names):
            raise Refused(f"{name!r} is not a value")
        return value

    def substituted(self, text: str) -> str:
        """In place of ``eval_extension``: what ``$(COMMAND ...)`` stands for."""
        inner = text[2:-1]
        if inner.startswith("eval "):
            return str(evaluate(inner[5:], Names(self._name_of_eval)))
        match inner.split():
            case ["cwd"]:
                return str(Path.cwd())
            case ["arg", name]:
                return _FIND.sub(lambda match: self.files.package(match.group(1)), self._argument(name))
            case ["find", name]:
                return self.files.package(name)
            case ["env" | "optenv", name, *_]:
                if name in self.environment:
                    return self.environment[name]
                name = label(name)[:80]
                remedy = f"state it: --arg 'env {name}=VALUE'"
                raise Refused(f"the environment variable {name} is not read; {remedy}")
        raise Refused(f"no substitution that is known: {shown(text)}")

    def _argument(self, name: str) -> str:
        arguments = self.xacro.substitution_args_context["arg"]
        if name not in arguments:
            raise Refused(f"no argument {shown(name)}: state it, --arg {label(name)[:80]}=VALUE")
        text: str = arguments[name]
        return text

    def _name_of_eval(self, name: str) -> Any:
        """A name in ``$(eval ...)``, where an argument may be written as a name."""
        if name in MATH or name in _OF_EVAL:
            return MATH.get(name, _OF_EVAL.get(name))
        if name in ("arg", "find"):
            arg = Function("arg", lambda name: _converted(self._argument(name)))
            return arg if name == "arg" else Function("find", self.files.package)
        if name in self.xacro.substitution_args_context["arg"] or name not in PYTHON:
            return _converted(self._argument(name))
        return PYTHON[name]

    def included(self, spec: str, symbols: Any) -> list[str]:
        """In place of ``get_include_files``: paths as they are written, which :meth:`document` looks at."""
        text = str(self.xacro.eval_text(spec, symbols))
        path: str = text if "://" in text else self.xacro.abs_filename_spec(text)
        folder, name = os.path.split(path)
        if not re.search(r"[*[?]", path):
            return [path]
        if re.search(r"[*[?]", folder):  # which folders there are would show, where links lead out
            raise Refused(f"a pattern of folders: {shown(text)}")
        self.files.path(path, "")
        return sorted(glob.glob(os.path.join(folder, name)))  # noqa: PTH118, PTH207

    def document(self, _: None, spec: str) -> Any:
        """In place of ``parse``: the document of a file."""
        path = self.files.path(spec, "")
        try:
            data = self.files.read(path, "xacro")
        except FileNotFoundError as error:
            self.xacro.filestack.pop()  # as parse does; a file that is optional is passed over
            raise self.xacro.XacroException(str(error), exc=error) from None
        xml = xml_text(data, label(path))
        if path != self.files.top:  # whose warnings its own reader has
            self.warnings.update(xml.warnings)
        try:
            return _Builder().parseString(xml.text)
        except expat.ExpatError as error:
            raise Refused(f"{label(path)}:{error.lineno}: {expat.ErrorString(error.code)}") from None

    def yaml(self, spec: Any) -> Any:
        """In place of ``load_yaml``."""
        folder = os.path.dirname(self.xacro.filestack[-1])  # noqa: PTH120
        path = self.files.path(str(spec), folder)
        try:
            data = self.files.read(path, "YAML")
        except FileNotFoundError as error:
            raise Refused(str(error)) from None
        return load_yaml(
            data, label(path), lambda text: float(evaluate(text, Names(self.symbols.__getitem__)))
        )


def _fail(*words: Any) -> None:
    raise Refused(" ".join(map(str, words)))


def _unavailable(*_: Any, **__: Any) -> None:
    raise Refused("a function that is not evaluated here")


def _converted(text: str) -> Any:
    """The number or truth value that an argument states, else its text, as ``$(eval)`` has it."""
    for convert in (float if "." in text else int, {"true": True, "false": False}.__getitem__):
        try:
            return convert(text.lower())
        except (ValueError, KeyError):
            pass
    return text


def guard() -> None:
    """From now on nothing is imported, run, started or opened, but by :class:`Files`, for reading."""
    readers = {files.open_regular.__code__, files._without_waiting.__code__}

    def audit(event: str, arguments: tuple[Any, ...]) -> None:
        if not event.startswith(_AUDITED) or event in _UNAUDITED:
            return
        if event == "open" and sys._getframe(1).f_code in readers:
            return
        raise Refused(f"the package xacro went another way than it may ({event})")

    sys.addaudithook(audit)


def _words(error: BaseException) -> str:
    """The message, that of a refusal without what xacro wraps around it."""
    inner: Any = error
    while inner is not None:
        match inner:
            case MemoryError():
                return "out of memory"
            case RecursionError():
                return "macros, properties or files that contain themselves without end"
            case Refused() | RobodynError():
                return str(inner)
        inner = getattr(inner, "exc", None)
    return str(error) or type(error).__name__


def main() -> int:
    """Reads file, bounds and arguments as JSON; on stdout a line of JSON with what in the files that were
    included is not XML by the letter, and the XML; or one line on stderr and code 1."""
    task = json.load(sys.stdin)
    warnings.simplefilter("ignore")  # of Python's parser: to show them, it would read files
    output, words = sys.stdout.buffer, sys.__stderr__
    assert words is not None
    sys.stdout = sys.stderr = open(os.devnull, "w")  # noqa: PTH123, SIM115 (xacro prints warnings)
    try:
        expansion = Expansion(task["file"], task["arguments"], task["ros"])
        load_encodings()
        bound(CPU=task["seconds"], AS=task["memory"], FSIZE=0, CORE=0)
        guard()
        data = expansion.text().encode("utf-8", "replace")
        if len(data) > FILE_MIB * MIB:
            raise Refused(f"more than {FILE_MIB} MiB")
        places = [((at.file, at.line, at.column), words) for at, words in expansion.warnings.items()]
    except BaseException as error:
        words.write(label(" ".join(_words(error).split()))[:1000])
        words.flush()
        return 1
    output.write(json.dumps(places).encode() + b"\n" + data)
    output.flush()
    return 0
