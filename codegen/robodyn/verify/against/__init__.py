"""A robot against its original file, which another library reads: MuJoCo an MJCF, Pinocchio a URDF.

Nothing of robodyn's readers has a part in what the robot is compared with, but that macros of a xacro file
are expanded by the package ``xacro``, and Pinocchio reads the text that comes out.
"""

from __future__ import annotations

from pathlib import Path
from xml.dom import expatbuilder
from xml.parsers.expat import ExpatError

from robodyn.errors import InputError, Place
from robodyn.files import MIB, label, read_bytes
from robodyn.formats.limits import FILE_MIB
from robodyn.robot.names import shown
from robodyn.verify.against.arm import PeerArm
from robodyn.verify.against.by_mujoco import MujocoFile
from robodyn.verify.against.by_pinocchio import PinocchioFile
from robodyn.verify.against.compared import comparable, compare, with_original

__all__ = [
    "MujocoFile",
    "PeerArm",
    "PinocchioFile",
    "comparable",
    "compare",
    "read_original",
    "with_original",
]


def read_original(path: Path) -> MujocoFile | PinocchioFile:
    """The file at ``path`` as the library for its format reads it; a xacro file with the arguments of
    :func:`.how_files_are_read`.

    Raises
    ------
    InputError: there is no such file, no library here reads its format, or it refuses the file.
    ToolError: the library is not installed.
    """
    name, expanded = label(path), None
    if name.lower().endswith(".xacro"):
        from robodyn.formats.arm import stated_arguments
        from robodyn.formats.xacro import expanded as expansion

        expanded = expansion(path, stated_arguments()).text.encode()
    original = expanded or read_bytes(str(path), FILE_MIB * MIB, "URDF or MJCF", name)
    # Python's parser takes no blanks before <?xml and no -- in a comment, which both libraries do.
    head, *rest = original.split(b"<!--")
    bare = (head + b"".join(part.partition(b"-->")[2] for part in rest)).lstrip()
    try:
        root = expatbuilder.parseString(bare, namespaces=False).documentElement
    except (ExpatError, ValueError, LookupError) as error:
        raise InputError("the file is not XML", where=Place(name), found=str(error)) from None
    assert root is not None  # expat refuses a document without an element
    if root.tagName == "mujoco":
        return MujocoFile.read(path)
    if root.tagName == "robot":
        return PinocchioFile.read(path, root, expanded is not None)
    raise InputError(
        "no library that is used here reads this format",
        where=Place(name),
        found=shown(root.tagName),
        expected="<robot>: URDF or xacro, which Pinocchio reads, or <mujoco>: MJCF, which MuJoCo reads",
    )
