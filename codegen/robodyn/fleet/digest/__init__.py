"""A log on its own: all that its fleet needs to know of it, in some tens of kilobytes."""
