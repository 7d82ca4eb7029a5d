"""Kernels: from a robot and options to programs, counts and source files; compiled, loaded and called.

Making kernels:

- ``options.Options`` says what to generate and how: functions, scalar type,
  sines, order, target.
- ``generate.generate`` builds the programs, runs the passes, counts operations
  and returns a ``Generated``, which has the files of every language.
- ``rigid_programs`` builds the programs of a rigid arm, ``with_effects`` those
  of an arm whose drives have effects; ``drafts`` keeps the cheapest of several
  programs for one function.
- ``proof`` compares every program with plain Newton-Euler at points of finite
  fields before it leaves; ``condition`` checks programs of arms with effects at
  60 digits.
- ``through_sympy`` builds the same model as sympy expressions, to be read,
  typeset and cross-checked.

Calling kernels from Python:

- ``kernel.load`` compiles and loads the files; ``kernel.Kernel`` calls each
  function on arrays, ``kernel.Workspace`` does so without allocation.
- ``robot_kernel`` does both in one call, which is what ``robodyn.compile`` is.
- ``arrays`` checks what is passed in, ``wrapper`` is the C between Python and
  the emitted functions, ``direct`` that which answers calls whose arrays need
  no conversion.

Without a compiler: ``array_dynamics.Model`` gives torques, loads, mass matrix
and regressor of a robot over samples ``[K, n]`` in numpy. It is the one class
that the log side takes its dynamics from.

>>> from robodyn.kernels.generate import generate
>>> sorted(generate(robodyn.load("puma560")).files())           # doctest: +SKIP
['puma560.c', 'puma560.f90', 'puma560.h']
"""
