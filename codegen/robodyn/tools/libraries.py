"""The Python packages: those that every installation has, and those that extras bring."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Final

from robodyn.tools.tool import Library, Use

CFFI: Final = Library("cffi", Use.EVERYTHING, "calls of compiled kernels")
CLICK: Final = Library("click", Use.EVERYTHING, "commands")
JINJA2: Final = Library("jinja2", Use.EVERYTHING, "texts of kernels")
MATPLOTLIB: Final = Library("matplotlib", Use.EVERYTHING, "pictures")
NUMPY: Final = Library("numpy", Use.EVERYTHING, "logs, simulations and diagnoses")
PYCPARSER: Final = Library("pycparser", Use.EVERYTHING, "operations counted in the C")
PYYAML: Final = Library("yaml", Use.EVERYTHING, "robots", package="pyyaml")
SCIPY: Final = Library("scipy", Use.EVERYTHING, "simulations and fits")
SYMPY: Final = Library("sympy", Use.EVERYTHING, "equations and exact references")
THREADPOOLCTL: Final = Library("threadpoolctl", Use.EVERYTHING, "the same sums with any number of cores")

REQUIRED: Final = (CFFI, CLICK, JINJA2, MATPLOTLIB, NUMPY, PYCPARSER, PYYAML, SCIPY, SYMPY, THREADPOOLCTL)
"""What ``pip install robodyn`` brings."""

CRYPTOGRAPHY: Final = Library(
    "cryptography", Use.CLUSTERS, "connections that other users of this machine cannot use", extra="fleet"
)
DISTRIBUTED: Final = Library(
    "distributed", Use.CLUSTERS, "processes that work together", extra="fleet", title="Dask"
)
H5PY: Final = Library("h5py", Use.LOGS, "logs of MATLAB 7.3 and in HDF5", extra="mat")
MCAP: Final = Library("mcap", Use.LOGS, "recordings of ROS 2 in MCAP", extra="ros")
MUJOCO: Final = Library("mujoco", Use.ARMS, "arms in MJCF", extra="mujoco")
ORTOOLS: Final = Library(
    "ortools", Use.SCHEDULES, "proven optima of schedules", extra="optimal", title="OR-Tools"
)
PYARROW: Final = Library("pyarrow", Use.LOGS, "logs in Parquet", extra="all")
ROSBAGS: Final = Library("rosbags", Use.LOGS, "recordings of ROS 2", extra="ros")
XACRO: Final = Library("xacro", Use.ARMS, "arms in xacro", extra="xacro")

PINOCCHIO: Final = Library(
    "pinocchio", Use.COMPARISONS, "robodyn verify --against URDF and times in robodyn bench", package="pin"
)
CASADI: Final = Library(
    "casadi", Use.PACKAGES, "functions of robodyn package --as casadi, and times in robodyn bench"
)
FMPY: Final = Library("fmpy", Use.PACKAGES, "simulations of robodyn package --as fmu")

OPTIONAL: Final = (
    CASADI, FMPY, MUJOCO, XACRO, DISTRIBUTED, CRYPTOGRAPHY, H5PY, MCAP, PYARROW, ROSBAGS, ORTOOLS, PINOCCHIO,
)  # fmt: skip
"""What an extra brings, or one installs oneself."""


@contextmanager
def quiet_mujoco(mujoco: Any) -> Iterator[None]:
    """Without warnings of MuJoCo, nor the log that it writes of them to the current folder.

    They are of a mass matrix that is near to singular and of settings of models that are attached; a reader
    that hides them says itself what they are about.
    """
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(lambda _: None)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    finally:
        mujoco.set_mju_user_warning(before)
