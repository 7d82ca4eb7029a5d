"""Selection of effects: what candidates foretell of parts of a log that are held out.

:func:`.search.search` runs the whole selection:

1. ``rows``: logs as rows, each with its weight; a row at rest says a set of dry friction.
2. ``families``: what the catalogue has (``library``), by effect and place; ``scope`` is what was asked for.
3. ``noise``: what of the rows is noise, that of the sensors at least.
4. ``score``: what each candidate foretells of blocks that were held out.
5. ``members``: effects that are in, fitted together in the model's full equations, beside the arm's own
   numbers (``prior``).
6. ``search``: effects come in, go out and are exchanged; ``odds``: how often such a name is right.
7. ``errors``: how sure the numbers are.

``contact`` looks for contacts with the surroundings, ``encoders`` for springs by second encoders. Every
threshold stands in ``limits``.
"""
