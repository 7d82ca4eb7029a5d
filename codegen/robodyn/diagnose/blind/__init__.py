"""Blind tests: effects hidden in simulated logs, answers under seal."""
