"""SVG and HTML: curves in frames, texts escaped."""
