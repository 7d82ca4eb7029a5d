"""What the thesis claims in its running text: ``data/claims.yaml`` has the claims, the modules here recompute
them.

A function here is named by the claim that it belongs to (``by: tasks.parallel_cost``) and returns its figures
by name, with whether the claim holds by them.
"""
