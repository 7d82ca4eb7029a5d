"""From a log to what the model lacks: the gate, signals, candidates, names, estimates, proof."""
