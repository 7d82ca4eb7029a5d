"""The wheel: installed by pip in an environment of its own, without a network, and used there."""

from __future__ import annotations

import email
import os
import sys
import venv
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from email.utils import parseaddr
from pathlib import Path

import numpy as np
import pytest

from packages.consumers import MAINTAINER, Consumer, consumer, loaded_arm, run, write
from robodyn.kernels.generate import Options, generate
from robodyn.packages import package
from robodyn.packages.formats.wheel import tag_of
from robodyn.robot import load
from robodyn.simulate.poses import PoseSolver
from robodyn_testing import require_module, require_tool

pytestmark = pytest.mark.thorough

FUNCTIONS = ("inverse_dynamics", "mass_matrix", "kinetic_energy", "inverse_dynamics_derivatives")
#: Reads the inputs of a :class:`Consumer` from stdin and prints what the functions give.
CALLS = """\
import sys
import numpy as np
import {package} as arm

numbers = iter(map(float, sys.stdin.read().split()))
for name, sizes in {routines}:
    rows = [[np.array([next(numbers) for _ in range(n)]) for n in sizes] for _ in range({states})]
    function = getattr(arm, name)
    batch = function(*map(np.array, zip(*rows)){params})
    for k, row in enumerate(rows):
        one = function(*row{params})
        many = [x[k] for x in batch] if isinstance(batch, tuple) else [batch[k]]
        for x, y in zip(one if isinstance(one, tuple) else [one], many):
            assert np.array_equal(x, y) and x.dtype == np.{dtype}, name
            print(*x.ravel())
"""


@dataclass(frozen=True, slots=True)
class Environment:
    """A virtual environment with numpy and a package."""

    python: Path
    variables: Mapping[str, str]

    def run(self, *arguments: str | Path, folder: Path, stdin: str = "") -> str:
        """The stdout of Python in ``folder``."""
        return run(self.python, "-I", *arguments, cwd=folder, stdin=stdin, environment=self.variables)


def environment(folder: Path, wheel: Path) -> Environment:
    """A new environment in which pip has installed ``wheel``; numpy is that of the tests."""
    require_module("pip")
    venv.create(folder, with_pip=False)
    python = folder / ("Scripts" if os.name == "nt" else "bin") / "python"
    here = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    pip = (sys.executable, "-m", "pip", "--python", python, "install", "--quiet", "--no-deps", "--no-index")
    run(*pip, "--disable-pip-version-check", wheel, cwd=folder, environment=here)
    new = Environment(python, here)
    packages = new.run("-c", "import sysconfig; print(sysconfig.get_path('purelib'))", folder=folder).strip()
    Path(packages, "numpy.pth").write_text(f"{Path(np.__file__).parents[1]}\n", encoding="utf-8")
    return new


def written(folder: Path, user: Consumer) -> Path:
    """The wheel on disk."""
    require_tool("cc")
    files = user.package.files()
    write(folder, files)
    (wheel,) = (folder / path for path in files if path.endswith(".whl"))
    return wheel


def program(user: Consumer) -> str:
    routines = [(case.routine.name, [array.size for array in case.routine.inputs]) for case in user.cases]
    return CALLS.format(
        package=user.package.name,
        routines=routines,
        states=len(user.cases[0].inputs),
        params=f", params={dict(user.parameters)}" if user.parameters else "",
        dtype="float32" if user.package.scalar == "float" else "float64",
    )


IN_FLOAT = Options(("inverse_dynamics", "forward_dynamics"), scalar="float", trig="builtin")


@pytest.mark.parametrize("robot", ["puma560", "crane"])
def test_pip_installs_it_and_it_computes(robot: str, tmp_path: Path) -> None:
    if robot == "crane":
        path = str(loaded_arm(tmp_path, robot))
        user = consumer(path, "wheel", IN_FLOAT, parameters={"m_tool": 1.5})
    else:
        user = consumer(robot, "wheel", Options(FUNCTIONS))
    there = environment(tmp_path / "environment", written(tmp_path, user))
    user.check(there.run("-c", program(user), folder=tmp_path, stdin=user.stdin))


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Environment:
    """With a wheel whose functions have run-time parameters, and one that remembers."""
    folder = tmp_path_factory.mktemp("wheel")
    path = folder / "arm.yaml"
    path.write_text(
        "name: arm\nlinks:\n- joint: revolute\n  mass: m_1\n  com: [0.1, 0, 0]\n  motor_inertia: 1\n"
        "  effects: [{effect: presliding_hysteresis, stiffness: 1000, level: 2}]\n"
        "- {joint: revolute, a: 1, mass: 2, com: [0.2, 0, 0], motor_inertia: 1}\n"
    )
    require_tool("cc")
    functions = ("inverse_dynamics", "mass_matrix", "forward_kinematics")
    files = package(generate(load(str(path)), Options(functions)), "wheel").files()
    write(folder, files)
    (wheel,) = folder.glob("*.whl")
    return environment(folder / "environment", wheel)


MEMORY = """\
import numpy as np
import arm_dynamics as arm

t = np.arange(50) * 1e-3
q = np.stack([np.sin(9 * t), 0 * t], 1)
qd = np.stack([9 * np.cos(9 * t), 0 * t], 1)
params = {"m_1": 3.0}
whole = arm.inverse_dynamics(q, qd, 0 * q, params=params, dt=1e-3)
state = np.zeros(1)
arm.inverse_dynamics(q[0], qd[0], 0 * q[0], params=params, dt=0.0, state=state)
parts = [arm.inverse_dynamics(*x, params=params, dt=1e-3, state=state) for x in zip(q, qd, 0 * q)]
assert np.array_equal(whole, np.array(parts)) and state[0] != 0
print(*whole.ravel())
"""


def test_memory_moves_on_as_in_our_kernels(installed: Environment, tmp_path: Path) -> None:
    import robodyn
    from robodyn.robot import read_text

    tau = np.array([float(x) for x in installed.run("-c", MEMORY, folder=tmp_path).split()]).reshape(-1, 2)
    description = (installed.python.parents[2] / "arm.yaml").read_text()
    t = np.arange(50) * 1e-3
    q, qd = (np.stack([x, 0 * t], 1) for x in (np.sin(9 * t), 9 * np.cos(9 * t)))
    kernel = robodyn.compile(read_text(description), functions=("inverse_dynamics",))
    assert tau == pytest.approx(
        kernel.inverse_dynamics(q, qd, 0 * q, params={"m_1": 3.0}, dt=1e-3), rel=1e-12, abs=1e-12
    )


REFUSED = """\
import numpy as np
import arm_dynamics as arm

p = {"m_1": 3.0}
for call in (
    lambda: arm.mass_matrix([0.0, 0.0, 0.0], params=p),
    lambda: arm.mass_matrix([0j, 0j], params=p),
    lambda: arm.mass_matrix([0.0, 0.0]),
    lambda: arm.mass_matrix([0.0, 0.0], params=p, dt=1.0),
    lambda: arm.mass_matrix(qd=[0.0, 0.0], params=p),
    lambda: arm.mass_matrix([0.0, 0.0], params=p, out=np.zeros((2, 2), np.float32)),
    lambda: arm.inverse_dynamics(np.zeros((3, 2)), np.zeros((2, 2)), np.zeros(2), params=p, dt=1.0),
    lambda: arm.inverse_dynamics([0.0, 0.0], [0.0, 0.0], [0.0, 0.0], params=p),
):
    try:
        call()
    except (TypeError, ValueError) as error:
        print(error)
    else:
        print("nothing")
"""
MESSAGES = (
    "q has the shape [3], expected [..., 2]",
    "q is an array of complex128, not of real numbers",
    "mass_matrix: params are [], expected m_1",
    "mass_matrix() remembers nothing, and takes neither state nor dt",
    "mass_matrix() takes q; found 0 arrays, ['qd']",
    "mass_matrix: out for M is no writable C array [2, 2] of float64",
    "inverse_dynamics: the numbers of states differ: q [3, 2], qd [2, 2], qdd [2]",
    "inverse_dynamics() remembers, and needs dt, the time between states in s",
)


def test_what_does_not_fit_is_refused(installed: Environment, tmp_path: Path) -> None:
    assert tuple(installed.run("-c", REFUSED, folder=tmp_path).splitlines()) == MESSAGES


ARRAYS = """\
import numpy as np
import arm_dynamics as arm

p = {"m_1": 3.0}
q = np.random.default_rng(0).uniform(-1, 1, (4, 1, 3, 2))
grid = arm.mass_matrix(q, params=p)
assert grid.shape == (4, 1, 3, 2, 2)
assert np.array_equal(arm.mass_matrix(np.asfortranarray(q[2, 0]), params=p), grid[2, 0])
assert np.array_equal(arm.mass_matrix(q[::-1, :, ::2], params=p), grid[::-1, :, ::2])
assert np.array_equal(arm.mass_matrix([1, 0], params=p), arm.mass_matrix([1.0, 0.0], params=p))
assert arm.mass_matrix(np.zeros((0, 2)), params=p).shape == (0, 2, 2)
rows = np.zeros((3, 2))
assert arm.inverse_dynamics(rows, [1.0, 2.0], [0, 0], params=p, dt=1e-3).shape == (3, 2)
buffer = np.concatenate([q[0, 0], q[0, 0]])[:4].copy()
expected = arm.mass_matrix(buffer[:1], params=p)
result = buffer[:2].reshape(1, 2, 2)
assert arm.mass_matrix(buffer[:1], params=p, out=result) is result
assert np.array_equal(result, expected)
assert arm.__version__ == "0.1.0" and arm.JOINTS == 2 and arm.PARAMETERS == ("m_1",)
assert "mass matrix" in arm.mass_matrix.__doc__
print("compared")
"""


def test_arrays_of_every_layout(installed: Environment, tmp_path: Path) -> None:
    assert installed.run("-c", ARRAYS, folder=tmp_path) == "compared\n"


TYPED = """\
import numpy as np
from numpy.typing import NDArray

import arm_dynamics as arm

def torque(q: NDArray[np.float64]) -> float:
    tau = arm.inverse_dynamics(q, [0, 0], q, params={"m_1": 1.0}, dt=1e-3)
    return float(tau[0])

def matrix(q: NDArray[np.float64]) -> arm.Array:
    return arm.mass_matrix(q, params={"m_1": 1.0}, out=np.zeros((2, 2)))
"""
MISTYPED = {
    "arm.mass_matrix([0, 0], params={})": 'Missing key "m_1" for TypedDict "Params"',
    "arm.inverse_dynamics([0, 0], [0, 0], [0, 0], params=p)": 'Missing named argument "dt"',
    "text: str = arm.forward_kinematics([0, 0], params=p)": "Incompatible types in assignment",
    "arm.invers_dynamics": 'Module has no attribute "invers_dynamics"',
}


def test_mypy_reads_the_stubs(installed: Environment, tmp_path: Path) -> None:
    mypy = require_module("mypy.api")
    (tmp_path / "right.py").write_text(TYPED)
    lines = ["import arm_dynamics as arm", 'p: arm.Params = {"m_1": 1.0}', *MISTYPED]
    (tmp_path / "wrong.py").write_text("\n".join(lines) + "\n")
    options = ("--strict", "--no-error-summary", "--config-file=", f"--cache-dir={tmp_path / 'cache'}")
    files = [str(tmp_path / name) for name in ("right.py", "wrong.py")]
    report, errors, _ = mypy.run([*options, "--python-executable", str(installed.python), *files])
    assert not errors
    assert "right.py" not in report
    complaints = [line for line in report.splitlines() if ": error: " in line]
    for (wrong, complaint), line in zip(MISTYPED.items(), complaints, strict=True):
        assert complaint in line, wrong


@pytest.mark.parametrize(
    ("symbols", "baseline", "system", "tag"),
    [
        (b"\0GLIBC_2.2.5\0", True, "linux-x86_64", "manylinux_2_5_x86_64"),
        (b"\0GLIBC_2.2.5\0GLIBC_2.29\0", True, "linux-x86_64", "manylinux_2_29_x86_64"),
        (b"\0GLIBC_2.4\0", True, "linux-aarch64", "manylinux_2_17_aarch64"),
        (b"\0GLIBC_2.2.5\0GLIBC_ABI_DT_RELR\0", True, "linux-x86_64", "linux_x86_64"),
        (b"\0GLIBC_2.2.5\0", False, "linux-x86_64", "linux_x86_64"),
        (b"no glibc", True, "linux-x86_64", "linux_x86_64"),
        (b"", True, "macosx-11.0-arm64", "macosx_11_0_arm64"),
        (b"", True, "win-amd64", "win_amd64"),
    ],
)
def test_a_tag_promises_no_more_than_is_so(
    symbols: bytes, baseline: bool, system: str, tag: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sysconfig.get_platform", lambda: system)
    monkeypatch.setattr("platform.libc_ver", lambda: ("glibc", "2.36"))
    assert tag_of(symbols, baseline=baseline) == f"py3-none-{tag}"


def test_a_wheel_as_pip_and_zip_want_it(tmp_path: Path) -> None:
    user = consumer("stanford_3dof", "wheel", Options(("gravity",)), license="MIT", maintainer=MAINTAINER)
    wheel = written(tmp_path, user)
    name, version, python, abi, machine = wheel.stem.split("-")
    assert (name, version, python, abi) == ("stanford_3dof_dynamics", "1.2.3", "py3", "none")
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        record = archive.read(f"{name}-{version}.dist-info/RECORD").decode().splitlines()
        tags = archive.read(f"{name}-{version}.dist-info/WHEEL").decode()
        metadata = archive.read(f"{name}-{version}.dist-info/METADATA").decode()
    assert sorted(line.partition(",")[0] for line in record) == sorted(names)
    assert f"Tag: py3-none-{machine}\n" in tags
    assert "\nLicense: MIT\n" in metadata
    stated = email.message_from_string(metadata)["Maintainer-email"]
    assert "{} <{}>".format(*parseaddr(stated)) == MAINTAINER


POSES = """\
import numpy as np
import ur5_dynamics as arm

T = np.array(%r)
whole = np.vstack([T, [0.0, 0.0, 0.0, 1.0]])
first = arm.inverse_kinematics(T)
for poses in (T.ravel(), whole, [T, T], [whole, whole]):
    solutions = arm.inverse_kinematics(poses)[0]
    assert np.array_equal(solutions if solutions.ndim == 2 else solutions[1], first[0])
assert all(map(np.array_equal, arm.inverse_kinematics(T, q_near=np.zeros(6)), first))
try:
    arm.inverse_kinematics(T[:2])
except ValueError as error:
    print(error)
print(*first[0][first[1] > 0].ravel())
"""


def test_poses_as_matrices(tmp_path: Path) -> None:
    """As 3 by 4 or 4 by 4 matrices or rows of numbers, one or many, with a reference or without."""
    q = np.array([0.3, -1.2, 1.5, -0.4, 0.8, 0.1])
    user = consumer("ur5", "wheel", Options(("inverse_kinematics",)))
    here = environment(tmp_path / "environment", written(tmp_path / "wheel", user))
    (tmp_path / "poses.py").write_text(POSES % PoseSolver(load("ur5")).pose(q).tolist(), encoding="utf-8")
    message, row = here.run(tmp_path / "poses.py", folder=tmp_path).splitlines()
    assert message == "T has the shape [2, 4], expected [..., 3, 4]"
    reached = np.array([float(word) for word in row.split()]).reshape(-1, 6)
    assert np.abs(reached - q).max(axis=1).min() < 1e-12
