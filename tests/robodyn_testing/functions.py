"""Which functions tests go through."""

from __future__ import annotations

from robodyn.dynamics.functions import FUNCTIONS

#: They need gears, which the arms of tests seldom have; tests/dynamics/test_functions.py is about them.
OF_MOTORS = ("motor_torque", "motor_current")
#: Base parameters depend on lengths, which are numbers then; tests/dynamics/test_regressor.py is about them.
OF_PARAMETERS = tuple(name for name, function in FUNCTIONS.items() if function.has_parameters)
#: Only arms of some classes have them; tests/dynamics/test_inverse_kinematics.py is about them.
OF_POSES = tuple(name for name, function in FUNCTIONS.items() if function.of_pose)
#: Functions that an arm has whatever is stated of it, but where a joint moves without inertia.
OF_ANY_ARM = tuple(name for name in FUNCTIONS if name not in (*OF_MOTORS, *OF_PARAMETERS, *OF_POSES))
