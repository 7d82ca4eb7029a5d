"""The effects that a rigid arm lacks, each defined once, over any scalar."""
