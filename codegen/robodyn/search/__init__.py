"""The search for fewer operations: formulation variants, then any algebra that holds.

``structured`` goes through gauges, forms, frames and origins; ``climb`` walks on from the best of them.
"""
