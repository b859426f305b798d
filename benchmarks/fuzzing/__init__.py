"""Inputs with faults drawn by lot, and what codegen may do with such an input."""
