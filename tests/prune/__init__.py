"""Tests of pruning: the proof, what is dropped, what is told of it."""
