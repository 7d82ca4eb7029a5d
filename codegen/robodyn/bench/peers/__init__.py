"""Other people's dynamics of a robot, to be timed beside ours: each is given the same numbers, none is needed
by anything else, and each is imported only where it is asked for."""

from robodyn.bench.peers.agreement import TOLERANCE, Disagreement, hold_against
from robodyn.bench.peers.numbers import Numbers, NumbersLacking, numbers_of

__all__ = ["TOLERANCE", "Disagreement", "Numbers", "NumbersLacking", "hold_against", "numbers_of"]
