"""``robodyn import``, ROBOT as a file in another format, and what is compared with such a file."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from cli.command import Capture, run, run_json
from robodyn.formats import loading
from robodyn.formats.arm import import_arm
from robodyn.robot import load
from robodyn_testing import require_module
from robodyn_testing.original_arms import MJCF, URDF
from robodyn_testing.urdf_text import joint, link, robot
from robodyn_testing.xacro_arms import HEAD, PACKAGE, TWO_LINKS, arm, write

ARM = robot(
    link("base"), link("a", link("x")[15:-7] + "<visual/>"), link("b"), joint("one", "base", "a"),
    joint("two", "a", "b", "revolute", '<axis xyz="0 1 0"/>'), name="two-joint arm",
)  # fmt: skip
XACRO = {
    "arm/arm.xacro": arm(
        '<xacro:arg name="m" default="1"/><xacro:property name="m" value="$(arg m)"/>'
        '<xacro:include filename="$(find more)/more.xacro"/>'
    ),
    "arm/more.xacro": f"{HEAD}</robot>",
    "arm/package.xml": PACKAGE % "more",
    "far/more.xacro": f'{HEAD}<xacro:property name="m" value="$(env MASS)"/></robot>',
}


@pytest.fixture
def folder(elsewhere: Path) -> Path:
    (elsewhere / "arm.urdf").write_text(ARM)
    return elsewhere


@pytest.fixture
def xacro(elsewhere: Path) -> Path:
    require_module("xacro")
    write(elsewhere, XACRO)
    return elsewhere


@pytest.fixture
def originals(elsewhere: Path, capsys: Capture) -> Path:
    for name in ("mujoco", "pinocchio"):
        require_module(name)
    for file, text in (("arm.xml", MJCF), ("arm.urdf", URDF)):
        (elsewhere / file).write_text(text)
        run(capsys, f"import {file} --tip tool -o {Path(file).suffix[1:]}.yaml")
    return elsewhere


@pytest.mark.usefixtures("folder")
def test_a_description_is_written_and_reads_back(capsys: Capture) -> None:
    run(capsys, "import arm.urdf -o arm.yaml")
    assert Path("arm.yaml").read_text().startswith("name: two_joint_arm\n")
    notes: list[str] = []
    described = loading.load("arm.yaml", note=notes.append)
    assert notes == [], "nothing that may change numbers"
    assert described.account == import_arm("arm.urdf").robot.account
    assert described.links[1].name == "two"
    counts = [run_json(capsys, f"flops arm.{end}") for end in ("urdf", "yaml")]
    assert len({(count["mul"], count["add"]) for count in counts}) == 1


@pytest.mark.usefixtures("folder")
def test_json_has_everything(capsys: Capture) -> None:
    data = run_json(capsys, "import arm.urdf --lock two=pi/2")
    assert (data["joints"], data["path"]) == (["one"], None)
    assert data["unused"] == [{"what": "visual geometry", "file": "arm.urdf", "lines": [3]}]
    assert data["remarks"] == ["locked, and lumped into the links that carry them: two at 1.5708"]


@pytest.mark.thorough
@pytest.mark.usefixtures("folder")
def test_results_of_a_file_in_another_format_are_descriptions(capsys: Capture) -> None:
    """What identify and diagnose write, and what simulate takes the hash of, is the YAML that is imported."""
    for seed, log in (("1", "a.csv"), ("2", "b.csv")):
        run(capsys, f"simulate arm.urdf --excite --duration 5 --seed {seed} --torque-noise 0.01 -o {log}")
    run(capsys, "identify arm.urdf a.csv -o own")
    assert load("own/identified.yaml", warn=lambda _: None).n == 2
    run(capsys, "diagnose arm.urdf a.csv --validate b.csv -o lacks")
    text = Path("lacks/model.yaml").read_text()
    assert 'imported:\n  file: "arm.urdf"\n  format: "URDF"\n' in text
    assert load("lacks/model.yaml", warn=lambda _: None).links[1].name == "two"


# --- arguments of xacro -----------------------------------------------------------------------------------


def test_arguments_reach_every_reading_of_the_file(xacro: Path, capsys: Capture) -> None:
    write(xacro, {"five/arm.xacro": XACRO["arm/arm.xacro"].replace('default="1"', 'default="5"')})
    words = ("diff arm/arm.xacro five/arm.xacro --ignore names --arg", "find more=arm")
    assert "mass" in run(capsys, *words, code=1)[0]
    run(capsys, *words, "--arg", "m=3")


def test_a_package_and_a_variable_are_stated(xacro: Path, capsys: Capture) -> None:
    words = ("import arm/arm.xacro --arg", "find more=far")
    assert "mass: 7" in run(capsys, *words, "--arg", "env MASS=7")[0]
    assert "MASS is not read; state it: --arg 'env MASS=VALUE'" in run(capsys, *words, code=2)[1]
    # Nobody who proposes a robodyn.toml opens folders or variables by it.
    (xacro / "robodyn.toml").write_text('[robots.arm]\nrobot = "arm/arm.xacro"\narg = ["find more=/"]\n')
    assert "arg" in run(capsys, "build --check", code=2)[1]


def test_no_command_runs_what_a_file_says(xacro: Path, capsys: Capture) -> None:
    text = "python['vars'](python['type'](xacro.load_yaml))['__globals__']"
    (xacro / "bad.xacro").write_text(f'{HEAD}<link name="${{{text}}}"/></robot>')
    (xacro / "robodyn.toml").write_text('[robots.bad]\nrobot = "bad.xacro"\n')
    files = sorted(xacro.rglob("*"))
    for command in ("gen bad.xacro", "flops bad.xacro", "import bad.xacro", "build --check"):
        assert "name 'vars' is not defined" in run(capsys, command, code=2)[1]
    assert sorted(xacro.rglob("*")) == files


# --- verify --against, and diff ---------------------------------------------------------------------------

QUICK = "--states 20 --optimize fast"


@pytest.mark.usefixtures("originals")
@pytest.mark.parametrize(
    ("file", "library"),
    [("arm.xml", "MuJoCo"), pytest.param("arm.urdf", "Pinocchio", marks=pytest.mark.thorough)],
)
def test_an_imported_arm_is_its_file(file: str, library: str, capsys: Capture) -> None:
    report = run_json(capsys, f"verify {Path(file).suffix[1:]}.yaml --against {file} {QUICK}")
    rows = [row for row in report["comparisons"] if row["against"].startswith(library)]
    functions = {row["function"] for row in rows}
    assert functions >= {
        "inverse_dynamics", "mass_matrix", "forward_dynamics", "motion of links", "tool frame",
    }  # fmt: skip
    title = f"{library} {require_module(library.lower()).__version__} reading {file}"
    assert {row["against"] for row in rows} - {title} == {f"{title}, {'site ' * (file == 'arm.xml')}tool"}
    assert ("gear ratios" in functions) == (file == "arm.xml")
    assert ("gravity" in report["skipped"]) == (file == "arm.urdf")


def test_a_wrong_number_is_exit_code_1_and_the_joint_is_named(
    originals: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    (originals / "arm.xml").write_text(MJCF.replace('damping="0.4"', 'damping="0.5"'))
    out, err = run(capsys, f"verify xml.yaml --against arm.xml {QUICK}", code=1)
    failed = [line for line in out.splitlines() if line.endswith("FAILED")]
    assert {line.split()[0] for line in failed} == {"inverse_dynamics", "bias", "forward_dynamics"}
    assert "most at joint 2 (j); 2 more rows differ" in err
    monkeypatch.setitem(sys.modules, "pinocchio", None)
    out, err = run(capsys, f"verify urdf.yaml --against arm.urdf {QUICK}", code=3)
    assert out == ""
    assert "need pin, which is not installed; pip install pin" in err


def test_the_file_itself_and_xacro(xacro: Path, capsys: Capture) -> None:
    (xacro / "two.urdf.xacro").write_text(TWO_LINKS)
    out, _ = run(capsys, f"verify two.urdf.xacro --against two.urdf.xacro {QUICK}")
    assert "reading two.urdf.xacro, expanded by xacro" in out


def test_differences_as_json(capsys: Capture) -> None:
    data = run_json(capsys, "diff ur5 ur10 --tolerance 0.5", code=1)
    assert (data["robots"], data["same"], data["operations"]) == (["ur5", "ur10"], False, [185, 185])
    assert data["torques"]["share"] > 0
    assert len(data["torques"]["joints"]) == 6
    assert data["tool"]["distance"] > 0
    assert data["differences"][0] == {
        "group": "names", "where": None, "what": "name of the robot", "left": "ur5", "right": "ur10",
        "by": None, "unit": "",
    }  # fmt: skip
