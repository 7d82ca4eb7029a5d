"""Fleets: many logs of many arms; which arms differ from their siblings, since when, and in what.

From files to results:

1. ``sources`` reads the description of a fleet (``fleet.toml``, or a folder)
   and finds the logs of each unit.
2. ``digest`` reduces a log to normal equations per joint. Digests of one unit
   add up, so that each log is read once; ``store`` keeps them by the log's
   content, and a second run digests new logs only.
3. ``work`` is what runs in a free process: reading, digesting, diagnosing.
   :mod:`robodyn.cluster` decides where.
4. ``pool`` compares units of one type: what they have in common, and which of
   them differ or have changed.
5. ``units`` diagnoses the logs of units that differ.
6. ``result`` holds all of it; ``as_json`` is ``fleet.json`` with its schema,
   ``table`` is ``fleet.parquet``.

``run.run_fleet`` does these steps. Every threshold stands in ``limits``.

Pages of the result are made by :mod:`robodyn.report.fleet`.

What a result says about a unit rests on the logs of that unit and of its
siblings alone: a joint that no log moves is not judged.

Simulated fleets with planted faults, and the scores on them, are in
``benchmarks/fleet``: they are no part of the product.

>>> from robodyn.fleet.run import run_fleet
>>> run_fleet(read_fleet("fleet.toml"), Path("out"), "local")   # doctest: +SKIP
"""
