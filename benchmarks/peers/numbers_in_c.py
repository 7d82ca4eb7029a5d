"""The numbers of an arm for programs in C and C++ (``benchmarks/peers/native/peer.h``)."""

from __future__ import annotations

from robodyn.bench.peers.numbers import Numbers, NumbersLacking


def text_of(arm: Numbers) -> str:
    """All numbers to the last digit.

    Raises
    ------
    NumbersLacking: a link has an offset that no row of DH numbers has.
    """
    check_rows(arm)
    rows = [[float(arm.n), *arm.gravity]]
    for link in arm.links:
        rows.append([float(link.revolute), *link.alpha, link.a, link.d, *link.theta])
        rows[-1] += [link.mass, *link.com, *link.inertia.ravel(), link.rotor]
        rows[-1] += [*link.rotation.ravel(), *link.position]
    return "".join(" ".join(repr(float(x)) for x in row) + "\n" for row in rows)


def check_rows(arm: Numbers) -> None:
    """:class:`NumbersLacking` where the frames of ``arm`` are no Denavit-Hartenberg rows."""
    if any(link.b for link in arm.links):
        raise NumbersLacking(f"{arm.name} has frames that four DH numbers a joint do not describe")
