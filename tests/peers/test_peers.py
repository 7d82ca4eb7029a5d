"""Compiled kernels against Pinocchio and MuJoCo, on the bundled robots and on 200 random ones.

The measure is the difference as a share of the largest torque of that robot over all states tried (mass
matrices: of their largest entry). Pinocchio takes every robot. MuJoCo's compiler refuses some; those reach it
as :mod:`peers.mujoco_peer` says, and the reasons are printed.

Accelerations are not compared but put back: with x the kernel's, M, b and X a peer's mass matrix, bias and
accelerations, |M x + b - tau| must be at most 1e-10 (|M| |X| + |b| + |tau|), largest entries. A solution by
elimination without cancellation (M is positive definite) makes this residual a small multiple of the rounding
unit whatever the condition of M, which a comparison of x with X would have to allow for. Where M is singular,
or so near it that the residual would say little of x, there is no forward dynamics to test and none is asked
for.
"""

from __future__ import annotations

import functools
import importlib
import importlib.util
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from types import ModuleType
from typing import Any, Final

import numpy as np
import pytest

import robodyn
import robodyn.robot
from peers.numbers import Array
from robodyn.robot.model import Inertia, Link, Robot
from robodyn.robot.values import angle
from robodyn_testing import representative, require_module, sampled
from robodyn_testing.random_robots import States, random_robot, random_states

pytestmark = pytest.mark.filterwarnings("ignore:Please update your 'hppfcl'")  # Pinocchio 3.3, on import

PEERS: Final = ("pinocchio", "mujoco")
STATES: Final = 24
RANDOM_ROBOTS: Final = 200
CHUNK: Final = 10
DOUBLE: Final = 1e-10
FLOAT: Final = 1e-5
WORST_CONDITION: Final = 1e8
"""Of the mass matrix scaled to a unit diagonal; beyond it forward dynamics is not asked for."""

TORQUES: Final = ("inverse_dynamics", "gravity", "bias")
ALL_BUT_FORWARD: Final = (*TORQUES, "mass_matrix")


@dataclass(frozen=True, slots=True)
class Reference:
    """What one peer says of one robot in some states, by kernel function; ``qdd`` where M is regular."""

    peer: str
    states: States
    answers: Mapping[str, Array]
    qdd: Array | None

    @property
    def functions(self) -> tuple[str, ...]:
        """The kernel functions that can be held against this reference."""
        return ALL_BUT_FORWARD if self.qdd is None else (*ALL_BUT_FORWARD, "forward_dynamics")

    def scale(self, function: str) -> float:
        """What differences in ``function`` are shares of."""
        return float(np.abs(self.answers["mass_matrix" if function == "mass_matrix" else TORQUES[0]]).max())


def peer_module(name: str) -> ModuleType:
    """The converter for ``name``; the library must be there."""
    return importlib.import_module(f"peers.{name}_peer")


def reference(peer: str, robot: Robot, states: States) -> Reference:
    """Ask ``peer`` for everything at ``states``."""
    module = peer_module(peer)
    model = getattr(module, f"{peer}_model")(robot)
    q, qd, qdd = states
    M = module.mass_matrix(model, robot, q)
    answers = {
        "inverse_dynamics": module.torques(model, robot, q, qd, qdd),
        "gravity": module.gravity(model, robot, q),
        "bias": module.bias(model, robot, q, qd),
        "mass_matrix": M,
    }
    regular = worst_condition(M) <= WORST_CONDITION
    accelerations = (
        module.forward_dynamics(model, robot, q, qd, answers["inverse_dynamics"]) if regular else None
    )
    return Reference(peer, states, answers, accelerations)


def worst_condition(M: Array) -> float:
    """The largest condition number of the mass matrices [N, n, n], each scaled to a unit diagonal."""
    diagonal = np.einsum("nii->ni", M)
    if not (diagonal > 1e-12 * np.abs(M).max()).all():
        return float("inf")
    root = np.sqrt(diagonal)
    return float(np.linalg.cond(M / root[:, :, None] / root[:, None, :]).max())


@functools.cache
def peers() -> tuple[str, ...]:
    """The peers that are installed, at least one; ``test_peer_is_installed`` complains of any other."""
    found = tuple(name for name in PEERS if importlib.util.find_spec(name))
    return found or (require_module(PEERS[0]).__name__,)


def references(robot: Robot, seed: int = 0) -> list[Reference]:
    """What every installed peer says of ``robot``."""
    states = random_states(robot, STATES, seed)
    return [reference(peer, robot, states) for peer in peers()]


def complaint(what: str, got: Array, expected: Array, scale: float, tolerance: float) -> str | None:
    """None where ``got`` is ``expected`` to ``tolerance * scale``; else what, where and by how much."""
    if got.shape != expected.shape:
        return f"{what}: shape {got.shape}, expected {expected.shape}"
    difference = np.abs(got - expected)
    place = np.unravel_index(int(np.argmax(difference)), difference.shape)  # the first NaN, if any
    if difference[place] <= tolerance * scale:
        return None
    state, *entry = (int(i) for i in place)
    return (
        f"{what}: off by {difference[place] / scale if scale else difference[place]:.2e} of the largest, "
        f"{scale:.6g} (allowed {tolerance:.0e}), in state {state}, entry {[i + 1 for i in entry]}: "
        f"{got[place]!r}, expected {expected[place]!r}"
    )


def complaints(kernel: Any, ref: Reference, functions: Sequence[str], tolerance: float) -> list[str]:
    """Everything in which ``functions`` of ``kernel`` differ from ``ref`` by more than ``tolerance``."""
    q, qd, qdd = ref.states
    calls: dict[str, Callable[[], Array]] = {
        "inverse_dynamics": lambda: kernel.inverse_dynamics(q, qd, qdd),
        "gravity": lambda: kernel.gravity(q),
        "bias": lambda: kernel.bias(q, qd),
        "mass_matrix": lambda: kernel.mass_matrix(q),
    }
    found = [
        complaint(f"{f} by {ref.peer}", calls[f](), ref.answers[f], ref.scale(f), tolerance)
        for f in functions
        if f != "forward_dynamics"
    ]
    if "forward_dynamics" in functions:
        found.append(_residual(kernel, ref, tolerance))
    return [text for text in found if text is not None]


def _residual(kernel: Any, ref: Reference, tolerance: float) -> str | None:
    """Put the kernel's accelerations back into the equation of motion; the module's head has the reasons."""
    q, qd, _ = ref.states
    tau, M, b = (ref.answers[f] for f in ("inverse_dynamics", "mass_matrix", "bias"))
    assert ref.qdd is not None
    x = np.asarray(kernel.forward_dynamics(q, qd, tau))
    if x.shape != tau.shape:
        return f"forward_dynamics: shape {x.shape}, expected {tau.shape}"
    back = (M @ x[..., None])[..., 0] + b
    inertial = (np.abs(M) @ np.abs(ref.qdd)[..., None]).max()
    scale = float(inertial + np.abs(b).max() + np.abs(tau).max())
    return complaint(f"torque of forward_dynamics by {ref.peer}", back, tau, scale, tolerance)


def kernel_of(robot: Robot, functions: Sequence[str], **options: Any) -> Any:
    """Compile ``functions`` of ``robot``, the quick way to load; the options are ``robodyn.compile``'s."""
    return robodyn.compile(robot, functions=tuple(functions), mode="abi", **options)


def check(robot: Robot, refs: Sequence[Reference], functions: Sequence[str], **options: Any) -> list[str]:
    """Compile one kernel and hold it against every reference; complaints name robot and options."""
    wanted = [f for f in functions if all(f in ref.functions for ref in refs)]
    kernel = kernel_of(robot, wanted, **options)
    tolerance = FLOAT if options.get("scalar") == "float" else DOUBLE
    return [
        f"{robot.name} ({robot.n} joints, {options}): {text}"
        for ref in refs
        for text in complaints(kernel, ref, wanted, tolerance)
    ]


@pytest.mark.parametrize("name", PEERS)
def test_peer_is_installed(name: str) -> None:
    require_module(name)


@pytest.mark.parametrize("chunk", range(RANDOM_ROBOTS // (2 * CHUNK)))
def test_peers_agree_with_each_other(chunk: int) -> None:
    """Ten times the accuracy that is asked of kernels, so that a complaint there is the kernel's."""
    for name in PEERS:
        require_module(name)
    found = []
    for seed in range(2 * CHUNK * chunk, 2 * CHUNK * (chunk + 1)):
        one, other = references(random_robot(seed), seed)
        for function in ALL_BUT_FORWARD:
            a, b = one.answers[function], other.answers[function]
            found.append(complaint(f"random_{seed} {function}", a, b, one.scale(function), 1e-12))
    assert [text for text in found if text is not None] == []


@pytest.mark.parametrize("name", representative(robodyn.robot.bundled_names(), "puma560", "stanford", "tx40"))
def test_bundled_robot(name: str) -> None:
    robot = robodyn.robot.load(name, warn=print)
    refs = references(robot)
    found = check(robot, refs, refs[0].functions, scalar="double", regroup=True)
    found += check(robot, refs, refs[0].functions, scalar="double", regroup=False)
    found += check(robot, refs, TORQUES[:1], scalar="double", regroup=True, optimize="none")
    found += check(robot, refs, ALL_BUT_FORWARD, scalar="float", regroup=True)
    if "mujoco" in peers():
        for i, reason in peer_module("mujoco").refusals(robot).items():
            print(f"{name} is not expressible in MJCF: link {i + 1}: {reason}")
    assert found == []


@pytest.mark.parametrize("chunk", sampled(range(RANDOM_ROBOTS // CHUNK), every=10))
def test_random_robots(chunk: int) -> None:
    """Torques of every robot in double and float; by turns the other functions, and without regrouping.

    With little or no optimisation by the compiler, to be quick; ``test_random_robots_in_full`` tries all.
    """
    found = []
    for seed in range(CHUNK * chunk, CHUNK * (chunk + 1)):
        robot = random_robot(seed)
        refs = references(robot, seed)
        functions = refs[0].functions if seed % 4 == 0 else TORQUES[:1]
        found += check(robot, refs, functions, scalar="double", regroup=True, flags=("-O1",))
        found += check(robot, refs, TORQUES[:1], scalar="float", regroup=True, flags=("-O0",))
        if seed % 4 == 2:
            found += check(robot, refs, TORQUES[:1], scalar="double", regroup=False, flags=("-O0",))
    assert found == []


@pytest.mark.slow
@pytest.mark.parametrize("chunk", sampled(range(RANDOM_ROBOTS // CHUNK), every=10))
def test_random_robots_in_full(chunk: int) -> None:
    """Every function of every robot, regrouped and not, optimised as shipped; in float no accelerations."""
    found = []
    for seed in range(CHUNK * chunk, CHUNK * (chunk + 1)):
        robot = random_robot(seed)
        refs = references(robot, seed)
        for regroup in (True, False):
            found += check(robot, refs, refs[0].functions, scalar="double", regroup=regroup)
            found += check(robot, refs, ALL_BUT_FORWARD, scalar="float", regroup=regroup)
    assert found == []


def test_forward_dynamics_is_asked_of_most_random_robots() -> None:
    require_module("pinocchio")
    regular = 0
    for seed in range(RANDOM_ROBOTS):
        robot = random_robot(seed)
        regular += reference("pinocchio", robot, random_states(robot, STATES, seed)).qdd is not None
    assert regular >= 0.9 * RANDOM_ROBOTS


# --- the check can fail -------------------------------------------------------------------------------------

MICRO: Final = Fraction(1, 10**6)


def _generic_arm() -> Robot:
    """Six revolute joints, no two consecutive axes parallel, nothing zero: every number tells, almost."""
    return random_robot(
        6, joints=6, prismatic=0, parallel=0, zeros=0, degenerate=0, exotic=0, motors=1, friction=1
    )


def _with_link(robot: Robot, i: int, link: Link) -> Robot:
    return replace(robot, links=(*robot.links[:i], link, *robot.links[i + 1 :]))


def _moved(robot: Robot, i: int, axis: int, by: Fraction = MICRO) -> Robot:
    """``robot`` with the centre of mass of link ``i`` (from 0) moved."""
    x, y, z = (c + by * (k == axis) for k, c in enumerate(robot.links[i].com))
    return _with_link(robot, i, replace(robot.links[i], com=(x, y, z)))


def _complains(kernel: Any, ref: Reference) -> bool:
    """Whether the torques of ``kernel`` are found wrong."""
    return bool(complaints(kernel, ref, TORQUES[:1], DOUBLE))


@pytest.fixture(scope="module")
def generic_kernel() -> Any:
    return kernel_of(_generic_arm(), (*ALL_BUT_FORWARD, "forward_dynamics"), scalar="double")


@pytest.mark.parametrize("peer", PEERS)
def test_a_centre_of_mass_one_micrometre_off_is_noticed(peer: str, generic_kernel: Any) -> None:
    """In every link and direction, but for link 1 along its own axis, which no torque depends on."""
    require_module(peer)
    robot = _generic_arm()
    states = random_states(robot, STATES, 1)
    assert complaints(generic_kernel, reference(peer, robot, states), TORQUES, DOUBLE) == []
    unnoticed = [
        (i + 1, "xyz"[axis])
        for i in range(robot.n)
        for axis in range(3)
        if not _complains(generic_kernel, reference(peer, _moved(robot, i, axis), states))
    ]
    assert unnoticed == [(1, "z")]


@pytest.mark.parametrize("function", [*ALL_BUT_FORWARD, "forward_dynamics"])
def test_every_function_notices_a_wrong_centre_of_mass(function: str, generic_kernel: Any) -> None:
    robot = _generic_arm()
    for ref in references(_moved(robot, 3, 0)):
        assert len(complaints(generic_kernel, ref, [function], DOUBLE)) == 1


def _changed_joint(link: Link, name: str) -> Link:
    value = getattr(link.joint, name)
    changes: dict[str, Any] = {
        name: angle(Fraction(value.radians) + MICRO) if name in ("alpha", "theta") else value + MICRO
    }
    return replace(link, joint=replace(link.joint, **changes))


def _changed_inertia(link: Link, entry: str) -> Link:
    entries = {name: getattr(link.inertia, name) for name in ("xx", "yy", "zz", "xy", "xz", "yz")}
    entries[entry] += MICRO
    return replace(link, inertia=Inertia(**entries))


@pytest.mark.parametrize("peer", PEERS)
def test_any_other_number_one_millionth_off_is_noticed(peer: str, generic_kernel: Any) -> None:
    require_module(peer)
    robot = _generic_arm()
    states = random_states(robot, STATES, 1)
    link = robot.links[3]
    broken = {"mass": replace(link, mass=link.mass + MICRO)}
    for entry in ("xx", "yy", "zz", "xy", "xz", "yz"):
        broken[entry] = _changed_inertia(link, entry)
    for name in ("alpha", "a", "d", "theta", "motor_inertia", "viscous", "coulomb"):
        broken[name] = _changed_joint(link, name)
    robots = {name: _with_link(robot, 3, other) for name, other in broken.items()}
    x, y, z = robot.gravity
    robots["gravity"] = replace(robot, gravity=(x, y + MICRO, z))
    unnoticed = [
        name
        for name, other in robots.items()
        if not _complains(generic_kernel, reference(peer, other, states))
    ]
    assert unnoticed == []


@pytest.mark.parametrize("wrong", [np.nan, np.inf])
def test_what_is_no_number_is_a_complaint(wrong: float) -> None:
    good = np.ones((3, 2))
    bad = good.copy()
    bad[2, 1] = wrong
    assert complaint("torque", good, good, 1.0, DOUBLE) is None
    text = complaint("torque", bad, good, 1.0, DOUBLE)
    assert text is not None
    assert "state 2, entry [2]" in text
    assert complaint("torque", good[:2], good, 1.0, DOUBLE) is not None


def test_mujoco_says_why_it_refuses_a_link() -> None:
    require_module("mujoco")
    mujoco_peer = peer_module("mujoco")
    robot = random_robot(1, joints=3, degenerate=0)
    assert mujoco_peer.refusals(robot) == {}
    bare = _with_link(robot, 1, replace(robot.links[1], mass=Fraction(0), inertia=Inertia()))
    assert list(mujoco_peer.refusals(bare)) == [1]
    with pytest.raises(mujoco_peer.NotExpressible, match="link 2: mass and inertia"):
        mujoco_peer.mujoco_model(bare, patch=False)
    mujoco_peer.mujoco_model(bare)
