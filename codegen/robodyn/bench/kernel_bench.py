"""``robodyn bench``: nanoseconds and instructions a call, beside the peers that are installed.

The kernels, and the C of CasADi if it is installed, are timed in one compiled program; calls from Python in
this process. Only what gives the same torques as the plain textbook is timed.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np

from robodyn.bench.peers.agreement import Disagreement, hold_against
from robodyn.bench.peers.calls import PEERS, States, checked, own_calls, raced
from robodyn.bench.peers.models import casadi_function
from robodyn.bench.peers.numbers import Floats, Numbers, NumbersLacking, numbers_of
from robodyn.emit.render import environment
from robodyn.errors import CheckError, ToolError
from robodyn.kernels.generate import Options, generate, program
from robodyn.optimize.programs import signature
from robodyn.passes.trig_given import AngleInput, given_layout
from robodyn.robot.model import Robot
from robodyn.toolchain.compiler import C_FLAGS
from robodyn.toolchain.program import built
from robodyn.toolchain.running import run
from robodyn.tools.libraries import CASADI, MUJOCO, PINOCCHIO
from robodyn.tools.programs import VALGRIND

_COUNT: Final = 64
_TITLES: Final = {"builtin": "built-in sine and cosine", "libm": "libm's", "given": "given by the caller"}
#: What each peer is called by those who look for it.
_PEERS: Final = {peer.module: peer for peer in (PINOCCHIO, MUJOCO, CASADI)}


@dataclass(frozen=True, slots=True)
class Timed:
    """A kernel or a call: median nanoseconds a state, the median of the ratios to the first of its kind in
    the same round, and instructions (None: not measured)."""

    key: str
    title: str
    ns: float
    ratio: float
    instructions: float | None = None

    def to_dict(self) -> dict[str, Any]:
        """As ``bench --json`` prints it."""
        return {k: getattr(self, k) for k in ("key", "title", "ns", "ratio", "instructions")}


@dataclass(frozen=True, slots=True)
class KernelBench:
    """One state after another in C, calls from Python, and what was not measured and why."""

    flags: str
    native: tuple[Timed, ...]
    python: tuple[Timed, ...]
    absent: Mapping[str, str]

    def to_dict(self) -> dict[str, Any]:
        """As ``bench --json`` prints it."""
        return {
            "flags": self.flags,
            "kernels": [row.to_dict() for row in self.native],
            "python": [row.to_dict() for row in self.python],
            "not_measured": dict(self.absent),
        }


def kernel_bench(
    robot: Robot, options: Options, *, cc: str | None = None, tell: Callable[[str], None] = lambda _: None
) -> KernelBench:
    """Measure the inverse dynamics of ``robot``.

    Raises
    ------
    ToolError: no compiler.
    CheckError: a kernel of ours does not give the textbook's torques.
    """
    interface = signature(robot, "inverse_dynamics")
    if interface.parameters or interface.states:
        why = "run-time parameters" if interface.parameters else "effects with a state"
        return KernelBench(" ".join(C_FLAGS), (), (), {"calls beside peers": f"{robot.name} has {why}"})
    absent: dict[str, str] = {}
    arm: Numbers | None = None
    try:
        arm = numbers_of(robot)
    except NumbersLacking as lacking:
        absent |= dict.fromkeys((peer.distribution for peer in _PEERS.values()), str(lacking))
    here = []
    for module, peer in _PEERS.items() if arm is not None else ():
        if peer.present():
            here.append(module)
        else:
            absent[peer.distribution] = f"not installed ({peer.install})"
    states = _states(robot)
    wanted = _reference(robot, states)
    tell("kernels in C")
    native = _native(robot, options, arm if "casadi" in here else None, states, wanted, cc, absent)
    tell("calls from Python")
    python = _python(robot, arm, states, wanted, here, cc, absent)
    return KernelBench(" ".join(C_FLAGS), native, python, absent)


def _states(robot: Robot) -> States:
    random = np.random.default_rng(7)
    q, qd, qdd = (random.uniform(-limit, limit, (_COUNT, robot.n)) for limit in (np.pi, 3.0, 10.0))
    return q, qd, qdd


def _reference(robot: Robot, states: States) -> Floats:
    from robodyn.verify.reference import Reference

    return np.asarray(Reference(robot).inverse_dynamics(*states), dtype=np.float64)


# --- in C ---------------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Runner:
    """A function in the program: its source, how it is declared, and how it is called on state k."""

    key: str
    title: str
    source: str
    declared: str
    called: str


def _native(
    robot: Robot,
    options: Options,
    arm: Numbers | None,
    states: States,
    wanted: Floats,
    cc: str | None,
    absent: dict[str, str],
) -> tuple[Timed, ...]:
    layout = given_layout([program(robot, "inverse_dynamics", options)])
    runners = [_own(robot, options, trig) for trig in _TITLES if trig != "given" or layout]
    if arm is not None:
        runners.append(_of_casadi(arm))
    arrays = dict(zip(("q", "qd", "qdd"), states, strict=True))
    if layout:
        arrays["sc"] = _trig_inputs(layout, states[0])
    with built(_files(runners, arrays, robot.n), cc=cc, flags=C_FLAGS) as path:
        torques = np.array([float(x) for x in _output_of([str(path)]).split()])
        for runner, tau in zip(runners, torques.reshape(len(runners), *wanted.shape), strict=True):
            hold_against(runner.title, wanted, tau)
        lines = _output_of([str(path), "200", "10"]).splitlines()
        counted = _instructions(path, [runner.key for runner in runners], absent)
    times = np.array([[float(x) for x in line.split()] for line in lines])
    ratios = np.median(times / times[:, :1], axis=0)
    return tuple(
        Timed(r.key, r.title, float(np.median(times[:, k])), float(ratios[k]), counted.get(r.key))
        for k, r in enumerate(runners)
    )


def _own(robot: Robot, options: Options, trig: str) -> _Runner:
    import dataclasses

    wanted = dataclasses.replace(options, functions=("inverse_dynamics",), trig=trig, scalar="double")  # type: ignore[arg-type]
    files = generate(robot, wanted).files(("c",))
    name, symbol = robot.name, f"{robot.name}_inverse_dynamics"
    text = files[f"{name}.c"].replace(f'#include "{name}.h"', files[f"{name}.h"])
    first = "sc" if trig == "given" else "q"
    return _Runner(
        trig,
        f"robodyn, sine and cosine {_TITLES[trig]}" if trig != "builtin" else f"robodyn, {_TITLES[trig]}",
        f"#define {symbol} kernel_{trig}\n{text}",
        f"void kernel_{trig}(const double *, const double *, const double *, double *);",
        f"kernel_{trig}({first}[k], qd[k], qdd[k], tau[k]);",
    )


def _of_casadi(arm: Numbers) -> _Runner:
    import casadi

    writer = casadi.CodeGenerator("casadi_kernel.c")
    writer.add(casadi_function(arm, "casadi_kernel"))
    return _Runner(
        "casadi",
        f"CasADi {casadi.__version__}, C of the textbook",
        writer.dump(),
        "int casadi_kernel(const double **, double **, long long *, double *, int);",
        "const double *arg[3] = {q[k], qd[k], qdd[k]}; double *res[1] = {tau[k]}; "
        "static double work[65536]; casadi_kernel(arg, res, 0, work, 0);",
    )


def _files(runners: Sequence[_Runner], arrays: Mapping[str, Floats], joints: int) -> dict[str, str]:
    spelled = [
        {
            "name": name,
            "size": values.shape[1],
            "rows": [", ".join(repr(float(x)) for x in row) for row in values],
        }
        for name, values in arrays.items()
    ]
    context = {"count": _COUNT, "joints": joints, "runners": runners, "arrays": spelled}
    main = environment().get_template("c/race.c.j2").render(context)
    return {"race_main.c": main, **{f"race_{r.key}.c": r.source for r in runners}}


def _trig_inputs(layout: Sequence[AngleInput], q: Floats) -> Floats:
    """Sines and cosines of positions ``q`` [N, n] as the kernel takes them."""
    functions: dict[str, Callable[[Any], Any]] = {"sin": np.sin, "cos": np.cos, "q": lambda x: x}
    columns = []
    for kind, terms, constant in layout:
        angle = float(constant) + sum(float(m) * q[:, x.index] for x, m in terms)
        columns.append(functions[kind](angle))
    return np.array(columns).T


def _output_of(command: Sequence[str]) -> str:
    done = run(command, seconds=120, listen="stdout")
    if done.code:
        raise CheckError("the benchmark in C fails", found=f"exit code {done.code}")
    if done.code is None:
        raise ToolError("the benchmark in C does not finish", expected="120 s at most")
    return done.output


def _instructions(path: Path, keys: Sequence[str], absent: dict[str, str]) -> dict[str, float]:
    """Instructions a call of each kernel, the loop around it included."""
    valgrind = VALGRIND.path()
    if valgrind is None:
        absent["instructions"] = f"needs {VALGRIND.remedy}"
        return {}
    counts: dict[str, float] = {}
    for k, key in enumerate(keys):
        totals = []
        for passes in (1, 3):  # the difference is free of starting and ending
            command = [valgrind, "--tool=callgrind", "--callgrind-out-file=/dev/null", str(path)]
            command += ["0", str(passes), str(k)]
            output = run(command, listen="stderr").output
            total = re.search(r"refs:\s+([\d,]+)", output)
            if total is None:
                absent["instructions"] = f"valgrind fails: {(output.strip().splitlines() or ['?'])[-1]}"
                return {}
            totals.append(int(total[1].replace(",", "")))
        counts[key] = (totals[1] - totals[0]) / (2 * _COUNT)
    return counts


# --- from Python --------------------------------------------------------------------------------------------


def _python(
    robot: Robot,
    arm: Numbers | None,
    states: States,
    wanted: Floats,
    here: Sequence[str],
    cc: str | None,
    absent: dict[str, str],
) -> tuple[Timed, ...]:
    calls = own_calls(robot, states, cc=cc)
    for call in calls:
        checked(call, wanted)
    for module in here:
        assert arm is not None  # else nothing is here
        try:
            call = PEERS[module](arm, states)
            checked(call, wanted)
            calls.append(call)
        except (Disagreement, ImportError, RuntimeError, ValueError) as error:
            absent[_PEERS[module].distribution] = str(error)
    times = raced(calls, 30, 5e-4)
    ratios = np.median(times / times[:, :1], axis=0)
    return tuple(
        Timed(call.key, call.title, float(np.median(times[:, k])), float(ratios[k]))
        for k, call in enumerate(calls)
    )
