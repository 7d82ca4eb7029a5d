"""Arms in other formats: files to a chain of axes, and the chain to a description."""
