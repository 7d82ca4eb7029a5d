"""The package for ROS 2: built by ament, loaded by pluginlib, called as a node calls a solver.

Debian has ament, pluginlib, urdfdom and Eigen, but neither rclcpp nor inverse_dynamics_solver: headers of our
own with the same declarations (``ros2/include``) stand in for those two.
"""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from packages.consumers import MAINTAINER, STATES, Consumer, c_program, consumer, run, write
from robodyn.kernels.generate import Options, generate
from robodyn.logs.log import read_log
from robodyn.packages import FORMATS, package
from robodyn.robot import read_text
from robodyn_testing import require_module, require_tool
from robodyn_testing.public_arms import arm_file

ROOT = Path(__file__).parents[2]
REAL = ROOT / "examples" / "real" / "ur10_bag"
STUBS = Path(__file__).parent / "ros2"
FUNCTIONS = FORMATS["ros2"].functions
METHODS = ",".join(FUNCTIONS)
#: Folders of Debian's packages that have no program.
LIBRARIES = {
    "/usr/share/ament_cmake": "ament-cmake",
    "/usr/include/eigen3": "libeigen3-dev",
    "/usr/share/pluginlib": "pluginlib-dev",
    "/usr/share/urdfdom": "liburdfdom-dev",
}
PREFIX = "dynamics_solver."
REVOLUTE = ("revolute", "prismatic", "revolute")
QUOTED = "turn &quot;1&quot; \\"
CONFIGS = {
    "rclcpp": """\
if(NOT TARGET rclcpp::rclcpp)
  add_library(rclcpp::rclcpp INTERFACE IMPORTED)
  target_include_directories(rclcpp::rclcpp INTERFACE "{include}")
endif()
""",
    # Folders of headers, as the interface exports them on Humble and Jazzy.
    "inverse_dynamics_solver": 'set(inverse_dynamics_solver_INCLUDE_DIRS "{include}")\n',
}
PROJECT = (STUBS / "node.cmake").read_text(encoding="utf-8")
#: A controller that calls the kernel itself.
DIRECT = (STUBS / "direct.cmake").read_text(encoding="utf-8")
ARM = (STUBS / "lift.yaml").read_text(encoding="utf-8")
URDF = (STUBS / "lift.urdf").read_text(encoding="utf-8")
NAMES = ("shoulder", "column", "wrist")
KINDS = ("continuous", "prismatic", "fixed")


@dataclass(frozen=True)
class Workspace:
    """A folder into which packages are installed, and the node that loads them."""

    folder: Path

    @property
    def prefix(self) -> Path:
        return self.folder / "install"

    def install(self, user: Consumer) -> str:
        """Build and install the package of ``user``; its name."""
        name = user.package.name
        write(self.folder / name, user.package.files())
        self.cmake(name, f"-DCMAKE_INSTALL_PREFIX={self.prefix}", "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror")
        tests = run("ctest", "--test-dir", f"build-{name}", cwd=self.folder)
        assert "100% tests passed" in tests  # newer versions do not count those that failed
        run("cmake", "--install", f"build-{name}", cwd=self.folder)
        return name

    def cmake(self, source: str, *options: str) -> None:
        build = f"build-{source}"
        # ament is in Debian's Python, whatever python3 is called here.
        found = (f"-DCMAKE_PREFIX_PATH={self.prefix}", "-DPython3_EXECUTABLE=/usr/bin/python3")
        run("cmake", "-S", source, "-B", build, *found, *options, cwd=self.folder)
        run("cmake", "--build", build, cwd=self.folder)

    def node(
        self,
        plugin: str,
        joints: int,
        stdin: str,
        *parameters: str,
        methods: str = METHODS,
        states: int = STATES,
    ) -> str:
        """What the node prints that calls the solver of the package ``plugin``."""
        return run(
            self.folder / "build-node" / "consumer", f"{plugin}/InverseDynamicsSolver", str(joints), methods,
            str(states), *parameters, cwd=self.folder, stdin=stdin,
            environment={**os.environ, "AMENT_PREFIX_PATH": str(self.prefix)},
        )  # fmt: skip


@pytest.fixture(scope="module")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Workspace:
    for tool in ("g++", "cmake", "ctest", "xmllint", "ament_xmllint"):
        require_tool(tool)
    for place, missing in LIBRARIES.items():
        if not Path(place).is_dir():
            require_tool(missing)
    built = Workspace(tmp_path_factory.mktemp("workspace"))
    include = STUBS / "include"
    for name, text in CONFIGS.items():
        share = {f"{name}/cmake/{name}Config.cmake": text.format(include=include)}
        write(built.prefix / "share", {**share, f"ament_index/resource_index/packages/{name}": ""})
    text = PROJECT.format(source=STUBS / "consumer.cpp", include=include)
    write(built.folder, {"node/CMakeLists.txt": text})
    built.cmake("node")
    return built


@pytest.fixture(scope="module")
def lift(workspace: Workspace) -> tuple[str, Consumer]:
    """An arm with a sliding joint, a run-time parameter, friction, and names that C++ has to escape."""
    path = workspace.folder / "lift.yaml"
    path.write_text(ARM, encoding="utf-8")
    user = consumer(
        str(path), "ros2", Options(FUNCTIONS),
        license="BSD-3-Clause", maintainer=MAINTAINER, parameters={"m_tool": 1.5},
    )  # fmt: skip
    return workspace.install(user), user


@pytest.mark.thorough
def test_a_node_calls_the_solver(workspace: Workspace, lift: tuple[str, Consumer]) -> None:
    """All methods agree with the recursion and allocate what they return, and the terms add up."""
    name, user = lift
    assert name == "lift_arm_dynamics"  # names of packages are lower case
    write(workspace.folder, {"lift.urdf": URDF.format(names=NAMES, kinds=KINDS)})
    mass, gravity = f"{PREFIX}m_tool=1.5", f"{PREFIX}gravity=0.0,0.0,-9.8"
    user.check(workspace.node(name, 2, user.stdin, mass, gravity, "robot_description=@lift.urdf"))
    user.check(workspace.node(name, 2, user.stdin, mass))  # without a URDF


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("names", "kinds", "parameters", "message"),
    [
        (NAMES, ("revolute", "revolute", "fixed"), (), r"joint 2 .* 'column', is revolute .* prismatic"),
        (NAMES, ("fixed", "prismatic", "fixed"), (), "of 2 joints, and the chain .* has 1 that move: column"),
        (NAMES, REVOLUTE, (), "has 3 that move: shoulder, column, wrist"),
        (NAMES, REVOLUTE, ("tip=slide",), ""),
        (NAMES, KINDS, ("tip=palm",), "no link 'palm'"),
        (NAMES, KINDS, ("tip=base", "root=boom"), "no chain from 'boom' to 'base'"),
        ((QUOTED, "lift", "wrist"), KINDS, (), ""),
        (("other", QUOTED, "lift"), ("revolute", "prismatic", "fixed"), (), "is 'turn .* here"),
        (NAMES, KINDS, ("gravity=0,0,9.8",), r"generated with gravity \[0.0, 0.0, -9.8\]"),
        (NAMES, KINDS, ("m_tool=heavy",), "invalid type"),
    ],
)  # fmt: skip
def test_what_does_not_fit_is_refused(
    names: tuple[str, ...], kinds: tuple[str, ...], parameters: tuple[str, ...], message: str,
    workspace: Workspace, lift: tuple[str, Consumer],
) -> None:  # fmt: skip
    name, user = lift
    write(workspace.folder, {"other.urdf": URDF.format(names=names, kinds=kinds)})
    values = (f"{PREFIX}{parameter}" for parameter in ("m_tool=1.5", *parameters))
    output = workspace.node(name, 2, user.stdin, "robot_description=@other.urdf", *values)
    check_output(user, output, message)


def check_output(user: Consumer, output: str, message: str) -> None:
    """The node refuses with a ``message``; without one it computes what it should."""
    if message:
        assert re.search(f"refused: .*{message}", output), output[:300]
    else:
        user.check(output)


@pytest.mark.thorough
def test_a_run_time_parameter_must_be_set(workspace: Workspace, lift: tuple[str, Consumer]) -> None:
    name, user = lift
    assert "'dynamics_solver.m_tool' is not initialized" in workspace.node(name, 2, user.stdin)


@pytest.mark.thorough
def test_a_controller_calls_the_kernel(workspace: Workspace, lift: tuple[str, Consumer]) -> None:
    name, user = lift
    robot = user.package.robot.name
    main = c_program(user).replace(f"#include <{robot}.h>", f"#include <{name}/{robot}.h>")
    assert f"#include <{name}/" in main
    text = DIRECT.format(package=name)
    write(workspace.folder, {"direct/CMakeLists.txt": text, "direct/main.cpp": main})
    workspace.cmake("direct")
    direct = workspace.folder / "build-direct" / "direct"
    user.check(run(direct, cwd=workspace.folder, stdin=user.stdin))


@pytest.mark.thorough
def test_the_schema_of_packages(workspace: Workspace, lift: tuple[str, Consumer]) -> None:
    """That of package.xml which ROS publishes; the build has read it too."""
    name, _ = lift
    manifest = ElementTree.parse(workspace.folder / name / "package.xml")
    maintainer = manifest.find("maintainer")
    assert maintainer is not None
    assert f"{maintainer.text} <{maintainer.get('email')}>" == MAINTAINER
    schema = "/usr/share/ament_xmllint/xml-catalog/download.ros.org/schema/package_format3.xsd"
    run("xmllint", "--noout", "--schema", schema, f"{name}/package.xml", cwd=workspace.folder)
    run("xmllint", "--noout", f"{name}/plugins.xml", cwd=workspace.folder)


@pytest.mark.parametrize(
    ("more", "text"),
    [
        ("", "return Eigen::VectorXd::Zero(n);"),
        (", friction: {viscous: 1}", "friction[i] -= cqd[i] + tau[i];"),
        (", effects: [{effect: gas_spring, torque: 300}]", "Zero(n);"),
        (", effects: [{effect: load_dependent_friction, bearing: torque, mu: 0.1}]", "UnimplementedError("),
    ],
)  # fmt: skip
def test_what_friction_depends_on(more: str, text: str) -> None:
    """The interface has friction as a function of velocities: springs are no friction, and what follows the
    load is no such function."""
    arm = f"name: arm\nlinks:\n- {{joint: revolute, alpha: pi/2, mass: 3, com: [1, 0, 0.5]{more}}}\n"
    generated = generate(read_text(arm), Options(FUNCTIONS, optimize="none"))
    solver = package(generated, "ros2").files()["src/solver.cpp"]
    assert isinstance(solver, str)
    assert text in solver


UR10 = "ur_description/urdf/ur10_robot.urdf"


@pytest.fixture(scope="module")
def ur10(workspace: Workspace) -> tuple[str, Consumer]:
    user = consumer(str(REAL / "ur10_bag.yaml"), "ros2", Options(FUNCTIONS))
    return workspace.install(user), user


@pytest.mark.slow
@pytest.mark.parametrize(
    ("joint", "old", "new", "named"),
    [
        ("elbow_joint", 'xyz="0.0 -0.1719 0.612"', 'xyz="0.0 -0.1719 0.615"', ""),  # as calibrated
        ("elbow_joint", 'xyz="0.0 -0.1719 0.612"', 'xyz="0.0 -0.1719 0.662"', "elbow_joint"),
        ("elbow_joint", 'rpy="0.0 0.0', 'rpy="0.0 0.1', "wrist_1_joint"),
        ("wrist_1_joint", 'axis xyz="0 1 0"', 'axis xyz="0 -1 0"', "wrist_1_joint"),
        ("wrist_2_joint", 'axis xyz="0 0 1"', 'axis xyz="0 0 -1"', "wrist_2_joint"),
    ],
)  # fmt: skip
def test_axes_lie_as_in_the_urdf(
    joint: str, old: str, new: str, named: str, workspace: Workspace, ur10: tuple[str, Consumer]
) -> None:
    """Another length, zero or direction of a joint is another arm, and its torques would be wrong."""
    name, user = ur10
    text = arm_file("example-robot-data", UR10).read_text()
    before, found, after = text.partition(f'<joint name="{joint}"')
    assert found
    assert old in after
    write(workspace.folder, {"ur10.urdf": before + found + after.replace(old, new, 1)})
    output = workspace.node(name, 6, user.stdin, "robot_description=@ur10.urdf")
    check_output(user, output, named and f"the axes of '.*' and '{named}' have another")


@pytest.mark.thorough
def test_the_recorded_ur10(workspace: Workspace, ur10: tuple[str, Consumer]) -> None:
    """The solver replays the bag, and Pinocchio says the same of the URDF that the node is given.

    Accelerations are differences of velocities, as the interface's own demonstration takes them.
    """
    pinocchio = require_module("pinocchio")
    require_module("rosbags.typesys")
    urdf = arm_file("example-robot-data", UR10)
    name, user = ur10
    log = read_log(REAL / "raw" / "ur10_exciting_trajectory.db3", robot=user.package.robot)
    assert log.qd is not None
    qdd = np.vstack([np.zeros(6), np.diff(log.qd, axis=0) / np.diff(log.t)[:, None]])
    states = np.hstack([log.q, log.qd, qdd])
    stdin = "\n".join(" ".join(map(repr, row)) for row in states.tolist())
    output = workspace.node(
        name, 6, stdin, f"robot_description=@{urdf}", methods="inverse_dynamics", states=len(states)
    )
    replayed = np.array(output.split(), dtype=float).reshape(-1, 6)
    model = pinocchio.buildModelFromUrdf(str(urdf))
    data = model.createData()
    expected = np.array([pinocchio.rnea(model, data, *np.split(row, 3)) for row in states])
    assert len(expected) == 3441
    np.testing.assert_allclose(replayed, expected, rtol=0, atol=1e-8 * np.abs(expected).max())
