"""Inverse dynamics in closed form: Lagrange's equations multiplied out and factored again."""

from robodyn.optimize.closed_form.seeds import closed_forms

__all__ = ["closed_forms"]
