"""Drivers of the project's own, in specs/drivers."""
