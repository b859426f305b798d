"""Judges whether a changed thing still means the same, and how bad it is where it does not."""
