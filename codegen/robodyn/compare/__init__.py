"""Two robots: what differs, in numbers and in what they do."""
