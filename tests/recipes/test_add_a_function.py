"""The recipe "Add a function" of CONTRIBUTING.md, carried out in a copy of the package: a power."""

from __future__ import annotations

import json
import textwrap

import numpy as np
import pytest

from recipes.copies import Copy, source_in_recipe
from robodyn.robot import load, read_text
from robodyn.verify import Reference
from robodyn_testing import require_tool

FILE = "codegen/robodyn/dynamics/functions/accelerating_power.py"

#: Drives with all that the rigid arm does not have: losses, memory, a motor that drives two joints, a name.
LOADED = """\
name: loaded
links:
  - joint: revolute
    mass: m_1
    com: [0.1, 0, 0.1]
    inertia: {xx: 0.1, yy: 0.1, zz: 0.12}
    motor_inertia: 0.3
    effects:
      - {effect: transmission_loss, breakaway: 0.2, efficiency: 0.8}
      - {effect: motor_coupling, with: 2, ratio: 0.5, inertia: 0.2}
  - joint: revolute
    alpha: pi/2
    a: 0.3
    mass: 2
    com: [0.1, 0.02, 0.1]
    inertia: {xx: 0.1, yy: 0.1, zz: 0.12}
    friction: {viscous: 1.2, coulomb: 3}
    effects:
      - {effect: load_dependent_friction, bearing: journal, mu: 0.1, radius: 0.02, span: 0.1}
  - joint: prismatic
    alpha: pi/2
    mass: 2
    effects:
      - {effect: presliding_hysteresis, level: 1.0, stiffness: 100.0}
"""

#: What runs in the copy: the command line in one process, which compiles the copy's sources once.
COMMANDS = """\
import contextlib, io, json, sys
from robodyn_cli.main import main

def cli(*arguments):
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = main(list(arguments))
    return {"code": code, "out": out.getvalue(), "err": err.getvalue()}
"""


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Copy:
    folder = tmp_path_factory.mktemp("function")
    made = Copy(folder / "copy", {FILE: source_in_recipe("Add a function", FILE)})
    (made.work / "loaded.yaml").write_text(LOADED, encoding="utf-8")
    return made


def answers(copy: Copy, *commands: str) -> list[dict[str, object]]:
    """What the commands say and end with, in one process."""
    script = COMMANDS + f"print(json.dumps([cli(*c.split()) for c in {list(commands)!r}]))"
    answered: list[dict[str, object]] = json.loads(copy.python("-c", script).splitlines()[-1])
    return answered


def test_the_kernels_give_the_product(copy: Copy) -> None:
    """C and Fortran, one state, many, a batch, in Python: ``qd^T M qdd`` with the reference's ``M``."""
    require_tool("gfortran")
    script = textwrap.dedent("""
        import json, sys, warnings
        import numpy as np, robodyn
        warnings.simplefilter("ignore")
        told = {}
        for name in ("puma560", "stanford", "tx40", "loaded.yaml"):
            robot = robodyn.load(name)
            params = {"m_1": 1.5} if robot.parameters else None
            random = np.random.default_rng(7)
            q, qd, qdd = random.uniform(-2, 2, (3, 40, robot.n))
            made = {"functions": ["accelerating_power"], "trig": "builtin", "cache": "cache", "mode": "abi"}
            c = robodyn.compile(robot, **made)
            power = c.accelerating_power(q, qd, qdd, params=params)
            told[name] = power.tolist()
            one = c.accelerating_power(q[3], qd[3], qdd[3], params=params)
            assert one.shape == () and one == power[3]
            work = c.workspace("accelerating_power", params)
            work.q, work.qd, work.qdd = q[3], qd[3], qdd[3]
            work()
            assert work.power == one
            if name in ("stanford", "loaded.yaml"):
                fortran = robodyn.compile(robot, language="fortran", **made)
                assert np.array_equal(power, fortran.accelerating_power(q, qd, qdd, params=params))
                batch = c.batch(q, qd, qdd, function="accelerating_power", params=params)
                assert np.array_equal(power, batch)
        assert "power: [] or [N], double; power, W" in c.accelerating_power.__doc__
        print(json.dumps(told))
    """)
    told = json.loads(copy.python("-c", script).splitlines()[-1])
    for name, powers in told.items():
        robot = read_text(LOADED) if name == "loaded.yaml" else load(name, warn=lambda _: None)
        q, qd, qdd = np.random.default_rng(7).uniform(-2, 2, (3, 40, robot.n))
        matrix = Reference(robot, {"m_1": 1.5} if robot.parameters else None).mass_matrix(q)
        expected = np.einsum("ki,kij,kj->k", qd, matrix, qdd)
        np.testing.assert_allclose(powers, expected, rtol=1e-12, atol=1e-12 * abs(expected).max())


def test_the_commands_know_it(copy: Copy) -> None:
    usual, written, flops, functions, unknown, unfit, plan, threads = answers(
        copy,
        "gen puma560_3dof -o usual",
        "gen puma560_3dof --functions gravity,accelerating_power --batch -o written --json",
        "flops stanford --functions accelerating_power --json",
        "functions",
        "flops puma560 --functions accelerating",
        "gen puma560 --functions accelerating_power --prune 1%",
        "plan puma560_3dof --functions accelerating_power --deadline 1ms --target x86-64",
        "schedule puma560_3dof -p 2 --cut 3 --functions accelerating_power -o threads",
    )
    assert [a["code"] for a in (usual, written, flops, functions, plan, threads)] == [0] * 6, written
    assert "accelerating" not in (copy.work / "usual" / "puma560_3dof.h").read_text()
    header = (copy.work / "written" / "puma560_3dof.h").read_text()
    assert "/* power that the accelerations take\n" in header
    assert "power power [W]" in header
    assert "puma560_3dof_real power[1])" in header
    assert (
        "puma560_3dof_accelerating_power_batch("
        in (copy.work / "written" / "puma560_3dof_batch.h").read_text()
    )
    counted = json.loads(str(flops["out"]))
    assert (counted["function"], counted["thesis"]) == ("accelerating_power", None)
    assert counted["total"] == counted["mul"] + counted["add"] > 50
    listed = " ".join(str(functions["out"]).split())
    assert "accelerating_power: power that the accelerations take (on request)" in listed
    assert unknown["code"] == unfit["code"] == 2
    assert "did you mean 'accelerating_power'?" in str(unknown["err"])
    assert "accelerating_power cannot be pruned; expected one of inverse_dynamics, gravity, bias" in str(
        unfit["err"]
    )
    assert "robodyn gen puma560_3dof --functions accelerating_power" in str(plan["out"])
    assert "out[0] = " in (copy.work / "threads" / "puma560_3dof_parallel.c").read_text()


@pytest.mark.parametrize("robot", [pytest.param("stanford", marks=pytest.mark.thorough), "loaded.yaml"])
def test_it_is_verified(copy: Copy, robot: str) -> None:
    (found,) = answers(copy, f"verify {robot} --functions accelerating_power,gravity --states 30 --json")
    report = json.loads(str(found["out"]))
    assert (found["code"], report["passed"]) == (0, True)
    powers = [c for c in report["comparisons"] if c["function"] == "accelerating_power"]
    against = ["reference"] if robot == "loaded.yaml" else ["reference", "exact"]
    assert [c["against"] for c in powers] == against
    assert all(c["joint"] is None and c["passed"] and c["error"] < 1e-14 for c in powers)
    assert report["equal_on_fractions"].get("accelerating_power") == (
        None if robot == "loaded.yaml" else True
    )


def test_the_record_must_be_whole() -> None:
    """A record that nothing could check, and one that takes another's name, end where they are read."""
    import dataclasses

    from robodyn.dynamics.functions import FUNCTIONS, registered

    gravity = FUNCTIONS["gravity"]
    with pytest.raises(ValueError, match="'gravity': nothing says what is right"):
        dataclasses.replace(gravity, expected=None)
    with pytest.raises(ValueError, match=r"other arguments called .*p"):
        dataclasses.replace(gravity, results=(gravity.results[0]._replace(name="p"),))
    with pytest.raises(ValueError, match="two functions are called 'gravity'"):
        registered([gravity, gravity])
    with pytest.raises(ValueError, match="'more': no such parts: bias"):
        registered([dataclasses.replace(gravity, name="more", parts=("bias",))])
    other = gravity.results[0]._replace(unit="kg m^2/s^2")
    with pytest.raises(ValueError, match="the array 'tau' is 'joint torques"):
        registered([dataclasses.replace(gravity, name="more", results=(other,))])
