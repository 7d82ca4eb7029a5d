"""xacro to URDF through the package xacro, in a process of its own with bounds of time and memory.

A xacro file is a program: its expressions are Python, and it reads the files that it includes. Expressions
that are more than arithmetic are refused (:mod:`robodyn.formats.xacro_process`), and nothing can be written;
it is still a file to be taken from people whom one trusts.
"""

from __future__ import annotations

import json
import subprocess
import sys
import threading
from collections.abc import Mapping
from pathlib import Path

from robodyn.errors import InputError, Place
from robodyn.files import MIB, label
from robodyn.formats import elements
from robodyn.formats.limits import FILE_MIB, XACRO_MEMORY, XACRO_SECONDS
from robodyn.formats.tree import EXPANDED
from robodyn.tools.libraries import XACRO


def expanded(path: Path, arguments: Mapping[str, str] | None = None) -> elements.Document:
    """The document that the xacro file at ``path`` expands to; ``arguments`` are those of its ``xacro:arg``.

    Raises
    ------
    InputError: it is not XML, xacro refuses it, or it takes too much time or memory.
    ToolError: the package is not installed.
    """
    name = label(path)
    elements.read(str(path), "xacro", name)  # its bounds, and no document type
    if not XACRO.present():
        raise XACRO.missing(where=Place(name))
    script = str(Path(__file__).with_name("xacro_process.py"))
    bounds = [str(XACRO_SECONDS), str(XACRO_MEMORY * MIB)]
    command = [sys.executable, "-I", "-B", script, str(path), *bounds, json.dumps(dict(arguments or {}))]
    pipe = subprocess.PIPE
    with subprocess.Popen(
        command, stdin=subprocess.DEVNULL, stdout=pipe, stderr=pipe, start_new_session=True
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        late_end = threading.Timer(XACRO_SECONDS, process.kill)  # it may wait for a file that never ends
        late_end.start()
        try:
            data = process.stdout.read(FILE_MIB * MIB + 1)
            process.stdout.close()
            stderr = process.stderr.read(4096).decode("utf-8", "replace")  # one line: it fits into the pipe
            process.wait()
        finally:
            late_end.cancel()
            process.kill()
    if len(data) > FILE_MIB * MIB:
        raise _refused(name, f"more than {FILE_MIB} MiB")
    if process.returncode:
        late = process.returncode < 0
        raise _refused(name, f"more than {XACRO_SECONDS} s or {XACRO_MEMORY} MiB" if late else stderr)
    return elements.parse(data, name + EXPANDED, "xacro that expands to URDF")


def _refused(name: str, words: str) -> InputError:
    return InputError(
        "the xacro file cannot be expanded",
        where=Place(name),
        found=words[:300],
        remedy="expand it where its packages are (xacro FILE > arm.urdf), and import that",
    )
