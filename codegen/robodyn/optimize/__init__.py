"""Fewer operations, proven equal: base parameters, formulation variants, closed forms, pruning, records."""
