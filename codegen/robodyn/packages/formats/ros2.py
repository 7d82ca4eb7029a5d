"""ROS 2: an ament package with a plugin for ``inverse_dynamics_solver``, and the plain header."""

from __future__ import annotations

from typing import Final

from robodyn.emit.languages.c import LANGUAGE as C
from robodyn.packages.axes import axes_of
from robodyn.packages.format import Files, Format, Package
from robodyn.packages.friction import FUNCTIONS, friction_of
from robodyn.packages.limits import SAME_AXES
from robodyn.packages.writing import arithmetic_flags, readme, rendered

_TEMPLATES: Final = {
    "package.xml": "package.xml.j2",
    "CMakeLists.txt": "CMakeLists.txt.j2",
    "plugins.xml": "plugins.xml.j2",
    "src/solver.cpp": "solver.cpp.j2",
    "src/settings.hpp": "settings.hpp.j2",
    "src/settings.cpp": "settings.cpp.j2",
    "src/axes.hpp": "axes.hpp.j2",
    "src/axes.cpp": "axes.cpp.j2",
}
#: What the methods of the interface call.
_NEEDS: Final = tuple(dict.fromkeys(("inverse_dynamics", "mass_matrix", *FUNCTIONS)))


def _files(package: Package) -> Files:
    robot = package.robot
    about = {"friction": friction_of(package), "gravity": [repr(float(g)) for g in robot.gravity]}
    joints = [(_quoted(link.name), link.joint.kind) for link in robot.links]
    model = {"joints": joints, "axes": axes_of(robot), "same": SAME_AXES}
    return {
        **readme(package, **about),
        **rendered(package, _TEMPLATES, flags=arithmetic_flags(package), **model, **about),
        **{
            f"include/{package.name}/{path}" if path.endswith(".h") else f"src/{path}": text
            for path, text in package.kernel().items()
        },
        **{f"test/{path}": text for path, text in package.tests().items()},
    }


def _called(robot: str) -> str:
    """In lower case, as ROS has it (REP 144)."""
    return f"{robot}_dynamics".lower()


def _quoted(text: str) -> str:
    """``text``, which has no control characters, as a literal of C++."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


FORMAT = Format(
    name="ros2",
    title="a ROS 2 package",
    tool="ROS 2 with inverse_dynamics_solver 1.0 (Humble), 2.0 (Jazzy) or 6.0 (Rolling)",
    language=C,
    files=_files,
    take="colcon build --base-paths {folder}",
    functions=_NEEDS,
    needs=_NEEDS,
    lacks=frozenset({"memory", "given sines"}),
    called=_called,
)
