"""Many logs of many arms: which of them differ from their siblings, since when, and in what."""
