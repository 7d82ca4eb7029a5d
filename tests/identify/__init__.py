"""Identification: the arm's numbers from logs of arms that are known."""
