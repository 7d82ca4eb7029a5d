"""The formulations: each a recursion over any scalar that reads like the equations in the book."""
