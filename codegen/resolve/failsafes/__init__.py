"""Failsafes: what they watch, from when on it is bad, and what is done then."""
