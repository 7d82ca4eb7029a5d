"""Is this log fit to be diagnosed, and with this model?"""
