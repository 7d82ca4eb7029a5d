"""Contact with something outside: where in a log, on which link, and with what force."""
