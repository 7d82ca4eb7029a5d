"""pip: a wheel with the compiled kernel, functions on numpy arrays, and type stubs.

Python calls the kernel through ctypes, so that one wheel serves every version of Python. The loops over
states are those of :mod:`robodyn.kernels.wrapper`.
"""

from __future__ import annotations

import platform
import re
import sysconfig
from base64 import urlsafe_b64encode
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from hashlib import sha256
from typing import Final

from robodyn.emit.languages.c import LANGUAGE as C
from robodyn.emit.markdown import Markdown
from robodyn.ir.signature import Signature
from robodyn.kernels.wrapper import parameters_of, wrapper
from robodyn.packages.format import Argument, Files, Format, Package, Routine
from robodyn.packages.writing import arithmetic_flags, readme, rendered, zipped

#: The oldest glibc that tags may name, 2.x, by machine (PEP 600; an older one was never built for).
_OLDEST: Final[Mapping[str, int]] = {"x86_64": 5, "i686": 5}
_OLDEST_ELSEWHERE: Final = 17
_DTYPES: Final = {"double": "float64", "float": "float32"}


@dataclass(frozen=True, slots=True)
class PythonFunction:
    """A function as Python has it: ``symbol`` in the library; ``inputs``, ``outputs``, ``parameters`` and
    ``states`` as literals of Python; ``arguments`` and ``result`` as its stub has them."""

    name: str
    symbol: str
    inputs: str
    outputs: str
    parameters: str
    states: str
    arguments: tuple[str, ...]
    result: str
    text: str


def _files(package: Package) -> Files:
    from robodyn.toolchain.compiler import library_suffix, shared_library

    library = f"lib{package.name}{library_suffix()}"
    sources = package.generated.files((C.name,))
    calls = wrapper(package.generated.signatures, sources, C.name)
    flags = ("-std=c99", "-O2", *arithmetic_flags(package))
    # A hyphen is in no emitted file's name.
    binary = shared_library({**sources, "robodyn-calls.c": calls}, library, flags=flags)
    tag = tag_of(binary, baseline=package.generated.options.target is None)
    project = re.sub(r"[-_.]+", "_", package.name).strip("_").lower()
    name = f"{project}-{package.version}"
    wheel = f"{name}-{tag}.whl"
    first = package.routines[0]
    rest = ", ".join(f"[0.0] * {array.size}" for array in first.inputs if not array.optional)
    words = {"wheel": wheel, "machine": tag.rpartition("-")[2], "example": f"{first.name}({rest})"}
    notes = readme(package, **{key: Markdown(text) for key, text in words.items()})
    templates = {
        f"{package.name}/__init__.py": "init.py.j2",
        f"{package.name}/__init__.pyi": "init.pyi.j2",
        f"{package.name}/_calls.py": "calls.py.j2",
        f"{name}.dist-info/METADATA": "METADATA.j2",
        f"{name}.dist-info/WHEEL": "WHEEL.j2",
    }
    texts = rendered(
        package, templates, functions=list(_functions(package)), dtype=_DTYPES[package.scalar],
        library=library, tag=tag, project=project,
    )  # fmt: skip
    texts[f"{name}.dist-info/METADATA"] += notes["README.md"]
    files: Files = {f"{package.name}/{library}": binary, f"{package.name}/py.typed": "", **texts}
    record = f"{name}.dist-info/RECORD"
    return {wheel: zipped({**files, record: _record(files, record)}), **notes}


def tag_of(binary: bytes, *, baseline: bool) -> str:
    """The tag of a wheel with ``binary``. If all that it needs is glibc of some version, the tag names that
    version; ``baseline``: it runs on every processor of this kind, as such a tag promises."""
    machine = re.sub(r"[-.]", "_", sysconfig.get_platform())
    system, _, processor = machine.partition("_")
    needs = {version.decode("ascii") for version in re.findall(rb"\0GLIBC_([0-9A-Z_.]+)(?=\0)", binary)}
    minors = [int(match[1]) for need in needs if (match := re.fullmatch(r"2\.([0-9]+)(\.[0-9]+)?", need))]
    glibc = platform.libc_ver()[0] == "glibc" and 0 < len(needs) == len(minors)
    if system == "linux" and baseline and glibc:
        machine = f"manylinux_2_{max(*minors, _OLDEST.get(processor, _OLDEST_ELSEWHERE))}_{processor}"
    return f"py3-none-{machine}"


def _record(files: Files, path: str) -> str:
    """What is in the wheel, with hashes; of itself it has none."""
    lines = []
    for name, content in files.items():
        data = content if isinstance(content, bytes) else content.encode("utf-8")
        digest = urlsafe_b64encode(sha256(data).digest()).rstrip(b"=").decode("ascii")
        lines.append(f"{name},sha256={digest},{len(data)}")
    return "\n".join([*lines, f"{path},,"]) + "\n"


def _functions(package: Package) -> Iterator[PythonFunction]:
    signatures = package.generated.signatures
    parameters = parameters_of(signatures)
    for signature, routine in zip(signatures, package.routines, strict=True):
        results = ["Array"] * len(routine.outputs)
        result = results[0] if len(results) == 1 else f"tuple[{', '.join(results)}]"
        yield PythonFunction(
            routine.name,
            f"{signature.function}_robodyn_batch",
            repr(tuple((array.name, array.shape, array.optional) for array in routine.inputs)),
            repr(tuple((array.name, array.shape) for array in routine.outputs)),
            repr(parameters if signature.parameters else ()),
            repr(signature.states),
            tuple(_arguments(signature, routine, result)),
            result,
            _text(routine),
        )


def _arguments(signature: Signature, routine: Routine, result: str) -> list[str]:
    """The arguments of a function as its stub has them."""
    inputs = [f"{x.name}: ArrayLike{' | None = None' if x.optional else ''}" for x in routine.inputs]
    parameters = ["params: Params"] if signature.parameters else []
    memory = ["dt: float", "state: Array | None = None"] if signature.states else []
    return [*inputs, "*", *parameters, *memory, f"out: {result} | None = None"]


def _text(routine: Routine) -> str:
    """The docstring of a function."""

    def line(array: Argument) -> str:
        shape = ", ".join(["...", *map(str, array.shape)])
        unit = f" ({array.unit})" if array.unit or array.optional else ""
        return (
            f"{array.name}: [{shape}], {array.holds}{unit}{'; zeros if left out' if array.optional else ''}"
        )

    purpose = f"{routine.purpose[:1].upper()}{routine.purpose[1:]}."
    inputs = ["Parameters", "----------", *map(line, routine.inputs)]
    outputs = ["Returns", "-------", *map(line, routine.outputs)]
    return "\n".join([purpose, "", *inputs, "", *outputs])


FORMAT = Format(
    name="wheel",
    title="a wheel",
    tool="pip, with Python 3.9 or newer and numpy",
    language=C,
    files=_files,
    take="pip install {folder}/*.whl",
    lacks=frozenset({"given sines"}),
    binary=True,
)
