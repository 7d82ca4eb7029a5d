"""The 43 tasks of Table 4.1 carried out, over any scalar: what each computes, and which do any arithmetic.

For what the tasks are cut for: angles alpha that are multiples of 90 degrees, diagonal tensors of inertia, no
rotor. Behind a prismatic joint ``R`` is constant and right-angled: the products ``k`` and lambda are those of
the link before, seen along other axes, T3 forms the Coriolis acceleration, and T6 adds it to ``a``.

What each of the tasks costs is counted by carrying them out over numbers that note what is done to them.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Final

from robodyn.counts.general import Tally
from robodyn.dynamics.arm import Arm, Body, Motion, Symmetric, about_x, origin
from robodyn.dynamics.transforms import Matrix, product, rotation, transposed
from robodyn.dynamics.vectors import AXES, Vector
from robodyn.robot.values import quarter_turns
from robodyn.schedule.graph import TaskId, link_and_number, task_id
from robodyn.schedule.tasks import TASKS

#: Told of every task before it is carried out.
Watch = Callable[[TaskId], None]


class Link:
    """The quantities of a link by the names of Table 4.1, vectors as lists, zero until a task writes them.

    ``ww`` holds the products ``k`` off the diagonal and the squares on it; ``f_turned`` and ``n_turned`` are
    ``f`` and ``n`` of the link beyond, turned about its joint's axis only.
    """

    def __init__(self) -> None:
        def zeros() -> list[Any]:
            return [0, 0, 0]

        self.w, self.c, self.alpha, self.moved, self.a, self.a_c = (zeros() for _ in range(6))
        self.F, self.N, self.f_turned, self.f, self.n_turned, self.n = (zeros() for _ in range(6))
        self.p_f, self.s_F = zeros(), zeros()
        self.ww, self.lam, self.before, self.own = ([zeros() for _ in range(3)] for _ in range(4))


@dataclass(frozen=True, slots=True)
class Joint:
    """A joint with its link's body, and where it is; ``p`` is the link's origin in the frame before [m]."""

    body: Body
    c: Any
    s: Any
    p: Vector
    qd: Any
    qdd: Any

    def R(self) -> Matrix:
        """From the link's axes to those before."""
        return rotation(self.body, self.c, self.s)

    def back(self, u: list[Any], axis: int) -> Any:
        """A component of ``R^T u``."""
        x, y, z = about_x(self.body.cos_alpha, -self.body.sin_alpha, (u[0], u[1], u[2]))
        if axis == 0:
            return self.c * x + self.s * y
        return self.c * y - self.s * x if axis == 1 else z

    def about_axis(self, u: list[Any], axis: int) -> Any:
        """The first or second component of ``u`` turned about z by the joint's angle."""
        return self.s * u[0] + self.c * u[1] if axis else self.c * u[0] - self.s * u[1]

    def forth(self, turned: list[Any]) -> Vector:
        """``R u`` of what is turned about z already."""
        return about_x(self.body.cos_alpha, self.body.sin_alpha, (turned[0], turned[1], turned[2]))


@dataclass(frozen=True, slots=True)
class Place:
    """Where a task is carried out: the link with those before and beyond it, and the joints of the two."""

    was: Link
    now: Link
    beyond: Link
    joint: Joint
    next: Joint | None

    def through(self, turned: list[Any]) -> Vector:
        """What the link beyond hands over, from what is turned about its axis already."""
        return (0, 0, 0) if self.next is None else self.next.forth(turned)


def _turn(axis: int, at: Place, *, what: str) -> None:
    source = at.now.moved if what == "a" else getattr(at.was, what)
    target = getattr(at.now, what)
    target[axis], target[2] = at.joint.back(source, axis), at.joint.back(source, 2)


def _joint_rate(at: Place) -> None:
    now, rate = at.now, at.joint.qd
    if at.joint.body.revolute:
        now.w[2] = now.w[2] + rate
    else:
        rate = 2 * rate
    now.c = [rate * now.w[1], -(rate * now.w[0]), at.joint.qdd]


def _add_joint(at: Place) -> None:
    target = at.now.alpha if at.joint.body.revolute else at.now.a
    target[:] = [x + y for x, y in zip(target, at.now.c, strict=True)]


#: The entries ``(row, column)`` of ``ww`` and lambda by the task that writes them.
_ENTRIES: Final = {
    7: ((1, 2), (2, 0), (0, 1)),
    8: ((0, 0), (1, 1), (2, 2)),
    9: ((0, 0), (1, 1), (2, 2)),
    10: ((1, 0), (0, 2), (2, 1)),
    11: ((0, 1), (2, 0), (1, 2)),
}


def _lambda(task_number: int, at: Place) -> None:
    now, square = at.now, task_number in (7, 8)
    target = now.ww if square else now.lam
    if not at.joint.body.revolute:
        R, source = at.joint.R(), at.was.ww if square else at.was.lam
        carried = product(product(transposed(R), tuple(map(tuple, source))), R)
        for i, j in _ENTRIES[task_number]:
            target[i][j] = carried[i][j]
            if square:
                target[j][i] = carried[i][j]
        return
    for i, j in _ENTRIES[task_number]:
        if square:
            target[i][j] = target[j][i] = now.w[i] * now.w[j]
        elif i == j:
            target[i][i] = -(now.ww[i - 1][i - 1] + now.ww[i - 2][i - 2])
        else:
            turning = now.alpha[3 - i - j]
            target[i][j] = now.ww[i][j] + (turning if task_number == 10 else -turning)


def _products(axis: int, at: Place, *, of_parent: bool) -> None:
    rows, r = (at.was.lam, at.joint.p) if of_parent else (at.now.lam, at.joint.body.com)
    into = at.now.before if of_parent else at.now.own
    into[axis] = [x * y for x, y in zip(rows[axis], r, strict=True)]


def _accelerate(axis: int, at: Place, *, of_parent: bool) -> None:
    into, start = (at.now.moved, at.was.a) if of_parent else (at.now.a_c, at.now.a)
    x, y, z = (at.now.before if of_parent else at.now.own)[axis]
    into[axis] = start[axis] + x + y + z


def _inertial(at: Place) -> None:
    at.now.F = [at.joint.body.mass * x for x in at.now.a_c]


def _euler(axis: int, at: Place) -> None:
    moments = (at.joint.body.inertia.xx, at.joint.body.inertia.yy, at.joint.body.inertia.zz)
    j, k = (axis + 1) % 3, (axis + 2) % 3
    at.now.N[axis] = moments[axis] * at.now.alpha[axis] + (moments[k] - moments[j]) * at.now.ww[j][k]


def _turn_back(axis: int, at: Place, *, force: bool) -> None:
    if at.next is not None:
        source, target = (at.beyond.f, at.now.f_turned) if force else (at.beyond.n, at.now.n_turned)
        target[axis], target[2] = at.next.about_axis(source, axis), source[2]


def _force(at: Place) -> None:
    at.now.f = [x + y for x, y in zip(at.now.F, at.through(at.now.f_turned), strict=True)]


def _p_cross_f(axis: int, at: Place) -> None:
    p: Vector = (0, 0, 0) if at.next is None else at.next.p
    at.now.p_f[axis] = _cross(axis, p, at.through(at.now.f_turned))


def _s_cross_F(axis: int, at: Place) -> None:
    x, y, z = at.now.F
    at.now.s_F[axis] = _cross(axis, at.joint.body.com, (x, y, z))


def _cross(axis: int, u: Vector, v: Vector) -> Any:
    i, j = (axis + 1) % 3, (axis + 2) % 3
    return u[i] * v[j] - u[j] * v[i]


def _moment(axis: int, at: Place) -> None:
    now = at.now
    now.n[axis] = now.N[axis] + now.p_f[axis] + now.s_F[axis] + at.through(now.n_turned)[axis]


def _each(step: Callable[..., None], axes: Iterable[int] = range(3), **how: Any) -> list[Callable[..., None]]:
    return [partial(step, axis, **how) for axis in axes]


_DO: Final[dict[int, Callable[[Place], None]]] = dict(
    enumerate(
        [
            *_each(_turn, (0, 1), what="w"), _joint_rate, *_each(_turn, (0, 1), what="alpha"), _add_joint,
            *_each(_lambda, _ENTRIES), *_each(_products, of_parent=True), *_each(_accelerate, of_parent=True),
            *_each(_turn, (0, 1), what="a"), *_each(_products, of_parent=False),
            *_each(_accelerate, of_parent=False), _inertial, *_each(_euler),
            *_each(_turn_back, (0, 1), force=True), _force, *_each(_p_cross_f), *_each(_s_cross_F),
            *_each(_turn_back, (0, 1), force=False), *_each(_moment),
        ],
        start=1,
    )
)  # fmt: skip


def run_tasks(
    arm: Arm,
    motion: Motion,
    watch: Watch = lambda _: None,
    *,
    origins: Sequence[Vector] | None = None,
    order: Iterable[TaskId] | None = None,
) -> list[Link]:
    """All tasks of ``arm`` in ``motion``, one after another; the links with what was computed.

    ``origins`` [n] stand in for the links' origins in the frames before [m]; ``order`` is another order of
    the tasks. The torque of a revolute joint is ``n[2]`` [N m] of its link, the force of a prismatic one
    ``f[2]`` [N].
    """
    links = [Link() for _ in range(len(arm.bodies) + 2)]
    links[0].a = [-x for x in arm.gravity]
    p = origins or [origin(body, d) for body, d in zip(arm.bodies, motion.d, strict=True)]
    joints = [
        Joint(*each) for each in zip(arm.bodies, motion.c, motion.s, p, motion.qd, motion.qdd, strict=True)
    ]
    beyond: list[Joint | None] = [*joints[1:], None]
    for task in one_after_another(arm) if order is None else order:
        watch(task)
        link, task_number = link_and_number(task)
        at = Place(links[link - 1], links[link], links[link + 1], joints[link - 1], beyond[link - 1])
        _DO[task_number](at)
    return links[1:-1]


def one_after_another(arm: Arm) -> list[TaskId]:
    """An order of all tasks: link by link to the tip and back.

    T6 of a prismatic joint adds to what T18 and T19 give, which Table 4.1, made for revolute joints, does not
    ask for.
    """
    forward = [task.row for task in TASKS if task.forward]
    sliding = [task_number for task_number in forward if task_number != 6]
    sliding.insert(sliding.index(20), 6)
    links = range(1, len(arm.bodies) + 1)
    there = [
        task_id(link, task_number)
        for link in links
        for task_number in (forward if arm.bodies[link - 1].revolute else sliding)
    ]
    back = [task_id(link, task.row) for link in reversed(links) for task in TASKS if not task.forward]
    return there + back


def flops_of_tasks(
    n: int, prismatic: Collection[int] = (), *, s: str = "xyz", p: str = "xyz"
) -> dict[TaskId, int]:
    """Multiplications and additions of each task, together; see :func:`operations_of_tasks`."""
    by_task = operations_of_tasks(n, prismatic, s=s, p=p)
    return {task: sum(kinds.values()) for task, kinds in by_task.items()}


def operations_of_tasks(
    n: int, prismatic: Collection[int] = (), *, s: str = "xyz", p: str = "xyz"
) -> dict[TaskId, dict[str, int]]:
    """Operations of each task by kind, ``{"mul": 2, "add": 1}``, on an arm of ``n`` joints (``prismatic``
    ones numbered from 1), the base at rest, the first axis upright and nothing carried.

    All numbers of the model are some number that is not zero, but for the components of the centres of mass
    and of the origins that ``s`` and ``p`` do not name.
    """
    ledger: dict[str, int] = {}
    by_task: dict[TaskId, dict[str, int]] = {}

    def fixed() -> Any:
        return Tally(ledger, True)

    def vector(axes: str) -> Vector:
        x, y, z = (fixed() if axis in axes else 0 for axis in AXES)
        return x, y, z

    def body(joint: int) -> Body:
        cos_alpha, sin_alpha = (1, 0) if joint == 1 else (0, 1)
        return Body(
            joint not in prismatic, cos_alpha, sin_alpha, fixed(), fixed(), quarter_turns(0), fixed(),
            vector(s), Symmetric(fixed(), fixed(), fixed(), 0, 0, 0), motor_inertia=0, viscous=0, coulomb=0,
        )  # fmt: skip

    bodies = tuple(map(body, range(1, n + 1)))
    c, sine, d, qd, qdd = (tuple(Tally(ledger) for _ in bodies) for _ in range(5))
    motion = Motion(
        tuple(x if body.revolute else 1 for x, body in zip(c, bodies, strict=True)),
        tuple(x if body.revolute else 0 for x, body in zip(sine, bodies, strict=True)),
        d, qd, qdd,
    )  # fmt: skip
    current: list[TaskId] = []

    def book(task: TaskId) -> None:
        if current:
            by_task[current.pop()] = dict(ledger)
        ledger.clear()
        current.append(task)

    arm = Arm(bodies, (0, 0, fixed()), rest_velocity=None)
    run_tasks(arm, motion, book, origins=[vector(p) for _ in bodies])
    book(0)
    return dict(sorted(by_task.items()))
