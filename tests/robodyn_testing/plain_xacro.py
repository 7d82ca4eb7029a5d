"""What the package xacro makes of a file by itself, without anything of robodyn: in a process of its own."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

#: The index of packages that ROS has is a module; this one knows those that the test states.
_SCRIPT = """
import json, sys, types
index, module = types.ModuleType("ament_index_python"), types.ModuleType("ament_index_python.packages")
sys.modules.update({"ament_index_python": index, "ament_index_python.packages": module})
import xacro
texts = []
for file, arguments, packages in json.load(sys.stdin):
    module.get_package_share_directory = packages.__getitem__
    try:
        texts.append(xacro.process_file(file, mappings=arguments).toxml())
    except Exception as error:
        texts.append(f"{file}: {type(error).__name__}: {error}")
print(json.dumps(texts))
"""
Task = tuple[Path, Mapping[str, str], Mapping[str, Path]]


def plain_expansions(tasks: Sequence[Task]) -> list[str]:
    """For each file, with its arguments and the folders of packages that ROS would find, the XML that xacro
    makes, or its error."""
    stated = [
        (str(file), dict(arguments), {name: str(folder) for name, folder in packages.items()})
        for file, arguments, packages in tasks
    ]
    ended = subprocess.run(
        [sys.executable, "-I", "-c", _SCRIPT],
        input=json.dumps(stated).encode(),
        capture_output=True,
        timeout=60,
        check=True,
    )
    texts: list[str] = json.loads(ended.stdout)
    return texts


def element_list(text: str) -> list[Any]:
    """The elements of an XML document, each with its depth, tag, attributes and text."""

    def walk(element: ElementTree.Element, depth: int) -> list[Any]:
        words = "".join([element.text or "", *(child.tail or "" for child in element)]).split()
        own = (depth, element.tag, tuple(sorted(element.attrib.items())), tuple(words))
        return [own, *(each for child in element for each in walk(child, depth + 1))]

    return walk(ElementTree.fromstring(text), 0)
