"""The thesis of 1990: every table, figure, schedule and claim, recomputed and held against what it prints."""
