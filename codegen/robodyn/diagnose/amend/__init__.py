"""The findings written into the description."""
