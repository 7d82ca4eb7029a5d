"""Derivatives: what is always zero, and those of a record; their values are compared in tests/peers."""

from __future__ import annotations

from robodyn import Options, load, program
from robodyn.counts import count
from robodyn.kernels.generate import generate

FAST = Options(optimize="fast")


def test_what_is_always_zero_is_listed() -> None:
    """Nothing depends on how far the first joint has turned about the vertical, whatever its program says."""
    made = generate(load("puma560"), Options(("inverse_dynamics_derivatives", "gravity"), optimize="fast"))
    assert set(range(0, 36, 6)) <= set(made.zeros["inverse_dynamics_derivatives"]["dtau_dq"])
    listed = made.files(["c"])["puma560.h"].partition("Always 0, elements counted from 0:")[2]
    assert "inverse_dynamics_derivatives: dtau_dq is 0 at 0, 5, 6, 11, 12," in listed.partition("*/")[0]
    assert "gravity: tau is 0" not in listed


def test_of_a_record_they_are_taken_where_that_is_less() -> None:
    robot = load("ur10")
    written, taken = (
        program(robot, "inverse_dynamics_derivatives", options) for options in (FAST, Options())
    )
    assert count(taken).total < count(written).total
