"""Slips in the thesis's equations and printed data, each tried: the printed form and the right one."""
