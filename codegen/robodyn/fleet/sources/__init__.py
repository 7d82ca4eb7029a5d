"""Where a fleet's logs are, and of which arm, unit and day each of them is."""
