"""What is shown: the thesis's tables beside ours, as JSON first and as text and pictures from it."""
