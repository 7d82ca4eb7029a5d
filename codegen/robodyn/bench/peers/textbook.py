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
    turned: list[tuple[Any, Any]] = []
    w: Vector = (0, 0, 0)
    dw: Vector = (0, 0, 0)
    dv: Vector = _vector(-arm.gravity)
    forces: list[Vector] = []
    moments: list[Vector] = []
    for i, link in enumerate(arm.links):
        angle = _sum(q[i], _plain(link.theta[0])) if link.revolute else None
        c, s = (cos(angle), sin(angle)) if link.revolute else (_plain(link.theta[1]), _plain(link.theta[2]))
        turned.append((c, s))
        p = _origin(link, q[i])
        dv = _down(link, c, s, _add(dv, _add(_cross(dw, p), _cross(w, _cross(w, p)))))
        before = _down(link, c, s, w)
        dw = _down(link, c, s, dw)
        along, along2 = (0, 0, qd[i]), (0, 0, qdd[i])
        if link.revolute:
            w = _add(before, along)
            dw = _add(_add(dw, _cross(before, along)), along2)
        else:
            w = before
            dv = _add(_add(dv, _scaled(2, _cross(w, along))), along2)
        com = _vector(link.com)
        dv_com = _add(dv, _add(_cross(dw, com), _cross(w, _cross(w, com))))
        forces.append(_scaled(_plain(link.mass), dv_com))
        moments.append(_add(_times(link, dw), _cross(w, _times(link, w))))
    return _inward(arm, q, qdd, turned, forces, moments)


def _inward(
    arm: Numbers,
    q: Sequence[Any],
    qdd: Sequence[Any],
    turned: Sequence[tuple[Any, Any]],
    forces: Sequence[Vector],
    moments: Sequence[Vector],
) -> list[Any]:
    f: Vector = (0, 0, 0)
    m: Vector = (0, 0, 0)
    tau: list[Any] = [None] * arm.n
    for i in reversed(range(arm.n)):
        link = arm.links[i]
        own = _cross(_vector(link.com), forces[i])
        if i + 1 < arm.n:
            child = arm.links[i + 1]
            f = _up(child, *turned[i + 1], f)
            m = _add(_up(child, *turned[i + 1], m), _cross(_origin(child, q[i + 1]), f))
        f = _add(f, forces[i])
        m = _add(_add(m, moments[i]), own)
        tau[i] = _sum((m if link.revolute else f)[2], _product(_plain(link.rotor), qdd[i]))
    return tau


def _origin(link: LinkNumbers, q: Any) -> Vector:
    d = _plain(link.d) if link.revolute else _sum(q, _plain(link.d))
    ca, sa, b = _plain(link.alpha[1]), _plain(link.alpha[2]), _plain(link.b)
    return (
        _plain(link.a),
        _sum(_product(ca, b), _product(_plain(-link.alpha[2]), d)),
        _sum(_product(sa, b), _product(ca, d)),
    )


def _down(link: LinkNumbers, c: Any, s: Any, v: Vector) -> Vector:
    """``v``, given in the frame before, in the link's frame."""
    ca, sa = _plain(link.alpha[1]), _plain(link.alpha[2])
    y, z = _sum(_product(ca, v[1]), _product(sa, v[2])), _less(_product(ca, v[2]), _product(sa, v[1]))
    return _sum(_product(c, v[0]), _product(s, y)), _less(_product(c, y), _product(s, v[0])), z


def _up(link: LinkNumbers, c: Any, s: Any, v: Vector) -> Vector:
    """``v``, given in the link's frame, in the frame before."""
    ca, sa = _plain(link.alpha[1]), _plain(link.alpha[2])
    x, y = _less(_product(c, v[0]), _product(s, v[1])), _sum(_product(s, v[0]), _product(c, v[1]))
    return x, _less(_product(ca, y), _product(sa, v[2])), _sum(_product(sa, y), _product(ca, v[2]))


def _times(link: LinkNumbers, v: Vector) -> Vector:
    rows = [[_product(_plain(x), y) for x, y in zip(row, v, strict=True)] for row in link.inertia]
    x, y, z = (_sum(_sum(row[0], row[1]), row[2]) for row in rows)
    return x, y, z


def _vector(numbers: Iterable[float]) -> Vector:
    x, y, z = (_plain(x) for x in numbers)
    return x, y, z


def _plain(x: float) -> Any:
    """A number; 0, 1 and -1 as integers, which every tool's algebra knows."""
    return int(x) if x in (0.0, 1.0, -1.0) else float(x)


def _known(x: Any, constant: int) -> bool:
    return isinstance(x, int) and x == constant


def _product(a: Any, b: Any) -> Any:
    if _known(a, 0) or _known(b, 0):
        return 0
    if _known(a, 1):
        return b
    return a if _known(b, 1) else a * b


def _sum(a: Any, b: Any) -> Any:
    if _known(a, 0):
        return b
    return a if _known(b, 0) else a + b


def _less(a: Any, b: Any) -> Any:
    if _known(b, 0):
        return a
    return -b if _known(a, 0) else a - b


def _scaled(k: Any, v: Vector) -> Vector:
    return _product(k, v[0]), _product(k, v[1]), _product(k, v[2])


def _add(u: Vector, v: Vector) -> Vector:
    return _sum(u[0], v[0]), _sum(u[1], v[1]), _sum(u[2], v[2])


def _cross(u: Vector, v: Vector) -> Vector:
    return (
        _less(_product(u[1], v[2]), _product(u[2], v[1])),
        _less(_product(u[2], v[0]), _product(u[0], v[2])),
        _less(_product(u[0], v[1]), _product(u[1], v[0])),
    )
