"""Compilers, other programs, and a cache of what they made."""
