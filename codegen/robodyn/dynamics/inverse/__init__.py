"""Inverse kinematics in closed form, over any scalar: classes of arms, their equations, all branches."""

from robodyn.dynamics.inverse.inverse import Inverse, inverse_of
from robodyn.dynamics.inverse.solution import Nearest, Solved

__all__ = ["Inverse", "Nearest", "Solved", "inverse_of"]
