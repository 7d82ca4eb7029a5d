"""What the test modules share: asking for tools that may not be on this machine, and choosing cases.

Use it in a test, a fixture, or at the head of a test module (which then is skipped as a whole)::

    from robodyn_testing import require_module, require_tool

    gfortran = require_tool("gfortran")         # its path, a str
    pinocchio = require_module("pinocchio")     # the imported module

A module of tests may also import a package of the extra ``test`` at its head as any other: where it is
missing the module is skipped, or fails in CI (:mod:`robodyn_testing.wanted`).

Of a test over all robots, effects, functions ... a few cases stay in ``make test``; the others are
``thorough``, and run in ``make test-all`` as well::

    @pytest.mark.parametrize("name", representative(bundled_names(), "puma560", "stanford"))
    @pytest.mark.parametrize(("name", "scalar"), covering(["puma560", "stanford"], ["double", "float"]))

A test over many random arms is one test, which loops over seeds that turn with the commit::

    @pytest.mark.parametrize("count", seed_counts(20, 500))  # 500 in make prove-all
    def test_an_arm(count):
        for seed in commit_seeds(count):
            robot = random_robot(seed)
"""

from __future__ import annotations

from robodyn_testing.cases import covering, representative, sampled
from robodyn_testing.exactly import constant, exactly
from robodyn_testing.seeds import commit_seeds, seed_counts
from robodyn_testing.wanted import (
    require_distribution,
    require_machine,
    require_module,
    require_npm_package,
    require_tool,
)

__all__ = [
    "commit_seeds",
    "constant",
    "covering",
    "exactly",
    "representative",
    "require_distribution",
    "require_machine",
    "require_module",
    "require_npm_package",
    "require_tool",
    "sampled",
    "seed_counts",
]
