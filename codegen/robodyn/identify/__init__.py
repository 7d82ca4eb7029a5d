"""The arm's numbers from logs: base parameters and friction, physically consistent, with intervals."""
