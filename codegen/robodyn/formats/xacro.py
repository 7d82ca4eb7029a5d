"""xacro to URDF through the package xacro, in a process of its own with bounds of time and memory.

What the file says is data: its expressions are evaluated over a whitelist of syntax, and it reads only files
of its own folder and of packages (:mod:`robodyn.formats.xacro_process`). It is given no environment.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.files import MIB, label
from robodyn.formats import elements
from robodyn.formats.limits import XACRO_MEMORY, XACRO_SECONDS
from robodyn.formats.tree import EXPANDED
from robodyn.tools.libraries import XACRO

#: The child's program: robodyn lies where it does here, and anything else where Python has it by itself.
_START: Final = (
    "import sys; sys.path.append(sys.argv[1]); "
    "from robodyn.formats.xacro_process import main; sys.exit(main())"
)
#: What Python may need to start.
_ENVIRONMENT: Final = ("LD_LIBRARY_PATH", "DYLD_LIBRARY_PATH", "SYSTEMROOT")


def expanded(path: Path, arguments: Mapping[str, str] | None = None) -> elements.Document:
    """The document that the xacro file at ``path`` expands to.

    ``arguments`` are those of its ``xacro:arg``; the names ``find PACKAGE`` and ``env NAME`` state the folder
    of a package and the value of an environment variable.

    Raises
    ------
    InputError: it is not XML, xacro refuses it, or it takes too much time or memory.
    ToolError: the package is not installed.
    """
    name = label(path)
    top = elements.read(str(path), "xacro", name)  # its bounds, and no document type
    if not XACRO.present():
        raise XACRO.missing(where=Place(name))
    task = {
        "file": os.fspath(path),
        "arguments": dict(arguments or {}),
        "ros": [os.environ.get(name, "") for name in ("AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH")],
        "seconds": XACRO_SECONDS,
        "memory": XACRO_MEMORY * MIB,
    }
    command = [sys.executable, "-I", "-B", "-c", _START, str(Path(__file__).parents[2])]
    environment = {name: os.environ[name] for name in _ENVIRONMENT if name in os.environ}
    late = f"more than {XACRO_SECONDS} s or {XACRO_MEMORY} MiB"
    try:
        child = subprocess.run(
            command,
            input=json.dumps(task).encode(),
            capture_output=True,
            start_new_session=True,
            env=environment,
            timeout=XACRO_SECONDS,
            check=False,
        )
    except subprocess.TimeoutExpired:  # it may wait for a file that never ends
        raise _refused(name, late) from None
    if child.returncode:
        raise _refused(name, late if child.returncode < 0 else child.stderr.decode("utf-8", "replace"))
    included, _, xml = child.stdout.partition(b"\n")
    warnings = [(Place(*where), words) for where, words in json.loads(included)]
    document = elements.parse(xml, name + EXPANDED, "xacro that expands to URDF")
    return replace(document, warnings=(*top.warnings, *warnings))


def _refused(name: str, words: str) -> InputError:
    return InputError(
        "the xacro file cannot be expanded",
        where=Place(name),
        found=words[:300],
        remedy="expand it where its packages are (xacro FILE > arm.urdf), and import that",
    )
