"""Searches for the machine that separates best: see __main__.py."""
