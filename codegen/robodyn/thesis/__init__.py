"""The thesis of 1990: every table, figure, schedule and claim, recomputed and compared with what it prints.

Charles Dhanaraj, "Parallel Processing of Manipulator Dynamics Incorporating
Frictional Effects".

- ``printed`` holds what the thesis prints, slips included; the numbers stand in
  ``data/``.
- ``tables`` recomputes each table. Every row has the printed figure, ours, a
  verdict (reproduced, differs, not recoverable) and a reason: ``robodyn
  tables``.
- ``claims`` recomputes the claims of the running text.
- ``slips`` has what the thesis prints wrongly, in equations and in data, and
  shows each slip by computing it.
- ``formulations`` has the recursions of earlier papers that the thesis counts
  (Lagrange in several forms, Kane, Balafoutis, Orin and others). The generator
  looks them up by name.
- ``steps`` has the two Newton-Euler methods step by step, as chapter 2 counts
  them.
- ``judge`` validates the printed schedules.
- ``logarithmic`` has the recursions whose time grows with the logarithm of the
  number of joints (chapter 4).
- ``case_study`` and ``case_*`` repeat the case study of friction (chapter 3):
  ``robodyn case-study``.
- ``puma_inverse`` is program D.1.3.
- ``polynomial`` counts operations as polynomials in the number of joints.

This room may import both sides, and no other room imports it but by name. A
match with a printed figure is never faked: where ours differs, the row says
why.
"""
