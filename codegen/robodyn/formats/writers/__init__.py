"""Descriptions as files of other formats."""
