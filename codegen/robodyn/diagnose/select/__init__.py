"""Selection of effects: which effects of the catalogue explain what the model leaves of a log.

``search.search`` runs the whole selection:

1. ``remainder``: what the model leaves of the log, in its full equations.
2. ``common``: effects that every joint has (friction, rotor inertia) are tried
   on all joints at once.
3. ``forward``: forward selection. ``library`` makes the candidates, ``trial``
   fits one of them together with the effects found so far, ``fit`` judges it on
   parts of the log that were left out.
4. ``choice``: which candidates pass, which one is best, and which are its
   rivals.
5. ``refine`` and ``local_fit``: all parameters of all findings refitted
   together.
6. Backward elimination: effects that are no longer needed are removed.
7. ``uncertainty``: standard errors and profile intervals.

Special cases:

- ``walk``: joint elasticity, searched along its stiffness; ``encoders`` finds
  it from second encoders.
- ``contact``: contacts with the surroundings.
- ``own_numbers``, ``about``, ``prior_share``: errors of the description itself,
  which every candidate is fitted beside, within the confidence that the
  description states.
- ``motion_noise``: encoder noise carried into torque.
- ``ceiling``: what all linear candidates together could explain, and so what
  counts as noise.

``scope`` is what the user asked for (``--only``, ``--joints``). Every threshold
stands in ``limits``.
"""
