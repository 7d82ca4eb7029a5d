"""Hostile lists of effects. What is said of broken ones stands in ``tests/refusals``."""

from __future__ import annotations

import pytest

from robodyn.errors import InputError
from robodyn.robot import read_text
from robodyn_testing.clocks import calls_of

HEAD = "name: arm\nlinks:\n  - joint: revolute\n    effects: "


@pytest.mark.parametrize(
    "text",
    [
        pytest.param(
            HEAD + "[" + "{effect: torque_ripple, amplitude: 1, cycles_per_rev: 2}," * 2000 + "]",
            marks=pytest.mark.thorough,
        ),
        HEAD + "[" + "{}," * 20_000 + "]",
        HEAD + "[{effect: transmission_loss, rated_torque: 1, efficiency: " + "[" * 25 + "]" * 25 + "}]",
        HEAD + "[{effect: transmission_loss, rated_torque: 1, efficiency: [" + "[0, 1]," * 5000 + "]}]",
        HEAD + "[{effect: transmission_loss, efficiency: " + "(" * 900_000 + "}]",
        HEAD + "[{effect: " + "x" * 900_000 + "}]",
        HEAD + "[{effect: spring, " + "x" * 900_000 + ": 1}]",
        HEAD + "[{effect: motor_coupling, with: " + "9" * 900_000 + "}]",
        HEAD + "[{effect: {effect: {effect: spring}}}]",
        HEAD + "&a [{effect: spring, stiffness: 1}, *a]",
        HEAD + "[{effect: spring, stiffness: \"1*/ __import__('os').system('true')\"}]",
    ],
    ids=lambda text: text[47:85],
)
def test_hostile_lists_end_soon(text: str) -> None:
    with pytest.raises(InputError) as caught:
        calls_of(lambda: read_text(text, "arm.yaml"), most=5_000_000)
    assert len(str(caught.value)) < 700


def test_a_table_of_efficiencies_is_short() -> None:
    entry = f"{{effect: transmission_loss, rated_torque: 1, efficiency: {[[x, 1] for x in range(65)]}}}"
    with pytest.raises(InputError, match="efficiency must have 2 to 64 knots; found a list of 65"):
        read_text(f"{HEAD}[{entry}]")


def test_text_is_kept_as_text() -> None:
    """Ends of comments and quotes go through; the emitter escapes them."""
    log = "*/ int main(void) { } /* \\\" 'x' \u00e9"
    robot = read_text(
        "name: arm\nlinks: [{joint: revolute}]\neffects:\n  - effect: external_contact\n    start: 0\n"
        f"    end: 1\n    link: 1\n    log: '{log.replace(chr(39), chr(39) * 2)}'\n"
    )
    assert robot.effects[0].text("log") == log
