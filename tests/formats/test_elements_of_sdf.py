"""For each element and attribute of SDF that changes torques a file: as Drake has it, or refused."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn import load
from robodyn.formats.elements_of import Entry, table_of
from robodyn.verify.reference import Reference
from robodyn_testing.refused import check_is_refused
from robodyn_testing.sdf_arms import ARM, STATE, model
from robodyn_testing.sdf_rows import FIGURES, FRICTION, ROWS, file_of

DRAKE = json.loads(FIGURES.read_text())
REFUSED = [
    (path, name, entry)
    for path, row in table_of("SDF").rows.items()
    for name, entry in row.items()
    if entry.physics
]
#: What says so, where it is not a 1.
WORDS = {"<gravity>": "false", "<joint>": None, "<include>": None, "<drake:joint>": None}


def torques(text: str, path: Path) -> Any:
    path.write_text(text)
    q, qd, qdd = (np.array(values[:2]) for values in STATE)
    return Reference(load(path, warn=lambda _: None)).inverse_dynamics(q, qd, qdd)


@pytest.mark.parametrize("row", ROWS)
def test_what_changes_torques_is_drakes(row: str, tmp_path: Path) -> None:
    expected = np.array(DRAKE[row])
    if row.endswith("<friction>"):
        expected += FRICTION * np.sign(STATE[1][:2])
    shown, plain = (torques(file_of(row, is_shown), tmp_path / "arm.sdf") for is_shown in (True, False))
    assert shown == pytest.approx(expected, rel=0, abs=1e-9)
    assert np.abs(shown - plain).max() > 1e-4


@pytest.mark.parametrize(("path", "name", "entry"), REFUSED, ids=lambda part: str(part)[:40])
def test_what_is_not_modelled_is_refused_by_its_name(
    path: tuple[str, ...], name: str, entry: Entry, tmp_path: Path
) -> None:
    text = f'<sdf version="1.11"><world name="w">{model(ARM)}</world></sdf>'
    words = name.replace(">", "/>") if WORDS.get(name, "1") is None else (
        f"{name}{WORDS.get(name, '1')}{name.replace('<', '</')}"
    )  # fmt: skip
    after = {"world": "</model>", "model": '<model name="arm" >', "link": '<link name="l2">'}
    after["joint"] = "</child>"
    if name == "auto":
        text = text.replace("<inertial>", '<inertial auto="true">')
    elif path[-1] in after:
        text = text.replace(after[path[-1]], after[path[-1]] + words)
    else:
        around = '<link name="l2">' if path[-1] == "velocity_decay" else "<inertial>"
        text = text.replace(around, f"{around}<{path[-1]}>{words}</{path[-1]}>")
    (file := tmp_path / "arm.sdf").write_text(text)
    check_is_refused(file, entry.physics)


def test_a_link_that_does_not_move_may_be_without_weight(tmp_path: Path) -> None:
    text = f'<sdf version="1.11">{model(ARM)}</sdf>'
    expected = torques(text, tmp_path / "arm.sdf")
    still = text.replace('<link name="b">', '<link name="b"><gravity>0</gravity>')
    assert still != text
    assert torques(still, tmp_path / "arm.sdf") == pytest.approx(expected)


def test_what_models_beside_the_arm_say_is_not_refused(tmp_path: Path) -> None:
    ball = model('<link name="x"><gravity>0</gravity><kinematic>1</kinematic></link>', "", "ball")
    text = f'<sdf version="1.11"><world name="w">{model(ARM)}{ball}</world></sdf>'
    assert torques(text, tmp_path / "arm.sdf").shape == (2,)
