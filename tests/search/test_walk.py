"""The walk: whatever it does, the program computes what it did, costs no more and rounds no worse."""

from __future__ import annotations

import gc
import itertools
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from records.made import ELBOW, arm, fast, recorded
from robodyn import InputError
from robodyn.counts import count
from robodyn.counts.objective import operations_of
from robodyn.dynamics.equality import equals_recursion
from robodyn.dynamics.functions import by_default, function_named
from robodyn.ir import Input, Operation, Program
from robodyn.ir.evaluate import evaluate
from robodyn.ir.fingerprint import fingerprint
from robodyn.optimize.records import parse_record
from robodyn.optimize.records.record import labelled
from robodyn.passes import SPELLING, run
from robodyn.robot import Robot
from robodyn.robot.values import circle_point
from robodyn.search.network import NoWalk
from robodyn.search.walk import CHAIN, FUSED, SUM, TOLERANCE, Walk
from robodyn_testing import representative, require_module, sampled
from robodyn_testing.random_robots import random_states
from search.arms import SPECIAL, bundled, random_arms

KINDS = {SUM: (1, 1), FUSED: (1, 1), CHAIN: (1, 1)}


def own_cost(made: Program, objective: int, weights: tuple[int, int] = (1, 1)) -> int:
    """The cost as the walk has it, counted apart from it; angles, sines and what else it leaves alone stay
    out: they are the same before and after."""
    found = operations_of(made)
    add, mul = weights
    total = add * found.counts.get("add", 0) + mul * found.counts.get("mul", 0)
    if objective == FUSED:
        return total - found.fused * mul
    if objective == CHAIN:
        return found.depth * 4 * add + total
    return total


def check(robot: Robot, function: str, steps: int, *, temperature: float = 0.25, **how: Any) -> None:
    """Walk, and hold what is found to everything that is promised."""
    plain = fast(robot, function)
    walk = Walk([plain], **{"seed": 1, **how})
    objective, weights = how.get("objective", SUM), how.get("weights", (1, 1))
    before = walk.run(0, temperature)
    after = walk.run(steps, temperature)
    made = walk.best()
    assert after <= before
    assert walk.counts["steps"] == steps
    assert walk.counts["false"] == 0
    assert walk.error <= TOLERANCE
    seeds = (21, 22)
    assert [fingerprint(made, s, circle_point) for s in seeds] == [
        fingerprint(plain, s, circle_point) for s in seeds
    ]
    if robot.rest_velocity is None:
        assert equals_recursion(robot, function, made, points=1)
    if not function_named(function).solves:  # what is divided by is an operand that no walk looks into
        saved = own_cost(plain, objective, weights) - own_cost(made, objective, weights)
        assert saved >= (before - after if objective == SUM else 0), "no folding makes it more again"
    spelled = run(made, SPELLING)
    assert count(spelled).total == operations_of(made).total
    named = labelled(spelled, plain)
    assert [op[:2] for op in named.operations] == [op[:2] for op in spelled.operations]
    record = recorded(robot, named, function)
    assert parse_record(record.text(), "").program.operations == named.operations


@pytest.mark.parametrize(
    "name", representative(["puma560", "stanford_d3", "tx40", "ur10"], "stanford_d3", "ur10")
)
def test_bundled_robots(name: str) -> None:
    check(bundled(name), "inverse_dynamics", 100)


@pytest.mark.parametrize("robot", random_arms(6, joints=4), ids=lambda robot: robot.name)
def test_random_arms(robot: Robot) -> None:
    for k, function in enumerate(("inverse_dynamics", "mass_matrix", "gravity")):
        try:
            check(robot, function, 400, seed=k + 3, temperature=(0.2, 0.35, 1.0)[k])
        except NoWalk as nothing:
            assert "nothing to rewrite" in str(nothing)  # noqa: PT017


@pytest.mark.parametrize(("objective", "temperature"), [*itertools.product(KINDS, (0.25, 3.0)), (SUM, 0.0)])
def test_objectives_and_temperatures(objective: int, temperature: float) -> None:
    robot, seed = arm(ELBOW), (1 << 63) + 5
    check(robot, "inverse_dynamics", 500, temperature=temperature, objective=objective, seed=seed)
    for weights in ((1, 3), (4, 7), (1, 0), (0, 1)) if objective == SUM else ():
        check(robot, "bias", 300, weights=weights, temperature=temperature * max(weights))


@pytest.mark.parametrize("name", sampled(SPECIAL, every=3))
def test_special_arms(name: str) -> None:
    for function in by_default():
        try:
            check(SPECIAL[name], function, 300)
        except NoWalk as nothing:
            assert "nothing to rewrite" in str(nothing)  # noqa: PT017
        except InputError as error:
            assert "has no forward dynamics" in str(error)  # noqa: PT017


@pytest.mark.parametrize("objective", KINDS)
def test_the_cost_is_that_of_the_program(objective: int) -> None:
    for name in ("stanford_3dof_d3", "puma560_3dof_d3"):
        plain = fast(bundled(name))
        walk = Walk([plain], seed=2, objective=objective)
        costs = [walk.run(steps, 0.25) for steps in (0, 500, 500)]
        assert costs == sorted(costs, reverse=True)
        angles = own_cost(plain, objective) - costs[0]  # sums of joint angles stay as they are
        assert angles in (0, 1)
        assert own_cost(walk.best(), objective) == costs[-1] + angles


def test_the_same_seed_takes_the_same_way() -> None:
    plain = fast(arm(ELBOW))

    def walked(seed: int, *chunks: int) -> Program:
        walk = Walk([plain], seed=seed)
        for chunk in chunks:
            walk.run(chunk, 0.3)
        return walk.best()

    once = walked(5, 600)
    assert own_cost(once, SUM) < own_cost(plain, SUM)
    assert once == walked(5, 600) == walked(5, 100, 250, 250)
    assert len({walked(seed, 600).operations for seed in (5, 6, 7)}) > 1


def test_rounding_stays_bounded() -> None:
    """Out at high temperature a walk subtracts what it has added: the tolerance holds it back."""
    plain = fast(bundled("puma560_3dof_d3"))

    def errors(tolerance: float) -> tuple[float, int]:
        walk = Walk([plain], seed=3, tolerance=tolerance)
        worst = 0.0
        for _ in range(200):
            walk.run(25, 3.0)
            worst = max(worst, walk.error)
        return worst, walk.counts["refused"]

    worst, refused = errors(TOLERANCE)
    assert worst <= TOLERANCE
    assert refused > 0
    assert errors(1.0)[0] > TOLERANCE, "nothing to be held back from: the test shows nothing"


@pytest.mark.parametrize("name", ["stanford_3dof_d3", "ur5"])
def test_single_precision_is_near_the_truth(name: str) -> None:
    """Apart from the walk's own bookkeeping, and at other states."""
    robot = bundled(name)
    plain = fast(robot)
    walk = Walk([plain], seed=8)
    walk.run(1500, 0.35)
    made = walk.best()
    q, qd, qdd = random_states(robot, 50, seed=1)
    state = {Input(a, i): x[:, i] for a, x in (("q", q), ("qd", qd), ("qdd", qdd)) for i in range(robot.n)}
    functions = {"sin": np.sin, "cos": np.cos, "sign": np.sign}
    truth = np.array(
        [x + 0 * q[:, 0] for x in evaluate(plain, state, functions=functions)["tau"]], dtype=np.float64
    )
    single = {key: np.float32(x) for key, x in state.items()}
    found = evaluate(made, single, constant=lambda x: np.float32(float(x)), functions=functions)["tau"]
    off = np.abs(np.array([x + 0 * single[Input("q", 0)] for x in found], dtype=np.float64) - truth)
    assert off.max() <= 10 * TOLERANCE * np.abs(truth).max()


def test_nothing_or_too_much_to_rewrite() -> None:
    x = Input("qd", 0)
    for outputs in ((), (x,), (Fraction(3), x), (Fraction(0),)):
        with pytest.raises(NoWalk, match="nothing to rewrite"):
            Walk([Program((), (("tau", outputs),))], seed=1)
    sine = Program((Operation("sin", (Input("q", 0),)),), (("tau", (0, 0)),))
    with pytest.raises(NoWalk, match="nothing to rewrite"):
        Walk([sine], seed=1)
    operations = [Operation("mul", (x, Input("q", 0)))]
    operations += [Operation("add", (k, Fraction(k + 1, 7))) for k in range(2500)]
    many = [Operation("mul", (x, Fraction(k + 2))) for k in range(300)]
    for large in (
        Program(tuple(operations), (("tau", (2500,)),)), Program(tuple(many), (("M", tuple(range(300))),)),
    ):  # fmt: skip
        with pytest.raises(NoWalk, match="too large"):
            Walk([large], seed=1)


def test_walks_run_side_by_side() -> None:
    """C code runs without the interpreter's lock, and walks share nothing."""
    plain = fast(bundled("stanford_3dof_d3"))

    def walked(seed: int) -> Program:
        walk = Walk([plain], seed=seed)
        walk.run(1500, 0.3)
        return walk.best()

    with ThreadPoolExecutor(4) as threads:
        assert list(threads.map(walked, range(4))) == list(map(walked, range(4)))


ENDLESS = """
import os, threading, time
from robodyn.search.walk import Walk
from records.made import ELBOW, arm, fast
walk = Walk([fast(arm(ELBOW))], seed=1)
walk.run(1, 0.3)
walking = threading.Event()

def run_on():
    walking.set()
    walk.run(1 << 60, 0.3)  # centuries, in one call into C

threading.Thread(target=run_on, daemon=True).start()
walking.wait()
for _ in range(20):
    time.sleep(0.01)
print("still here", flush=True)
os._exit(0)
"""


def test_a_walk_lets_other_threads_work() -> None:
    """A call into C that kept the interpreter's lock would not let the others on before it has ended."""
    path = os.pathsep.join(path for path in sys.path if path)
    done = subprocess.run(
        [sys.executable, "-c", ENDLESS],
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert (done.stdout, done.stderr) == ("still here\n", "")


@pytest.mark.thorough
def test_a_walk_gives_its_room_back() -> None:
    resource = require_module("resource")
    plain = fast(bundled("stanford_3dof"))

    def used() -> int:
        for _ in range(8):
            Walk([plain], seed=1).run(10, 0.2)
        gc.collect()
        return int(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)

    first = used()
    used()
    last = used()
    assert last - first < 40_000, "kB; a walk takes 10,000"
