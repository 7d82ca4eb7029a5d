"""The command line of robodyn: one file a command, no mathematics."""
