"""Arms with every effect of the catalogue that a kernel holds, a few a joint (``arms_with_effects/``)."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

from robodyn.robot import Robot, read_text

#: Descriptions by name; two of them once more, with other rules for friction at rest.
TEXTS: Final = {
    name: (Path(__file__).parent / "arms_with_effects" / f"{name}.yaml").read_text(encoding="utf-8")
    for name in ("rubbing", "sliding", "remembering")
}
for _name, _of, _rest in (("smooth", "rubbing", "{smooth: {velocity: 0.5}}"),
                          ("banded", "sliding", "{dead_band: {velocity: 0.2}}")):  # fmt: skip
    TEXTS[_name] = TEXTS[_of].replace(f"name: {_of}", f"name: {_name}\nfriction_at_rest: {_rest}")


def arm(name: str) -> Robot:
    """The arm of that name."""
    return read_text(TEXTS[name], name)


def arm_of(joint: str = "", robot: str = "", **more: Any) -> Robot:
    """The arm of :func:`arm_text`."""
    return read_text(arm_text(joint, robot, **more))


def arm_text(
    joint: str = "", robot: str = "", *, head: str = "", link: str = "", kind: str = "revolute"
) -> str:
    """The description of two joints with effects in flow style: at the first joint, of the whole robot."""
    return (
        f"name: arm\n{head}links:\n  - joint: {kind}\n    mass: 2\n{link}    effects: [{joint}]\n"
        f"  - joint: revolute\neffects: [{robot}]\n"
    )
