"""Logs: recordings of an arm are read from files of many kinds and become arrays in SI units.

Reading, in order:

1. ``formats`` has one file per log format. A reader returns a
   ``recording.Recording``: streams of rows with named columns, without any
   interpretation. Binary formats are read by libraries in a child process with
   limits of memory and time (``guard``).
2. A ``mapping.LogMap`` says which column is which signal of which joint, and in
   which unit. ``propose`` suggests one from names and numbers; ``map_text``
   writes it as YAML.
3. ``resolve`` finds the columns of a map in a recording, ``units`` converts
   them, ``assemble`` brings them to common times.
4. The result is a ``log.Log``: time, positions, and where they exist rates,
   accelerations, torques and link positions, as arrays ``[K, n]``.

Long files: ``pieces`` hands over the same samples block by block, in memory
that does not grow with the file (``blocks``, ``windows``).

For people: ``wizard.examine`` is what ``robodyn logs`` prints; ``survey`` has
the facts about each column. For models: ``signals`` filters positions and
torques alike before they are compared with a model. For simulations:
``provenance`` is the file ``LOG.csv.json`` beside a simulated log.

Every threshold stands in ``limits``, with its unit and its meaning.

>>> from robodyn.logs.log import read_log
>>> log = read_log("log.csv")                                   # doctest: +SKIP
>>> log.q.shape == log.tau.shape == (log.samples, 6)            # doctest: +SKIP
True
"""
