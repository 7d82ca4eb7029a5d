"""What may stand at a key: bounds of numbers, and the words that messages have for it."""

from __future__ import annotations

from fractions import Fraction

from robodyn.robot.keys import Key, Sign

#: Bounds of a number: what is said of one that breaks them, and what was expected.
SIGNS = {
    "nonzero": ("is 0", "any number but 0"),
    "nonnegative": ("is negative", "0{unit} or more"),
    "positive": ("is not positive", "more than 0{unit}"),
    "share": ("is not a share", "more than 0 and at most 1"),
}

#: What other formats call our keys.
OTHER_NAMES = {
    "type": "joint",
    "kind": "joint",
    "joint_type": "joint",
    "m": "mass",
    "weight": "mass",
    "r": "com",
    "cog": "com",
    "center_of_mass": "com",
    "centre_of_mass": "com",
    "offset": "theta",
    "armature": "motor_inertia",
    "jm": "motor_inertia",
    "imotor": "motor_inertia",
    "ixx": "xx",
    "iyy": "yy",
    "izz": "zz",
    "ixy": "xy",
    "ixz": "xz",
    "iyz": "yz",
    "yx": "xy",
    "zx": "xz",
    "zy": "yz",
    "joints": "links",
    "g": "gravity",
    "effort": "torque",
    "damping": "viscous",
    "dh": "convention",
    "mount": "base",
    "tcp": "tool",
    "flange": "tool",
    "translation": "xyz",
    "position_xyz": "xyz",
    "rotation": "rpy",
}


def allowed(value: Fraction, sign: Sign) -> bool:
    """Whether ``value`` is within the bounds that ``sign`` names."""
    if sign == "any":
        return True
    if sign == "nonnegative":
        return value >= 0
    if sign == "nonzero":
        return value != 0
    return value > 0 and (sign == "positive" or value <= 1)


def expectation(key: Key) -> str:
    """What should stand at ``key``, for the "expected" of a message."""
    if key.kind == "choice":
        return " or ".join(key.choices)
    unit = f" [{key.unit}]" if key.unit else ""
    words = {
        "name": "a name",
        "text": "text",
        "number": " or ".join(["a number" + (", or a name" if key.names else ""), *key.choices]),
        "angle": "an angle, such as -pi/2",
        "vector": "three numbers [x, y, z]",
        "angles": "three angles [roll, pitch, yaw]",
        "range": "[lowest, highest]",
        "list": "a list",
        "texts": "a list of lines of text",
        "group": "a mapping",
        "rest": "exact, or smooth: {velocity: 1e-3}, or dead_band: {velocity: 1e-3}",
        "efficiency": "a number, or a table [[load fraction, efficiency], ...]",
        "origins": f"{' or '.join(key.choices)}, or a mapping such as {{inertial: synthetic}}",
        "joint": "the number of a joint",
        "effects of a joint": "a list of effects, such as [{effect: backlash, gap: 1e-3}]",
        "effects of the robot": "a list of effects, such as [{effect: payload, mass: 2}]",
    }
    return words[key.kind] + unit
