"""Fewer operations: equal programs with fewer multiplications and additions.

Every choice in this room changes what a program costs and not what it computes;
:mod:`robodyn.kernels.proof` checks the result.

- ``base_parameters``: modified Newton-Euler on base parameters. Moments of mass
  move to the parent link, so that a link may have none left.
- ``variant.Variant``: every freedom of that recursion: how much of each link's
  moments moves (``gauge``), along which axes and about which origin a link's
  quantities are written (``moments``).
- ``costing`` and ``tally``: what a variant costs, counted without building its
  program.
- ``fast``: a good variant without a search; the level ``fast`` of ``gen``.
- ``choice`` and ``programs``: which formulation and which variant an arm gets,
  and its programs.
- ``merging``, ``cheapest``, ``lazy``: graphs that merge equal values, and the
  cheapest of several ways to write a value.

Packages:

- ``closed_form``: products of sines and cosines of sums of angles, factored.
- ``prune``: terms that cannot matter within the joint limits, with a proven
  bound on the error.
- ``records``: the best known program of an arm, stored as a file and validated
  when it is read.

The search itself is :mod:`robodyn.search`.

>>> from robodyn.kernels.generate import generate
>>> counts = generate(robodyn.load("puma560")).counts           # doctest: +SKIP
>>> counts["inverse_dynamics"].total                            # doctest: +SKIP
262
"""
