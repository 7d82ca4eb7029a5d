"""Which effects explain what the model leaves over."""
