"""Logs: what a recording holds, read from files of many kinds, and filtered for comparison with a model."""
