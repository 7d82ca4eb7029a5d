"""``robodyn bench``: nanoseconds and instructions a call, beside the peers that are installed.

The kernels, and the C of CasADi if it is installed, are timed in one compiled program; calls from Python in
this process. Only what gives the same torques as the plain textbook is timed.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.bench.peers.calls import PEERS, Call, States, casadi_function, checked, own_calls, raced
from robodyn.bench.peers.numbers import Disagreement, NumbersLacking, hold_against, numbers_of
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
from robodyn.verify.reference import Reference

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
            "kernels": list(map(asdict, self.native)),
            "python": list(map(asdict, self.python)),
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
    flags, interface = " ".join(C_FLAGS), signature(robot, "inverse_dynamics")
    if interface.parameters or interface.states:
        why = "run-time parameters" if interface.parameters else "effects with a state"
        return KernelBench(flags, (), (), {"calls beside peers": f"{robot.name} has {why}"})
    try:
        numbers_of(robot)
        absent = {
            peer.distribution: f"not installed ({peer.install})"
            for peer in _PEERS.values()
            if not peer.present()
        }
    except NumbersLacking as lacking:
        absent = {peer.distribution: str(lacking) for peer in _PEERS.values()}
    random = np.random.default_rng(7)
    q, qd, qdd = (random.uniform(-limit, limit, (_COUNT, robot.n)) for limit in (np.pi, 3.0, 10.0))
    states = (q, qd, qdd)
    wanted = np.asarray(Reference(robot).inverse_dynamics(*states), dtype=np.float64)
    tell("kernels in C")
    native = _native(robot, options, states, wanted, cc, absent)
    tell("calls from Python")
    calls = own_calls(robot, states, cc=cc)
    for call in calls:
        checked(call, wanted)
    for module, peer in _PEERS.items():
        if peer.distribution in absent:
            continue
        try:
            call = PEERS[module](robot, states)
            checked(call, wanted)
            calls.append(call)
        except (Disagreement, ImportError, RuntimeError, ValueError) as error:
            absent[peer.distribution] = str(error)
    return KernelBench(flags, native, _timed(calls, raced(calls, 30, 5e-4), {}), absent)


def _timed(ways: Sequence[Call | _Runner], times: Floats, counted: Mapping[str, float]) -> tuple[Timed, ...]:
    """What each of ``ways`` takes, of nanoseconds ``times`` [rounds, ways]."""
    median, ratio = np.median(times, axis=0), np.median(times / times[:, :1], axis=0)
    return tuple(
        Timed(way.key, way.title, float(median[k]), float(ratio[k]), counted.get(way.key))
        for k, way in enumerate(ways)
    )


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
    states: States,
    wanted: Floats,
    cc: str | None,
    absent: dict[str, str],
) -> tuple[Timed, ...]:
    layout = given_layout([program(robot, "inverse_dynamics", options)])
    runners = [_own(robot, options, trig) for trig in _TITLES if trig != "given" or layout]
    if CASADI.distribution not in absent:
        runners.append(_of_casadi(robot))
    arrays = dict(zip(("q", "qd", "qdd"), states, strict=True))
    if layout:
        arrays["sc"] = _trig_inputs(layout, states[0])
    with built(_files(runners, arrays, robot.n), cc=cc, flags=C_FLAGS) as path:
        torques = np.array(_output_of([str(path)]).split(), dtype=np.float64)
        for runner, tau in zip(runners, torques.reshape(len(runners), *wanted.shape), strict=True):
            hold_against(runner.title, wanted, tau)
        times = np.array([line.split() for line in _output_of([str(path), "200", "10"]).splitlines()], float)
        return _timed(runners, times, _instructions(path, [runner.key for runner in runners], absent))


def _own(robot: Robot, options: Options, trig: str) -> _Runner:
    own = replace(options, functions=("inverse_dynamics",), trig=trig, scalar="double")  # type: ignore[arg-type]
    files = generate(robot, own).files(("c",))
    name, symbol = robot.name, f"{robot.name}_inverse_dynamics"
    text = files[f"{name}.c"].replace(f'#include "{name}.h"', files[f"{name}.h"])
    first = "sc" if trig == "given" else "q"
    return _Runner(
        trig,
        f"robodyn, {'' if trig == 'builtin' else 'sine and cosine '}{_TITLES[trig]}",
        f"#define {symbol} kernel_{trig}\n{text}",
        f"void kernel_{trig}(const double *, const double *, const double *, double *);",
        f"kernel_{trig}({first}[k], qd[k], qdd[k], tau[k]);",
    )


def _of_casadi(robot: Robot) -> _Runner:
    import casadi

    writer = casadi.CodeGenerator("casadi_kernel.c")
    writer.add(casadi_function(robot, "casadi_kernel"))
    return _Runner(
        "casadi",
        f"CasADi {casadi.__version__}, C of the textbook",
        writer.dump(),
        "int casadi_kernel(const double **, double **, long long *, double *, int);",
        "const double *arg[3] = {q[k], qd[k], qdd[k]}; double *res[1] = {tau[k]}; "
        "static double work[65536]; casadi_kernel(arg, res, 0, work, 0);",
    )


def _files(runners: Sequence[_Runner], arrays: Mapping[str, Floats], joints: int) -> dict[str, str]:
    spelled = {name: [", ".join(map(repr, x)) for x in values.tolist()] for name, values in arrays.items()}
    sizes = {name: values.shape[1] for name, values in arrays.items()}
    template = environment().get_template("c/race.c.j2")
    main = template.render(count=_COUNT, joints=joints, runners=runners, arrays=spelled, sizes=sizes)
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
