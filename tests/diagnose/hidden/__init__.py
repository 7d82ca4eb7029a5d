"""Blind tests of the diagnosis by another engine: MuJoCo moves the arm, own formulas hide the effects."""

from diagnose.hidden.arms import ARMS
from diagnose.hidden.cases import Case, cases
from diagnose.hidden.logs import Hidden, Truth, effect, hidden_log, outsider

__all__ = ["ARMS", "Case", "Hidden", "Truth", "cases", "effect", "hidden_log", "outsider"]
