"""For each row of the table of SDF that changes torques and is modelled a file in which it does.

What Drake 1.51.1 computes of them is in ``tests/formats/drake_rows.json``, which
``python -m robodyn_testing.sdf_rows`` writes, run in ``tests`` where the package drake is installed.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Final

from robodyn.formats.elements_of import table_of
from robodyn_testing.sdf_arms import ARM, by_drake, model

FIGURES: Final = Path(__file__).parents[1] / "formats" / "drake_rows.json"
_PLAIN: Final = model(ARM)
FRICTION: Final = 0.3
"""[N m or N] of both joints, which Drake does not know."""
_L2: Final = '<pose relative_to="l1">0.1 0.2 0.3 0.7 0.2 0.5</pose>'
_J2: Final = "<pose>0.05 0.02 -0.01 0.1 0.2 0.3</pose>"
_XYZ: Final = "<xyz>0.36 0.48 0.8</xyz>"
_INSIDE: Final = "0.1 0.02 -0.03 0.2 0.4 -0.6"
_DYNAMICS: Final = "<dynamics><{0}>{1}</{0}>{2}</dynamics></axis></joint>"


def _dynamics(name: str, value: str, more: str = "") -> tuple[str, str]:
    """In both joints, which the arm has one after the other at its end."""
    return "</axis></joint>", _DYNAMICS.format(name, value, more)


_STIFF: Final = "<spring_stiffness>8</spring_stiffness>"
#: What is put in the place of what, by the row; for a world it is put around the model.
_SHOWN: Final[dict[str, tuple[str, str]]] = {
    "world/<gravity>": ("", "<gravity>1 2 -3</gravity>"),
    "world/physics/<gravity>": ("", '<physics type="ode"><gravity>1 2 -3</gravity></physics>'),
    "model/placement_frame": (
        '<model name="arm" >', '<model name="arm" placement_frame="l1"><pose>0.1 0 0.2 0.3 0.4 0</pose>'
    ),
    "model/<pose>": ('<model name="arm" >', '<model name="arm"><pose>0.1 0.2 0.3 0.4 0.5 0.6</pose>'),
    "link/<pose>": (_L2, "<pose>0.3 0.2 0.1 0 0.4 0</pose>"),
    "inertial/<pose>": (_INSIDE, "0.2 0.1 0 0 0.3 0"),
    "inertial/<mass>": ("<mass>1.5</mass>", "<mass>3.5</mass>"),
    "inertial/<inertia>": ("<iyz>0.002</iyz>", "<iyz>0.001</iyz>"),
    "inertia/<ixx>": ("<ixx>0.03</ixx>", "<ixx>0.035</ixx>"),
    "inertia/<iyy>": ("<iyy>0.05</iyy>", "<iyy>0.055</iyy>"),
    "inertia/<izz>": ("<izz>0.04</izz>", "<izz>0.045</izz>"),
    "inertia/<ixy>": ("<ixy>0.004</ixy>", "<ixy>0.002</ixy>"),
    "inertia/<ixz>": ("<ixz>-0.003</ixz>", "<ixz>0.001</ixz>"),
    "inertia/<iyz>": ("<iyz>0.002</iyz>", "<iyz>-0.002</iyz>"),
    "joint/type": ('type="prismatic"', 'type="revolute"'),
    "joint/<pose>": (_J2, "<pose>0.1 0.1 0.1 0.4 0 0</pose>"),
    "joint/<axis>": (_XYZ, "<xyz>0 0 1</xyz>"),
    "axis/<xyz>": (_XYZ, "<xyz>1 0 0</xyz>"),
    "axis/<use_parent_model_frame>": (
        _XYZ, f"{_XYZ}<use_parent_model_frame>1</use_parent_model_frame>"
    ),
    "axis/<dynamics>": _dynamics("damping", "0.7"),
    "axis/dynamics/<damping>": _dynamics("damping", "0.4"),
    "axis/dynamics/<friction>": _dynamics("friction", f"{FRICTION}"),
    "axis/dynamics/<spring_stiffness>": _dynamics("spring_stiffness", "5"),
    "axis/dynamics/<spring_reference>": _dynamics("spring_reference", "0.2", _STIFF),
    "joint/<drake:rotor_inertia>": ("</joint>", "<drake:rotor_inertia>0.2</drake:rotor_inertia></joint>"),
    "joint/<drake:gear_ratio>": (
        "</joint>",
        "<drake:gear_ratio>50</drake:gear_ratio><drake:rotor_inertia>1e-4</drake:rotor_inertia></joint>",
    ),
    "xyz/expressed_in": (_XYZ, '<xyz expressed_in="__model__">0.36 0.48 0.8</xyz>'),
    "pose/relative_to": (_L2, _L2.replace("l1", "b")),
    "pose/frame": (_L2, _L2.replace("relative_to", "frame")),
    "pose/degrees": (_L2, '<pose relative_to="l1" degrees="true">0.1 0.2 0.3 20 30 40</pose>'),
    "pose/rotation_format": (
        _L2, '<pose relative_to="l1" rotation_format="quat_xyzw">0.1 0.2 0.3 0.1 0.3 -0.3 0.9</pose>'
    ),
}  # fmt: skip
#: Versions of SDF that have what the newest one has no more.
_VERSIONS: Final = {
    "world/physics/<gravity>": "1.5",
    "axis/<use_parent_model_frame>": "1.6",
    "pose/frame": "1.6",
}
ROWS: Final = tuple(
    "/".join((*path, name))
    for path, row in table_of("SDF").rows.items()
    for name, entry in row.items()
    if entry.kind == "torques" and not entry.physics
)


def file_of(row: str, is_shown: bool = True) -> str:
    """The file in which a row is shown, or the same without what shows it."""
    old, new = _SHOWN[row]
    version = _VERSIONS.get(row, "1.11")
    arm = _PLAIN.replace(old, new) if old and is_shown else _PLAIN
    if version in _VERSIONS.values():  # there poses are relative to the model
        arm = arm.replace(' relative_to="l1"', "")
    around = new if is_shown and not old else ""
    return f'<sdf version="{version}"><world name="w">{around}{arm}</world></sdf>'


def torques_by_drake(row: str) -> list[float]:
    """Torques [n] of the arm at :data:`STATE`; Drake knows no dry friction."""
    gravity = (1, 2, -3) if row.endswith("<gravity>") else (0, 0, -9.8)
    torques: list[float] = by_drake(file_of(row), "", "l2", ("j1", "j2"), gravity)["torques"]
    return torques


if __name__ == "__main__":
    figures = {row: torques_by_drake(row) for row in ROWS}
    lines = ",\n".join(f"{json.dumps(row)}: {json.dumps(torques)}" for row, torques in figures.items())
    FIGURES.write_text(f"{{\n{lines}\n}}\n")
