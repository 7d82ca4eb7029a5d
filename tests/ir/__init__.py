"""Tests of the graph and its programs, and the random programs that other tests use too."""
