"""A damping, friction or rotor inertia of 0 that a file states is not one that nobody states."""

from __future__ import annotations

from pathlib import Path

import pytest

from robodyn import load
from robodyn_testing import sdf_arms, urdf_text

URDF = urdf_text.robot(urdf_text.link("a"), urdf_text.link("b"), urdf_text.joint("j", "a", "b"))
SDF = sdf_arms.sdf(sdf_arms.model(sdf_arms.ARM))


@pytest.mark.parametrize(
    ("ending", "text", "stated", "friction", "rotor"),
    [
        ("urdf", URDF, "", "absent", "absent"),
        ("urdf", URDF, '<dynamics damping="0"/>', "stated", "absent"),
        ("urdf", URDF, '<dynamics friction="0" armature="0"/>', "stated", "stated"),
        ("sdf", SDF, "", "absent", "absent"),
        ("sdf", SDF, "<dynamics><damping>0</damping></dynamics>", "stated", "absent"),
    ],
)
def test_a_stated_0_is_not_what_nobody_states(
    ending: str, text: str, stated: str, friction: str, rotor: str, tmp_path: Path
) -> None:
    before = "</axis></joint>" if ending == "sdf" else "</joint>"
    path = tmp_path / f"arm.{ending}"
    path.write_text(text.replace(before, stated + before))
    for link in load(path, warn=lambda _: None).links:
        assert (link.origins.friction, link.origins.motor_inertia) == (friction, rotor)
