"""Motions of the joints: made from joint positions, lines, sums of harmonics, or read from files."""

from robodyn.simulate.trajectories.file import from_file
from robodyn.simulate.trajectories.fourier import fourier
from robodyn.simulate.trajectories.joints import PROFILES, ProfileName, quintic, trapezoid
from robodyn.simulate.trajectories.line import line
from robodyn.simulate.trajectories.trajectory import PERIOD, Trajectory

__all__ = [
    "PERIOD",
    "PROFILES",
    "ProfileName",
    "Trajectory",
    "fourier",
    "from_file",
    "line",
    "quintic",
    "trapezoid",
]
