"""Statements that no rule reads for certain: a field and a value in its reach, weighed by what stands around them."""
