"""Recursive Newton-Euler as it stands in the textbook, over the scalars of any symbolic tool.

J. J. Craig, Introduction to Robotics, 6.45 to 6.53, modified DH frames, each rotation as one about x and one
about z. It is what a user of CasADi, SymForce or wrenfold writes; what becomes of it is the tool's affair.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

from robodyn.bench.peers.numbers import LinkNumbers, Numbers

Vector = tuple[Any, Any, Any]


def inverse_dynamics(
    arm: Numbers,
    q: Sequence[Any],
    qd: Sequence[Any],
    qdd: Sequence[Any],
    sin: Callable[[Any], Any],
    cos: Callable[[Any], Any],
) -> list[Any]:
    """The torques [n] as expressions; numbers stay Python's, 0 and 1 as integers."""
    joints = joint_reactions(arm, q, qd, qdd, sin, cos)
    return [
        plus((m if link.revolute else f)[2], times(plain(link.rotor), rate))
        for link, rate, (f, m) in zip(arm.links, qdd, joints, strict=True)
    ]


def joint_reactions(
    arm: Numbers,
    q: Sequence[Any],
    qd: Sequence[Any],
    qdd: Sequence[Any],
    sin: Callable[[Any], Any],
    cos: Callable[[Any], Any],
) -> list[tuple[Vector, Vector]]:
    """Force and moment of the link before on each link, at and along its frame."""
    turned: list[tuple[Any, Any]] = []
    w: Vector = (0, 0, 0)
    dw: Vector = (0, 0, 0)
    dv: Vector = vector(-arm.gravity)
    forces: list[Vector] = []
    moments: list[Vector] = []
    for i, link in enumerate(arm.links):
        angle = plus(q[i], plain(link.theta[0])) if link.revolute else None
        c, s = (cos(angle), sin(angle)) if link.revolute else (plain(link.theta[1]), plain(link.theta[2]))
        turned.append((c, s))
        p = origin(link, q[i])
        dv = down(link, c, s, add(dv, add(cross(dw, p), cross(w, cross(w, p)))))
        before = down(link, c, s, w)
        dw = down(link, c, s, dw)
        along, along2 = (0, 0, qd[i]), (0, 0, qdd[i])
        if link.revolute:
            w = add(before, along)
            dw = add(add(dw, cross(before, along)), along2)
        else:
            w = before
            dv = add(add(dv, scaled(2, cross(w, along))), along2)
        com = vector(link.com)
        dv_com = add(dv, add(cross(dw, com), cross(w, cross(w, com))))
        forces.append(scaled(plain(link.mass), dv_com))
        moments.append(add(on_inertia(link, dw), cross(w, on_inertia(link, w))))
    return _inward(arm, q, turned, forces, moments)


def _inward(
    arm: Numbers,
    q: Sequence[Any],
    turned: Sequence[tuple[Any, Any]],
    forces: Sequence[Vector],
    moments: Sequence[Vector],
) -> list[tuple[Vector, Vector]]:
    f: Vector = (0, 0, 0)
    m: Vector = (0, 0, 0)
    joints: list[tuple[Vector, Vector]] = []
    for i in reversed(range(arm.n)):
        link = arm.links[i]
        own = cross(vector(link.com), forces[i])
        if i + 1 < arm.n:
            child = arm.links[i + 1]
            f = up(child, *turned[i + 1], f)
            m = add(up(child, *turned[i + 1], m), cross(origin(child, q[i + 1]), f))
        f = add(f, forces[i])
        m = add(add(m, moments[i]), own)
        joints.append((f, m))
    return joints[::-1]


def origin(link: LinkNumbers, q: Any) -> Vector:
    d = plain(link.d) if link.revolute else plus(q, plain(link.d))
    ca, sa, b = plain(link.alpha[1]), plain(link.alpha[2]), plain(link.b)
    return (
        plain(link.a),
        plus(times(ca, b), times(plain(-link.alpha[2]), d)),
        plus(times(sa, b), times(ca, d)),
    )


def down(link: LinkNumbers, c: Any, s: Any, v: Vector) -> Vector:
    """``v``, given in the frame before, in the link's frame."""
    ca, sa = plain(link.alpha[1]), plain(link.alpha[2])
    y, z = plus(times(ca, v[1]), times(sa, v[2])), minus(times(ca, v[2]), times(sa, v[1]))
    return plus(times(c, v[0]), times(s, y)), minus(times(c, y), times(s, v[0])), z


def up(link: LinkNumbers, c: Any, s: Any, v: Vector) -> Vector:
    """``v``, given in the link's frame, in the frame before."""
    ca, sa = plain(link.alpha[1]), plain(link.alpha[2])
    x, y = minus(times(c, v[0]), times(s, v[1])), plus(times(s, v[0]), times(c, v[1]))
    return x, minus(times(ca, y), times(sa, v[2])), plus(times(sa, y), times(ca, v[2]))


def on_inertia(link: LinkNumbers, v: Vector) -> Vector:
    rows = [[times(plain(x), y) for x, y in zip(row, v, strict=True)] for row in link.inertia]
    x, y, z = (plus(plus(row[0], row[1]), row[2]) for row in rows)
    return x, y, z


def vector(numbers: Iterable[float]) -> Vector:
    x, y, z = (plain(x) for x in numbers)
    return x, y, z


def plain(x: float) -> Any:
    """A number; 0, 1 and -1 as integers, which every tool's algebra knows."""
    return int(x) if x in (0.0, 1.0, -1.0) else float(x)


def known(x: Any, constant: int) -> bool:
    return isinstance(x, int) and x == constant


def times(a: Any, b: Any) -> Any:
    if known(a, 0) or known(b, 0):
        return 0
    if known(a, 1):
        return b
    return a if known(b, 1) else a * b


def plus(a: Any, b: Any) -> Any:
    if known(a, 0):
        return b
    return a if known(b, 0) else a + b


def minus(a: Any, b: Any) -> Any:
    if known(b, 0):
        return a
    return -b if known(a, 0) else a - b


def scaled(k: Any, v: Vector) -> Vector:
    return times(k, v[0]), times(k, v[1]), times(k, v[2])


def add(u: Vector, v: Vector) -> Vector:
    return plus(u[0], v[0]), plus(u[1], v[1]), plus(u[2], v[2])


def cross(u: Vector, v: Vector) -> Vector:
    return (
        minus(times(u[1], v[2]), times(u[2], v[1])),
        minus(times(u[2], v[0]), times(u[0], v[2])),
        minus(times(u[0], v[1]), times(u[1], v[0])),
    )


def casadi_function(arm: Numbers, name: str = "inverse_dynamics") -> Any:
    """The textbook's recursion as a function of ``casadi`` over SX, equal nodes merged (``casadi.cse``)."""
    import casadi

    q, qd, qdd = (casadi.SX.sym(array, arm.n) for array in ("q", "qd", "qdd"))
    split = casadi.vertsplit
    tau = inverse_dynamics(arm, split(q), split(qd), split(qdd), casadi.sin, casadi.cos)
    return casadi.Function(name, [q, qd, qdd], [casadi.cse(casadi.vertcat(*tau))])
