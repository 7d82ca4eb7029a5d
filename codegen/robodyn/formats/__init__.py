"""Robots in other formats: URDF, SDF, MJCF and xacro are read, and URDF, SDF and MJCF are written.

Reading, in order:

1. ``arm.import_arm`` (or ``loading.load``, which also takes a bundled name or a
   YAML description) picks the reader by the file's ending.
2. A reader turns the file into a ``tree.Tree``: links, joints of every kind,
   and everything that the file states beyond them. ``urdf`` and ``sdf`` read
   the XML themselves (``xml_text``, ``elements``). ``mjcf`` lets the package
   mujoco compile the file. ``xacro`` expands the file first, in a child process
   with limits.
3. ``elements_of`` has one table per format: for each element, whether it is
   read, has no effect on torques, or is refused until ``--without`` names it.
   An element that no table knows is refused.
4. ``serial`` extracts the serial chain: fixed joints are merged, branches are
   locked and lumped.
5. ``frames`` converts joint axes in any direction to modified DH frames,
   ``conversion`` converts names, limits and effects.

Writing: ``exporting`` builds a ``chain.Chain`` from a robot; ``writers`` has
one module per format.

Rules of this room:

- Nothing of a file is dropped silently. What was left out, decided or assumed
  is recorded in the robot's account (:mod:`robodyn.robot.account`).
- A file is untrusted: sizes are bounded (``limits``), no entity is expanded,
  and expressions of xacro files are data that ``xacro_expressions`` evaluates
  over a fixed set of operations.
- Numbers stay exact rationals until they are emitted.
"""
