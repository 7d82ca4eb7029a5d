"""A simulated fleet whose faults are known and sealed, and how well an answer names them."""
