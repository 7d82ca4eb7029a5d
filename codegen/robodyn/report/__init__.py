"""Reports: results as JSON, as text for a terminal, and as HTML pages that need no network.

A module takes a result object of a lower room and computes nothing new about
it.

Generator side:

- ``arm_page`` (data: ``arm_data``, ``arm_parts``): the page of an arm,
  ``robodyn report``.
- ``schedules``, ``schedule_pictures``: task graphs, schedules, Gantt charts.
- ``benchmarks``: the tables of ``robodyn bench`` and ``plan``.
- ``effects``: the catalogue of effects as Markdown and LaTeX.
- ``poses``: solutions of inverse kinematics.

Log side:

- ``logs``: what ``robodyn logs`` prints.
- ``run``: a simulated run, with its picture.
- ``diagnosis`` and ``diagnosis_*``: the page and the summary of a diagnosis.
  ``diagnosis_headline`` words the verdict, ``diagnosis_findings`` draws the
  findings, ``diagnosis_residual`` shows where the residual is.
- ``fleet`` and ``fleet_*``: the pages of a fleet and of its units.
- ``identification``: the summary of ``robodyn identify``.

Shared: ``figures`` formats numbers, ``chart_frames`` draws the frames of charts
as SVG.

The same result gives the same bytes: no clock, no path, no random identifiers.

>>> from robodyn.report.arm_page import page
>>> page([arm_of(robodyn.load("puma560"))], None)[:15]          # doctest: +SKIP
'<!doctype html>'
"""
