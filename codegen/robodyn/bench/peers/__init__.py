"""Other people's dynamics of a robot, to be timed beside ours: each is given the same numbers, none is needed
by anything else, and each is imported only where it is asked for."""
