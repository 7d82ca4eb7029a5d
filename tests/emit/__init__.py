"""Tests of the emitted files: read by a parser, by compilers, and run."""
