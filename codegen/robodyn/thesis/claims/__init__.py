"""What the thesis claims in its running text: ``claims.yaml`` has the claims, the modules beside it recompute
them.

A function here is named by the claim that it belongs to (``by: tasks.parallel_cost``) and returns its figures
by name, with whether the claim holds by them.
"""
