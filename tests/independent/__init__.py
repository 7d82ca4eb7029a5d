"""Every function of every effect, against an evaluation that shares no code with robodyn."""
