"""Inverse dynamics of earlier papers, with which the thesis compares its recursion: one formulation a module.

Kernels for users are written from none of them unless ``--formulation`` asks for it. Each module has a
function of its name, from an arm and a motion to joint torques.
"""

from __future__ import annotations

from typing import Final

#: What each formulation is called in the heads of files, by its name on the command line.
TITLES: Final = {
    "newton_euler_base": "Newton-Euler along the base's axes",
    "orin": "Orin's Newton-Euler (motion along the base's axes, forces along each link's)",
    "balafoutis": "Balafoutis's tensor recursion",
    "kane": "Kane's equations",
    "lagrange_3x3": "recursive Lagrange with 3x3 matrices (Hollerbach)",
    "lagrange_4x4": "recursive Lagrange with 4x4 matrices (Hollerbach)",
    "lagrange": "closed-form Lagrange (Uicker, Kahn)",
}
