"""The data gate: whether a log can be used, and whether it is a log of this robot.

``gate`` runs all checks before anything is fitted. It returns the usable part
of the log with flags about it, or refuses the log with the reason. A
``flag.Flag`` names what was found and where.

Checks of the rows:

- ``samples``: how the log was sampled: rows sent twice, angles that wrap
  around, smoothed signals.
- ``rows``: rows that are not numbers, out of order, repeated or missing.
- ``spikes``: single rows that do not follow the motion.
- ``stuck``: positions that stay at one value while the joint moves.

Checks against the motion and the model:

- ``rates``: logged velocities against the slope of the positions: unit, sign,
  order of columns, lag.
- ``model``: whether the torques would agree far better in other units, with
  other signs, zeros or gains, later, without gravity, or in another order of
  the joints (``readings``); ``comparison`` says which readings are more
  likely, by fits of the arm's numbers to each (``arm_fit``).
- ``links``: second encoders, on the links.
- ``content``: which part of each joint's dynamics the motion can show at all.

``grid`` brings the usable rows to an even grid, ``smooth`` filters signals for
the checks alone. Every threshold stands in ``limits``.

>>> from robodyn.gate.gate import inspect
>>> inspect(read_log("tx40.csv"), robodyn.load("tx40")).flags   # doctest: +SKIP
"""
