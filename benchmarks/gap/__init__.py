"""How much of the torque of real arms stays unexplained: our tools beside plain least squares and others."""
