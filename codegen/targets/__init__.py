"""Targets: each makes one kind of output. listed.py lists those that a project has; the codec needs no project."""
