"""Inverse kinematics over any scalar: classes of arms that have it in closed form, their equations, all
branches; and of other arms steps towards a pose."""

from robodyn.dynamics.inverse.closed_form import Inverse, inverse_of
from robodyn.dynamics.inverse.numerical import Numerical, solver_of
from robodyn.dynamics.inverse.solution import Nearest, Solved

__all__ = ["Inverse", "Nearest", "Numerical", "Solved", "inverse_of", "solver_of"]
