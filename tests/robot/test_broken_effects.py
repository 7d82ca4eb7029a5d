"""Broken lists of effects: each refused in one line, at its place, with what was expected and what to do."""

from __future__ import annotations

import pytest

from robodyn.errors import InputError
from robodyn.robot import read_text
from robodyn_testing.clocks import calls_of

#: What is broken: what stands in the list of joint 1 and a part of the message. ¶ is where it must point.
#: First R: in the robot's list; P: at a prismatic joint; F: beside friction; M: beside a huge motor_inertia.
BROKEN = {
    # entries
    "a word": ("¶spring", "link 1: effect 1 must be a mapping; found 'spring'; expected {effect: ...}"),
    "a list": ("¶[spring]", "link 1: effect 1 must be a mapping; found a list of 1"),
    "nothing": ("¶~", "link 1: effect 1 has no value"),
    "no effect": (
        "¶{stiffness: 1}",
        "link 1: effect 1: the key 'effect' is missing; expected effect: one of",
    ),
    "an empty mapping": ("¶{}", "the key 'effect' is missing"),
    "effect is null": ("{effect: ¶~}", "link 1: effect 1 is unknown"),
    "effect is a list": ("{effect: ¶[spring]}", "link 1: effect 1 is unknown; found a list of 1"),
    "misspelt": ("{effect: ¶Backlsh, gap: 1}", "found 'Backlsh'; expected one of"),
    "misspelt, with a remedy": ("{effect: ¶Backlsh, gap: 1}", "did you mean 'backlash'?"),
    "unknown": ("{effect: ¶gremlins}", "expected one of viscous_friction, coulomb_friction"),
    "unknown key": (
        "{effect: spring, stiffness: 1, ¶dampng: 1}",
        "link 1: spring: unknown key; found 'dampng'; expected one of effect, stiffness, rest, cubic",
    ),
    "misspelt key": ("{effect: spring, ¶stifness: 1}", "did you mean 'stiffness'?"),
    "missing": (
        "¶{effect: spring}",
        "link 1: spring: the key 'stiffness' is missing; expected stiffness: a num",
    ),
    "missing at a prismatic joint": ("P¶{effect: spring}", "or a name [N/m]"),
    "of the robot": (
        "{effect: ¶payload, mass: 1}",
        "payload is an effect of the whole robot; move it to the list 'effects' beside 'links'",
    ),
    "of a joint": (
        "R{effect: ¶spring, stiffness: 1}",
        "effect 1: spring is an effect of a joint; move it to 'effects' of the link whose joint it is at",
    ),
    "of a pair": ("R{effect: ¶motor_coupling, with: 1}", "motor_coupling is an effect of a joint"),
    # values
    "negative coefficient": (
        "{effect: viscous_friction, coefficient: ¶-1}",
        "link 1: viscous_friction: coefficient is negative; found -1 N m s/rad; expected 0 N m s/rad or more",
    ),
    "negative at a prismatic joint": (
        "P{effect: viscous_friction, coefficient: ¶-1}",
        "found -1 N s/m; expected 0 N s/m or more",
    ),
    "zero stiffness": ("{effect: joint_elasticity, stiffness: ¶0}", "stiffness is not positive"),
    "no name there": ("{effect: torque_bias, bias: ¶b}", "a name cannot stand here"),
    "a list for a number": ("{effect: backlash, gap: ¶[1]}", "gap must be a single value; found a list of 1"),
    "python": ("{effect: backlash, gap: ¶exit(1)}", "functions are not supported"),
    "infinite": ("{effect: backlash, gap: ¶.inf}", "not a finite number"),
    "a name of the emitted files": ("{effect: backlash, gap: ¶arm_state}", "is a name of the emitted files"),
    "names by case": ("{effect: spring, stiffness: k, rest: ¶K}", "found 'K' after 'k' in line 5"),
    "choice": (
        "{effect: backlash, gap: 1, encoder: ¶moter}",
        "expected motor or link; did you mean 'motor'?",
    ),
    "vector": ("R{effect: payload, mass: 1, com: ¶[1, 2]}", "payload: com must have 3 entries"),
    "inertia": ("R{effect: payload, mass: 1, inertia: ¶[1, 2]}", "payload: inertia must be a mapping"),
    "key of inertia": ("R{effect: payload, mass: 1, inertia: {¶ii: 1}}", "payload: inertia: unknown key"),
    "empty text": (
        "R{effect: external_contact, start: 0, end: 1, link: 1, log: ¶''}",
        "external_contact: log is empty",
    ),
    "text with a bell": (
        'R{effect: external_contact, start: 0, end: 1, link: 1, log: ¶"a\\ab"}',
        "log contains the control character U+0007",
    ),
    "contact that ends at once": (
        "R{effect: external_contact, start: 1, end: ¶1, link: 1}",
        "external_contact: end is not after the start; found '1'; expected more than 1.0 s",
    ),
    "contact with no link": (
        "R{effect: external_contact, start: 0, end: 1, link: ¶3}",
        "link is no joint of this robot; found '3'; expected a whole number from 1 to 2",
    ),
    "coupled with joint 0": ("{effect: motor_coupling, with: ¶0}", "with is no joint of this robot"),
    "coupled with a share": ("{effect: motor_coupling, with: ¶1.5}", "expected a whole number from 1 to 2"),
    "coupled with a digit of Arabic": ("{effect: motor_coupling, with: ¶٢}", "with is no joint"),
    "coupled with itself": ("{effect: motor_coupling, with: ¶1}", "with names the joint itself; found 1"),
    # efficiencies
    "efficiency above 1": (
        "{effect: transmission_loss, efficiency: ¶1.01}",
        "efficiency is not a share; found 1.01; expected more than 0 and at most 1",
    ),
    "efficiency 0": ("{effect: transmission_loss, efficiency: ¶0}", "efficiency is not a share"),
    "efficiency by name": ("{effect: transmission_loss, efficiency: ¶eta}", "a name cannot stand here"),
    "unsorted": (
        "{effect: transmission_loss, efficiency: [[0, 0.5], [1, 1], [¶0.5, 0.8]], rated_torque: 1}",
        "efficiency is an unsorted table: load fractions must rise; found 0.5 after 1; sort the knots",
    ),
    "equal loads": (
        "{effect: transmission_loss, efficiency: [[1, 0.5], [¶1, 0.5]], rated_torque: 1}",
        "an unsorted table",
    ),
    "negative load": (
        "{effect: transmission_loss, efficiency: [[¶-1, 0.5], [1, 1]], rated_torque: 1}",
        "efficiency: knot 1: load fraction is negative; found -1; expected 0 or more",
    ),
    "knot above 1": (
        "{effect: transmission_loss, efficiency: [[0, 0.5], [1, ¶2]], rated_torque: 1}",
        "efficiency: knot 2: efficiency is not a share",
    ),
    "one knot": (
        "{effect: transmission_loss, efficiency: ¶[[0, 1]], rated_torque: 1}",
        "efficiency must have 2 to 64 knots; found a list of 1; expected a number, or a table [[load",
    ),
    "65 knots": (
        f"{{effect: transmission_loss, efficiency: ¶{[[x, 1] for x in range(65)]}, rated_torque: 1}}",
        "efficiency must have 2 to 64 knots; found a list of 65",
    ),
    "knot of three": (
        "{effect: transmission_loss, efficiency: [[0, 1], ¶[1, 1, 1]], rated_torque: 1}",
        "efficiency: knot 2 must be a pair; found a list of 3; expected [load fraction, efficiency]",
    ),
    "knots are numbers": (
        "{effect: transmission_loss, efficiency: [¶0, 1], rated_torque: 1}",
        "knot 1 must be a pair; found '0'",
    ),
    # what the catalogue checks
    "table without rated torque": (
        "{effect: transmission_loss, efficiency: ¶[[0, 0.5], [1, 1]]}",
        "efficiency is a table, and rated_torque is missing",
    ),
    "rated torque without table": (
        "{effect: transmission_loss, efficiency: 0.5, rated_torque: ¶9}",
        "rated_torque means nothing to a constant efficiency; found '9'; expected a table; delete it",
    ),
    "static below Coulomb": (
        "{effect: stribeck_friction, level: 2, static: ¶1, velocity: 1}",
        "static is below the Coulomb level",
    ),
    "phase of many turns": (
        "{effect: torque_ripple, amplitude: 1, cycles_per_rev: 6, phase: ¶2305843009213693951}",
        "phase is so many turns that a position added to it loses its digits",
    ),
    "bearing that does not fit": (
        "{effect: load_dependent_friction, bearing: ¶linear, mu: 1, span: 1}",
        "bearing 'linear' does not fit a revolute joint",
    ),
    "bearing that does not fit a slide": (
        "P{effect: load_dependent_friction, bearing: ¶thrust, mu_r: 1}",
        "bearing 'thrust' does not fit a prismatic joint",
    ),
    "bearing that lacks": (
        "{effect: load_dependent_friction, bearing: ¶thrust, mu: 1}",
        "bearing 'thrust' lacks a number; found 'thrust'; expected mu and radius or mu_r",
    ),
    # what does not go together
    "twice": (
        "{effect: spring, stiffness: 1}, ¶{effect: spring, stiffness: 2}",
        "link 1: spring stands here a second time; found the first in line 5; delete one of the two",
    ),
    "payload twice": (
        "R{effect: payload, mass: 1}, ¶{effect: payload, mass: 1}",
        "payload stands here a second",
    ),
    "tilted twice": (
        "R{effect: base_tilt, tilt_x: 1}, ¶{effect: base_tilt}",
        "base_tilt stands here a second",
    ),
    "coupled twice": (
        "{effect: motor_coupling, with: 2}, ¶{effect: motor_coupling, with: 2, ratio: 3}",
        "motor_coupling stands here a second time",
    ),
    "spring in play": (
        "{effect: joint_elasticity, stiffness: 1}, ¶{effect: backlash, gap: 1}",
        "joint_elasticity and backlash are at one joint; expected one of the two; delete joint_elasticity",
    ),
    "play in spring": (
        "{effect: backlash, gap: 1}, ¶{effect: joint_elasticity, stiffness: 1}",
        "joint_elasticity and backlash are at one joint",
    ),
    "viscous friction twice": (
        "F¶{effect: viscous_friction, coefficient: 1}",
        "link 1: viscous_friction stands beside 'friction: {viscous: ...}', which is the same; delete one",
    ),
    "delay of all and of one": (
        "{effect: time_delay, delay: 1}]\neffects: [¶{effect: time_delay, delay: 1}",
        "time_delay stands at a joint too; expected one for all joints, or one at each",
    ),
    # into the arm's numbers
    "negative mass": (
        "{effect: inertial_error, delta_com_x: 1, delta_mass: ¶-2.5}",
        "delta_mass makes the link's mass negative; found -0.5 kg; expected 0 kg or more in all",
    ),
    "sum beyond double": ("M¶{effect: rotor_inertia, inertia: 1.7e308}", "a sum is beyond double"),
    "gravity beyond double": (
        "]\ngravity: [1.7e308, 1.7e308, -1.7e308]\neffects: [¶{effect: base_tilt, tilt_x: pi/4}",
        "the tilted gravity is beyond double",
    ),
}


def _text(entries: str) -> str:
    at = entries[0] if entries[0] in "RPFM" else ""
    entries = entries.removeprefix(at)
    more = {"F": "friction: {viscous: 0}", "M": "motor_inertia: 1.7e308"}.get(at, "mass: 2")
    head = f"name: arm\nlinks:\n  - joint: revolute\n    {more}\n"
    if at == "R":
        return f"{head}  - joint: prismatic\neffects: [{entries}]\n"
    if at == "P":
        return f"{head}  - joint: prismatic\n    effects: [{entries}]\n"
    first, _, rest = entries.partition("]\n")
    return f"{head}    effects: [{first}]\n  - joint: prismatic\n" + (f"{rest}]\n" if rest else "")


@pytest.mark.parametrize("case", BROKEN)
def test_refused_at_its_place_in_one_line(case: str) -> None:
    entries, message = BROKEN[case]
    before, _, after = _text(entries).partition("¶")
    line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
    with pytest.raises(InputError) as caught:
        read_text(before + after, "arm.yaml", strict=True)
    told = str(caught.value)
    assert told.startswith(f"arm.yaml:{line}:{column}: "), told
    assert message in told
    assert "\n" not in told
    assert told.isprintable()
    assert len(told) < 700
    assert caught.value.exit_code == 2
    assert caught.value.__cause__ is None


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


def test_text_is_kept_as_text() -> None:
    """Ends of comments and quotes go through; the emitter escapes them."""
    log = "*/ int main(void) { } /* \\\" 'x' \u00e9"
    robot = read_text(
        "name: arm\nlinks: [{joint: revolute}]\neffects:\n  - effect: external_contact\n    start: 0\n"
        f"    end: 1\n    link: 1\n    log: '{log.replace(chr(39), chr(39) * 2)}'\n"
    )
    assert robot.effects[0].text("log") == log
