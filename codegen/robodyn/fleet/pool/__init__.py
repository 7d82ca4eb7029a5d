"""From the digests of a fleet to what its types have in common and what is peculiar to a unit."""
