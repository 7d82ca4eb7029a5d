"""For each element and attribute of URDF that changes torques a file: as Pinocchio has it, or refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn import InputError, load
from robodyn.formats.elements_of import Entry, table_of
from robodyn.verify.reference import Reference
from robodyn_testing import require_module
from robodyn_testing.refused import check_is_refused

_PLACE = '<origin xyz="0.1 0.2 0.3" rpy="0.3 0.2 0.1"/>'
_INERTIA = '<inertia ixx="0.03" iyy="0.05" izz="0.04" ixy="0.004" ixz="-0.003" iyz="0.002"/>'
_SOLID = (
    f'<inertial><origin xyz="0.1 0.02 -0.03" rpy="0.2 0.4 -0.6"/><mass value="2.5"/>{_INERTIA}</inertial>'
)
ARM = f"""<robot name="arm" version="1.1"><link name="b"/>
<link name="l1">{_SOLID}</link><link name="l2">{_SOLID}</link>
<joint name="j1" type="revolute"><parent link="b"/><child link="l1"/>{_PLACE}<axis xyz="0.36 0.48 0.8"/>
<limit lower="-3" upper="3" effort="9" velocity="9"/></joint>
<joint name="j2" type="revolute"><parent link="l1"/><child link="l2"/>{_PLACE}<axis xyz="0 1 0"/>
<limit lower="-3" upper="3" effort="9" velocity="9"/></joint></robot>"""
STATE = np.array([[0.3, -0.2], [0.4, -0.9], [1.1, -0.7]])


def motor(inside: str, in_actuator: str, in_joint: str = "") -> tuple[str, str]:
    """A transmission at the first joint, put before the end."""
    joint = f'<joint name="j1">{in_joint}</joint>'
    words = f'<transmission name="t">{inside}{joint}<actuator name="m">{in_actuator}</actuator>'
    return "</robot>", f"{words}</transmission></robot>"


_GEAR, _ROTOR = '<drake:gear_ratio value="50"/>', '<drake:rotor_inertia value="1e-4"/>'
_REDUCTION, _MOTOR = "<mechanicalReduction>50</mechanicalReduction>", "<motorInertia>1e-4</motorInertia>"
_QUATERNION = 'quat_xyzw="0.1 0.3 -0.3 0.9"'
#: What is put in the place of what, by the row; the inertia [kg m^2] of it that Pinocchio does not read.
SHOWN: dict[str, tuple[str, str] | tuple[str, str, float]] = {
    "robot/<transmission>": (*motor(_REDUCTION, _MOTOR), 0.25),
    "inertial/<origin>": (_SOLID, _SOLID.replace("0.1 0.02 -0.03", "0.3 0 0")),
    "inertial/<mass>": ('<mass value="2.5"/>', '<mass value="1.5"/>'),
    "inertial/<inertia>": (_INERTIA, _INERTIA.replace("0.05", "0.055")),
    "mass/value": ('value="2.5"', 'value="3.5"'),
    "inertia/ixx": ('ixx="0.03"', 'ixx="0.035"'),
    "inertia/iyy": ('iyy="0.05"', 'iyy="0.045"'),
    "inertia/izz": ('izz="0.04"', 'izz="0.045"'),
    "inertia/ixy": ('ixy="0.004"', 'ixy="0.001"'),
    "inertia/ixz": ('ixz="-0.003"', 'ixz="0.003"'),
    "inertia/iyz": ('iyz="0.002"', 'iyz="-0.002"'),
    "origin/xyz": ('xyz="0.1 0.2 0.3"', 'xyz="0.3 0.2 0.1"'),
    "origin/rpy": ('rpy="0.3 0.2 0.1"', 'rpy="0.1 0.2 0.4"'),
    "origin/quat_xyzw": ('rpy="0.3 0.2 0.1"', _QUATERNION),
    "joint/type": ('"j2" type="revolute"', '"j2" type="prismatic"'),
    "joint/<origin>": (_PLACE, '<origin xyz="0.3 0.1 0"/>'),
    "joint/<axis>": ('<axis xyz="0.36 0.48 0.8"/>', ""),
    "axis/xyz": ('xyz="0 1 0"', 'xyz="0 0.6 -0.8"'),
    "joint/<dynamics>": ("</joint>", '<dynamics damping="0.2" friction="0.1"/></joint>'),
    "dynamics/damping": ("</joint>", '<dynamics damping="0.4"/></joint>'),
    "dynamics/friction": ("</joint>", '<dynamics friction="0.3"/></joint>'),
    "dynamics/armature": ('<axis xyz="0.36', '<dynamics damping="0" armature="0.2"/><axis xyz="0.36', 0.2),
    "transmission/<mechanicalReduction>": (*motor(_REDUCTION, _MOTOR), 0.25),
    "transmission/joint/<mechanicalReduction>": (*motor("", _MOTOR, _REDUCTION), 0.25),
    "drake:gear_ratio/value": (*motor("", _ROTOR + _GEAR), 0.25),
    "drake:rotor_inertia/value": (*motor("", _ROTOR), 1e-4),
    "transmission/<drake:gear_ratio>": (*motor(_GEAR, _ROTOR), 0.25),
    "transmission/<drake:rotor_inertia>": (*motor(_ROTOR, ""), 1e-4),
    "transmission/actuator/<mechanicalReduction>": (*motor("", _REDUCTION + _MOTOR), 0.25),
    "transmission/actuator/<motorInertia>": (*motor("", _MOTOR), 1e-4),
    "transmission/actuator/<drake:gear_ratio>": (*motor("", _GEAR + _ROTOR), 0.25),
    "transmission/actuator/<drake:rotor_inertia>": (*motor("", _ROTOR), 1e-4),
}
ROWS = [
    (path, name, entry)
    for path, row in table_of("URDF").rows.items()
    for name, entry in row.items()
    if entry.kind in ("torques", "refused")
]
MODELLED = ["/".join((*path, name)) for path, name, entry in ROWS if entry.kind == "torques"]
REFUSED = [(path, name, entry) for path, name, entry in ROWS if entry.physics]


def torques(text: str, path: Path) -> Any:
    path.write_text(text)
    return Reference(load(path, warn=lambda _: None)).inverse_dynamics(*STATE)


def by_pinocchio(path: Path) -> Any:
    pinocchio = require_module("pinocchio")
    model = pinocchio.buildModelFromUrdf(str(path))
    model.gravity.linear = np.array([0, 0, -9.81])
    rigid = pinocchio.rnea(model, model.createData(), *STATE)
    return rigid + model.damping * STATE[1] + model.upperDryFrictionLimit * np.sign(STATE[1])


@pytest.mark.parametrize("row", MODELLED)
def test_what_changes_torques_is_pinocchios(row: str, tmp_path: Path) -> None:
    old, new, *rotor = SHOWN[row]
    text, file = ARM.replace(old, new), tmp_path / "arm.urdf"
    shown, plain = torques(text, file), torques(ARM, file)
    file.write_text(text)
    expected = by_pinocchio(file) + np.array([sum(rotor), 0]) * STATE[2]
    assert shown == pytest.approx(expected, rel=0, abs=1e-9)
    assert np.abs(shown - plain).max() > 1e-5


def test_quaternions_are_of_urdf_1_1(tmp_path: Path) -> None:
    text = ARM.replace(*SHOWN["origin/quat_xyzw"]).replace(' version="1.1"', "")
    with pytest.raises(InputError, match=r"quat_xyzw is of URDF 1\.1; found 1\.0"):
        torques(text, tmp_path / "arm.urdf")


@pytest.mark.parametrize(("path", "name", "entry"), REFUSED, ids=lambda part: str(part)[:40])
def test_what_is_not_modelled_is_refused_by_its_name(
    path: tuple[str, ...], name: str, entry: Entry, tmp_path: Path
) -> None:
    value = {"<gravity>": "0", "<velocity_decay>": "", "inertiafromgeom": "true"}.get(name, "1")
    words = f"{name}{value}{name.replace('<', '</')}" if name[0] == "<" else f'<{path[-1]} {name}="{value}"/>'
    if entry.physics == "transmission":
        words = motor("", _REDUCTION)[1].replace('"j1"', '"x"').removesuffix("</robot>")
    around = [tag for tag in path if tag != "robot"][: None if name[0] == "<" else -1]
    for tag in reversed(around):
        words = f"<{tag}>{words}</{tag}>"
    (file := tmp_path / "arm.urdf").write_text(ARM.replace("</robot>", f"{words}</robot>"))
    check_is_refused(file, entry.physics)
