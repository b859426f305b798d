"""One value of a quantity with elements for each element of a field: the answer, and what a receiver makes of it."""
