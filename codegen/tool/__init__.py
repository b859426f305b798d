"""Codegen itself: its own files and templates, and what it keeps from one run to the next."""
