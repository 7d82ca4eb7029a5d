"""The picture of a motion: a row a joint, a column a quantity, units by the kind of joint."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from robodyn.logs.log import Log
from robodyn.report import motion
from robodyn.robot import load
from robodyn_testing import require_module

T = np.linspace(0, 1, 50)


def log(n: int) -> Log:
    q = np.outer(np.sin(T), np.arange(1, n + 1))
    return Log(T, q, q, q, 10 * q)


def words(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Every text that matplotlib sets from now on."""
    text, texts = require_module("matplotlib.text").Text, []
    own = text.set_text

    def set_text(self: object, s: object) -> None:
        texts.append(str(s))
        own(self, s)

    monkeypatch.setattr(text, "set_text", set_text)
    return texts


@pytest.mark.parametrize(("name", "units"), [("puma560_3dof", "rad/s"), ("stanford_3dof", "[m, m/s, N]")])
def test_every_joint_has_a_panel_for_each_quantity(
    name: str, units: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot, texts = load(name, warn=lambda _: None), words(monkeypatch)
    picture = motion.motion_picture(robot, log(3), "svg").decode()
    assert len(set(re.findall(r'id="axes_\d+"', picture))) == 9
    assert sum(text.startswith("joint ") for text in texts) == 3
    assert any(units in text for text in texts)
    assert ("velocity [rad/s]" in texts) == (name == "puma560_3dof")
    assert not any("reference" in text for text in texts)


def test_what_a_log_lacks_has_no_column() -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    bare = replace(log(3), qd=None)
    picture = motion.motion_picture(robot, bare, "svg")
    assert len(set(re.findall(rb'id="axes_\d+"', picture))) == 6
    assert motion.motion_picture(robot, bare, "svg") == picture
